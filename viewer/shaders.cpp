// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The shaders. All colour is linear; the target converts to sRGB.
// Sun: percentage-closer soft shadows (Fernando 2005): the mean depth of what stands before the point gives
// the penumbra's width, over which a fixed spiral of samples is averaged. The samples lie in the plane of the
// lit surface (receiver-plane bias), so wide penumbrae need no large offset. No noise turns the spiral: two
// renders are the same and the PNG stays small. Sky: kSkyLights hard shadows, one hardware-filtered
// comparison each, weighted by the cosine to the surface. Ground: lines whose coverage is integrated over the
// pixel's footprint (a box filter of a periodic pulse), so they neither shimmer nor break far away; beyond a
// few view distances the floor dissolves into the colour of the horizon. Deferred: shapes and ground only
// write where and what they are, four samples a pixel; light is computed once per pixel and surface, so its
// cost follows the picture's size and not the number of triangles. Samples of one pixel that agree in place,
// direction and colour share one computation; only where surfaces meet are there more. What is translucent
// is lit where it is drawn, over a veil of its own with the same samples.
// Textures lie in a surface's own space along its three axes, each seen by the share of the normal
// (triplanar): every shape has them without coordinates of its own and without poles.
#include "shaders.h"

namespace epode::viewer {

const char* const kShaderHead = R"(layout(std140) uniform Frame {
    mat4 camera;
    mat4 sun;
    mat4 sky[SKY_LIGHTS];
    vec4 sky_direction[SKY_LIGHTS];
    vec4 eye, target;
    vec4 view_right, view_up, view_forward;
    vec4 sun_right, sun_up, sun_direction;
    vec4 options, viewport, look, state;
    vec4 spiral[SPIRAL];
};
// What the vertices of shapes and of triangles tell of their surface.
#define SURFACE(way) way vec3 normal, local, local_normal; way vec4 paint; flat way float layer; centroid way vec3 world;
)"
                                R"(
#ifdef FRAGMENT
uniform sampler2D sun_depth;
uniform sampler2DShadow sun_shadow;
uniform sampler2DArrayShadow sky_shadow;
uniform sampler2DMS places, normals, paints;
uniform sampler2DArray textures;

const vec3 kSunLight = vec3(1.0, 0.90, 0.76) * 2.05;
const vec3 kZenith = vec3(0.17, 0.36, 0.68);
const vec3 kHorizon = vec3(0.77, 0.86, 0.95);
const vec3 kGroundPaint = vec3(0.66, 0.65, 0.635);
const float kSunWidth = 0.045;    // diameter of the sun over its distance: five times the real one, as thin haze makes it
const float kTextureSize = 1.25;  // metres of a shape that a texture covers

float sun_visible(vec3 p, vec3 n) {
    if (state.x < 0.5) return 1.0;
    float texel = viewport.w;
    int samples = int(options.w);
    vec3 q = (sun * vec4(p + n * sun_direction.w, 1.0)).xyz;
    if (any(lessThan(q.xy, vec2(0.0))) || any(greaterThan(q.xy, vec2(1.0)))) return 1.0;
    float side = sun_right.w, range = sun_up.w;
    float facing = max(dot(n, sun_direction.xyz), 0.12);
    vec2 slope = vec2(dot(n, sun_right.xyz), dot(n, sun_up.xyz)) / facing * side / range;
    float width_of_depth = kSunWidth * range / side;
    float reach = clamp(0.5 * width_of_depth * q.z, 2.0 * texel, 60.0 * texel);
    float blockers = 0.0, depth = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 o = spiral[i].xy * reach;
        float d = texture(sun_depth, q.xy + o).r;
        if (d < q.z + dot(o, slope)) { blockers += 1.0; depth += q.z + dot(o, slope) - d; }
    }
    if (blockers == 0.0) return 1.0;
    float radius = max(0.5 * width_of_depth * depth / blockers, 1.3 * texel);
    float lit = 0.0;
    for (int i = 0; i < samples; ++i) {
        vec2 o = spiral[i].xy * radius;
        lit += texture(sun_shadow, vec3(q.xy + o, min(q.z + dot(o, slope), 1.0)));
    }
    return lit / float(samples);
}

// Without shadows the sky's light has a closed form: the integral over the half sphere, fitted by a parabola in
// the normal's height through the values up, sideways and down.
vec3 open_sky_light(vec3 n) {
    float z = n.z;
    return kHorizon * (0.288 + 0.167 * z - 0.122 * z * z) + kZenith * (0.212 + 0.333 * z + 0.122 * z * z);
}

