// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// drawstuff's C functions. Each is a line or two in front of the loop and the list of what is drawn; what a
// call outside its time does is decided here.
#include "drawstuff/drawstuff.h"

#include <cstdio>

#include "loop.h"
#include "messages.h"
#include "ppm.h"

namespace epode::drawstuff {

namespace {

DrawList& list_in_frame()
{
    const Loop* loop = Loop::current();
    if (!loop || !loop->in_frame()) fail("drawing function called outside simulation loop");
    return draw_list();
}

Loop& loop_for(const char* function)
{
    Loop* loop = Loop::current();
    if (!loop) fail("%s called before the simulation loop", function);
    return *loop;
}

void print_help_once()
{
    static bool printed = false;
    if (printed) return;
    printed = true;
    std::fputs(
        "Simulation\n"
        "  Ctrl-P  pause or go on (or start with -pause)    Ctrl-O  one step while paused\n"
        "  Ctrl-T  textures on or off (or -notex)           Ctrl-S  shadows on or off (or -noshadow)\n"
        "  Ctrl-V  print the viewpoint                      Ctrl-W  begin or end writing frame/frame0001.ppm "
        "...\n"
        "  Ctrl-X  end\n"
        "  mouse   left: turn    right: forwards and sideways    middle, or left and right: up and "
        "sideways\n",
        stderr);
}

// All four or none: a scene half in one style and half in another is a riddle.
void load_textures(const std::string& folder, viewer::Renderer& renderer)
{
    constexpr const char* kNames[viewer::kTextures] = {"wood", "checkered", "ground", "sky"};
    if (folder.empty()) return;
    viewer::Image images[viewer::kTextures];
    for (int i = 0; i < viewer::kTextures; ++i) {
        const std::string path = folder + "/" + kNames[i] + ".ppm";
        if (read_ppm(path, images[i])) continue;
        note("%s is missing or is no binary PPM: textures of drawstuff's own making are used", path.c_str());
        return;
    }
    for (int i = 0; i < viewer::kTextures; ++i)
        renderer.set_texture(static_cast<viewer::Texture>(i + 1), images[i]);
}

std::unique_ptr<Surface> open_surface(const Options& options, int width, int height)
{
    std::string error;
    if (!options.headless) {
        std::unique_ptr<Surface> window = make_window_surface();
        if (!window) {
            note(
                "built without GLFW, so there is no window: frames become files (see EPODE_FRAMES in "
                "drawstuff.h)");
        } else if (window->open(width, height, error)) {
            return window;
        } else {
            fail("%s (EPODE_GL=egl makes files instead)", error.c_str());
        }
    }
    std::unique_ptr<Surface> files = make_headless_surface(options);
    if (!files->open(width, height, error)) fail("%s", error.c_str());
    return files;
}

void simulate(int argc, char** argv, int width, int height, const dsFunctions& functions)
{
    const Options options = read_options(argc, argv, functions);
    width = std::min(width, viewer::kMaxPictureSide);
    height = std::min(height, viewer::kMaxPictureSide);
    print_help_once();
    const std::unique_ptr<Surface> surface = open_surface(options, width, height);
    const bool draws = !options.headless || !options.frame_folder.empty();
    viewer::Renderer renderer;
    std::string error;
    if (draws && !renderer.open(error)) fail("%s", error.c_str());
    if (draws) load_textures(options.texture_path, renderer);
    Loop(*surface, draws ? &renderer : nullptr, draw_list(), functions, options).run();
}

template <class Scalar>
void draw_convex(const Scalar* pos, const Scalar* R, unsigned faces, const Scalar* points,
                 unsigned point_count, const unsigned* polygons)
{
    DrawList& list = list_in_frame();
    if (!points || !polygons) return;
    for (unsigned face = 0; face < faces; ++face) {
        const unsigned count = *polygons++;
        bool exists = true;
        for (unsigned i = 0; i < count; ++i) exists = exists && polygons[i] < point_count;
        for (unsigned i = 2; exists && i < count; ++i) {
            list.triangle(pos, R, points + 3 * polygons[0], points + 3 * polygons[i - 1],
                          points + 3 * polygons[i], true);
        }
        polygons += count;
    }
}

template <class Scalar>
void draw_triangles(const Scalar* pos, const Scalar* R, const Scalar* v, int n, bool solid)
{
    DrawList& list = list_in_frame();
    if (!v) return;
    for (int i = 0; i < n; ++i, v += 9) list.triangle(pos, R, v, v + 3, v + 6, solid);
}

template <class Scalar>
void draw_box(const Scalar* pos, const Scalar* R, const Scalar* sides)
{
    DrawList& list = list_in_frame();
    if (sides)
        list.shape(viewer::ShapeKind::kBox, pos, R, static_cast<float>(sides[0]),
                   static_cast<float>(sides[1]), static_cast<float>(sides[2]));
}

}  // namespace

}  // namespace epode::drawstuff

using namespace epode::drawstuff;
using epode::viewer::ShapeKind;

