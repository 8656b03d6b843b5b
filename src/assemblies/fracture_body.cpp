// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "assemblies/fracture_body.h"

#include "collide/types/registry.h"
#include "dynamics/body.h"
#include "ode/impulses.h"
#include "ode/ode.h"

namespace epode {
namespace {

constexpr int kElsewhere = -1;  // the group of parts that are not on the body
constexpr const char* kNoMass = "a part that encloses no volume, or whose mass is no rigid body's";

// What the parts of one group are together.
struct Piece {
    dBodyID body;
    Pose frame;  // of the mass: at its centre
    MassProperties mass;
    int parts;
};

// Where the group's body is to be: one part keeps its own axes, several have those of `frame`.
bool measure(Parts parts, std::span<const int> group_of, int group, const Pose& frame, Piece& out)
{
    out = {nullptr, frame, {}, 0};
    for (std::size_t i = 0; i < parts.size(); ++i)
        if (group_of[i] == group && ++out.parts == 1) out.frame = pose_of_part(parts[i]);
    if (out.parts > 1) out.frame = frame;
    out.mass = mass_of_group(parts, group_of, group, out.frame);
    if (!(out.mass.mass > 0)) return false;
    out.frame.p = out.frame.to_world(out.mass.center);
    out.mass = translated(out.mass, -out.mass.center);
    out.mass.center = {};
    return usable(out.mass) && usable(&out.frame.p.x, 3) && mass_fault(out.mass) == MassFault::kNone;
}

bool create(dWorldID world, Piece& piece)
{
    piece.body = dBodyCreate(world);
    if (!piece.body) return false;
    dMass mass{};
    put_mass(&mass, piece.mass);
    dMatrix3 R;
    store_mat(R, piece.frame.R);
    dBodySetMass(piece.body, &mass);
    dBodySetRotation(piece.body, R);
    dBodySetPosition(piece.body, piece.frame.p.x, piece.frame.p.y, piece.frame.p.z);
    return true;
}

// The geom stays where it is.
void hand_over(const dFracturePart& part, dBodyID body)
{
    const Pose at = pose_of_part(part);
    dMatrix3 R;
    store_mat(R, at.R);
    dGeomSetBody(part.geom, body);
    dGeomSetOffsetWorldPosition(part.geom, at.p.x, at.p.y, at.p.z);
    dGeomSetOffsetWorldRotation(part.geom, R);
}

void copy_settings(dBodyID from, dBodyID to)
{
    dBodySetData(to, dBodyGetData(from));
    dBodySetGravityMode(to, dBodyGetGravityMode(from));
    dBodySetGyroscopicMode(to, dBodyGetGyroscopicMode(from));
    dBodySetFiniteRotationMode(to, dBodyGetFiniteRotationMode(from));
    dBodySetMaxAngularSpeed(to, dBodyGetMaxAngularSpeed(from));
    dBodySetDamping(to, dBodyGetLinearDamping(from), dBodyGetAngularDamping(from));
    dBodySetLinearDampingThreshold(to, dBodyGetLinearDampingThreshold(from));
    dBodySetAngularDampingThreshold(to, dBodyGetAngularDampingThreshold(from));
    dBodySetAutoDisableFlag(to, dBodyGetAutoDisableFlag(from));
    dBodySetAutoDisableLinearThreshold(to, dBodyGetAutoDisableLinearThreshold(from));
    dBodySetAutoDisableAngularThreshold(to, dBodyGetAutoDisableAngularThreshold(from));
    dBodySetAutoDisableSteps(to, dBodyGetAutoDisableSteps(from));
    dBodySetAutoDisableTime(to, dBodyGetAutoDisableTime(from));
    dBodySetAutoDisableAverageSamplesCount(to, unsigned(dBodyGetAutoDisableAverageSamplesCount(from)));
}

void go_on(dBodyID whole, const Piece& piece)
{
    copy_settings(whole, piece.body);
    const Vec3 w = load(dBodyGetAngularVel(whole)), r = piece.frame.p - load(dBodyGetPosition(whole));
    const Vec3 v = load(dBodyGetLinearVel(whole)) + cross(w, r);
    dVector3 linear, angular;
    store(linear, v), store(angular, w);
    dBodySetVelocities(piece.body, linear, angular, 1);
    if (dBodyIsKinematic(whole) && piece.parts > 1) dBodySetKinematic(piece.body);
}

// A list of parts on their way from one body to several.
class Swap {
  public:
    explicit Swap(Parts parts) : parts_(parts) {}

