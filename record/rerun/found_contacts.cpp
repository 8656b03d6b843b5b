// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See found_contacts.h.
#include "record/rerun/found_contacts.h"

#include <algorithm>

#include "record/watch/lookup.h"

namespace epode::record {

namespace {

using CreateHull = dGeomID (*)(dSpaceID, const dReal*, unsigned, unsigned);

constexpr int kMostContacts = 64;

}  // namespace

FoundContacts::FoundContacts(const Recording& was, dWorldID world)
    : was_(was), world_(world), space_(dHashSpaceCreate(nullptr)), group_(dJointGroupCreate(0))
{
    for (const Step& step : was.steps) {
        std::map<Pair, int> count;
        for (const Contact& contact : step.contacts)
            max_contacts_ = std::max(max_contacts_, ++count[pair_of(contact.geom[0], contact.geom[1])]);
    }
    max_contacts_ = std::min(max_contacts_, kMostContacts);
}

FoundContacts::~FoundContacts()
{
    dJointGroupDestroy(group_);
    dSpaceDestroy(space_);
    for (dTriMeshDataID mesh : meshes_) dGeomTriMeshDataDestroy(mesh);
}

void FoundContacts::learn(const Step& step, const std::vector<dSurfaceParameters>& surfaces)
{
    // Contacts and surfaces are the same calls; where a program destroyed some, there is no telling which.
    if (step.contacts.size() != surfaces.size()) return;
    for (size_t i = 0; i < surfaces.size(); ++i) {
        const std::uint32_t a = step.contacts[i].geom[0], b = step.contacts[i].geom[1];
        if (a == kNoGeom || b == kNoGeom) continue;
        pairs_[pair_of(a, b)] = last_[a] = last_[b] = surfaces[i];
    }
}

// A convex form by its hull where the library makes hulls, else by its triangles as meshes and height fields
// are.
dGeomID FoundContacts::create_surface(const Shape& shape)
{
    if (shape.vertices.empty()) return nullptr;
    Triangles& kept = *triangles_.emplace_back(std::make_unique<Triangles>());
    for (const auto& vertex : shape.vertices)
        kept.vertices.insert(kept.vertices.end(), vertex.begin(), vertex.end());
    if (shape.kind == ShapeKind::kConvex) {
        static const auto hull = reinterpret_cast<CreateHull>(library_function("dCreateConvexHull"));
        const std::vector<dReal> points(kept.vertices.begin(), kept.vertices.end());
        dGeomID geom = hull ? hull(space_, points.data(), unsigned(shape.vertices.size()), 0) : nullptr;
        if (geom) return geom;
    }
    for (const auto& triangle : shape.triangles)
        kept.corners.insert(kept.corners.end(), triangle.begin(), triangle.end());
    if (kept.corners.empty()) return nullptr;
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, kept.vertices.data(), 3 * sizeof(double), int(shape.vertices.size()),
                                kept.corners.data(), int(kept.corners.size()), 3 * sizeof(dTriIndex));
    meshes_.push_back(data);
    return dCreateTriMesh(space_, data, nullptr, nullptr, nullptr);
}

dGeomID FoundContacts::create(const Shape& shape)
{
    const auto size = [&](size_t i) { return dReal(shape.size[i]); };
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return dCreateSphere(space_, size(0));
        case ShapeKind::kBox:
            return dCreateBox(space_, size(0), size(1), size(2));
        case ShapeKind::kCapsule:
            return dCreateCapsule(space_, size(0), size(1));
        case ShapeKind::kCylinder:
            return dCreateCylinder(space_, size(0), size(1));
        case ShapeKind::kPlane:
            return dCreatePlane(space_, size(0), size(1), size(2), size(3));
        case ShapeKind::kConvex:
        case ShapeKind::kMesh:
        case ShapeKind::kHeightField:
            return create_surface(shape);
        default:
            return nullptr;
    }
}

