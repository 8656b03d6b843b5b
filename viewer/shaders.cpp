// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The shaders. All colour is linear; the target converts to sRGB.
// Sun: percentage-closer soft shadows (Fernando 2005): the mean depth of what stands before the point gives the penumbra's width, over which a
// fixed spiral of samples is averaged. The samples lie in the plane of the lit surface (receiver-plane bias), so wide penumbrae need no large
// offset. No noise turns the spiral: two renders are the same and the PNG stays small.
// Sky: kSkyLights hard shadows, one hardware-filtered comparison each, weighted by the cosine to the surface.
// Ground: lines whose coverage is integrated over the pixel's footprint (a box filter of a periodic pulse), so they neither shimmer nor break
// far away; beyond a few view distances the floor dissolves into the colour of the horizon.
#include "shaders.h"

namespace epode::viewer {

const char* const kShaderHead = R"(#version 330 core
#define SKY_LIGHTS 48
layout(std140) uniform Frame {
    mat4 camera;
    mat4 sun;
    mat4 sky[SKY_LIGHTS];
    vec4 sky_direction[SKY_LIGHTS];
    vec4 eye, target;
    vec4 view_right, view_up, view_forward;
    vec4 sun_right, sun_up, sun_direction;
    vec4 options, viewport;
};
)"
                                R"(
#ifdef FRAGMENT
uniform sampler2D sun_depth;
uniform sampler2DShadow sun_shadow;
uniform sampler2DArrayShadow sky_shadow;

const vec3 kSunLight = vec3(1.0, 0.90, 0.76) * 2.05;
const vec3 kZenith = vec3(0.23, 0.40, 0.66);
const vec3 kHorizon = vec3(0.74, 0.81, 0.87);
const vec3 kGround = vec3(0.46, 0.455, 0.44);
const float kSunWidth = 0.045;    // diameter of the sun over its distance: five times the real one, as thin haze makes it
const float kSunTexel = 1.0 / 4096.0;

vec2 spiral(int i, int count) {
    float radius = sqrt((float(i) + 0.5) / float(count)), turn = 2.39996323 * float(i);
    return radius * vec2(cos(turn), sin(turn));
}

float sun_visible(vec3 p, vec3 n) {
    vec3 q = (sun * vec4(p + n * sun_direction.w, 1.0)).xyz;
    if (any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0)))) return 1.0;
    float side = sun_right.w, range = sun_up.w;
    float facing = max(dot(n, sun_direction.xyz), 0.12);
    vec2 slope = vec2(dot(n, sun_right.xyz), dot(n, sun_up.xyz)) / facing * side / range;
    float width_of_depth = kSunWidth * range / side;
    float reach = clamp(0.5 * width_of_depth * q.z, 2.0 * kSunTexel, 60.0 * kSunTexel);
    float blockers = 0.0, depth = 0.0;
    for (int i = 0; i < 24; ++i) {
        vec2 o = spiral(i, 24) * reach;
        float d = texture(sun_depth, q.xy + o).r;
        if (d < q.z + dot(o, slope)) { blockers += 1.0; depth += q.z + dot(o, slope) - d; }
    }
    if (blockers == 0.0) return 1.0;
    float radius = max(0.5 * width_of_depth * depth / blockers, 1.3 * kSunTexel);
    float lit = 0.0;
    for (int i = 0; i < 40; ++i) {
        vec2 o = spiral(i, 40) * radius;
        lit += texture(sun_shadow, vec3(q.xy + o, min(q.z + dot(o, slope), 1.0)));
    }
    return lit / 40.0;
}

vec3 sky_light(vec3 p, vec3 n) {
    vec4 from = vec4(p + n * options.y, 1.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < SKY_LIGHTS; ++i) {
        vec3 d = sky_direction[i].xyz;
        float c = dot(n, d);
        if (c <= 0.0) continue;
        vec3 q = (sky[i] * from).xyz;
        sum += c * texture(sky_shadow, vec4(q.xy, float(i), min(q.z, 1.0))) * mix(kHorizon, kZenith, d.z);
    }
    return sum * (2.0 / float(SKY_LIGHTS));
}

vec3 sky_color(vec3 ray) {
    float height = max(ray.z, 0.0);
    return mix(kHorizon, kZenith, 1.0 - exp(-3.2 * height));
}

float haze(vec3 p) {
    float d = length(p.xy - target.xy) / eye.w;
    return 1.0 - exp(-0.055 * d * d);
}

// The shoulder of a film: black and middle grey stay, light that would clip is bent below white. By luminance, so hues stay too.
vec3 exposed(vec3 color) {
    float y = max(dot(color, vec3(0.2126, 0.7152, 0.0722)), 1e-5);
    float white = 1.9;
    return color * (1.0 + y / (white * white)) / (1.0 + y) * 1.28;
}

vec3 to_linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
#endif
)";

