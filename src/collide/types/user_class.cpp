// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// User classes: registration, geoms, and the bridge from GeomType's functions to the program's.
#include "collide/user_class.h"
#include "collide/describe.h"

#include <atomic>
#include <cstring>
#include <mutex>

#include "base/float_environment.h"
#include "base/objects/lifecycle.h"
#include "collide/types/registry.h"

namespace epode {
namespace {

constexpr int kMaxClasses = dLastUserClass - dFirstUserClass + 1;

struct UserClasses {
    SpinLock lock;
    int count = 0;
    std::atomic<int> generation{0};
    dGeomClass descriptions[kMaxClasses] = {};
};

UserClasses g_classes;

void forget_classes()
{
    std::lock_guard guard(g_classes.lock);
    g_classes.count = 0;
    ++g_classes.generation;
}

void to_bounds(const Aabb& box, Real out[6])
{
    for (int i = 0; i < 3; ++i) out[2 * i] = box.lo[i], out[2 * i + 1] = box.hi[i];
}

// Holds a geom while its box is made. If that is left, the box has to be made later.
class BoxHold {
  public:
    explicit BoxHold(Geom& geom) : guard_(leave, &geom), geom_(geom) { geom.users.fetch_add(1); }
    ~BoxHold()
    {
        if (guard_.end()) geom_.users.fetch_sub(1);
    }

  private:
    static void leave(void* id, const void*, std::size_t)
    {
        Geom& geom = *static_cast<Geom*>(id);
        geom.users.fetch_sub(1);
        mark_stepped(geom);
    }

    CallGuard guard_;
    Geom& geom_;
};

Aabb aabb(Geom& geom)
{
    Real b[6] = {};
    const BoxHold hold(geom);
    const CallerFloatEnvironment program;
    static_cast<UserGeom&>(geom).functions.aabb(to_handle(&geom), b);
    return {{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
}

bool may_touch(Geom& geom, Geom& other)
{
    const auto test = static_cast<UserGeom&>(geom).functions.aabb_test;
    if (!test) return true;
    const GeomHold hold_geom(geom), hold_other(other);
    Real bounds[6];
    to_bounds(box_of(other), bounds);
    const CallerFloatEnvironment program;
    return test(to_handle(&geom), to_handle(&other), bounds) != 0;
}

void farewell(Geom& geom)
{
    const auto dtor = static_cast<UserGeom&>(geom).functions.dtor;
    if (dtor) dtor(to_handle(&geom));
}

void destroy(Geom* geom)
{
    UserGeom* user = static_cast<UserGeom*>(geom);
    release(user->memory, std::size_t(user->functions.bytes));
    Pool<UserGeom>::destroy(user);
}

void describe_user(const Geom&, DifWriter& out) { out.text("type", "user"); }

constexpr GeomType type_of(int index)
{
    return {.number = dFirstUserClass + index,
            .aabb = aabb,
            .destroy = destroy,
            .farewell = farewell,
            .may_touch = may_touch,
            .describe = describe_user};
}

constexpr GeomType kUserTypes[] = {type_of(0), type_of(1), type_of(2), type_of(3)};
static_assert(std::size(kUserTypes) == kMaxClasses);

// -1 when all numbers are taken.
int add_class(const dGeomClass& description)
{
    std::lock_guard guard(g_classes.lock);
    if (g_classes.count == kMaxClasses) return -1;
    g_classes.descriptions[g_classes.count] = description;
    return dFirstUserClass + g_classes.count++;
}

UserGeom* create_user_geom(int number)
{
    const dGeomClass description = *user_description(number);
    UserGeom* geom = Pool<UserGeom>::create(*user_type(number), description);
    if (!geom) return nullptr;
    const std::size_t bytes = std::size_t(description.bytes);
    geom->memory = allocate(bytes);
    if (!geom->memory) {
        Pool<UserGeom>::destroy(geom);
        return nullptr;
    }
    std::memset(geom->memory, 0, bytes);
    geom->generation = g_classes.generation;
    return geom;
}

}  // namespace

bool is_forgotten(const Geom& geom)
{
    return is_user_class(geom.type->number) && static_cast<const UserGeom&>(geom).generation !=
                                                   g_classes.generation.load(std::memory_order_relaxed);
}

const GeomType* user_type(int number)
{
    return user_description(number) ? &kUserTypes[number - dFirstUserClass] : nullptr;
}

const dGeomClass* user_description(int number)
{
    std::lock_guard guard(g_classes.lock);
    if (!is_user_class(number)) return nullptr;
    const int index = number - dFirstUserClass;
    return index < g_classes.count ? &g_classes.descriptions[index] : nullptr;
}

}  // namespace epode

using namespace epode;

extern "C" int dCreateGeomClass(const dGeomClass* classptr)
{
    EPODE_USER_SAY(classptr && classptr->bytes >= 0 && classptr->collider && classptr->aabb, "bad geom class",
                   -1);
    EPODE_USER(on_last_close(forget_classes), -1);
    const int number = add_class(*classptr);
    EPODE_USER_SAY(number >= 0, "too many user classes", -1);
    return number;
}

extern "C" dGeomID dCreateGeom(int classnum)
{
    EPODE_USER_SAY(user_type(classnum), "not a custom class", nullptr);
    const UserGeom* geom = create_user_geom(classnum);
    EPODE_USER_SAY(geom, kOutOfMemory, nullptr);
    return to_handle<Geom>(geom);
}

extern "C" void* dGeomGetClassData(dGeomID id)
{
    EPODE_GEOM(geom, id, nullptr);
    EPODE_USER_SAY(is_user_class(geom->type->number), "not a custom class", nullptr);
    return static_cast<UserGeom*>(geom)->memory;
}