vec3 sky_light(vec3 p, vec3 n) {
    int count = int(options.z);
    if (count == 0 || state.x < 0.5) return open_sky_light(n);
    vec4 from = vec4(p + n * options.y, 1.0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < count; ++i) {
        vec3 d = sky_direction[i].xyz;
        float c = dot(n, d);
        if (c <= 0.0) continue;
        vec3 q = (sky[i] * from).xyz;
        sum += c * texture(sky_shadow, vec4(q.xy, float(i), min(q.z, 1.0))) * mix(kHorizon, kZenith, d.z);
    }
    return sum * (2.0 / options.z);
}

vec3 sky_color(vec3 ray) {
    float height = max(ray.z, 0.0);
    return mix(kHorizon, kZenith, 1.0 - exp(-6.0 * height));
}

float haze(vec3 p) {
    float d = length(p.xy - target.xy) / eye.w;
    return 1.0 - exp(-look.x * d * d);
}

// The shoulder of a film: black and middle grey stay, light that would clip is bent below white. By luminance, so hues stay too.
vec3 exposed(vec3 color) {
    float y = max(dot(color, vec3(0.2126, 0.7152, 0.0722)), 1e-5);
    float white = 1.9;
    return color * (1.0 + y / (white * white)) / (1.0 + y) * 1.2;
}

vec3 to_linear(vec3 c) { return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c)); }
)"
                                R"(
// Layer 1 to 4, 0 for none.
vec3 textured(vec3 paint, float layer, vec3 p, vec3 n) {
    if (layer < 0.5) return paint;
    vec3 share = n * n * n * n;
    share /= share.x + share.y + share.z;
    vec3 q = p / kTextureSize;
    return paint * (share.x * texture(textures, vec3(q.yz, layer - 1.0)).rgb +
                    share.y * texture(textures, vec3(q.xz, layer - 1.0)).rgb +
                    share.z * texture(textures, vec3(q.xy, layer - 1.0)).rgb);
}

// What comes from a surface to the eye. place.w: 1 shape, 2 ground.
vec3 lit(vec4 place, vec3 n, vec3 paint) {
    bool is_shape = place.w < 1.5;
    vec3 p = place.xyz;
    float facing = dot(n, sun_direction.xyz);
    float visible = facing > 0.0 ? sun_visible(p, n) : 0.0;
    vec3 bounce = to_linear(kGroundPaint) * (0.5 - 0.5 * n.z) * 0.75;
    vec3 light = to_linear(paint) * (kSunLight * max(facing, 0.0) * visible + sky_light(p, n) + bounce);
    if (is_shape) {
        vec3 to_eye = normalize(eye.xyz - p);
        float shine = pow(max(dot(n, normalize(to_eye + sun_direction.xyz)), 0.0), 48.0);
        float rim = pow(1.0 - max(dot(n, to_eye), 0.0), 5.0);
        light += kSunLight * visible * shine * 0.10 + sky_color(reflect(-to_eye, n)) * rim * 0.12;
    }
    return mix(exposed(light), exposed(kHorizon), haze(p));
}
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
layout(location = 6) in vec4 color;
layout(location = 7) in float texture_layer;
SURFACE(out)
uniform mat4 view;
void main() {
    local = corner * core.xyz + direction * core.w;
    vec4 p = vec4(local, 1.0);
    world = vec3(dot(row_x, p), dot(row_y, p), dot(row_z, p));
    normal = vec3(dot(row_x.xyz, direction), dot(row_y.xyz, direction), dot(row_z.xyz, direction));
    local_normal = direction;
    paint = color;
    layer = texture_layer;
    gl_Position = view * vec4(world, 1.0);
}
)";

// Triangles come in world coordinates, their textures' place and normal with them.
constexpr char kTriangleVertex[] = R"(
layout(location = 0) in vec3 place;
layout(location = 1) in vec3 direction;
layout(location = 2) in vec3 in_texture;
layout(location = 3) in vec3 texture_normal;
layout(location = 4) in vec4 color;
layout(location = 5) in float texture_layer;
SURFACE(out)
uniform mat4 view;
void main() {
    world = place;
    normal = direction;
    local = in_texture;
    local_normal = texture_normal;
    paint = color;
    layer = texture_layer;
    gl_Position = view * vec4(world, 1.0);
}
)";

constexpr char kNothing[] = R"(
void main() {}
)";