extern "C" {

void dsSimulationLoop(int argc, char** argv, int window_width, int window_height, struct dsFunctions* fn)
{
    if (Loop::current()) fail("dsSimulationLoop called inside itself");
    if (!fn) abort_with("dsSimulationLoop: no dsFunctions given");
    if (fn->version > DS_VERSION)
        abort_with("dsSimulationLoop: version 0x%04x of dsFunctions is newer than 0x%04x", fn->version,
                   DS_VERSION);
    if (window_width < 1 || window_height < 1)
        abort_with("dsSimulationLoop: a window of %d by %d pixels", window_width, window_height);
    simulate(argc, argv, window_width, window_height, *fn);
}

void dsSetViewpoint(const float xyz[3], const float hpr[3])
{
    loop_for("dsSetViewpoint").viewpoint().set(xyz, hpr);
}

void dsGetViewpoint(float xyz[3], float hpr[3])
{
    const Viewpoint& viewpoint = loop_for("dsGetViewpoint").viewpoint();
    if (xyz) std::copy(viewpoint.xyz, viewpoint.xyz + 3, xyz);
    if (hpr) std::copy(viewpoint.hpr, viewpoint.hpr + 3, hpr);
}

void dsStop(void)
{
    if (Loop* loop = Loop::current()) loop->end();
}

double dsElapsedTime(void) { return loop_for("dsElapsedTime").elapsed(); }

void dsError(const char* msg, ...)
{
    std::va_list values;
    va_start(values, msg);
    print_failure("Error", msg, values);
    va_end(values);
    std::exit(1);
}

void dsDebug(const char* msg, ...)
{
    std::va_list values;
    va_start(values, msg);
    print_failure("INTERNAL ERROR", msg, values);
    va_end(values);
    std::abort();
}

void dsPrint(const char* msg, ...)
{
    std::va_list values;
    va_start(values, msg);
    std::vprintf(msg, values);
    va_end(values);
}

void dsSetTexture(int texture_number) { draw_list().set_texture(texture_number); }

void dsSetColor(float red, float green, float blue) { draw_list().set_color(red, green, blue, 1); }

void dsSetColorAlpha(float red, float green, float blue, float alpha)
{
    draw_list().set_color(red, green, blue, alpha);
}

void dsSetDrawMode(int mode) { draw_list().set_wire(mode == DS_WIREFRAME); }

void dsSetSphereQuality(int n) { draw_list().set_sphere_quality(n); }

void dsSetCapsuleQuality(int n) { draw_list().set_capsule_quality(n); }

void dsDrawBox(const float pos[3], const float R[12], const float sides[3]) { draw_box(pos, R, sides); }

void dsDrawBoxD(const double pos[3], const double R[12], const double sides[3]) { draw_box(pos, R, sides); }

void dsDrawSphere(const float pos[3], const float R[12], float radius)
{
    list_in_frame().shape(ShapeKind::kSphere, pos, R, radius, 0, 0);
}

void dsDrawSphereD(const double pos[3], const double R[12], float radius)
{
    list_in_frame().shape(ShapeKind::kSphere, pos, R, radius, 0, 0);
}

void dsDrawCylinder(const float pos[3], const float R[12], float length, float radius)
{
    list_in_frame().shape(ShapeKind::kCylinder, pos, R, radius, length, 0);
}

void dsDrawCylinderD(const double pos[3], const double R[12], float length, float radius)
{
    list_in_frame().shape(ShapeKind::kCylinder, pos, R, radius, length, 0);
}

void dsDrawCapsule(const float pos[3], const float R[12], float length, float radius)
{
    list_in_frame().shape(ShapeKind::kCapsule, pos, R, radius, length, 0);
}

void dsDrawCapsuleD(const double pos[3], const double R[12], float length, float radius)
{
    list_in_frame().shape(ShapeKind::kCapsule, pos, R, radius, length, 0);
}

void dsDrawTriangle(const float pos[3], const float R[12], const float* v0, const float* v1, const float* v2,
                    int solid)
{
    list_in_frame().triangle(pos, R, v0, v1, v2, solid != 0);
}

void dsDrawTriangleD(const double pos[3], const double R[12], const double* v0, const double* v1,
                     const double* v2, int solid)
{
    list_in_frame().triangle(pos, R, v0, v1, v2, solid != 0);
}

void dsDrawTriangles(const float pos[3], const float R[12], const float* v, int n, int solid)
{
    draw_triangles(pos, R, v, n, solid != 0);
}

void dsDrawTrianglesD(const double pos[3], const double R[12], const double* v, int n, int solid)
{
    draw_triangles(pos, R, v, n, solid != 0);
}

void dsDrawLine(const float pos1[3], const float pos2[3]) { list_in_frame().line(pos1, pos2); }

void dsDrawLineD(const double pos1[3], const double pos2[3]) { list_in_frame().line(pos1, pos2); }

void dsDrawConvex(const float pos[3], const float R[12], const float*, unsigned int _planecount,
                  const float* _points, unsigned int _pointcount, const unsigned int* _polygons)
{
    draw_convex(pos, R, _planecount, _points, _pointcount, _polygons);
}

void dsDrawConvexD(const double pos[3], const double R[12], const double*, unsigned int _planecount,
                   const double* _points, unsigned int _pointcount, const unsigned int* _polygons)
{
    draw_convex(pos, R, _planecount, _points, _pointcount, _polygons);
}

}  // extern "C"
