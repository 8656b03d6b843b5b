// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Python functions that the library calls. The first exception is kept and raised when the outermost call ends; until
// then no other function of Python is called: pairs then touch, queries find, heights are 0.
#include <map>

#include "filter.h"
#include "written_texts.h"

namespace {

template <typename F>
void guarded(F f)
{
    const WithGil lock;
    if (exception_waits()) return;
    try {
        f();
    } catch (nb::python_error& e) {
        e.restore();
        keep_exception();
    } catch (const std::exception& e) {
        PyErr_SetString(PyExc_TypeError, e.what());
        keep_exception();
    }
}

void on_near(void* data, dGeomID o1, dGeomID o2)
{
    guarded([&] { nb::borrow(static_cast<PyObject*>(data))(wrapped(o1), wrapped(o2)); });
}

int on_pair(void* data, dGeomID o1, dGeomID o2)
{
    int keep_it = 1;
    guarded([&] {
        keep_it =
            nb::cast<bool>(nb::bool_(nb::borrow(static_cast<PyObject*>(data))(wrapped(o1), wrapped(o2))));
    });
    return keep_it;
}

int on_query(void* data, dGeomID geom)
{
    int keep_it = 1;
    guarded([&] {
        keep_it = nb::cast<bool>(nb::bool_(nb::borrow(static_cast<PyObject*>(data))(wrapped(geom))));
    });
    return keep_it;
}

dReal on_height(void* data, int x, int z)
{
    dReal height = 0;
    guarded([&] { height = nb::cast<double>(nb::borrow(static_cast<PyObject*>(data))(x, z)); });
    return height;
}

dReal on_surface(void* data, const dVector3 place, dReal time)
{
    dReal height = 0;
    guarded([&] {
        height = nb::cast<double>(nb::borrow(static_cast<PyObject*>(data))(array_of(place, 3), time));
    });
    return height;
}

void on_current(void* data, const dVector3 place, dReal time, dVector3 velocity)
{
    guarded([&] {
        const nb::object found = nb::borrow(static_cast<PyObject*>(data))(array_of(place, 3), time);
        const auto v = numbers<3>(found, "current");
        for (int i = 0; i < 3; ++i) velocity[i] = v.v[i];
    });
}

// Places of kept objects.
enum {
    kMoved,
    kContactFilter,
    kHeights,
    kFeedback,
    kMeshVertices,
    kMeshIndices,
    kSurface,
    kCurrent,
    kManifold,
    kCharacterFilter
};

// The function belongs to the geom, not to the pointer in its settings, which copies of worlds have, too.
int on_character(void*, dGeomID character, dGeomID other, const dVector3 velocity)
{
    int keep_it = 1;
    guarded([&] {
        const nb::object filter = kept(character, kCharacterFilter);
        if (filter.is_none()) return;
        keep_it =
            nb::cast<bool>(nb::bool_(filter(wrapped(character), wrapped(other), array_of(velocity, 3))));
    });
    return keep_it;
}

// The function gets a copy, which it may keep.
void on_manifold(void* data, dManifold* manifold)
{
    guarded([&] {
        const nb::object shown = nb::cast(*manifold);
        nb::borrow(static_cast<PyObject*>(data))(shown);
        *manifold = *nb::cast<const dManifold*>(shown);
    });
}

// The library knows its dead.
bool is_dead_joint(const void* owner, int place)
{
    if (place != kFeedback) return false;
    Call probe;
    dJointGetType(static_cast<dJointID>(const_cast<void*>(owner)));
    return !probe.silent();
}

dWorldID world_of(dJointID joint)
{
    dBodyID body = dJointGetBody(joint, 0);
    if (!body) body = dJointGetBody(joint, 1);
    return body ? dBodyGetWorld(body) : nullptr;
}

void on_moved(dBodyID body)
{
    guarded([&] {
        nb::object function = kept(body, kMoved);
        if (!function.is_none()) function(wrapped(body));
    });
}

void collide(const SpaceHandle* space, nb::object callback)
{
    Call call;
    call.uses(space_of(space));
    dSpaceCollide(space_of(space), callback.ptr(), on_near);
    call.done();
}

void collide_two(const GeomHandle* o1, const GeomHandle* o2, nb::object callback)
{
    Call call;
    call.uses(get(o1));
    call.uses(get(o2));
    dSpaceCollide2(get(o1), get(o2), callback.ptr(), on_near);
    call.done();
}

void set_moved_callback(const BodyHandle* body, nb::object callback)
{
    Call call;
    call.uses(get(body));
    dBodySetMovedCallback(get(body), callback.is_none() ? nullptr : on_moved);
    call.done();
    keep(get(body), kMoved, callback, dBodyGetWorld(get(body)));
}

void set_contact_filter(const WorldHandle* world, nb::object filter)
{
    Call call;
    call.uses(get(world));
    dWorldSetContactFilter(get(world), filter.is_none() ? nullptr : on_pair, filter.ptr());
    call.done();
    keep(get(world), kContactFilter, filter, get(world));
}

void set_manifold_function(const WorldHandle* world, nb::object function)
{
    Call call;
    call.uses(get(world));
    dWorldSetManifoldFunction(get(world), function.is_none() ? nullptr : on_manifold, function.ptr(), 0);
    call.done();
    keep(get(world), kManifold, function, get(world));
}

// Settings of a character with the filter that is given, or with none.
dCharacterSettings with_filter(const dCharacterSettings& settings, const nb::object& filter)
{
    dCharacterSettings result = settings;
    result.filter = filter.is_none() ? nullptr : on_character;
    result.data = nullptr;
    return result;
}

nb::object create_character(const SpaceHandle* space, const dCharacterSettings* settings, nb::object filter)
{
    dCharacterSettings given;
    dCharacterSettingsInit(&given, sizeof given);
    given = with_filter(settings ? *settings : given, filter);
    Call call;
    call.uses(space_of(space));
    const dGeomID character = dCharacterCreate(space_of(space), &given);
    call.done();
    keep(character, kCharacterFilter, filter);
    return wrapped(character);
}

int set_character(const GeomHandle* character, const dCharacterSettings* settings, nb::object filter)
{
    const dCharacterSettings given = settings ? with_filter(*settings, filter) : dCharacterSettings{};
    Call call;
    call.uses(get(character));
    const int done = dCharacterSetSettings(get(character), settings ? &given : nullptr);
    call.done();
    keep(get(character), kCharacterFilter, filter);
    return done;
}

void set_surface(const FluidHandle* fluid, nb::object surface)
{
    Call call;
    const dWorldID world = dFluidGetWorld(get(fluid));
    call.uses(world);
    dFluidSetSurface(get(fluid), surface.is_none() ? nullptr : on_surface, surface.ptr());
    call.done();
    keep(get(fluid), kSurface, surface, world);
}

void set_current(const FluidHandle* fluid, nb::object current)
{
    Call call;
    const dWorldID world = dFluidGetWorld(get(fluid));
    call.uses(world);
    dFluidSetCurrentFunction(get(fluid), current.is_none() ? nullptr : on_current, current.ptr());
    call.done();
    keep(get(fluid), kCurrent, current, world);
}

void build_callback(const HeightsHandle* data, nb::object callback, double width, double depth,
                    int width_samples, int depth_samples, double scale, double offset, double thickness,
                    bool wrap)
{
    Call call;
    dGeomHeightfieldDataBuildCallback(get(data), callback.ptr(), on_height, width, depth, width_samples,
                                      depth_samples, scale, offset, thickness, wrap);
    call.done();
    keep(get(data), kHeights, callback);
}

void set_feedback(const JointHandle* joint, nb::object feedback)
{
    Call call;
    call.uses(get(joint));
    dJointSetFeedback(get(joint), feedback.is_none() ? nullptr : nb::cast<dJointFeedback*>(feedback));
    call.done();
    keep(get(joint), kFeedback, feedback, world_of(get(joint)));
}

nb::object get_feedback(const JointHandle* joint)
{
    Call call;
    call.uses(get(joint));
    dJointFeedback* feedback = dJointGetFeedback(get(joint));
    call.done();
    return feedback ? kept(get(joint), kFeedback) : nb::none();
}

// The data point to the arrays, which are kept until the data get others.
void build_mesh(const MeshHandle* data, nb::object vertices, nb::object indices, bool simple)
{
    auto points = array_in<double>(vertices);
    auto corners = array_in<unsigned>(indices);
    size_t width = simple ? 4 : 3;
    if (points.size % width || (points.shape.size() == 2 && points.shape[1] != width) ||
        points.size > (1u << 30) || corners.size > (1u << 30))
        throw nb::value_error(simple ? "vertices: an array of n rows of 4 numbers expected"
                                     : "vertices: an array of n rows of 3 numbers expected");
    Call call;
    if (simple)
        dGeomTriMeshDataBuildSimple(get(data), points.data, int(points.size / 4), corners.data,
                                    int(corners.size));
    else
        dGeomTriMeshDataBuildDouble(get(data), points.data, 3 * sizeof(double), int(points.size / 3),
                                    corners.data, int(corners.size), 3 * sizeof(unsigned));
    call.done();
    keep(get(data), kMeshVertices, points.owner);
    keep(get(data), kMeshIndices, corners.owner);
}

}  // namespace

