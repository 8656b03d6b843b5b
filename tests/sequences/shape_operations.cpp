// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Operations on geoms, spaces, transforms, height fields, meshes, and collision.
#include "attempt.h"

namespace epode::sequences {
namespace {

constexpr std::size_t kMostGeoms = 60, kMostFields = 4, kMostMeshes = 4;
enum Shape {
    kSphere,
    kBox,
    kCapsule,
    kCylinder,
    kPlane,
    kRay,
    kTransform,
    kConvex,
    kHull,
    kTrimesh,
    kHeightfield,
    kShapes
};
template <typename Function>
constexpr Named<Function*> kNoCallback{"0", nullptr};
constexpr int kFewestPoints = 4;  // of a hull; the first four of the wedge lie in a plane

}  // namespace

Geom* Player::any_space(Dice& dice)
{
    std::vector<Geom*> spaces;
    for (Geom* geom : model.geoms.living())
        if (geom->is_space) spaces.push_back(geom);
    return any(spaces, dice);
}

Geom* Player::any_shape(Dice& dice)
{
    std::vector<Geom*> shapes;
    for (Geom* geom : model.geoms.living())
        if (!geom->is_space) shapes.push_back(geom);
    return any(shapes, dice);
}

void Player::create_geom(Dice& dice)
{
    if (model.geoms.living().size() >= kMostGeoms) return;
    Geom* space = dice.chance(75) ? any_space(dice) : nullptr;
    const int kind = dice.below(kShapes);
    Field* field = any(model.fields.living(), dice);
    const bool placeable = kind != kPlane && !(kind == kHeightfield && dice.chance(30));
    Mesh* mesh = any(model.meshes.living(), dice);
    if ((kind == kHeightfield && !field) || (kind == kTrimesh && !mesh)) return;
    const double x = dice.between(0.1, 1), y = dice.between(0.1, 1), z = dice.between(0.1, 1);
    const AsSpace in{space};
    dGeomID id = nullptr;
    const int number = model.geoms.made();
#define MAKE(function, ...) \
    id = script.make("o", number, "", #function, function, in __VA_OPT__(, ) __VA_ARGS__)
    const bool done = attempt(true, "creation of a geom", [&] {
        switch (kind) {
            case kSphere:
                MAKE(dCreateSphere, x);
                break;
            case kBox:
                MAKE(dCreateBox, x, y, z);
                break;
            case kCapsule:
                MAKE(dCreateCapsule, x, y);
                break;
            case kCylinder:
                MAKE(dCreateCylinder, x, y);
                break;
            case kPlane:
                MAKE(dCreatePlane, 0.0, 0.0, 1.0, x - 0.5);
                break;
            case kRay:
                MAKE(dCreateRay, 5 * x);
                break;
            case kTransform:
                MAKE(dCreateGeomTransform);
                break;
            case kConvex:
                MAKE(create_wedge);
                break;
            case kHull:
                MAKE(create_hull, kFewestPoints + 1 + dice.below(2));
                break;
            case kTrimesh:
                MAKE(dCreateTriMesh, mesh, kNoCallback<dTriCallback>, kNoCallback<dTriArrayCallback>,
                     kNoCallback<dTriRayCallback>);
                break;
            default:
                MAKE(dCreateHeightfield, field, int(placeable));
                break;
        }
    });
#undef MAKE
    if (!done) return;
    if (!id) return fail("no geom");
    Geom& geom = model.born_geom(id, space);
    geom.kind = kind;
    geom.placeable = placeable;
    geom.is_transform = kind == kTransform;
}

void Player::create_space(Dice& dice)
{
    if (model.geoms.living().size() >= kMostGeoms) return;
    Geom* parent = dice.chance(50) ? any_space(dice) : nullptr;
    const AsSpace in{parent};
    const int number = model.geoms.made();
    dSpaceID id = nullptr;
    const bool done = attempt(true, "creation of a space", [&] {
        const auto make = [&](const char* name, auto function, auto... rest) {
            id = script.make("o", number, "(dGeomID)", name, function, in, rest...);
        };
        const Four centre{{0, 0, 0}}, extents{{10, 10, 10}};
        switch (dice.below(4)) {
            case 0:
                make("dSimpleSpaceCreate", dSimpleSpaceCreate);
                break;
            case 1:
                make("dHashSpaceCreate", dHashSpaceCreate);
                break;
            case 2:
                make("dSweepAndPruneSpaceCreate", dSweepAndPruneSpaceCreate, int(dSAP_AXES_XYZ));
                break;
            default:
                make("dQuadTreeSpaceCreate", dQuadTreeSpaceCreate, centre, extents, 3);
                break;
        }
    });
    if (!done) return;
    if (!id) return fail("no space");
    Geom& space = model.born_geom(reinterpret_cast<dGeomID>(id), parent);
    space.is_space = true;
    space.placeable = false;
}

// Puts a geom into a space, takes it out, or moves it from one to another.
void Player::change_space(Dice& dice)
{
    Geom* geom = any(model.geoms.living(), dice);
    Geom* space = any_space(dice);
    if (!geom || !space) return;
    if (geom->space && dice.chance(85)) {
        const AsSpace from{geom->space};
        if (ATTEMPT(true, dSpaceRemove, from, geom)) model.leave(*geom);
        if (dice.chance(30)) return;
    } else if (dice.chance(10)) {
        const bool legal = geom->space == space;
        if (ATTEMPT(legal, dSpaceRemove, AsSpace{space}, geom)) model.leave(*geom);
        return;
    }
    const bool legal = !geom->space && geom->holders.empty() && !Model::inside(*space, *geom);
    if (ATTEMPT(legal, dSpaceAdd, AsSpace{space}, geom)) model.join(*geom, *space);
}

void Player::tune_space(Dice& dice)
{
    Geom* space = any_space(dice);
    if (!space) return;
    const AsSpace s{space};
    switch (dice.below(4)) {
        case 0: {
            const bool on = dice.chance(50);
            if (ATTEMPT(true, dSpaceSetCleanup, s, int(on))) space->cleanup = on;
            break;
        }
        case 1:
            ATTEMPT(true, dSpaceSetSublevel, s, dice.below(3));
            break;
        case 2:
            ATTEMPT(true, dSpaceClean, s);
            break;
        default:
            ATTEMPT(false, dSpaceGetGeom, s, dice.chance(50) ? -1 : int(space->members.size()));
            break;
    }
}

void Player::set_geom_body(Dice& dice)
{
    Geom* geom = any(model.geoms.living(), dice);
    if (!geom) return;
    Body* body = dice.chance(80) ? any(model.bodies.living(), dice) : nullptr;
    const bool legal = !body || (geom->placeable && geom->holders.empty());
    if (ATTEMPT(legal, dGeomSetBody, geom, body) && geom->placeable) model.set_body(*geom, body);
}

void Player::place_geom(Dice& dice)
{
    Geom* geom = any_shape(dice);
    if (!geom) return;
    const double x = dice.between(-2, 2), y = dice.between(-2, 2), z = dice.between(-0.5, 3);
    const Four q{{dReal(x), dReal(y), dReal(z), dReal(0.4)}};
    if (dice.chance(60))
        ATTEMPT(geom->placeable, dGeomSetPosition, geom, x, y, z);
    else if (geom->kind == kRay && dice.chance(50))
        ATTEMPT(true, dGeomRaySet, geom, x, y, z, 0.1, y, -1.0);
    else
        ATTEMPT(geom->placeable, dGeomSetQuaternion, geom, q);
}

void Player::tune_geom(Dice& dice)
{
    Geom* geom = any(model.geoms.living(), dice);
    if (!geom) return;
    const double x = dice.between(0.05, 1), y = dice.between(0.05, 1), z = dice.between(0.05, 1);
    const bool shape = !geom->is_space;
    const bool convex = geom->kind == kConvex || geom->kind == kHull;
    switch (dice.below(7)) {
        case 0:
            ATTEMPT(true, dGeomEnable, geom);
            break;
        case 1:
            ATTEMPT(true, dGeomDisable, geom);
            break;
        case 2:
            ATTEMPT(true, dGeomSetCategoryBits, geom, (unsigned long)dice.below(8));
            break;
        case 3:
            ATTEMPT(true, dGeomSetCollideBits, geom, ~0ul);
            break;
        case 4:
            ATTEMPT(shape && geom->kind == kBox, dGeomBoxSetLengths, geom, x, y, z);
            break;
        case 5: {
            const int points = kFewestPoints + dice.below(3);
            ATTEMPT(shape && convex && points > kFewestPoints, set_hull, geom, points);
            break;
        }
        default:
            ATTEMPT(shape && geom->kind == kSphere, dGeomSphereSetRadius, geom, x);
            break;
    }
}

void Player::offset_geom(Dice& dice)
{
    Geom* geom = any_shape(dice);
    if (!geom) return;
    const double x = dice.between(-0.5, 0.5), y = dice.between(-0.5, 0.5), z = dice.between(-0.5, 0.5);
    const Four q{{dReal(x), dReal(y), dReal(z), dReal(0.4)}};
    const bool legal = geom->placeable && geom->body;
    switch (dice.below(5)) {
        case 0:
            ATTEMPT(legal, dGeomSetOffsetPosition, geom, x, y, z);
            break;
        case 1:
            ATTEMPT(legal, dGeomSetOffsetQuaternion, geom, q);
            break;
        case 2:
            ATTEMPT(legal, dGeomSetOffsetWorldPosition, geom, x, y, z);
            break;
        case 3:
            ATTEMPT(legal, dGeomSetOffsetWorldQuaternion, geom, q);
            break;
        default:
            ATTEMPT(geom->placeable, dGeomClearOffset, geom);
            break;
    }
}

void Player::hold_geom(Dice& dice)
{
    std::vector<Geom*> transforms;
    for (Geom* geom : model.geoms.living())
        if (geom->is_transform) transforms.push_back(geom);
    Geom* transform = any(transforms, dice);
    if (!transform) return;
    if (dice.chance(30)) {
        const bool on = dice.chance(50);
        if (ATTEMPT(true, dGeomTransformSetCleanup, transform, int(on))) transform->inner_cleanup = on;
        return;
    }
    if (dice.chance(20)) {
        ATTEMPT(true, dGeomTransformSetInfo, transform, dice.below(2));
        return;
    }
    Geom* inner = dice.chance(85) ? any(model.geoms.living(), dice) : nullptr;
    // A geom that would die with the one that is let go cannot be taken in the same call.
    bool goes = false;
    if (Geom* old = transform->inner; old && old != inner && transform->inner_cleanup)
        for (Geom* g = old; g; g = g->inner_cleanup ? g->inner : nullptr) goes = goes || g == inner;
    const bool legal =
        !inner || inner == transform->inner ||
        (inner->placeable && !inner->space && !inner->body && !goes && !Model::holds(*inner, *transform));
    if (ATTEMPT(legal, dGeomTransformSetGeom, transform, inner)) model.hold(*transform, inner);
}

void Player::destroy_geom(Dice& dice)
{
    Geom* geom = any(model.geoms.living(), dice);
    if (!geom || (geom->is_space && dice.chance(60))) return;
    if (geom->is_space && dice.chance(50)) {
        if (ATTEMPT(true, dSpaceDestroy, AsSpace{geom})) model.kill(*geom);
    } else {
        if (ATTEMPT(true, dGeomDestroy, geom)) model.kill(*geom);
    }
}

void Player::use_field(Dice& dice)
{
    Field* field = any(model.fields.living(), dice);
    if (!field || (dice.chance(30) && model.fields.living().size() < kMostFields)) {
        const dHeightfieldDataID id = script.make("f", model.fields.made(), "", "dGeomHeightfieldDataCreate",
                                                  dGeomHeightfieldDataCreate);
        if (!id) return fail("no height field data");
        field = &model.fields.add(id);
        ATTEMPT(true, build_heights, field, dice.below(2), dice.between(1, 8), dice.below(2));
    } else if (dice.chance(30)) {
        if (ATTEMPT(true, dGeomHeightfieldDataDestroy, field)) model.fields.bury(*field);
    } else {
        Geom* geom = any_shape(dice);
        if (geom) ATTEMPT(geom->kind == kHeightfield, dGeomHeightfieldSetHeightfieldData, geom, field);
    }
}

void Player::use_mesh(Dice& dice)
{
    Mesh* mesh = any(model.meshes.living(), dice);
    if (!mesh || (dice.chance(30) && model.meshes.living().size() < kMostMeshes)) {
        const dTriMeshDataID id =
            script.make("m", model.meshes.made(), "", "dGeomTriMeshDataCreate", dGeomTriMeshDataCreate);
        if (!id) return fail("no mesh data");
        mesh = &model.meshes.add(id);
        if (dice.chance(80)) mesh->built = ATTEMPT(true, build_mesh, mesh, dice.below(kMeshes));
    } else if (dice.chance(25)) {
        if (ATTEMPT(true, dGeomTriMeshDataDestroy, mesh)) model.meshes.bury(*mesh);
    } else if (dice.chance(30)) {
        mesh->built = ATTEMPT(true, build_mesh, mesh, dice.below(kMeshes)) || mesh->built;
    } else if (dice.chance(50)) {
        CALL(move_corner, dice.below(kMeshes), dice.below(kCorners), dice.between(-1, 3), dice.between(-1, 3),
             dice.between(-1, 3));
        ATTEMPT(mesh->built, dGeomTriMeshDataUpdate, mesh);
    } else {
        Geom* geom = any_shape(dice);
        if (geom) ATTEMPT(geom->kind == kTrimesh, dGeomTriMeshSetData, geom, mesh);
    }
}

// ---- collision ----

void Player::collide(Dice& dice)
{
    Geom* a = dice.chance(90) ? any_space(dice) : any(model.geoms.living(), dice);
    Geom* b = any(model.geoms.living(), dice);
    if (!a || !b) return;
    Dice inner(dice.next());
    Dice* const outer_dice = near_dice_;
    World* const outer_world = near_world_;
    Group* const outer_group = near_group_;
    near_dice_ = &inner;
    near_world_ = any(model.worlds.living(), dice);
    near_group_ = any(model.groups.living(), dice);
    const Named<void*> data{"0", this};
    const Named<dNearCallback*> callback{"near", &near_c};
    if (a->is_space && dice.chance(70))
        ATTEMPT(true, dSpaceCollide, AsSpace{a}, data, callback);
    else
        ATTEMPT(true, dSpaceCollide2, a, b, data, callback);
    near_dice_ = outer_dice;
    near_world_ = outer_world;
    near_group_ = outer_group;
}

void Player::collide_two(Dice& dice)
{
    Geom* a = any(model.geoms.living(), dice);
    Geom* b = any(model.geoms.living(), dice);
    World* world = any(model.worlds.living(), dice);
    if (!a || !b || !world || model.joints.living().size() > 150) return;
    Group* group = any(model.groups.living(), dice);
    CALL(meet, world, group, a, b, 1 + dice.below(8), int(dContactApprox1));
    adopt_contacts(*world, group);
}

}  // namespace epode::sequences