// What a surface writes of itself: place and kind (0 sky, 1 shape, 2 ground), normal, sRGB paint.
constexpr char kShapeFragment[] = R"(
SURFACE(in)
layout(location = 0) out vec4 place;
layout(location = 1) out vec4 direction;
layout(location = 2) out vec4 surface;
void main() {
    place = vec4(world, 1.0);
    direction = vec4(gl_FrontFacing ? normalize(normal) : -normalize(normal), 0.0);
    surface = vec4(textured(paint.rgb, layer, local, local_normal), 1.0);
}
)";

// The same, lit at once, times its opacity.
constexpr char kVeilFragment[] = R"(
SURFACE(in)
out vec4 result;
void main() {
    vec3 n = gl_FrontFacing ? normalize(normal) : -normalize(normal);
    result = vec4(lit(vec4(world, 1.0), n, textured(paint.rgb, layer, local, local_normal)), 1.0) * paint.a;
}
)";

constexpr char kVeilOverFragment[] = R"(
uniform sampler2DMS veil;
out vec4 result;
void main() {
    vec4 sum = vec4(0.0);
    for (int i = 0; i < SAMPLES; ++i) sum += texelFetch(veil, ivec2(gl_FragCoord.xy), i);
    result = sum / float(SAMPLES);
}
)";

// From the canvas, which OpenGL decodes as it is read, to a window whose pixels are sRGB by habit.
constexpr char kShowFragment[] = R"(
uniform sampler2D canvas;
uniform int left;
out vec4 result;
void main() {
    vec3 c = texelFetch(canvas, ivec2(gl_FragCoord.xy) - ivec2(left, 0), 0).rgb;
    result = vec4(mix(c * 12.92, 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c)), 1.0);
}
)";

constexpr char kGroundVertex[] = R"(
centroid out vec3 world;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    world = vec3(look.y < 0.5 ? target.xy + corner * 60.0 * eye.w : corner * 100.0, target.w);
    gl_Position = camera * vec4(world, 1.0);
}
)";

constexpr char kGroundFragment[] = R"(
centroid in vec3 world;
layout(location = 0) out vec4 place;
layout(location = 1) out vec4 direction;
layout(location = 2) out vec4 surface;
// Part of the footprint `w` around x (in periods) that a line of width `part` at the whole numbers covers.
vec2 integral(vec2 x, float part) { return floor(x) * part + min(fract(x), part); }
float covered(vec2 x, vec2 footprint, float part) {
    vec2 w = max(footprint, 1e-5);
    x += 0.5 * part;
    vec2 cover = (integral(x + 0.5 * w, part) - integral(x - 0.5 * w, part)) / w;
    return cover.x + cover.y - cover.x * cover.y;
}
void main() {
    vec3 paint = kGroundPaint;
    vec2 footprint = fwidth(world.xy);
    if (options.x > 0.0) {
        float every = covered(world.xy / options.x, footprint / options.x, 0.018);
        float fifth = covered(world.xy / (5.0 * options.x), footprint / (5.0 * options.x), 0.007);
        paint *= 1.0 - 0.09 * every - 0.09 * fifth;
    }
    if (look.y > 0.5) paint = look.y < 1.5 ? texture(textures, vec3(world.xy / 5.0, 2.0)).rgb : vec3(0.56, 0.62, 0.44);
    place = vec4(world, 2.0);
    direction = vec4(0.0, 0.0, 1.0, 0.0);
    surface = vec4(paint, 1.0);
}
)";

constexpr char kLightVertex[] = R"(
out vec3 ray;
void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0;
    ray = view_forward.xyz + (corner.x - state.y) * view_right.xyz + (corner.y - state.z) * view_up.xyz;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