void forget_joints() { forget_dead(is_dead_joint); }

void adopt_functions(dWorldID from, dWorldID copy)
{
    dWorldSetContactFilter(copy, nullptr, nullptr);
    dWorldSetManifoldFunction(copy, nullptr, nullptr, 0);
    for (int i = 0; i < dWorldGetNumFluids(copy); ++i) {
        const dFluidID was = dWorldGetFluid(from, i), is = dWorldGetFluid(copy, i);
        for (const int place : {kSurface, kCurrent}) keep(is, place, kept(was, place), copy);
    }
}

Filter::Filter() { dQueryFilterInit(&filter, sizeof filter); }

const dQueryFilter* filter_of(const Filter* filter)
{
    if (!filter) return nullptr;
    auto& raw = const_cast<dQueryFilter&>(filter->filter);
    bool given = filter->callback.is_valid() && !filter->callback.is_none();
    raw.callback = given ? on_query : nullptr;
    raw.data = given ? filter->callback.ptr() : nullptr;
    return &raw;
}

void bind_callbacks(nb::module_& m)
{
    nb::class_<Filter>(m, "dQueryFilter")
        .def(nb::init<>())
        .def_prop_rw(
            "category_bits", [](Filter& f) { return f.filter.category_bits; },
            [](Filter& f, unsigned long v) { f.filter.category_bits = v; })
        .def_prop_rw(
            "collide_bits", [](Filter& f) { return f.filter.collide_bits; },
            [](Filter& f, unsigned long v) { f.filter.collide_bits = v; })
        .def_prop_rw(
            "skip_body", [](Filter& f) { return wrapped(f.filter.skip_body); },
            [](Filter& f, const BodyHandle* body) { f.filter.skip_body = get(body); },
            nb::for_setter(nb::arg("body").none()))
        .def_prop_rw(
            "callback", [](Filter& f) { return f.callback.is_valid() ? f.callback : nb::none(); },
            [](Filter& f, nb::object callback) { f.callback = callback; },
            nb::for_setter(nb::arg("callback").none()));
    m.def(
        "dQueryFilterInit", [](Filter& f) { f = Filter(); }, "filter"_a, TEXT(dQueryFilterInit));
    m.def("dSpaceCollide", collide, "space"_a.none(), "callback"_a, TEXT(dSpaceCollide));
    m.def("dSpaceCollide2", collide_two, "o1"_a.none(), "o2"_a.none(), "callback"_a, TEXT(dSpaceCollide2));
    m.def("dBodySetMovedCallback", set_moved_callback, "body"_a.none(), "callback"_a.none(),
          TEXT(dBodySetMovedCallback));
    m.def("dWorldSetContactFilter", set_contact_filter, "world"_a.none(), "filter"_a.none(),
          TEXT(dWorldSetContactFilter));
    nb::class_<dManifold>(m, "dManifold")
        .def("__init__", [](dManifold* m) { *m = {}, m->struct_size = sizeof(dManifold); })
        .def_prop_ro("g1", [](const dManifold& m) { return wrapped(m.g1); })
        .def_prop_ro("g2", [](const dManifold& m) { return wrapped(m.g2); })
        .def_ro("touched", &dManifold::touched)
        .def_ro("count", &dManifold::count)
        .def_prop_ro("pos",
                     [](const dManifold& m) {
                         dReal* data;
                         nb::object result = real_array(size_t(m.count), 3, &data);
                         for (int i = 0; i < m.count; ++i) std::copy_n(m.pos[i], 3, data + 3 * i);
                         return result;
                     })
        .def_prop_ro("depth", [](const dManifold& m) { return array_of(m.depth, m.count); })
        .def_prop_ro("normal", [](const dManifold& m) { return array_of(m.normal, 3); })
        .def_prop_ro("velocity", [](const dManifold& m) { return array_of(m.velocity, 3); })
        .def_rw("accept", &dManifold::accept)
        .def_rw("friction", &dManifold::friction)
        .def_rw("bounce", &dManifold::bounce)
        .def_rw("bounce_speed", &dManifold::bounce_speed)
        .def_rw("rolling_friction", &dManifold::rolling_friction)
        .def_rw("compliance", &dManifold::compliance)
        .def_rw("damping_time", &dManifold::damping_time)
        .def_rw("cross_friction", &dManifold::cross_friction)
        .def_rw("max_impulse", &dManifold::max_impulse)
        .def_prop_rw(
            "friction_axis", [](const dManifold& m) { return array_of(m.friction_axis, 3); },
            [](dManifold& m, nb::object v) {
                std::copy_n(numbers<3>(v, "friction_axis").v, 3, m.friction_axis);
            })
        .def_prop_rw(
            "surface_velocity", [](const dManifold& m) { return array_of(m.surface_velocity, 3); },
            [](dManifold& m, nb::object v) {
                std::copy_n(numbers<3>(v, "surface_velocity").v, 3, m.surface_velocity);
            });
    m.def("dWorldSetManifoldFunction", set_manifold_function, "world"_a.none(), "function"_a.none(),
          TEXT(dWorldSetManifoldFunction));
    m.def("dCharacterCreate", create_character, "space"_a.none(), "settings"_a.none() = nb::none(),
          "filter"_a.none() = nb::none(), TEXT(dCharacterCreate));
    m.def("dCharacterSetSettings", set_character, "character"_a.none(), "settings"_a.none(),
          "filter"_a.none() = nb::none(), TEXT(dCharacterSetSettings));
    m.def("dFluidSetSurface", set_surface, "fluid"_a.none(), "surface"_a.none(), TEXT(dFluidSetSurface));
    m.def("dFluidSetCurrentFunction", set_current, "fluid"_a.none(), "current"_a.none(),
          TEXT(dFluidSetCurrentFunction));
    m.def("dGeomHeightfieldDataBuildCallback", build_callback, "d"_a.none(), "callback"_a, "width"_a,
          "depth"_a, "widthSamples"_a, "depthSamples"_a, "scale"_a, "offset"_a, "thickness"_a, "bWrap"_a,
          TEXT(dGeomHeightfieldDataBuildCallback));
    m.def("dJointSetFeedback", set_feedback, "joint"_a.none(), "feedback"_a.none(), TEXT(dJointSetFeedback));
    m.def("dJointGetFeedback", get_feedback, "joint"_a.none(), TEXT(dJointGetFeedback));
    m.def(
        "dGeomTriMeshDataBuildDouble",
        [](const MeshHandle* d, nb::object v, nb::object i) { build_mesh(d, v, i, false); }, "g"_a.none(),
        "vertices"_a, "indices"_a, TEXT(dGeomTriMeshDataBuildDouble));
    m.def(
        "dGeomTriMeshDataBuildSimple",
        [](const MeshHandle* d, nb::object v, nb::object i) { build_mesh(d, v, i, true); }, "g"_a.none(),
        "vertices"_a, "indices"_a, TEXT(dGeomTriMeshDataBuildSimple));
}
