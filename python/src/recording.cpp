// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See recording.h.
#include "recording.h"

#include <nanobind/stl/pair.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>

#include "record/file/reader.h"
#include "record/file/writer.h"
#include "record/output/csv.h"
#include "record/output/glb.h"
#include "record/output/page.h"
#include "record/watch/figures.h"

namespace {

using epode::record::ContactSeen;
using epode::record::Info;
using epode::record::Recording;
using epode::record::Step;
using epode::record::StepFigures;

[[noreturn]] void fail(const std::string& problem)
{
    PyErr_SetString(PyExc_OSError, problem.c_str());
    throw nb::python_error();
}

std::vector<ContactSeen> contacts_of(dWorldID world)
{
    std::vector<dWorldContact> found(size_t(std::max(dWorldGetContacts(world, nullptr, 0), 0)));
    if (!found.empty()) dWorldGetContacts(world, found.data(), int(found.size()));
    std::vector<ContactSeen> seen;
    for (const dWorldContact& from : found) {
        ContactSeen& to = seen.emplace_back();
        to.geom[0] = from.g1;
        to.geom[1] = from.g2;
        to.depth = from.depth;
        for (int i = 0; i < 3; ++i) {
            to.pos[i] = from.pos[i];
            to.normal[i] = from.normal[i];
            to.force[i] = from.normal[i] * from.normal_force + from.friction_force[i];
        }
    }
    return seen;
}

// The state now: of the beginning (dt 0), or after a step.
void take_state(WorldRecording& self, const WorldHandle* world, double time, double dt, double milliseconds)
{
    Call call;
    call.uses(get(world));
    StepFigures figures;
    figures.time = time;
    figures.dt = dt;
    figures.ms = milliseconds;
    epode::record::measure(get(world), self.recorder.bodies(), self.recorder.joints(), figures);
    self.recorder.step(figures, contacts_of(get(world)), true);
    call.done();
}

template <typename H>
void add(WorldRecording& self, const H* handle)
{
    Call call;
    self.recorder.add(get(handle));
    call.done();
}
template <typename H>
void remove(WorldRecording& self, const H* handle)
{
    self.recorder.remove(get(handle));
}

bool ends_with(const std::string& text, const char* ending) { return text.ends_with(ending); }

void save(const WorldRecording& self, const std::string& path, double fps)
{
    std::string problem;
    bool done = false;
    if (ends_with(path, ".epr"))
        done = epode::record::write_file(self.recording, path, problem);
    else if (ends_with(path, ".glb"))
        done = epode::record::write_glb(self.recording, path, fps, problem);
    else if (ends_with(path, ".html"))
        done = epode::record::write_page(self.recording, path, fps, problem);
    else if (ends_with(path, ".csv"))
        done = epode::record::write_csv(self.recording, path, problem);
    else
        throw nb::value_error(("the ending of '" + path + "' is none of .epr .glb .html .csv").c_str());
    if (!done) fail("'" + path + "': " + problem);
}

void load(WorldRecording& self, const std::string& path)
{
    auto result = epode::record::read_file(path, self.recording);
    if (!result.whole()) fail("'" + path + "': " + result.problem);
}

const Step& state_at(const WorldRecording& self, size_t state)
{
    if (state >= self.recording.steps.size()) throw nb::index_error("there is no such state");
    return self.recording.steps[state];
}

// One row a state: time, dt, kinetic and potential energy, contacts, ms.
nb::object figures(const WorldRecording& self)
{
    dReal* out;
    nb::object rows = real_array(self.recording.steps.size(), 6, &out);
    for (const Step& s : self.recording.steps) {
        const double row[] = {s.time, s.dt, s.kinetic, s.potential, double(s.contacts.size()), s.ms};
        out = std::copy(row, row + 6, out);
    }
    return rows;
}

// One row a body that lives in a state: position 3, quaternion 4, velocity 3, angular velocity 3.
nb::object bodies(const WorldRecording& self, size_t state)
{
    const Step& step = state_at(self, state);
    dReal* out;
    nb::object rows = real_array(step.bodies.size(), 13, &out);
    for (const auto& b : step.bodies) {
        out = std::copy_n(b.pose.pos.data(), 3, out);
        out = std::copy_n(b.pose.turn.data(), 4, out);
        out = std::copy_n(b.linear.data(), 3, out);
        out = std::copy_n(b.angular.data(), 3, out);
    }
    return rows;
}

}  // namespace

void bind_recording(nb::module_& m)
{
    nb::class_<WorldRecording>(m, "WorldRecording")
        .def(nb::init<>())
        .def("add_body", add<BodyHandle>)
        .def("add_geom", add<GeomHandle>)
        .def("add_joint", add<JointHandle>)
        .def("remove_body", remove<BodyHandle>)
        .def("remove_geom", remove<GeomHandle>)
        .def("remove_joint", remove<JointHandle>)
        .def("about",
             [](WorldRecording& self, const std::vector<std::pair<std::string, std::string>>& pairs) {
                 self.recording.info(Info(pairs.begin(), pairs.end()));
             })
        .def("value", [](const WorldRecording& self,
                         const std::string& key) { return self.recording.about_value(key); })
        .def("take_state", take_state)
        .def("__len__", [](const WorldRecording& self) { return self.recording.steps.size(); })
        .def("hash", [](const WorldRecording& self, size_t state) { return state_at(self, state).hash; })
        .def("figures", figures)
        .def("bodies", bodies)
        .def("living",
             [](const WorldRecording& self, size_t state) {
                 state_at(self, state);
                 return self.recording.living(state);
             })
        .def("save", save)
        .def("load", load)
        .def(
            "picture",
            [](const WorldRecording& self, size_t state, int width, int height, nb::object eye,
               nb::object target, nb::object up, double field) {
                state_at(self, state);
                return picture_of(self.recording, state, width, height, {eye, target, up, field});
            },
            nb::arg("state"), nb::arg("width"), nb::arg("height"), nb::arg("eye").none(),
            nb::arg("target").none(), nb::arg("up").none(), nb::arg("field"));
}