void FoundContacts::place(std::uint32_t number, std::int32_t body, const Pose& pose,
                          const std::vector<dBodyID>& bodies)
{
    dGeomID geom = geoms_[number];
    if (!geom || dGeomGetClass(geom) == dPlaneClass) return;
    const dQuaternion turn = {dReal(pose.turn[0]), dReal(pose.turn[1]), dReal(pose.turn[2]),
                              dReal(pose.turn[3])};
    const dReal x = dReal(pose.pos[0]), y = dReal(pose.pos[1]), z = dReal(pose.pos[2]);
    dBodyID on = body == kNobody ? nullptr : bodies[size_t(body)];
    dGeomSetBody(geom, on);
    if (!on) {
        dGeomSetPosition(geom, x, y, z);
        dGeomSetQuaternion(geom, turn);
    } else if (pose != Pose()) {
        dGeomSetOffsetPosition(geom, x, y, z);
        dGeomSetOffsetQuaternion(geom, turn);
    }
}

// What lives, and where, in the state before `state`: the one that its step begins with. In the first, what
// the state has itself.
void FoundContacts::bring_up_to_date(size_t state, const std::vector<dBodyID>& bodies)
{
    const auto is_there = [&](std::int32_t body) { return body == kNobody || size_t(body) < bodies.size(); };
    for (; next_geom_ < was_.geoms.size() && was_.geom_lives[next_geom_].born <= state; ++next_geom_) {
        const Geom& geom = was_.geoms[next_geom_];
        if (!is_there(geom.body)) break;
        geoms_.push_back(create(was_.shapes[geom.shape]));
        if (geoms_.back()) numbers_[geoms_.back()] = std::uint32_t(next_geom_);
        place(std::uint32_t(next_geom_), geom.body, geom.pose, bodies);
    }
    for (; next_move_ < was_.moves.size() && was_.moves[next_move_].step <= state; ++next_move_) {
        const Move& move = was_.moves[next_move_];
        if (move.geom < geoms_.size() && is_there(move.body)) place(move.geom, move.body, move.pose, bodies);
    }
    for (size_t i = 0; i < geoms_.size(); ++i) {
        const bool dead = was_.geom_lives[i].died <= state;
        if (!geoms_[i] || !dead) continue;
        numbers_.erase(geoms_[i]);
        dGeomDestroy(geoms_[i]);
        geoms_[i] = nullptr;
    }
}

const dSurfaceParameters* FoundContacts::surface_of(std::uint32_t a, std::uint32_t b) const
{
    const auto pair = pairs_.find(pair_of(a, b));
    if (pair != pairs_.end()) return &pair->second;
    const auto first = last_.find(a), second = last_.find(b);
    return first == last_.end() || second == last_.end() ? nullptr : &first->second;
}

void FoundContacts::near(void* self, dGeomID a, dGeomID b)
{
    static_cast<FoundContacts*>(self)->collide(a, b);
}

void FoundContacts::collide(dGeomID a, dGeomID b)
{
    dBodyID body_a = dGeomGetBody(a), body_b = dGeomGetBody(b);
    if (body_a == body_b) return;
    const std::uint32_t number_a = numbers_.at(a), number_b = numbers_.at(b);
    const dSurfaceParameters* surface = surface_of(number_a, number_b);
    if (!surface) return;
    const bool seen = pairs_.contains(pair_of(number_a, number_b));
    if (!seen && body_a && body_b && dAreConnectedExcluding(body_a, body_b, dJointTypeContact)) return;
    dContactGeom found[kMostContacts];
    const int count = dCollide(a, b, max_contacts_, found, sizeof(dContactGeom));
    for (int i = 0; i < count; ++i) {
        dContact contact{};
        contact.surface = *surface;
        contact.surface.mode &= ~dContactFDir1;  // it was the other contact's
        contact.geom = found[i];
        dJointAttach(dJointCreateContact(world_, group_, &contact), body_a, body_b);
        Contact& kept = made_.emplace_back();
        kept.geom[0] = numbers_.at(found[i].g1);
        kept.geom[1] = numbers_.at(found[i].g2);
        for (int k = 0; k < 3; ++k)
            kept.pos[k] = float(found[i].pos[k]), kept.normal[k] = float(found[i].normal[k]);
        kept.depth = float(found[i].depth);
    }
}

void FoundContacts::make(size_t state, const std::vector<dBodyID>& bodies)
{
    bring_up_to_date(state, bodies);
    dSpaceCollide(space_, this, &near);
}

std::vector<Contact> FoundContacts::take()
{
    dJointGroupEmpty(group_);
    std::vector<Contact> made;
    made.swap(made_);
    return made;
}

}  // namespace epode::record
