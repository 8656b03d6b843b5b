// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene in ODE's form: world, space, bodies, geoms, joints, made with ode/*.h alone, and what a step needs
// that does not depend on where contacts come from. Static bodies are geoms without a body. A geom's data is
// the number of its body in the scene.
#pragma once

#include <ode/ode.h>

#include <deque>

#include "bench/engines/engine.h"

namespace epode::bench {

class OdeScene {
  public:
    OdeScene(const SceneData& data, const EngineOptions& options);
    ~OdeScene();
    OdeScene(const OdeScene&) = delete;
    OdeScene& operator=(const OdeScene&) = delete;

    const SceneData& data() const { return data_; }
    dWorldID world() const { return world_; }
    dSpaceID space() const { return space_; }
    // Whether contacts between these geoms are wanted at all.
    bool may_touch(dGeomID geom1, dGeomID geom2) const;
    void drive(double time);
    int advance();  // of the world, by dt; 0: the library refused
    void read(State& state) const;
    RayAnswer cast(const std::vector<RayData>& rays);
    // Puts the bodies there; the number of pairs that the space reports.
    int pairs_at(const std::vector<Vec>& places);

  private:
    // What a near callback asks of a body. Pairs come in no order of theirs: it must lie close together.
    struct Kind {
        int group;
        bool dynamic;
    };
    // What geoms point into.
    struct HullArrays {
        std::vector<dReal> planes, points;
        std::vector<unsigned> polygons;
    };
    struct MeshArrays {
        std::vector<dReal> points;
        std::vector<dTriIndex> indices;
        dTriMeshDataID id = nullptr;
    };

    void make_shape_arrays(const ShapeData& shape);
    void make_body(int number);
    void make_part(int number, const PartData& part);
    dGeomID make_geom(int shape);
    void make_joint(const JointData& joint);
    void make_hinge2(const JointData& joint, dJointID made) const;
    dBodyID body(int number) const { return bodies_[size_t(number)]; }

    const SceneData& data_;
    EngineOptions options_;
    dWorldID world_;
    dSpaceID space_;
    std::deque<HullArrays> hulls_;  // by shape
    std::deque<MeshArrays> meshes_;
    std::vector<dBodyID> bodies_;  // null: static
    std::vector<dGeomID> geoms_;   // the first of each body, null: none
    std::vector<Kind> kinds_;      // by body
    std::vector<int> driven_;
    dGeomID ray_ = nullptr;
};

int body_number(dGeomID geom);

}  // namespace epode::bench
