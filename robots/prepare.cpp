// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is made once for all worlds of a model: see build.h.
#include <ode/ext.h>

#include <algorithm>
#include <set>

#include "robots/build.h"

namespace epode::robots {

namespace {

constexpr unsigned kMaxHullVertices = 256;

std::vector<dReal> reals_of(const std::vector<Vec>& points)
{
    std::vector<dReal> out;
    for (Vec p : points) out.insert(out.end(), {dReal(p.x), dReal(p.y), dReal(p.z)});
    return out;
}

}  // namespace

// Where no length is stated springs rest where those of the joints do.
void Prepared::make_rests()
{
    if (model_.tendons.empty() || model_.has_errors()) return;
    std::vector<double> positions = reference_positions(model_);
    for (const Joint& joint : model_.joints)
        if (joint.is_scalar()) positions[size_t(joint.position)] = joint.spring_reference;
    const std::vector<double> lengths = tendon_lengths(model_, positions);
    for (size_t i = 0; i < lengths.size(); ++i) {
        const Tendon& its = model_.tendons[i];
        rests_.push_back(its.has_rest ? std::array{its.rest, its.rest_high}
                                      : std::array{lengths[i], lengths[i]});
    }
}

void Prepared::list_actuators()
{
    joint_actuators_.resize(model_.joints.size()), tendon_actuators_.resize(model_.tendons.size());
    if (model_.has_errors()) return;
    for (size_t i = 0; i < model_.actuators.size(); ++i) {
        const Actuator& its = model_.actuators[i];
        if (its.joint >= 0) joint_actuators_[size_t(its.joint)].push_back(int(i));
        if (its.tendon >= 0) tendon_actuators_[size_t(its.tendon)].push_back(int(i));
    }
}

Prepared::Prepared(RobotModel model)
    : model_(std::move(model)),
      springs_(model_),
      pairs_(model_),
      hulls_(model_.meshes.size()),
      triangles_(model_.meshes.size(), nullptr),
      corners_(model_.meshes.size()),
      indices_(model_.meshes.size())
{
    make_heights();
    make_rests();
    list_actuators();
    std::set<int> known;
    const auto prepare = [&](const Shape& shape, bool touches) {
        if (shape.mesh < 0 || !known.insert(shape.mesh).second) return;
        if (shape.kind == ShapeKind::kTriangles)
            make_triangles(size_t(shape.mesh));
        else if (touches)
            make_hulls(shape.mesh);
        else if (Hull hull = hull_of(model_.meshes[size_t(shape.mesh)].vertices, kMaxHullVertices);
                 !hull.is_empty())
            hulls_[size_t(shape.mesh)].push_back(std::move(hull));
    };
    for (const Link& link : model_.links)
        for (const Shape& shape : link.shapes) prepare(shape, true);
    for (const Link& link : model_.links)
        for (const Shape& look : link.visuals)
            if (link.shapes.empty()) prepare(look, false);
    if (!model_.has_errors()) find_overlapping();
}

Prepared::~Prepared()
{
    for (dTriMeshDataID data : triangles_)
        if (data) dGeomTriMeshDataDestroy(data);
    for (dHeightfieldDataID data : heights_)
        if (data) dGeomHeightfieldDataDestroy(data);
}

// Plates and lines have none.
void Prepared::make_hulls(int number)
{
    const Mesh& mesh = model_.meshes[size_t(number)];
    std::vector<Hull>& hulls = hulls_[size_t(number)];
    Decomposition parts;
    std::string problem;
    if (model_.decomposes_meshes && decompose(mesh, model_.parts, parts, problem)) {
        fits_.push_back({number, int(parts.hulls.size()), parts.surplus, parts.tolerance, parts.is_closed});
        hulls = std::move(parts.hulls);
    } else if (Hull hull = hull_of(mesh.vertices, kMaxHullVertices); !hull.is_empty()) {
        hulls.push_back(std::move(hull));
    }
}

void Prepared::make_triangles(size_t number)
{
    const Mesh& mesh = model_.meshes[number];
    corners_[number] = reals_of(mesh.vertices);
    for (const auto& t : mesh.triangles)
        for (std::uint32_t corner : t) indices_[number].push_back(dTriIndex(corner));
    triangles_[number] = dGeomTriMeshDataCreate();
    if (!triangles_[number]) return;
    constexpr int kReal = int(sizeof(dReal));
    const auto build = kReal == 8 ? &dGeomTriMeshDataBuildDouble : &dGeomTriMeshDataBuildSingle;
    build(triangles_[number], corners_[number].data(), 3 * kReal, int(mesh.vertices.size()),
          indices_[number].data(), int(indices_[number].size()), int(3 * sizeof(dTriIndex)));
}

// ODE's fields run from the largest y down.
void Prepared::make_heights()
{
    for (const HeightField& field : model_.fields) {
        std::vector<double> samples;
        for (int row = field.rows; row-- > 0;) {
            const double* const its = &field.samples[size_t(row) * size_t(field.columns)];
            samples.insert(samples.end(), its, its + field.columns);
        }
        const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
        if (data)
            dGeomHeightfieldDataBuildDouble(data, samples.data(), 1, dReal(2 * field.half_x),
                                            dReal(2 * field.half_y), field.columns, field.rows,
                                            dReal(field.top), 0, dReal(field.base), 0);
        heights_.push_back(data);
    }
}

}  // namespace epode::robots