constexpr char kLightFragment[] = R"(
in vec3 ray;
out vec4 result;
const int kSamples = SAMPLES;
// Clouds hang in a plane over the eye; near the horizon they dissolve.
vec3 clouds(vec3 d, vec2 where) {
    vec3 seen = to_linear(texture(textures, vec3(where, 3.0)).rgb);
    return mix(exposed(kHorizon), seen, 1.0 - exp(-7.0 * max(d.z, 0.0)));
}
void main() {
    ivec2 pixel = ivec2(gl_FragCoord.xy);
    vec3 direction = normalize(ray);
    vec3 sky_here = exposed(sky_color(direction));
    if (look.z > 0.5) sky_here = clouds(direction, direction.xy / (max(direction.z, 0.0) + 0.15) * 0.22);
    vec4 place[kSamples];
    vec3 normal[kSamples], paint[kSamples], color[kSamples];
    int same[kSamples];  // an earlier sample with the same light, or the sample itself
    int left = 0;        // bit i: sample i is to be lit
    for (int i = 0; i < kSamples; ++i) {
        place[i] = texelFetch(places, pixel, i);
        normal[i] = texelFetch(normals, pixel, i).xyz;
        paint[i] = texelFetch(paints, pixel, i).rgb;
        color[i] = sky_here;
        same[i] = i;
        for (int k = 0; k < i; ++k) {
            float apart = length(place[i].xyz - place[k].xyz);
            bool alike = place[i].w == place[k].w && dot(normal[i], normal[k]) > 0.9 &&
                         distance(paint[i], paint[k]) < 0.02 && apart < 0.01 * length(place[i].xyz - eye.xyz);
            if (same[i] == i && alike) same[i] = k;
        }
        if (place[i].w > 0.5 && same[i] == i) left |= 1 << i;
    }
    // A loop and not a condition in the loop above: software rasterisers compute what a false condition guards.
    do {
        vec4 where = place[0];
        vec3 n = normal[0], coat = paint[0];
        int now = 0;
        for (int i = kSamples - 1; i >= 0; --i) {
            if ((left >> i & 1) == 0) continue;
            where = place[i];
            n = normal[i];
            coat = paint[i];
            now = i;
        }
        vec3 light = lit(where, n, coat);
        for (int i = 0; i < kSamples; ++i) {
            if (i == now && (left >> i & 1) == 1) color[i] = light;
        }
        left &= left - 1;
    } while (left > 0);
    vec3 sum = vec3(0.0);
    for (int i = 0; i < kSamples; ++i) {
        for (int k = 0; k < i; ++k) {
            if (same[i] == k) color[i] = color[k];
        }
        sum += color[i];
    }
    result = vec4(sum / float(kSamples), 1.0);
}
)";

constexpr char kLineVertex[] = R"(
layout(location = 0) in vec3 first;
layout(location = 1) in vec3 second;
layout(location = 2) in vec3 color;
out vec3 paint;
noperspective out float across;
out float depth;
void main() {
    vec4 a = camera * vec4(first, 1.0), b = camera * vec4(second, 1.0);
    float near = 0.02 * eye.w;
    vec4 a_seen = a.w < near && b.w > near ? mix(a, b, (near - a.w) / (b.w - a.w)) : a;
    vec4 b_seen = b.w < near && a.w > near ? mix(b, a, (near - b.w) / (a.w - b.w)) : b;
    vec2 along = (b_seen.xy / b_seen.w - a_seen.xy / a_seen.w) * viewport.xy;
    vec2 side = length(along) > 1e-6 ? normalize(vec2(-along.y, along.x)) : vec2(1.0, 0.0);
    float half_width = viewport.z + 1.0;
    vec4 p = (gl_VertexID >> 1) == 0 ? a_seen : b_seen;
    depth = p.w;
    across = (float(gl_VertexID & 1) * 2.0 - 1.0) * half_width;
    p.xy += side * across * 2.0 / viewport.xy * p.w;
    paint = color;
    gl_Position = p;
}
)";

constexpr char kLineFragment[] = R"(
in vec3 paint;
noperspective in float across;
in float depth;
out vec4 result;
void main() {
    float opacity = 0.0;
    for (int i = 0; i < SAMPLES; ++i) {
        vec4 place = texelFetch(places, ivec2(gl_FragCoord.xy), i);
        bool hidden = place.w > 0.5 && dot(place.xyz - eye.xyz, view_forward.xyz) < (look.w > 0.0 ? depth : 0.997 * depth);
        opacity += (hidden ? look.w : 1.0) / float(SAMPLES);
    }
    result = vec4(to_linear(paint), opacity * clamp(viewport.z + 0.5 - abs(across), 0.0, 1.0));
}
)";

}  // namespace

const ProgramText kDepthProgram = {"depth", kShapeVertex, kNothing};
const ProgramText kShapeProgram = {"shape", kShapeVertex, kShapeFragment};
const ProgramText kGroundProgram = {"ground", kGroundVertex, kGroundFragment};
const ProgramText kLightProgram = {"light", kLightVertex, kLightFragment};
const ProgramText kVeilProgram = {"veil", kShapeVertex, kVeilFragment};
const ProgramText kTriangleDepthProgram = {"triangle depth", kTriangleVertex, kNothing};
const ProgramText kTriangleProgram = {"triangle", kTriangleVertex, kShapeFragment};
const ProgramText kTriangleVeilProgram = {"triangle veil", kTriangleVertex, kVeilFragment};
const ProgramText kVeilOverProgram = {"veil over", kLightVertex, kVeilOverFragment};
const ProgramText kShowProgram = {"show", kLightVertex, kShowFragment};
const ProgramText kLineProgram = {"line", kLineVertex, kLineFragment};

}  // namespace epode::viewer
