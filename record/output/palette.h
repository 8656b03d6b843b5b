// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Colours of bodies: eight that stand apart also for those who see few colours, in linear light.
#pragma once

#include <array>
#include <cstdint>

namespace epode::record {

using Color = std::array<double, 3>;

constexpr std::uint32_t kColors = 9;  // the first is that of what belongs to no body

inline std::uint32_t color_number(std::int32_t body)
{
    // Neighbours in order of making lie in rows; the high bits of a product break the stripes.
    return body < 0 ? 0 : 1 + ((std::uint32_t(body) * 2654435761u) >> 29);
}

inline Color color(std::uint32_t number)
{
    // sRGB, after Okabe and Ito 2008, "Color universal design", with yellow and black replaced by softer
    // ones.
    static constexpr std::array<Color, kColors> kTable = {{{0.66, 0.65, 0.62},
                                                           {0.90, 0.62, 0.15},
                                                           {0.34, 0.71, 0.91},
                                                           {0.16, 0.62, 0.47},
                                                           {0.93, 0.85, 0.42},
                                                           {0.15, 0.45, 0.70},
                                                           {0.84, 0.37, 0.12},
                                                           {0.80, 0.48, 0.65},
                                                           {0.45, 0.49, 0.55}}};
    return kTable[number];
}

}  // namespace epode::record
