// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Everything is made of gradient noise on a lattice whose period is the picture (Perlin 1985, "An image
// synthesizer"; fade 6t^5 - 15t^4 + 10t^3 of his 2002 "Improving noise"): n(x, y) blends the slopes g_ij . d
// of the four corners around; octaves are summed with halved amplitude. Wood: n stretched along the grain,
// whose contours are the rings; ground: several octaves around the green of dry grass; sky: the sum over a
// threshold is cloud. Corners take their slopes from a hash of (i, j, seed), so the same pictures come on
// every machine.
#include "textures.h"

#include <algorithm>
#include <cmath>

namespace epode::viewer {

namespace {

std::uint32_t hash(std::uint32_t i, std::uint32_t j, std::uint32_t seed)
{
    std::uint32_t h = i * 0x9E3779B1u ^ (j * 0x85EBCA77u + seed * 0xC2B2AE3Du);
    h = (h ^ (h >> 15)) * 0x2C1B3C6Du;
    h = (h ^ (h >> 12)) * 0x297A2D39u;
    return h ^ (h >> 15);
}

float slope(int i, int j, float dx, float dy, std::uint32_t seed)
{
    constexpr float kDiagonal = 0.70710678f;
    constexpr float kSlopes[8][2] = {{1, 0},
                                     {-1, 0},
                                     {0, 1},
                                     {0, -1},
                                     {kDiagonal, kDiagonal},
                                     {-kDiagonal, kDiagonal},
                                     {kDiagonal, -kDiagonal},
                                     {-kDiagonal, -kDiagonal}};
    const float* g = kSlopes[hash(static_cast<std::uint32_t>(i), static_cast<std::uint32_t>(j), seed) & 7];
    return g[0] * dx + g[1] * dy;
}

float fade(float t) { return t * t * t * (t * (6 * t - 15) + 10); }
float mix(float a, float b, float t) { return a + (b - a) * t; }

// u, v in [0, 1); the lattice has `across` by `down` cells and closes upon itself. About -0.7 to 0.7.
float noise(float u, float v, int across, int down, std::uint32_t seed)
{
    const float x = u * static_cast<float>(across), y = v * static_cast<float>(down);
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    const float dx = x - static_cast<float>(i), dy = y - static_cast<float>(j);
    const int i0 = i % across, i1 = (i + 1) % across, j0 = j % down, j1 = (j + 1) % down;
    const float low = mix(slope(i0, j0, dx, dy, seed), slope(i1, j0, dx - 1, dy, seed), fade(dx));
    const float high = mix(slope(i0, j1, dx, dy - 1, seed), slope(i1, j1, dx - 1, dy - 1, seed), fade(dx));
    return mix(low, high, fade(dy));
}

float octaves(float u, float v, int across, int down, int count, std::uint32_t seed)
{
    float sum = 0, amplitude = 1;
    for (int k = 0; k < count; ++k) {
        sum += amplitude * noise(u, v, across << k, down << k, seed + static_cast<std::uint32_t>(k));
        amplitude *= 0.5f;
    }
    return sum;
}

struct Tone {
    float r, g, b;
};

Tone mix(Tone a, Tone b, float t) { return {mix(a.r, b.r, t), mix(a.g, b.g, t), mix(a.b, b.b, t)}; }
Tone operator*(float s, Tone a) { return {s * a.r, s * a.g, s * a.b}; }
float smooth(float low, float high, float x)
{
    const float t = std::clamp((x - low) / (high - low), 0.0f, 1.0f);
    return t * t * (3 - 2 * t);
}

Tone wood(float u, float v)
{
    const float height = octaves(u, v, 1, 3, 3, 11);
    const float rings = height * 6 - std::floor(height * 6);
    const float dark = smooth(0.15f, 0.95f, rings) * (1 - smooth(0.95f, 1.0f, rings));
    const float fibre = octaves(u, v, 4, 96, 2, 29);
    const Tone tone = mix(Tone{0.96f, 0.84f, 0.68f}, Tone{0.84f, 0.68f, 0.51f}, dark);
    return (1 + 0.10f * fibre) * tone;
}

Tone checkered(float u, float v)
{
    const int squares = static_cast<int>(u * 8) + static_cast<int>(v * 8);
    return squares % 2 == 0 ? Tone{1, 1, 1} : Tone{0.42f, 0.42f, 0.44f};
}

Tone ground(float u, float v)
{
    const float clumps = octaves(u, v, 5, 5, 3, 41), blades = octaves(u, v, 64, 64, 3, 53);
    const Tone tone =
        mix(Tone{0.53f, 0.60f, 0.41f}, Tone{0.62f, 0.61f, 0.46f}, smooth(-0.45f, 0.45f, clumps));
    return (1 + 0.22f * blades) * tone;
}

Tone sky(float u, float v)
{
    const float sum = octaves(u, v, 3, 3, 6, 71);
    const float cloud = smooth(-0.05f, 0.55f, sum);
    const float shade = octaves(u, v, 6, 6, 3, 97);
    return mix(Tone{0.42f, 0.62f, 0.86f}, (1 + 0.05f * shade) * Tone{0.96f, 0.97f, 0.99f}, 0.85f * cloud);
}

std::uint8_t byte_of(float x) { return static_cast<std::uint8_t>(255 * std::clamp(x, 0.0f, 1.0f) + 0.5f); }

Tone tone_of(Texture texture, float u, float v)
{
    switch (texture) {
        case Texture::kWood:
            return wood(u, v);
        case Texture::kCheckered:
            return checkered(u, v);
        case Texture::kGround:
            return ground(u, v);
        case Texture::kSky:
            return sky(u, v);
        case Texture::kNone:
            break;
    }
    return {1, 1, 1};
}

// Mean of the pixels of [low, high) in one channel, at least one of them.
std::uint8_t mean(const Image& image, const int (&low)[2], const int (&high)[2], int channel)
{
    unsigned sum = 0, count = 0;
    for (int y = low[1]; y < std::max(high[1], low[1] + 1); ++y) {
        for (int x = low[0]; x < std::max(high[0], low[0] + 1); ++x) {
            sum += image.rgb[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                  static_cast<std::size_t>(x)) +
                             static_cast<std::size_t>(channel)];
            ++count;
        }
    }
    return static_cast<std::uint8_t>((sum + count / 2) / count);
}

}  // namespace