namespace {

constexpr char kShapeVertex[] = R"(
layout(location = 0) in vec3 corner;
layout(location = 1) in vec3 direction;
layout(location = 2) in vec4 row_x;
layout(location = 3) in vec4 row_y;
layout(location = 4) in vec4 row_z;
layout(location = 5) in vec4 core;
layout(location = 6) in vec3 color;
out vec3 world, normal, paint;
uniform mat4 view;
invariant gl_Position;
void main() {
    vec4 local = vec4(corner * core.xyz + direction * core.w, 1.0);
    world = vec3(dot(row_x, local), dot(row_y, local), dot(row_z, local));
    normal = vec3(dot(row_x.xyz, direction), dot(row_y.xyz, direction), dot(row_z.xyz, direction));
    paint = color;
    gl_Position = view * vec4(world, 1.0);
}
)";

constexpr char kNothing[] = R"(
void main() {}
)";

constexpr char kShapeFragment[] = R"(
in vec3 world, normal, paint;
out vec4 result;
void main() {
    vec3 n = normalize(normal);
    vec3 albedo = to_linear(paint);
    float facing = dot(n, sun_direction.xyz);
    float lit = facing > 0.0 ? facing * sun_visible(world, n) : 0.0;
    vec3 bounce = kGround * (0.5 - 0.5 * n.z) * 0.75;
    vec3 light = albedo * (kSunLight * lit + sky_light(world, n) + bounce);
    vec3 to_eye = normalize(eye.xyz - world);
    float shine = pow(max(dot(n, normalize(to_eye + sun_direction.xyz)), 0.0), 48.0);
    float rim = pow(1.0 - max(dot(n, to_eye), 0.0), 5.0);
    light += kSunLight * (lit > 0.0 ? lit / facing : 0.0) * shine * 0.10 + sky_color(reflect(-to_eye, n)) * rim * 0.12;
    result = vec4(mix(exposed(light), exposed(kHorizon), haze(world)), 1.0);
}
)";

constexpr char kGroundVertex[] = R"(
out vec3 world;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    world = vec3(target.xy + corner * 60.0 * eye.w, target.w);
    gl_Position = camera * vec4(world, 1.0);
}
)";

constexpr char kGroundFragment[] = R"(
in vec3 world;
out vec4 result;
// Part of the footprint `w` around x (in periods) that a line of width `part` at the whole numbers covers.
vec2 integral(vec2 x, float part) { return floor(x) * part + min(fract(x), part); }
float covered(vec2 x, float part) {
    vec2 w = max(fwidth(x), 1e-5);
    x += 0.5 * part;
    vec2 cover = (integral(x + 0.5 * w, part) - integral(x - 0.5 * w, part)) / w;
    return cover.x + cover.y - cover.x * cover.y;
}
void main() {
    vec3 n = vec3(0.0, 0.0, 1.0);
    vec3 albedo = kGround;
    if (options.x > 0.0) {
        vec2 cell = world.xy / options.x;
        albedo *= 1.0 - 0.16 * covered(cell, 0.018) - 0.16 * covered(cell / 5.0, 0.007);
    }
    vec3 light = albedo * (kSunLight * sun_direction.z * sun_visible(world, n) + sky_light(world, n));
    result = vec4(mix(exposed(light), exposed(kHorizon), haze(world)), 1.0);
}
)";

constexpr char kSkyVertex[] = R"(
out vec3 ray;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    ray = view_forward.xyz + corner.x * view_right.xyz + corner.y * view_up.xyz;
    gl_Position = vec4(corner, 1.0, 1.0);
}
)";

constexpr char kSkyFragment[] = R"(
in vec3 ray;
out vec4 result;
void main() { result = vec4(exposed(sky_color(normalize(ray))), 1.0); }
)";

constexpr char kLineVertex[] = R"(
layout(location = 0) in vec3 first;
layout(location = 1) in vec3 second;
layout(location = 2) in vec3 color;
out vec3 paint;
void main() {
    vec4 a = camera * vec4(first, 1.0), b = camera * vec4(second, 1.0);
    float near = 0.005 * eye.w;
    vec4 a_seen = a.w < near && b.w > near ? mix(a, b, (near - a.w) / (b.w - a.w)) : a;
    vec4 b_seen = b.w < near && a.w > near ? mix(b, a, (near - b.w) / (a.w - b.w)) : b;
    vec2 along = (b_seen.xy / b_seen.w - a_seen.xy / a_seen.w) * viewport.xy;
    vec2 side = length(along) > 1e-6 ? normalize(vec2(-along.y, along.x)) : vec2(1.0, 0.0);
    vec4 p = (gl_VertexID >> 1) == 0 ? a_seen : b_seen;
    p.xy += side * (float(gl_VertexID & 1) * 2.0 - 1.0) * 2.0 * viewport.z / viewport.xy * p.w;
    paint = color;
    gl_Position = p;
}
)";

constexpr char kLineFragment[] = R"(
in vec3 paint;
out vec4 result;
uniform float opacity;
void main() { result = vec4(to_linear(paint), opacity); }
)";

}  // namespace

const ProgramText kDepthProgram = {"depth", kShapeVertex, kNothing};
const ProgramText kShapeProgram = {"shape", kShapeVertex, kShapeFragment};
const ProgramText kGroundProgram = {"ground", kGroundVertex, kGroundFragment};
const ProgramText kSkyProgram = {"sky", kSkyVertex, kSkyFragment};
const ProgramText kLineProgram = {"line", kLineVertex, kLineFragment};

}  // namespace epode::viewer