    // Null, or what is wrong; pieces() then says what it becomes, if more than one.
    const char* prepare_break(dBodyID whole, const Break& how)
    {
        if (!group_of_.resize(int(parts_.size())) || !rest_.reserve(int(parts_.size()))) return kOutOfMemory;
        if (!all_geoms_are_parts(whole)) return kStrangers;
        if (!choose(whole, how)) return kOutOfMemory;
        groups_ = group_touching(parts_, rest_.span(), groups_, group_of_.span());
        return groups_ > 1 ? measure_all({load(dBodyGetPosition(whole)), load_mat(dBodyGetRotation(whole))})
                           : nullptr;
    }
    const char* prepare_whole()
    {
        if (!group_of_.resize(int(parts_.size()))) return kOutOfMemory;
        groups_ = 1;
        return measure_all({});
    }

    int groups() const { return groups_; }
    dBodyID body(int group) const { return pieces_[group].body; }
    const Piece& piece(int group) const { return pieces_[group]; }

    // False: out of memory, with nothing changed.
    bool create_bodies(dWorldID world)
    {
        for (int i = 0; i < groups_; ++i) {
            if (create(world, pieces_[i])) continue;
            while (i-- > 0) dBodyDestroy(pieces_[i].body);
            return false;
        }
        return true;
    }
    void hand_geoms_over() const
    {
        for (std::size_t i = 0; i < parts_.size(); ++i)
            if (const int group = group_of_[int(i)]; group != kElsewhere)
                hand_over(parts_[i], pieces_[group].body);
    }

  private:
    bool all_geoms_are_parts(dBodyID whole) const
    {
        int on_body = 0;
        for (const dFracturePart& part : parts_) on_body += dGeomGetBody(part.geom) == whole;
        for (dGeomID geom = dBodyGetFirstGeom(whole); geom; geom = dBodyGetNextGeom(geom)) --on_body;
        return on_body == 0;
    }

    // What comes off gets groups of its own; the rest is listed.
    bool choose(dBodyID whole, const Break& how)
    {
        bool found = true;
        for (int i = 0; i < group_of_.size(); ++i) {
            const dFracturePart& part = parts_[std::size_t(i)];
            group_of_[i] = kElsewhere;
            if (dGeomGetBody(part.geom) != whole) continue;
            if (i == how.struck || is_near(part, how.place, how.radius, found))
                group_of_[i] = groups_++;
            else
                found = rest_.push(i) && found;
        }
        return found;
    }

    const char* measure_all(const Pose& frame)
    {
        if (!pieces_.resize(groups_)) return kOutOfMemory;
        for (int i = 0; i < groups_; ++i)
            if (!measure(parts_, group_of_.span(), i, frame, pieces_[i])) return kNoMass;
        return nullptr;
    }

    Parts parts_;
    int groups_ = 0;
    Array<int> group_of_, rest_;
    Array<Piece> pieces_;
};

}  // namespace

dBodyID unite_parts(dWorldID world, Parts parts, const char** fault)
{
    Swap swap(parts);
    if ((*fault = swap.prepare_whole())) return nullptr;
    if (!swap.create_bodies(world)) return *fault = kOutOfMemory, nullptr;
    swap.hand_geoms_over();
    return swap.body(0);
}

int break_body(Parts parts, dBodyID body, const Break& how, const char** fault)
{
    Swap swap(parts);
    if ((*fault = swap.prepare_break(body, how)) || swap.groups() < 2) return 0;
    if (!swap.create_bodies(dBodyGetWorld(body))) return *fault = kOutOfMemory, 0;
    for (int i = 0; i < swap.groups(); ++i) go_on(body, swap.piece(i));
    swap.hand_geoms_over();
    dBodyDestroy(body);
    return swap.groups();
}

}  // namespace epode
