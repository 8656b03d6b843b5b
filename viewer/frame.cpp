// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Fitting the lights' maps to the shapes, and filling the uniform block.
// A light is a parallel projection along its direction. Its map is the smallest square, in the light's axes,
// around the box of all shapes near the camera's target; what stands outside that square neither casts nor
// receives (rays are parallel, so the shadow of the box on the ground falls inside the square by itself).
// Casters nearer to the light than the box are kept by clamping their depth. The sky's directions are a
// Fibonacci lattice on the half sphere: height z_i = (i + 1/2) / n gives equal areas, turning by the golden
// angle spreads them (Gonzalez 2010, "Measurement of areas on a sphere using Fibonacci and latitude-longitude
// lattices").
#include "frame.h"

#include <algorithm>

namespace epode::viewer {

namespace {

constexpr float kGoldenAngle = 2.39996323f;

struct Light {
    Mat4 matrix;
    Basis basis;
    float side, range;
};

float clamped(float x, float lo, float hi) { return std::min(std::max(x, lo), hi); }

Bounds lit_region(const Picture& picture)
{
    const Vec target = vec(picture.camera.target);
    const float reach = picture.shadow_reach * view_distance(picture.camera);
    Bounds all, near;
    near.add(target, reach);
    for (const Shape& shape : picture.shapes) {
        if (!drawable(shape)) continue;
        const Ball ball = bounding_ball(shape);
        if (length(ball.center - target) < reach + ball.radius) all.add(ball.center, ball.radius);
    }
    for (const Triangle& triangle : picture.triangles) {
        if (!drawable(triangle)) continue;
        for (const Corner& corner : triangle.corners) {
            if (length(vec(corner.pos) - target) < reach) all.add(vec(corner.pos), 0);
        }
    }
    if (all.empty()) return near;
    const auto inside = [&](Vec p) {
        return Vec{clamped(p.x, near.lo.x, near.hi.x), clamped(p.y, near.lo.y, near.hi.y),
                   clamped(p.z, near.lo.z, near.hi.z)};
    };
    all.lo = inside(all.lo);
    all.hi = inside(all.hi);
    return all;
}

Light fit_light(const Bounds& region, Vec to_light)
{
    Light light;
    light.basis = look_along(to_light, {0, 0, 1});
    Bounds seen;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec p = {(corner & 1 ? region.hi : region.lo).x, (corner & 2 ? region.hi : region.lo).y,
                       (corner & 4 ? region.hi : region.lo).z};
        seen.add({dot(p, light.basis.right), dot(p, light.basis.up), dot(p, light.basis.back)}, 0);
    }
    // Behind the box by as far as its shadow can fall, so that depth still measures the distance from shadow
    // to caster.
    seen.lo.z -= (region.hi.z - region.lo.z) / std::max(light.basis.back.z, 0.1f);
    light.side = std::max({seen.hi.x - seen.lo.x, seen.hi.y - seen.lo.y, 1e-6f}) * 1.01f;
    light.range = std::max(seen.hi.z - seen.lo.z, 1e-6f);
    const Vec center = 0.5f * (seen.lo + seen.hi);
    const Vec half = {0.5f * light.side, 0.5f * light.side, 0.5f * light.range};
    const Mat4 to_unit = {{0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0.5f, 0, 0.5f, 0.5f, 0.5f, 1}};
    light.matrix = to_unit * orthographic(center - half, center + half) * view_matrix(light.basis, {0, 0, 0});
    return light;
}

void store(float (&to)[4], Vec v, float w)
{
    to[0] = v.x;
    to[1] = v.y;
    to[2] = v.z;
    to[3] = w;
}

Vec sky_direction(int i, int count)
{
    const float z = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
    const float ring = std::sqrt(1 - z * z), turn = kGoldenAngle * static_cast<float>(i);
    return {ring * std::cos(turn), ring * std::sin(turn), z};
}

void set_spiral(Frame& frame, int count)
{
    for (int i = 0; i < count; ++i) {
        const float radius = std::sqrt((static_cast<float>(i) + 0.5f) / static_cast<float>(count)),
                    turn = kGoldenAngle * static_cast<float>(i);
        store(frame.spiral[i], {radius * std::cos(turn), radius * std::sin(turn), 0}, 0);
    }
}

void set_lights(Frame& frame, const Picture& picture, const Quality& quality)
{
    Bounds region = lit_region(picture);
    if (picture.ground)
        region.lo.z =
            std::min(region.lo.z, std::max(picture.ground_height, region.lo.z - (region.hi.z - region.lo.z)));
    const Light sun = fit_light(region, normalize(vec(picture.sun), {0, 0, 1}));
    frame.sun = sun.matrix;
    store(frame.sun_right, sun.basis.right, sun.side);
    store(frame.sun_up, sun.basis.up, sun.range);
    store(frame.sun_direction, sun.basis.back, 1.5f * sun.side / static_cast<float>(quality.sun_map));
    float widest = 0;
    for (int i = 0; i < quality.sky_lights; ++i) {
        const Light light = fit_light(region, sky_direction(i, quality.sky_lights));
        frame.sky[i] = light.matrix;
        store(frame.sky_direction[i], light.basis.back, 0);
        widest = std::max(widest, light.side);
    }
    store(frame.options,
          {picture.grid > 0 ? picture.grid : 0, 2 * widest / static_cast<float>(quality.sky_map),
           static_cast<float>(quality.sky_lights)},
          static_cast<float>(quality.sun_samples));
}

}  // namespace

Quality bounded(const Quality& quality)
{
    return {std::clamp(quality.sun_map, kMinMapSide, kMaxMapSide),
            std::clamp(quality.sky_map, kMinMapSide, kMaxMapSide),
            std::clamp(quality.sky_lights, 0, kSkyLights), std::clamp(quality.sun_samples, 4, kSpiral)};
}

Frame make_frame(const Picture& picture)
{
    Frame frame{};
    const Quality quality = bounded(picture.quality);
    const Camera& camera = picture.camera;
    const auto width = static_cast<float>(picture.width), height = static_cast<float>(picture.height);
    frame.camera = camera_matrix(camera, width / height);
    store(frame.eye, vec(camera.eye), view_distance(camera));
    store(frame.target, vec(camera.target), picture.ground_height);
    const Basis basis = look_along(vec(camera.eye) - vec(camera.target), vec(camera.up));
    const float tangent = std::tan(camera.fov * 3.14159265f / 360);
    store(frame.view_right, (tangent * width / height) * basis.right, 0);
    store(frame.view_up, tangent * basis.up, 0);
    store(frame.view_forward, -1 * basis.back, 0);
    store(frame.viewport, {width, height, 0.5f * picture.line_width * height / 720},
          1 / static_cast<float>(quality.sun_map));
    store(frame.look, {picture.haze, static_cast<float>(picture.floor), static_cast<float>(picture.clouds)},
          picture.hidden_lines);
    store(frame.state, {static_cast<float>(picture.shadows), camera.shift[0], camera.shift[1]}, 0);
    set_lights(frame, picture, quality);
    set_spiral(frame, quality.sun_samples);
    return frame;
}

}  // namespace epode::viewer
