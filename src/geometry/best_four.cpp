// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See best_four.h. Each choice is the first point whose score lies within the tie margin of the best.
#include "geometry/best_four.h"

#include <algorithm>

#include "simd/quad.h"

namespace epode {

namespace {

constexpr Real kTie = Real(1e-3);       // of a distance or an area
constexpr Real kDepthTie = Real(1e-5);  // of the manifold's span, for depths
// Scores of kQuads * 4 points.
template <int kQuads>
struct Scores {
    Quad of[kQuads];

    Real best() const
    {
        Quad largest = of[0];
        for (int i = 1; i < kQuads; ++i) largest = larger(of[i], largest);
        return largest_lane(largest);
    }
    // The first that is not less.
    int first_from(Real least) const
    {
        std::uint64_t less = 0;
        for (int i = 0; i < kQuads; ++i) less |= std::uint64_t(bits(of[i] < quad(least))) << (4 * i);
        return __builtin_ctzll(~less);
    }
};

// The differences from one point.
struct Offsets {
    Quad x, y, z;
    EPODE_LANEWISE Offsets(const ManifoldPoints& p, int at, int from)
        : x(load_quad(p.x + at) - quad(p.x[from])),
          y(load_quad(p.y + at) - quad(p.y[from])),
          z(load_quad(p.z + at) - quad(p.z[from]))
    {}
    EPODE_LANEWISE Quad length2() const { return x * x + y * y + z * z; }
};

template <int kQuads>
int choose(const ManifoldPoints& p, Vec3 normal, int wanted, int* chosen)
{
    Scores<kQuads> scores, other;
    for (int i = 0; i < kQuads; ++i) scores.of[i] = Offsets(p, 4 * i, 0).length2();
    const Real span = std::sqrt(scores.best());
    for (int i = 0; i < kQuads; ++i) scores.of[i] = load_quad(p.depth + 4 * i);
    const int first = scores.first_from(scores.best() - kDepthTie * span);
    chosen[0] = first;
    if (wanted < 2) return 1;
    for (int i = 0; i < kQuads; ++i) scores.of[i] = Offsets(p, 4 * i, first).length2();
    const Real farthest = scores.best();
    if (!(farthest > 0)) return 1;
    const int far = scores.first_from(farthest * (1 - kTie));
    chosen[1] = far;
    int count = 2;
    const Vec3 line = {p.x[far] - p.x[first], p.y[far] - p.y[first], p.z[far] - p.z[first]};
    const Vec3 aside = cross(normal, line);
    const Real thin = Real(1e-6) * length2(line);  // a point on the line adds nothing
    for (int i = 0; i < kQuads; ++i) {
        const Offsets d(p, 4 * i, first);
        scores.of[i] = quad(aside.x) * d.x + quad(aside.y) * d.y + quad(aside.z) * d.z;
        other.of[i] = quad(0) - scores.of[i];
    }
    const auto add = [&](const Scores<kQuads>& side) {
        const Real largest = side.best(), near = largest * (1 - kTie);
        if (largest > thin && count < wanted) chosen[count++] = side.first_from(near > thin ? near : thin);
    };
    add(scores), add(other);
    return count;
}

int choose_of(ManifoldPoints& p, Vec3 normal, int wanted, int* chosen)
{
    // What fills up, the first point again, is never better than itself.
    const int full = p.count <= 8 ? 8 : p.count <= 16 ? 16 : p.count <= 32 ? 32 : p.kMax;
    while (p.count < full) p.add({p.x[0], p.y[0], p.z[0]}, p.depth[0]);
    return full == 8    ? choose<2>(p, normal, wanted, chosen)
           : full == 16 ? choose<4>(p, normal, wanted, chosen)
           : full == 32 ? choose<8>(p, normal, wanted, chosen)
                        : choose<ManifoldPoints::kMax / 4>(p, normal, wanted, chosen);
}

}  // namespace

int best_four(ManifoldPoints& p, Vec3 normal, int wanted, int* chosen)
{
    const auto touching = std::count_if(p.depth, p.depth + p.count, [](Real d) { return d >= 0; });
    if (touching < wanted || touching == p.count) return choose_of(p, normal, wanted, chosen);
    ManifoldPoints those;
    int places[ManifoldPoints::kMax];
    for (int i = 0; i < p.count; ++i) {
        if (!(p.depth[i] >= 0)) continue;
        places[those.count] = i;
        those.add({p.x[i], p.y[i], p.z[i]}, p.depth[i]);
    }
    if (those.count == wanted) return std::copy_n(places, wanted, chosen), wanted;
    const int kept = choose_of(those, normal, wanted, chosen);
    for (int i = 0; i < kept; ++i) chosen[i] = places[chosen[i]];
    return kept;
}

}  // namespace epode
