// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A picture is plain data: shapes, triangles, lines, a camera, a size. write_png turns it into a file,
// offscreen, with no display and no GPU needed; a Renderer (renderer.h) draws one after the other, in a
// window too. World: right-handed, z up, metres. Colours are the sRGB numbers 0..1 that one writes in a style
// sheet; light is computed in linear space. What cannot be drawn (a pose that is not finite, a size that is
// not positive) is left out of the picture and the rest is drawn: the picture of a simulation that went wrong
// is wanted most of all. Plain structs rather than a scene graph: a picture is made once and thrown away, and
// the caller needs no knowledge of OpenGL, nor this library of ODE.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace epode::viewer {

struct Color {
    float r = 0.8f, g = 0.8f, b = 0.8f;
};

// What the colour of a surface is multiplied with; of our own making (textures.h) unless the caller has
// others.
enum class Texture { kNone, kWood, kCheckered, kGround, kSky };

enum class ShapeKind { kSphere, kBox, kCapsule, kCylinder };

struct Shape {
    ShapeKind kind = ShapeKind::kBox;
    // sphere: radius, unused, unused      box: full side lengths along local x, y, z
    // capsule and cylinder: radius, length along local z (a capsule's length leaves out its two caps, as in
    // ODE), unused
    float size[3] = {1, 1, 1};
    float pos[3] = {0, 0, 0};
    float rot[12] = {1, 0, 0, 0, 0, 1,
                     0, 0, 0, 0, 1, 0};  // ODE's dMatrix3: three rows of four, the fourth column unused
    Color color;
    float alpha = 1;  // opacity; below 1 what lies behind shines through, below a half there is no shadow
    Texture texture = Texture::kNone;
    bool wire = false;  // the edges of its mesh instead of its surface
    int steps = 0;      // of spheres and capsules: pieces into which 45 degrees are cut, 1 to 16; 0: enough
};

// One triangle of a surface, seen from both sides. `local` is where it lies in its texture's space, in
// metres.
struct Corner {
    float pos[3] = {0, 0, 0};
    float normal[3] = {0, 0, 1};
    float local[3] = {0, 0, 0};
};

struct Triangle {
    Corner corners[3];
    Color color;
    float alpha = 1;
    Texture texture = Texture::kNone;
    bool wire = false;
};

// Drawn over the shapes, faintly where a shape hides it: joints, chains, trajectories.
struct Line {
    float a[3] = {0, 0, 0};
    float b[3] = {0, 0, 0};
    Color color{0.15f, 0.15f, 0.17f};
};

struct Camera {
    float eye[3] = {5, -8, 4};
    float target[3] = {0, 0, 1};
    float up[3] = {0, 0, 1};
    float fov = 32;  // vertical opening, degrees
    // The whole picture is moved to the right and up by these parts of half its width and height, as by a
    // lens that is shifted: what is looked at leaves the middle and keeps its perspective.
    float shift[2] = {0, 0};
};

// How much work a picture may be. kFine takes about a second without a GPU, kQuick a few hundredths.
struct Quality {
    int sun_map = 4096;  // sides of the depth maps, in pixels
    int sky_map = 768;
    int sky_lights =
        48;  // points of the sky that throw shadows, 0 to 48; 0: the sky shines through everything
    int sun_samples = 48;  // looks into the sun's map for one point, 4 to 48
    bool operator==(const Quality&) const = default;
};
constexpr Quality kFine{};
constexpr Quality kQuick{2048, 0, 0, 12};

// The floor: endless and plain with lines, or 200 m by 200 m with the ground's texture.
enum class Floor { kGrid, kTextured, kPlain };

struct Picture {
    std::vector<Shape> shapes;
    std::vector<Triangle> triangles;
    std::vector<Line> lines;
    Camera camera;
    int width = 1280;
    int height = 720;
    bool ground = true;  // an endless floor at z = ground_height
    float ground_height = 0;
    float grid = 1;                          // spacing of the floor's lines; 0: none
    float sun[3] = {-0.60f, -0.50f, 0.80f};  // towards the sun, any length
    float line_width = 3;                    // pixels in a picture 720 high, scaled with the height
    float hidden_lines = 0.28f;              // opacity of lines where shapes hide them
    Floor floor = Floor::kGrid;
    bool clouds = false;  // the sky's texture instead of a clear sky
    bool shadows = true;
    float haze = 0.055f;        // at x view distances 1 - exp(-haze x^2) of the floor is sky
    float shadow_reach = 2.5f;  // in view distances: how far from the target shapes still have shadows
    Quality quality = kFine;
};

constexpr int kMaxPictureSide = 4096;

// Renders and writes an 8-bit RGB PNG. On failure returns false, error says why in words, and no file is
// begun.
bool write_png(const Picture& picture, const char* path, std::string& error);

// A three-quarter view in which every drawable shape is wholly visible. aspect = width / height. The eye
// looks from `azimuth` degrees (counter-clockwise from +x, about z) and `elevation` degrees above the
// horizon.
Camera frame_shapes(std::span<const Shape> shapes, float aspect, float azimuth = -62, float elevation = 17);

// Where a world point appears: pixel[0] to the right, pixel[1] downwards from the upper left corner. False
// behind the eye.
bool project(const Camera& camera, int width, int height, const float point[3], float pixel[2]);

// An endless row of muted colours that go well together; the same index gives the same colour.
Color palette(int index);
// Of bodies by their number, so that neighbours in the order of making, which lie in rows, make no stripes.
Color body_color(std::uint32_t number);
constexpr Color kStone{0.62f, 0.61f, 0.59f};  // of what does not move

// False for what pictures leave out.
bool drawable(const Shape& shape);
bool drawable(const Triangle& triangle);

// Copies a pose in ODE's layout, whatever its precision.
template <class Scalar>
void set_pose(Shape& shape, const Scalar* pos, const Scalar* rot)
{
    for (int i = 0; i < 3; ++i) shape.pos[i] = static_cast<float>(pos[i]);
    for (int i = 0; i < 12; ++i) shape.rot[i] = i % 4 == 3 ? 0.0f : static_cast<float>(rot[i]);
}

}  // namespace epode::viewer
