// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A geom: a shape with a pose, a bounding box, filter bits and a place in at most one space. Its type is a
// table of functions (GeomType), so that classes made at run time are no different from built-in ones.
//   pose      own arrays; or the body's arrays, shared; or, on a body with an offset, own arrays that are
//             composed (pose = body * offset) on first use after the body has moved.
//   body      known as an opaque id, two pointers to its pose and the head of its list of geoms: this folder
//             knows nothing of dynamics (step/common/link introduces the two).
//   moving    marks the geom and queues it, and each space above it, for the next cleaning; what does not
//             move costs nothing then.
#pragma once

#include <atomic>

#include "base/call_guard.h"
#include "base/objects/handle.h"
#include "base/prefetch.h"
#include "geometry/shapes.h"
#include "ode/collision.h"

struct dMaterial;

namespace epode {

class ContentHash;
class DifWriter;
class ShapeStream;
struct Character;
struct Geom;
struct GeomLeaves;
struct SolidType;
struct Space;
struct TransformGeom;

struct GeomType {
    int number = -1;  // dSphereClass ...
    bool placeable = true;
    Aabb (*aabb)(Geom& geom) = nullptr;                    // in the world
    bool (*zero_sized)(const Geom& geom) = nullptr;        // spaces ignore such geoms; null: never
    void (*destroy)(Geom* geom) = nullptr;                 // runs the destructor, gives the memory back
    void (*farewell)(Geom& geom) = nullptr;                // the first thing when it is destroyed; null: none
    bool (*may_touch)(Geom& geom, Geom& other) = nullptr;  // a last look before a pair is reported; null: yes
    int (*control)(Geom& geom, int control_class, int code, void* data, int* size) = nullptr;  // null: none
    void (*describe)(const Geom& geom, DifWriter& out) = nullptr;  // in dWorldExportDIF; null: writes nothing
    // What distinguishes its shape and `describe` does not write; null: nothing.
    void (*fingerprint)(const Geom& geom, ContentHash& hash) = nullptr;
    const SolidType* solid = nullptr;                    // convex solids (collide/solid_type.h); null: none
    Real (*half_thickness)(const Geom& geom) = nullptr;  // of what may be continuous; null: it may not
    Geom* (*create)(const GeomType& type) = nullptr;     // in no space; null when memory is exhausted
    // Its shape, in clones and files of worlds (collide/shape_stream.h); null: it cannot be copied.
    void (*structure)(Geom& geom, ShapeStream& stream) = nullptr;
};

// Where the body keeps what its geoms need; all null when there is none.
struct BodyLink {
    dBodyID id = nullptr;
    const Real* position = nullptr;
    const Real* rotation = nullptr;
    dxGeom** first_geom = nullptr;
};

// Pose of a geom in its body's frame, in ODE's layout because clients may hold pointers to it.
struct GeomOffset {
    Real position[4] = {};
    Real rotation[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
};

// Why somebody wants to know when something happens to a geom: pairs of it lie at rest; a body touches it,
// which may sleep on it; its own body sleeps on what has been disturbed already.
enum WatchedFor : std::uint8_t { kRestingPairs = 1, kTouch = 2, kUnsupported = 4 };

struct Geom : Numbered {
    explicit Geom(const GeomType& geom_type);
    Geom(const Geom&) = delete;
    Geom& operator=(const Geom&) = delete;

    // What every collision reads, and every mark that it has moved: one line of the cache, with the tag.
    const GeomType* type;
    const Real* position;  // where the pose is
    const Real* rotation;
    bool enabled = true;
    bool queued = false;  // its space will look at it at the next cleaning
    bool box_stale = true;
    bool pose_stale = false;      // only with an offset
    std::uint8_t continuous = 0;  // a dContinuous... value; set_continuous() writes it
    bool dying = false;         // being destroyed: its class's function, or those of its members, are running
    bool sensor = false;        // reports what overlaps it and exerts no force; set_sensor() writes it
    std::uint8_t watched = 0;   // WatchedFor: who wants to know when something happens to it
    int slot = -1;              // place among the members of its space
    std::uint32_t changes = 0;  // of the shape, see mark_changed()
    Space* space = nullptr;

    // The next: whom it belongs to, and what programs ask for first when a pair is reported.
    TransformGeom* holders = nullptr;  // transforms that place this geom
    GeomOffset* offset = nullptr;
    void* data = nullptr;
    Geom* body_next = nullptr;  // geoms of the same body, newest first
    BodyLink body;