Image make_texture(Texture texture)
{
    Image image{kTextureSide, kTextureSide, {}};
    image.rgb.reserve(3 * kTextureSide * kTextureSide);
    for (int y = 0; y < kTextureSide; ++y) {
        for (int x = 0; x < kTextureSide; ++x) {
            const Tone tone =
                tone_of(texture, static_cast<float>(x) / kTextureSide, static_cast<float>(y) / kTextureSide);
            for (const float c : {tone.r, tone.g, tone.b}) image.rgb.push_back(byte_of(c));
        }
    }
    return image;
}

Image fitted(const Image& image)
{
    if (image.width < 1 || image.height < 1) return {};
    Image result{kTextureSide, kTextureSide, {}};
    result.rgb.reserve(3 * kTextureSide * kTextureSide);
    const auto place = [](int i, int size) {
        return static_cast<int>(static_cast<std::int64_t>(i) * size / kTextureSide);
    };
    for (int y = 0; y < kTextureSide; ++y) {
        for (int x = 0; x < kTextureSide; ++x) {
            const int low[2] = {place(x, image.width), place(y, image.height)};
            const int high[2] = {place(x + 1, image.width), place(y + 1, image.height)};
            for (int c = 0; c < 3; ++c) result.rgb.push_back(mean(image, low, high, c));
        }
    }
    return result;
}

}  // namespace epode::viewer
