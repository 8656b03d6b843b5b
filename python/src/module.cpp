// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// epode._c: ODE's C API as it is. Handles are objects of the type that C gives them; what a function writes is what
// it returns; structures are classes that are passed and written to.
#include "recording.h"

namespace {

template <typename H, typename... Base>
void bind_handle(nb::module_& m, const char* name)
{
    nb::class_<H, Base...>(m, name)
        .def(
            "__eq__",
            [](const H& a, nb::handle b) { return nb::isinstance<H>(b) && nb::cast<const H&>(b).p == a.p; },
            nb::arg().none())
        .def("__hash__", [](const H& a) { return size_t(a.p) >> 6; })
        .def_prop_ro(
            "id", [](const H& a) { return size_t(a.p); }, "The address, as structured arrays have it.")
        .def("__repr__", [name = std::string(name)](const H& a) {
            char text[40];
            snprintf(text, sizeof text, " at %p>", static_cast<const void*>(a.p));
            return "<" + name + text;
        });
}

}  // namespace

NB_MODULE(_c, m)
{
    nb::set_leak_warnings(false);
    bind_handle<WorldHandle>(m, "dWorldID");
    bind_handle<BodyHandle>(m, "dBodyID");
    bind_handle<JointHandle>(m, "dJointID");
    bind_handle<GroupHandle>(m, "dJointGroupID");
    bind_handle<FluidHandle>(m, "dFluidID");
    bind_handle<HeightsHandle>(m, "dHeightfieldDataID");
    bind_handle<MeshHandle>(m, "dTriMeshDataID");
    bind_handle<GeomHandle>(m, "dGeomID");
    bind_handle<SpaceHandle, GeomHandle>(m, "dSpaceID");
    m.def("_set_exceptions", set_exceptions);
    install_handlers();
    dInitODE2(0);
    bind_structures(m);
    bind_functions(m);
    bind_written(m);
    bind_arrays(m);
    bind_shapes(m);
    bind_callbacks(m);
    bind_assemblies(m);
    bind_recording(m);
    bind_picture(m);
    bind_command(m);
    bind_robots(m);
    bind_batches(m);
    bind_environments(m);
    bind_decomposition(m);
}