    Aabb box;
    unsigned long category = ~0ul;
    unsigned long collide = ~0ul;
    dMaterial* material = nullptr;  // null: the default
    Geom* body_prev = nullptr;
    std::atomic<int> users{0};                 // calls into the program in progress that rely on this geom
    std::atomic<GeomLeaves*> leaves{nullptr};  // of the mesh met last, see geom_leaves.h
    Character* character = nullptr;            // what makes it one (collide/character.h); null: it is none
    void* recorder = nullptr;                  // the history that has it last recorded (state/history.h)
    std::uint64_t disturbed = 0;               // the last disturbance that it had, see note_disturbed()
    std::uint64_t shape_hash = 0;              // see describe.h
    std::uint32_t hashed_changes = ~0u;        // changes_of() then
    alignas(32) Real own_rotation[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    Real own_position[4] = {};  // stored with the shape, which follows
};

template <>
struct HandleOf<Geom> {
    using Id = dGeomID;
    static constexpr Tag kTag = Tag::kGeom;
};

// A geom that consists of one of the plain shapes.
template <typename Shape>
struct ShapeGeom : Geom {
    explicit ShapeGeom(const GeomType& geom_type) : Geom(geom_type) {}
    Shape shape;
};

// Keeps a geom, while the program's own functions run, from being destroyed by them: what they return to
// still needs it. Members of a locked space are safe without, and all where no such function can be called.
class GeomHold {
  public:
    explicit GeomHold(Geom& geom, bool called = true) : guard_(called ? let_go : nullptr, &geom)
    {
        if (called) geom.users.fetch_add(1, std::memory_order_relaxed);
    }

  private:
    static void let_go(void* geom, const void*, std::size_t)
    {
        static_cast<Geom*>(geom)->users.fetch_sub(1, std::memory_order_relaxed);
    }
    CallGuard guard_;
};

// Whether a call that has not ended holds it, or is destroying it.
bool is_held(const Geom& geom);
bool is_dying(const Geom& geom);

// Starts to bring what a box is made of and goes to: the mark, the box, the shape. No more: in a pile of
// thousands as many lines are on their way as the processor can wait for.
inline void prefetch_shape(const Geom& geom)
{
    prefetch<1>(&geom), prefetch<1>(&geom.box), prefetch<1>(geom.own_position);
}

// visit(geom) for every geom of a body, given its newest; they stay its geoms meanwhile.
template <typename Visit>
void for_each_geom_from(dGeomID newest, Visit&& visit)
{
    for (Geom* geom = from_handle<Geom>(newest); geom; geom = geom->body_next) visit(*geom);
}

inline bool of_one_body(const Geom& a, const Geom& b) { return a.body.id && a.body.id == b.body.id; }
inline bool is_space(const Geom& geom)
{
    return geom.type->number >= dFirstSpaceClass && geom.type->number <= dLastSpaceClass;
}
bool in_locked_space(const Geom& geom);

// ---- pose and box, computed when stale ----
void refresh_pose(Geom& geom);
inline Pose pose_of(Geom& geom)
{
    if (geom.pose_stale) refresh_pose(geom);
    return load_pose(geom.position, geom.rotation);
}
void refresh_box(Geom& geom);
inline const Aabb& box_of(Geom& geom)
{
    if (geom.box_stale) refresh_box(geom);
    return geom.box;
}

// The pose has changed; the shape, which is counted: what somebody knows of its contacts is not true any
// more.
void mark_moved(Geom& geom);
void mark_stepped(Geom& geom);  // moved by a step, which disturbs nothing at rest
// The program has set the pose, as some do every frame whether it is another one or not.
inline void mark_placed(Geom& geom, bool elsewhere) { elsewhere ? mark_moved(geom) : mark_stepped(geom); }
void mark_changed(Geom& geom);

// Whether steps look at the geom's whole way, and whether there is any geom of which they do.
void set_continuous(Geom& geom, int mode);
bool any_continuous();

// The same of sensors, of which steps report what overlaps them.
void set_sensor(Geom& geom, bool on);
bool any_sensor();

// ---- body and offset; `link.first_geom` gets the geom in front ----
void link_body(Geom& geom, const BodyLink& link);
void unlink_body(Geom& geom);    // the geom keeps its pose in the world
bool ensure_offset(Geom& geom);  // identity if new; false when memory is exhausted
void drop_offset(Geom& geom);    // back to the body's pose
void drop_material(Geom& geom);  // face_materials.cpp

// All geoms that have been created so far have this serial or a lower one.
std::uint64_t newest_geom_serial();

// Destroys the geom and for a space in cleanup mode its members. The caller has checked the locks.
void destroy_geom(Geom& geom);

}  // namespace epode
