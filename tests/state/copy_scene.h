// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a Scene lacks and a copy of a world must have: geoms of every class, shared meshes and height fields,
// nested spaces, transforms, offsets, materials, filter bits, drives, breaking limits, couplings, contact
// joints between steps. And copies, which clean up after themselves.
#pragma once

#include "scene.h"

namespace epode::states {

class RichScene : public Scene {
  public:
    explicit RichScene(const Setting& setting);
    ~RichScene();

    dGeomID sensor = nullptr;

  private:
    void add_solid(dGeomID geom, int i);
    void add_solids();
    void add_surfaces();
    void add_spaces();
    void add_drives();

    dJointGroupID group_ = dJointGroupCreate(0);
    unsigned char heights_[81];
    dTriMeshDataID block_ = nullptr;
    dHeightfieldDataID hills_ = nullptr, waves_ = nullptr;
};

// A copy of a scene's world, with its space.
class Copy {
  public:
    static Copy cloned(const Scene& scene);
    static Copy loaded(const Scene& scene);  // from memory
    Copy(const Scene& scene, dWorldID world, dSpaceID space, bool owns_meshes);
    Copy(Copy&& other) noexcept;
    ~Copy();
    Running running;

  private:
    bool owns_meshes_;
};

// As dWorldExportDIF writes it.
std::string text_of(dWorldID world);

Bytes file_of(dWorldID world, dSpaceID space);

}  // namespace epode::states
