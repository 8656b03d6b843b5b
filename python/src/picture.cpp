// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recorded state as pixels, drawn without display or GPU, or into the OpenGL context that is current in this thread:
// epode.viewer opens windows with the package glfw from PyPI, so this module needs no window system to be imported.
#include "recording.h"

#ifdef EPODE_HAVE_DRAWING

#include <algorithm>
#include <cstring>
#include <memory>

#include "studio.h"
#include "viewer/headless.h"
#include "viewer/renderer.h"

namespace {

using namespace epode;

[[noreturn]] void fail(const std::string& problem)
{
    PyErr_SetString(PyExc_RuntimeError, problem.c_str());
    throw nb::python_error();
}

void set_camera(Studio& studio, const View& view)
{
    viewer::Picture& picture = studio.picture;
    picture.camera = viewer::frame_shapes(studio.extents, float(picture.width) / float(picture.height));
    const auto take = [](nb::object from, const char* name, float(&to)[3]) {
        if (!from.is_none()) std::copy_n(numbers<3>(from, name).v, 3, to);
    };
    take(view.eye, "eye", picture.camera.eye), take(view.target, "target", picture.camera.target);
    take(view.up, "up", picture.camera.up);
    if (view.field > 0) picture.camera.fov = float(view.field * 180 / 3.14159265358979323846);
}

// Lines that a program adds: nine floats each, both ends and the colour.
void add_lines(viewer::Picture& picture, const nb::bytes& from)
{
    constexpr size_t kSize = 9 * sizeof(float);
    for (size_t at = 0; at + kSize <= from.size(); at += kSize) {
        float its[9];
        std::memcpy(its, from.c_str() + at, kSize);
        viewer::Line line;
        std::copy_n(its, 3, line.a), std::copy_n(its + 3, 3, line.b);
        line.color = {its[6], its[7], its[8]};
        picture.lines.push_back(line);
    }
}

// Draws into the context that was current when it was made; it is used and dies while that one is current.
class Painter {
  public:
    Painter()
    {
        std::string problem;
        renderer_ = std::make_unique<viewer::Renderer>();
        if (!renderer_->open(problem)) fail(problem);
    }

    // Into the window, `left` pixels from its left side.
    void draw(const WorldRecording& from, size_t state, int width, int height, const View& view,
              const nb::bytes& lines, int left)
    {
        if (state >= from.recording.steps.size()) throw nb::index_error("there is no such state");
        Studio studio(from.recording, state);
        studio.picture.width = width;
        studio.picture.height = height;
        studio.picture.quality = viewer::kQuick;
        set_camera(studio, view);
        add_lines(studio.picture, lines);
        std::string problem;
        if (!viewer::check_picture(studio.picture, problem) || !renderer_->draw(studio.picture, problem))
            fail(problem);
        renderer_->show(0, left);
    }

    // An image of rows from the top over the window, which is `below` pixels high, from x to the right and y down on.
    void lay(const nb::bytes& pixels, int width, int height, int x, int y, int below)
    {
        if (width < 1 || height < 1 || pixels.size() != 3 * size_t(width) * size_t(height))
            throw nb::value_error("pixels of three bytes each are expected, as many as the panel has");
        viewer::Renderer::lay(0, {width, height, reinterpret_cast<const std::uint8_t*>(pixels.c_str())}, x, y,
                              below);
    }

    void close() { renderer_.reset(); }

  private:
    std::unique_ptr<viewer::Renderer> renderer_;
};

// The eye and the target from which a state can be seen as a whole.
nb::object camera(const WorldRecording& from, size_t state, double aspect)
{
    if (state >= from.recording.steps.size()) throw nb::index_error("there is no such state");
    const Studio studio(from.recording, state);
    const viewer::Camera its = viewer::frame_shapes(studio.extents, float(aspect));
    const dReal eye[] = {its.eye[0], its.eye[1], its.eye[2]},
                target[] = {its.target[0], its.target[1], its.target[2]};
    return nb::make_tuple(array_of(eye, 3), array_of(target, 3));
}

nb::bytes screen(int width, int height)
{
    const std::vector<std::uint8_t> pixels = viewer::read_pixels(0, width, height);
    return nb::bytes(pixels.data(), pixels.size());
}

}  // namespace

nb::bytes picture_of(const record::Recording& recording, size_t state, int width, int height,
                     const View& view)
{
    Studio studio(recording, state);
    studio.picture.width = width;
    studio.picture.height = height;
    set_camera(studio, view);
    std::string problem;
    std::vector<std::uint8_t> pixels;
    bool drawn = false;
    {
        const WithoutGil released;
        viewer::Headless context;
        const bool open = context.open(problem);
        viewer::Renderer renderer;
        drawn = open && viewer::check_picture(studio.picture, problem) && renderer.open(problem) &&
                renderer.draw(studio.picture, problem) && renderer.read(pixels, problem);
    }
    if (!drawn) fail(problem);
    return nb::bytes(pixels.data(), pixels.size());
}

void bind_picture(nb::module_& m)
{
    nb::class_<Painter>(m, "_Painter")
        .def(nb::init<>())
        .def(
            "draw",
            [](Painter& its, const WorldRecording& from, size_t state, int width, int height, nb::object eye,
               nb::object target, nb::object up, double field, const nb::bytes& lines, int left) {
                its.draw(from, state, width, height, {eye, target, up, field}, lines, left);
            },
            "recording"_a, "state"_a, "width"_a, "height"_a, "eye"_a.none(), "target"_a.none(),
            "up"_a.none() = nb::none(), "field"_a = 0.0, "lines"_a = nb::bytes("", 0), "left"_a = 0)
        .def("lay", &Painter::lay, "pixels"_a, "width"_a, "height"_a, "x"_a, "y"_a, "below"_a)
        .def("close", &Painter::close);
    m.def("_camera", camera, "recording"_a, "state"_a, "aspect"_a);
    m.def("_screen", screen, "width"_a, "height"_a);
}

#else

nb::bytes picture_of(const epode::record::Recording&, size_t, int, int, const View&)
{
    PyErr_SetString(
        PyExc_RuntimeError,
        "this build of epode draws no pictures: libepoxy-dev, libegl-dev and libstb-dev were not there");
    throw nb::python_error();
}

void bind_picture(nb::module_&) {}

#endif
