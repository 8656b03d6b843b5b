// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The dispatcher. Convex solids collide with each other, planes, rays, meshes and height fields by their
// views (solid_pairs.h); pairs.inc replaces that where a special function is better. Pair functions are pure;
// a thunk made from each line of pairs.inc takes the shapes out of the geoms. The geom in a transform is
// never moved: its pose is an argument (only functions of the program, which read the pose from the geom, see
// it placed during the call). If a function serves a pair in the other order, normals are negated and g1 with
// g2, side1 with side2 exchanged.
#include "collide/collide.h"

#include <algorithm>
#include <atomic>
#include <type_traits>
#include <utility>

#include "base/float_environment.h"
#include "base/objects/lifecycle.h"
#include "collide/geom_leaves.h"
#include "collide/pairs/at_once.h"
#include "collide/pairs/solid_pairs.h"
#include "collide/types/registry.h"
#include "collide/user_class.h"

namespace epode {
namespace {

template <auto function, typename First, typename Second>
void thunk(const Geom& a, const Pose& A, const Geom& b, const Pose& B, ContactSink& sink)
{
    function(static_cast<const ShapeGeom<First>&>(a).shape, A, static_cast<const ShapeGeom<Second>&>(b).shape,
             B, sink);
}

// Where the two are.
using DirectFunction = void (*)(Geom& a, Geom& b, ContactArray& out);
void collide_slowly(Geom& a, Geom& b, ContactArray& out);
bool has_callbacks(Geom& geom);

template <PairFunction pair>
void direct_pair(Geom& a, Geom& b, ContactArray& out)
{
    ContactSink sink(out.at(out.count), out.stride, out.capacity - out.count, out.unimportant);
    sink.name(to_handle(&a), to_handle(&b));
    sink.keep(out.kept);
    sink.reach(out.margin);
    sink.report_to_program(out.to_program);
    pair(a, pose_of(a), b, pose_of(b), sink);
    out.count += sink.count();
}

template <auto function, typename First, typename Second>
void direct(Geom& a, Geom& b, ContactArray& out)
{
    direct_pair<thunk<function, First, Second>>(a, b, out);
}

// Classes of ours that never make contacts, such as two planes.
void collide_nothing(Geom&, Geom&, ContactArray&) {}

// Solids keep what is near them of a mesh; of two meshes, a ray or a plane nothing is kept.
template <typename First, typename Second>
constexpr bool kKeepsLeaves =
    std::is_same_v<Second, Trimesh> && !std::is_same_v<First, Trimesh> && !std::is_same_v<First, Ray>;

// With a mesh, which may have functions of the program.
template <PairFunction pair, bool keeps_leaves>
void unasked_pair(Geom& a, Geom& b, ContactArray& out)
{
    if (has_callbacks(a) || has_callbacks(b)) return collide_slowly(a, b, out);
    if (!keeps_leaves || out.kept) return direct_pair<pair>(a, b, out);
    const GeomLeavesHold own(a);
    out.kept = own.leaves();
    direct_pair<pair>(a, b, out);
    out.kept = nullptr;
}

template <auto function, typename First, typename Second>
void unasked(Geom& a, Geom& b, ContactArray& out)
{
    unasked_pair<thunk<function, First, Second>, kKeepsLeaves<First, Second>>(a, b, out);
}

struct Collider {
    PairFunction pair = nullptr;
    dColliderFn* user = nullptr;
    bool reversed = false;
    bool disabled = false;            // by the program
    bool settled = true;              // false: a user class has not been queried yet
    DirectFunction direct = nullptr;  // null unless the pair function is all: nothing to open or to override
};

// Read by every dCollide of any thread, written hardly ever: an entry is published by its flags.
class ColliderEntry {
  public:
    void set(const Collider& c)
    {
        pair_.store(c.pair, std::memory_order_relaxed);
        user_.store(c.user, std::memory_order_relaxed);
        const int flags =
            (c.reversed ? kReversed : 0) | (c.disabled ? kDisabled : 0) | (c.settled ? kSettled : 0);
        direct_.store(c.direct, std::memory_order_relaxed);
        flags_.store(flags, std::memory_order_release);
    }
    Collider get() const
    {
        const int flags = flags_.load(std::memory_order_acquire);
        return {pair_.load(std::memory_order_relaxed),
                user_.load(std::memory_order_relaxed),
                (flags & kReversed) != 0,
                (flags & kDisabled) != 0,
                (flags & kSettled) != 0,
                direct_.load(std::memory_order_relaxed)};
    }
    // The way of nearly all calls, if it is all; null otherwise.
    DirectFunction direct(bool& reversed) const
    {
        reversed = (flags_.load(std::memory_order_acquire) & kReversed) != 0;
        return direct_.load(std::memory_order_relaxed);
    }

