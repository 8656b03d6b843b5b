// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Lists of bodies and joints, whose states are arrays, and the surfaces of many geoms as one structured array.
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "filter.h"
#include "written_texts.h"

nb::object dtype_of(const std::vector<std::tuple<const char*, const char*, size_t>>& fields, size_t size)
{
    nb::list names, formats, offsets;
    for (auto& [name, format, offset] : fields) {
        names.append(name);
        formats.append(format);
        offsets.append(offset);
    }
    nb::dict spec;
    spec["names"] = names;
    spec["formats"] = formats;
    spec["offsets"] = offsets;
    spec["itemsize"] = size;
    return nb::module_::import_("numpy").attr("dtype")(spec);
}

namespace {

int width_of(unsigned fields)
{
    static const int widths[] = {3, 4, 3, 3, 3, 3, 1};
    int width = 0;
    for (int i = 0; i < 7; ++i)
        if (fields >> i & 1) width += widths[i];
    return width;
}

// No world becomes busy meanwhile: that takes the interpreter's lock.
template <typename P>
void use_all(Call& call, const HandleList<P>& list)
{
    if (!any_is_busy()) return;
    for (P one : list.v) call.uses(one);
}

[[noreturn]] void refuse_size(size_t rows, size_t width, size_t given)
{
    const std::string text = std::to_string(rows) + " rows of " + std::to_string(width) +
                             " numbers expected, not " + std::to_string(given) + " numbers";
    throw nb::value_error(text.c_str());
}

// The program's own array, which is written to: it is never converted.
dReal* rows_to_fill(nb::handle out, size_t rows, size_t width)
{
    nb::ndarray<double, nb::c_contig, nb::device::cpu> view;
    if (!nb::try_cast(out, view, false))
        throw nb::type_error("out: a contiguous array of float64 that may be written to expected");
    if (view.size() != rows * width) refuse_size(rows, width, view.size());
    return view.data();
}

nb::object get_states(const BodyList& bodies, unsigned fields, nb::object out)
{
    const size_t rows = bodies.v.size(), width = size_t(std::max(width_of(fields), 1));
    dReal* data;
    if (out.is_none())
        out = real_array(rows, width, &data);
    else
        data = rows_to_fill(out, rows, width);
    Call call;
    use_all(call, bodies);
    dBodiesGetStates(bodies.v.data(), int(rows), fields, data, 0);
    call.done();
    return out;
}

void set_states(const BodyList& bodies, unsigned fields, nb::object from)
{
    auto rows = array_in<double>(from);
    if (rows.size != bodies.v.size() * size_t(width_of(fields)))
        refuse_size(bodies.v.size(), size_t(width_of(fields)), rows.size);
    Call call;
    use_all(call, bodies);
    dBodiesSetStates(bodies.v.data(), int(bodies.v.size()), fields, rows.data, 0);
    call.done();
}

nb::object joint_states(const JointList& joints, int stride)
{
    if (stride < 1 || stride > 3) throw nb::value_error("stride: 1, 2 or 3 axes expected");
    dReal *value, *rate;
    nb::object values = real_array(joints.v.size(), size_t(stride), &value),
               rates = real_array(joints.v.size(), size_t(stride), &rate);
    std::fill_n(value, joints.v.size() * size_t(stride), 0);
    std::fill_n(rate, joints.v.size() * size_t(stride), 0);
    Call call;
    use_all(call, joints);
    dJointsGetStates(joints.v.data(), int(joints.v.size()), value, rate, stride);
    call.done();
    return nb::make_tuple(values, rates);
}

nb::object material_type()
{
    using M = dMaterial;
    return dtype_of(
        {FIELD(M, friction, "f8"), FIELD(M, bounce, "f8"), FIELD(M, bounce_speed, "f8"),
         FIELD(M, surface_velocity, "3f8"), FIELD(M, rolling_friction, "f8"), FIELD(M, compliance, "f8"),
         FIELD(M, damping_time, "f8"), FIELD(M, friction_rule, "i4"), FIELD(M, bounce_rule, "i4"),
         FIELD(M, rolling_friction_rule, "i4"), FIELD(M, priority, "i4"), FIELD(M, cross_friction, "f8"),
         FIELD(M, friction_axis, "3f8"), FIELD(M, kind, "i4")},
        sizeof(M));
}

using Geoms = std::vector<GeomHandle*>;

void use_all(Call& call, const Geoms& geoms)
{
    if (!any_is_busy()) return;
    for (const GeomHandle* geom : geoms) call.uses(get(geom));
}

nb::object get_materials(const Geoms& geoms)
{
    void* data;
    nb::object array = empty_records(material_type(), geoms.size(), &data);
    auto* to = static_cast<dMaterial*>(data);
    Call call;
    use_all(call, geoms);
    for (const GeomHandle* geom : geoms) {
        dMaterialInit(to, sizeof *to);
        dGeomGetMaterial(get(geom), to++);
    }
    call.done();
    return array;
}

// All or none: what was set before a refusal gets its old material again.
void set_materials(const Geoms& geoms, nb::object from)
{
    void* data;
    nb::object array = empty_records(material_type(), geoms.size(), &data);
    array[nb::ellipsis()] = from;
    std::vector<dMaterial> before(geoms.size());
    const auto* to = static_cast<const dMaterial*>(data);
    Call call;
    use_all(call, geoms);
    for (size_t i = 0; i < geoms.size() && call.silent(); ++i) {
        dMaterialInit(&before[i], sizeof before[i]);
        dGeomGetMaterial(get(geoms[i]), &before[i]);
        dMaterial its = to[i];
        its.struct_size = sizeof its;
        dGeomSetMaterial(get(geoms[i]), &its);
        for (size_t k = 0; !call.silent() && k < i; ++k) dGeomSetMaterial(get(geoms[k]), &before[k]);
    }
    call.done();
}

template <typename P>
void bind_list(nb::module_& m, const char* name)
{
    using L = HandleList<P>;
    nb::class_<L>(m, name)
        .def("__init__",
             [](L* self, const std::vector<Handle<P>*>& handles) {
                 new (self) L;
                 for (const Handle<P>* handle : handles) self->v.push_back(get(handle));
             })
        .def("__len__", [](const L& list) { return list.v.size(); })
        .def("__getitem__", [](const L& list, size_t i) {
            if (i >= list.v.size()) throw nb::index_error();
            return wrapped(list.v[i]);
        });
}

}  // namespace

void bind_arrays(nb::module_& m)
{
    bind_list<dBodyID>(m, "BodyList");
    bind_list<dJointID>(m, "JointList");
    m.def("dBodiesGetStates", get_states, "bodies"_a, "fields"_a, "out"_a.none() = nb::none(),
          TEXT(dBodiesGetStates));
    m.def("dBodiesSetStates", set_states, "bodies"_a, "fields"_a, "states"_a, TEXT(dBodiesSetStates));
    m.def("dJointsGetStates", joint_states, "joints"_a, "stride"_a = 1, TEXT(dJointsGetStates));
    m.def("_get_materials", get_materials);
    m.def("_set_materials", set_materials);
}