  private:
    static constexpr int kReversed = 1, kDisabled = 2, kSettled = 4;
    std::atomic<DirectFunction> direct_{nullptr};
    std::atomic<PairFunction> pair_{nullptr};
    std::atomic<dColliderFn*> user_{nullptr};
    std::atomic<int> flags_{0};
};

struct ColliderTable {
    ColliderTable();
    void fill();
    void fill_solids();
    void set_both(int i, int j, Collider collider)
    {
        entries[i][j].set(collider);
        collider.reversed = !collider.reversed;
        if (i != j) entries[j][i].set(collider);
    }
    PairFunction built_in(int i, int j) const
    {
        return i >= 0 && j >= 0 && i < kGeomClasses && j < kGeomClasses ? built_in_[i][j] : nullptr;
    }
    ColliderEntry entries[kGeomClasses][kGeomClasses];
    std::atomic<bool> any_overridden{false}, rays_overridden{false};

  private:
    // Of the library, in this order of the two.
    void set_built_in(int i, int j, PairFunction pair, DirectFunction direct)
    {
        built_in_[i][j] = pair;
        set_both(i, j, {.pair = pair, .direct = direct});
    }
    PairFunction built_in_[kGeomClasses][kGeomClasses] = {};
};

// Spaces and transforms are always opened: user classes are not queried about them.
bool is_opened(int number)
{
    return number == dGeomTransformClass || (number >= dFirstSpaceClass && number <= dLastSpaceClass);
}

const GeomType* listed_type(int number) { return is_user_class(number) ? nullptr : geom_type(number); }

void ColliderTable::fill_solids()
{
    for (int i = 0; i < kGeomClasses; ++i) {
        const GeomType* type = listed_type(i);
        if (!type || !type->solid) continue;
        for (int j = i; j < kGeomClasses; ++j)
            if (const GeomType* other = listed_type(j); other && other->solid)
                set_built_in(i, j, solid_solid, direct_pair<solid_solid>);
        set_built_in(i, dPlaneClass, solid_plane, direct_pair<solid_plane>);
        set_built_in(dRayClass, i, ray_solid, direct_pair<ray_solid>);
        set_built_in(i, dTriMeshClass, solid_trimesh, unasked_pair<solid_trimesh, true>);
        set_built_in(i, dHeightfieldClass, solid_heightfield, direct_pair<solid_heightfield>);
    }
}

void ColliderTable::fill()
{
    any_overridden = rays_overridden = false;
    for (int i = 0; i < kGeomClasses; ++i)
        for (int j = 0; j < kGeomClasses; ++j) {
            const bool opened = is_opened(i) || is_opened(j), ours = !is_user_class(i) && !is_user_class(j);
            entries[i][j].set(
                {.settled = opened || ours, .direct = ours && !opened ? collide_nothing : nullptr});
        }
    fill_solids();
#define PAIR_BY(First, Second, function, way)                                                              \
    set_built_in(GeomTraits<First>::kNumber, GeomTraits<Second>::kNumber, thunk<&function, First, Second>, \
                 way);
#define PAIR(First, Second, function) PAIR_BY(First, Second, function, (unasked<&function, First, Second>))
#include "collide/pairs/mesh_pairs.inc"
#undef PAIR
#define PAIR(First, Second, function) PAIR_BY(First, Second, function, (direct<&function, First, Second>))
#define PAIR_AT_ONCE(First, Second, function) PAIR_BY(First, Second, function, function##_at_once)
#include "collide/pairs/pairs.inc"
#include "collide/pairs/terrain_pairs.inc"
#undef PAIR
#undef PAIR_BY
}

ColliderTable& table()
{
    static ColliderTable the_table;
    return the_table;
}

void restore_table() { table().fill(); }

ColliderTable::ColliderTable()
{
    fill();
    (void)on_last_close(restore_table);
}

// What the class i, if it is the program's, offers against j.
dColliderFn* offer(int i, int j)
{
    const dGeomClass* description = user_description(i);
    if (!description) return nullptr;
    const CallerFloatEnvironment program;
    return description->collider(j);
}

// Of two user classes the one registered first is asked first, so the answer does not depend on the first call.
Collider chosen(int first, int second)
{
    Collider found;
    if (dColliderFn* direct = offer(first, second)) {
        found.user = direct;
    } else if (dColliderFn* turned = offer(second, first)) {
        found.user = turned;
        found.reversed = true;
    }
    return found;
}

// A geom, the pose at which it is collided, and the geom that its contacts must name.
struct Placed {
    Geom* geom;
    Pose pose;
    Geom* named;
    bool elsewhere = false;  // not at its own pose
};

Placed in_place(Geom& geom) { return {&geom, pose_of(geom), &geom}; }

// What the transform holds, at its place in the world. An outer transform that wants to be named stays so.
Placed opened(const Placed& outer, const TransformGeom& transform)
{
    Geom* inner = transform.inner;
    const bool pinned = outer.named != outer.geom || transform.info != 0;
    return {inner, outer.pose * pose_of(*inner), pinned ? outer.named : inner, true};
}

void turn(dContactGeom& c)
{
    for (int k = 0; k < 3; ++k) c.normal[k] = -c.normal[k];
    if (c.side1 != c.side2) std::swap(c.side1, c.side2);
}

void reverse_from(int first, const ContactArray& out)
{
    for (int i = first; i < out.count; ++i) {
        turn(*out.at(i));
        std::swap(out.at(i)->g1, out.at(i)->g2);
    }
}

// Takes in new contacts; where a transform wants to be named, in place of the geom it holds.
void name_outer(const Placed& a, const Placed& b, ContactArray& out, int found)
{
    for (int i = out.count; i < out.count + found; ++i) {
        dContactGeom& c = *out.at(i);
        if (a.named != a.geom) c.g1 = to_handle(a.named);
        if (b.named != b.geom) c.g2 = to_handle(b.named);
    }
    out.count += found;
}

void run_pair(PairFunction pair, const Placed& a, const Placed& b, ContactArray& out)
{
    ContactSink sink(out.at(out.count), out.stride, out.capacity - out.count, out.unimportant);
    sink.name(to_handle(a.geom), to_handle(b.geom));
    sink.keep(out.kept);
    sink.reach(out.margin);
    sink.report_to_program(out.to_program);
    pair(*a.geom, a.pose, *b.geom, b.pose, sink);
    name_outer(a, b, out, sink.count());
}

// For what calls functions of the program: these find both geoms where they are taken to be, and cannot give
// up what the call relies on.
template <typename Call>
void while_held(Call&& call, const Placed& a, const Placed& b)
{
    if (a.elsewhere) {
        const PlacedElsewhere there(*a.geom, a.pose, true);
        Placed settled = a;
        settled.elsewhere = false;
        return while_held(call, settled, b);
    }
    if (b.elsewhere) {
        const PlacedElsewhere there(*b.geom, b.pose, true);
        Placed settled = b;
        settled.elsewhere = false;
        return while_held(call, a, settled);
    }
    const MeshHold hold_a(*a.geom), hold_b(*b.geom);
    const GeomHold hold_named_a(*a.named), hold_named_b(*b.named);
    call();
}

// The collider of the two. A user class is asked once, and its answer is kept, also "none"; what it asks for that finds the two as a
// collider does. Not kept is what a forgotten class would offer to the next one of its number.
Collider collider_of(const Placed& a, const Placed& b)
{
    const int i = a.geom->type->number, j = b.geom->type->number;
    const auto forgotten = [&] { return is_forgotten(*a.geom) || is_forgotten(*b.geom); };
    const Collider known = table().entries[i][j].get();
    if (known.settled || forgotten()) return known;
    Collider found;
    while_held([&] { found = chosen(std::min(i, j), std::max(i, j)); }, a, b);
    if (forgotten()) return {};  // since then: the program has closed the library
    table().set_both(std::min(i, j), std::max(i, j), found);
    return table().entries[i][j].get();
}

int call_user(dColliderFn* function, const Placed& a, const Placed& b, const ContactArray& out)
{
    const int capacity = out.capacity - out.count;
    const int flags = capacity | (out.unimportant ? int(CONTACTS_UNIMPORTANT) : 0);
    const CallerFloatEnvironment program;
    const int found = function(to_handle(a.geom), to_handle(b.geom), flags, out.at(out.count), out.stride);
    return std::clamp(found, 0, capacity);
}

void run_user(dColliderFn* function, const Placed& a, const Placed& b, ContactArray& out)
{
    int found = 0;
    while_held([&] { found = call_user(function, a, b, out); }, a, b);
    name_outer(a, b, out, found);
}

// Whether the geom has functions of the program that decide about its contacts.
bool has_callbacks(Geom& geom)
{
    const TrimeshGeom* mesh = as_trimesh(geom);
    return mesh && mesh->shape.has_callbacks();
}

void collide_placed(const Placed& a, const Placed& b, ContactArray& out)
{
    if (out.full()) return;
    if (is_forgotten(*a.geom) || is_forgotten(*b.geom)) return;
    const Collider collider = collider_of(a, b);
    if (collider.disabled) return;
    if (!collider.pair && !collider.user) {
        // Transforms have no entry unless the program has overridden them.
        if (const TransformGeom* ta = as_transform(*a.geom)) {
            if (ta->inner) collide_placed(opened(a, *ta), b, out);
        } else if (const TransformGeom* tb = as_transform(*b.geom)) {
            if (tb->inner) collide_placed(a, opened(b, *tb), out);
        }
        return;
    }
    const int before = out.count;
    const Placed &first = collider.reversed ? b : a, &second = collider.reversed ? a : b;
    if (collider.pair && (has_callbacks(*first.geom) || has_callbacks(*second.geom)))
        while_held([&] { run_pair(collider.pair, first, second, out); }, first, second);
    else if (collider.pair)
        run_pair(collider.pair, first, second, out);
    else
        run_user(collider.user, first, second, out);
    if (collider.reversed) reverse_from(before, out);
}

void collide_candidates(void* data, dGeomID o1, dGeomID o2)
{
    collide(*from_handle<Geom>(o1), *from_handle<Geom>(o2), *static_cast<ContactArray*>(data));
}

// What the table has no straight way for.
[[gnu::noinline]] void collide_slowly(Geom& a, Geom& b, ContactArray& out)
{
    if ((is_space(a) || is_space(b)) && !overridden(a, b))
        collide_across(a, b, &out, collide_candidates);
    else
        collide_placed(in_place(a), in_place(b), out);
}

[[gnu::noinline]] void collide_reversed(DirectFunction direct, Geom& a, Geom& b, ContactArray& out)
{
    const int before = out.count;
    direct(b, a, out);
    // g1 and g2 are known, so they are written again and not read and swapped: the processor stalls when two
    // recent stores are read as one.
    for (int i = before; i < out.count; ++i) {
        turn(*out.at(i));
        out.at(i)->g1 = to_handle(&a), out.at(i)->g2 = to_handle(&b);
    }
}

[[gnu::always_inline]] inline void collide_two(Geom& a, Geom& b, ContactArray& out)
{
    if (&a == &b || out.full() || of_one_body(a, b)) return;
    bool reversed;
    const DirectFunction direct = table().entries[a.type->number][b.type->number].direct(reversed);
    if (!direct) return collide_slowly(a, b, out);
    reversed ? collide_reversed(direct, a, b, out) : direct(a, b, out);
}

}  // namespace

bool overridden(Geom& a, Geom& b)
{
    const Collider collider = collider_of(in_place(a), in_place(b));
    return collider.user || collider.disabled;
}

PairFunction own_pair(int first, int second)
{
    if (is_user_class(first) || is_user_class(second)) return nullptr;
    const Collider collider = table().entries[first][second].get();
    return collider.user || collider.disabled || collider.reversed ? nullptr : collider.pair;
}

PairFunction built_in_pair(int first, int second) { return table().built_in(first, second); }

namespace {
// Also of one that a transform holds.
const HeightfieldData* field_of(const Geom& geom)
{
    const Geom* its = &geom;
    while (its && its->type == &kTransformType) its = static_cast<const TransformGeom*>(its)->inner;
    if (!its || its->type->number != dHeightfieldClass) return nullptr;
    return static_cast<const ShapeGeom<Heightfield>*>(its)->shape.field();
}
}  // namespace

bool may_call_program(Geom& geom)
{
    if (is_user_class(geom.type->number) || as_transform(geom) || has_callbacks(geom)) return true;
    const HeightfieldData* field = field_of(geom);
    return field && (field->source == HeightfieldData::Source::kCallback || field->sampled);
}

bool may_call_program(Geom& a, Geom& b)
{
    return may_call_program(a) || may_call_program(b) ||
           (any_overridden() && table().entries[a.type->number][b.type->number].get().user);
}

bool program_collides(Geom& a, Geom& b)
{
    const auto opens = [](Geom& geom) { return is_user_class(geom.type->number) || as_transform(geom); };
    return opens(a) || opens(b) ||
           (any_overridden() && table().entries[a.type->number][b.type->number].get().user);
}

std::uint32_t changes_of(const Geom& geom)
{
    const HeightfieldData* field = field_of(geom);
    if (!field) return geom.changes;
    // No sum, which is an earlier one again when the field is gone or another stands in its place.
    const std::uint64_t its = std::uint64_t(field->serial) << 32 | field->changes;
    return geom.changes ^ std::uint32_t(its * 0x9e3779b97f4a7c15u >> 32);
}

bool changes_unseen(const Geom& geom)
{
    const HeightfieldData* field = field_of(geom);
    return field && (!field->copy || field->foreign);
}

void collide(Geom& a, Geom& b, ContactArray& out) { collide_two(a, b, out); }

void collide_at(Geom& a, const Pose& A, Geom& b, const Pose& B, ContactArray& out)
{
    collide_placed({&a, A, &a, true}, {&b, B, &b, true}, out);
}

void override_collider(int i, int j, dColliderFn* function)
{
    table().set_both(i, j, {.user = function, .disabled = !function});
    if (function) table().any_overridden = true;
    if (function && (i == dRayClass || j == dRayClass)) table().rays_overridden = true;
}

bool any_overridden() { return table().any_overridden.load(std::memory_order_relaxed); }

bool rays_overridden() { return table().rays_overridden.load(std::memory_order_relaxed); }

}  // namespace epode

using namespace epode;

// Called for every pair, and often as small as a dozen operations: there is no way out to pass where nothing
// has to be given back.
extern "C" int dCollide(dGeomID o1, dGeomID o2, int flags, dContactGeom* contact, int skip)
{
    if (!has_library_modes()) [[unlikely]] {
        const FloatEnvironment floats;
        return dCollide(o1, o2, flags, contact, skip);
    }
    EPODE_GEOM(a, o1, 0);
    EPODE_GEOM(b, o2, 0);
    EPODE_USER(contact && skip >= int(sizeof(dContactGeom)), 0);
    EPODE_USER_SAY((flags & 0xffff) != 0, "no contacts requested", 0);
    ContactArray out{contact, skip, flags & 0xffff, (unsigned(flags) & CONTACTS_UNIMPORTANT) != 0};
    out.to_program = true;
    collide_two(*a, *b, out);
    return out.count;
}

extern "C" void dSetColliderOverride(int i, int j, dColliderFn* fn)
{
    EPODE_USER(i >= 0 && i < kGeomClasses && j >= 0 && j < kGeomClasses);
    override_collider(i, j, fn);
}
