// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A node of the tree over a mesh: four boxes on a grid of 256 steps a side, lo = origin + step * q, tested
// four at a time. Vectors of 16 bytes are on every machine that we serve; every operation is done lane by
// lane, so the answers do not depend on how.
//   ray    a slab is met between (origin - o) inv + q (step inv) for its two q; o, inv: the ray's origin and
//          the inverse of its direction, in which what is next to zero is replaced by something tiny.
#pragma once

#include <bit>
#include <climits>
#include <cmath>

#include "geometry/shapes.h"

namespace epode {

inline constexpr float kMeshMargin = 0x1p-19f;
inline constexpr int kMeshLeaf = 4;    // most triangles in one (mesh_packet.h)
inline constexpr int kMeshDepth = 68;  // most levels of nodes
inline constexpr int kMeshStack = 3 * kMeshDepth + 4;

struct FloatBox {
    float lo[3], hi[3];
};

inline FloatBox float_box(const Aabb& b)
{
    return {{float(b.lo.x), float(b.lo.y), float(b.lo.z)}, {float(b.hi.x), float(b.hi.y), float(b.hi.z)}};
}

// One side of a grid of 256 steps: origin + step * q. A little more than what it is for, so that its far end
// is within reach of the 255th step whatever is rounded.
struct GridSteps {
    GridSteps(float low, float high) : origin(low), step((high - low) / 254) {}
    // Rounds outward, by the very expression that is evaluated when it is asked.
    void enclose(float low, float high, std::uint8_t& lo, std::uint8_t& hi) const;
    float origin, step;
};

// n . x <= d in the frame of the mesh.
struct HalfSpace {
    float n[3], d;
};

namespace mesh_lanes {

typedef float Floats __attribute__((vector_size(16)));
typedef int Ints __attribute__((vector_size(16)));
typedef std::uint8_t Bytes __attribute__((vector_size(16)));
typedef std::uint16_t Shorts __attribute__((vector_size(16)));

}  // namespace mesh_lanes

// A box as nodes are asked with it.
struct NodeBox {
    explicit NodeBox(const FloatBox& b)
        : lo{b.lo[0], b.lo[1], b.lo[2], b.lo[2]}, hi{b.hi[0], b.hi[1], b.hi[2], b.hi[2]}
    {}
    mesh_lanes::Floats lo, hi;
};

// A ray in the frame of the mesh.
struct NodeRay {
    NodeRay(Vec3 o, Vec3 d);
    float origin[3], inverse[3];
    bool down[3];  // runs against the axis
};

// Which of four children a ray meets (all bits of their lanes are set), and how far away.
struct MetNodes {
    mesh_lanes::Ints yes;
    mesh_lanes::Floats near;
};

// A child and how far away it is, at least 0, as one number that grows with the distance: bits of floats that
// are not negative are ordered as they are. No child of a node is node 0, so 0 is none.
class WaitingNode {
  public:
    WaitingNode() {}  // nothing: stacks of them are left unwritten
    WaitingNode(int child, float near)
        : key_(std::uint64_t(std::bit_cast<std::uint32_t>(near)) << 32 | std::uint32_t(child))
    {}
    int child() const { return int(std::uint32_t(key_)); }
    float near() const { return std::bit_cast<float>(std::uint32_t(key_ >> 32)); }

    friend void far_first(WaitingNode* four);

  private:
    std::uint64_t key_;
};

// Sorts four, the nearest last and none behind it. A network: what comparisons say cannot be foreseen, so
// there are no branches on it.
inline void far_first(WaitingNode* w)
{
    const auto order = [w](int i, int j) {
        const std::uint64_t a = w[i].key_, b = w[j].key_;
        w[i].key_ = a > b ? a : b;
        w[j].key_ = a > b ? b : a;
    };
    order(0, 1), order(2, 3), order(0, 2), order(1, 3), order(1, 2);
}

// The children that are met, none in the places of the others; without branches, too. As pairs of numbers,
// the lesser half first, a key is a child and a distance.
inline void put_met(const MetNodes& met, const int* children, WaitingNode* w)
{
    using namespace mesh_lanes;
    static_assert(std::endian::native == std::endian::little && sizeof(WaitingNode) == 8);
    Ints child;
    __builtin_memcpy(&child, children, sizeof child);
    child &= met.yes;
    const Ints near = Ints(met.near) & met.yes;
    const Ints low = __builtin_shufflevector(child, near, 0, 4, 1, 5),
               high = __builtin_shufflevector(child, near, 2, 6, 3, 7);
    __builtin_memcpy(static_cast<void*>(w), &low, sizeof low);
    __builtin_memcpy(static_cast<void*>(w + 2), &high, sizeof high);
}

struct alignas(64) MeshNode {
    static constexpr int kNone = INT_MIN;

    float origin[3], step[3];
    std::uint8_t lo[3][4], hi[3][4];
    int child[4];  // a node, -1 - a packet of triangles, or kNone

    void set_grid(const FloatBox& all);
    void set_box(int k, const FloatBox& box);  // within the grid
    void set_none(int k);

    // Bits of the children met.
    unsigned met_by(const NodeBox& box) const;
    unsigned met_by(const HalfSpace& space) const;
    MetNodes met_by(const NodeRay& ray, float reach) const;
    unsigned there() const;  // bits of the children that exist
};
static_assert(sizeof(MeshNode) == 64);

namespace mesh_lanes {

inline Floats floats(float x) { return Floats{x, x, x, x}; }
inline Floats places(const std::uint8_t* q)
{
    // In two steps, each of which is one instruction; a conversion in one is done number by number.
    std::uint32_t four;
    __builtin_memcpy(&four, q, 4);
    const Bytes bytes = Bytes(Ints{int(four), 0, 0, 0});
    const Shorts shorts = Shorts(
        __builtin_shufflevector(bytes, Bytes{}, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
    const Ints ints = Ints(__builtin_shufflevector(shorts, Shorts{}, 0, 8, 1, 9, 2, 10, 3, 11));
    return __builtin_convertvector(ints, Floats);
}
inline Floats smaller(Floats a, Floats b) { return a < b ? a : b; }
inline Floats larger(Floats a, Floats b) { return a > b ? a : b; }
inline unsigned bits(Ints yes)
{
#if defined(__SSE2__)
    typedef float Vector __attribute__((vector_size(16)));
    return unsigned(__builtin_ia32_movmskps(Vector(yes)));
#else
    return unsigned((yes[0] & 1) | (yes[1] & 2) | (yes[2] & 4) | (yes[3] & 8));
#endif
}

inline unsigned bits(Bytes yes)
{
#if defined(__SSE2__)
    typedef char Vector __attribute__((vector_size(16)));
    return unsigned(__builtin_ia32_pmovmskb128(Vector(yes)));
#else
    unsigned all = 0;
    for (int i = 0; i < 16; ++i) all |= (yes[i] & 1u) << i;
    return all;
#endif
}
inline Bytes bytes_at(const std::uint8_t* p)
{
    Bytes x;
    __builtin_memcpy(&x, p, sizeof(x));
    return x;
}

// Each rounded down to a step of the grid, 0 ... 255, four times.
inline Bytes steps(Floats x)
{
    const Ints q = __builtin_convertvector(smaller(larger(x, Floats{}), floats(255)), Ints);
    const Ints twice = q | q << 8;
    return Bytes(twice | twice << 16);
}

// Of four bits, how many are set: a digit each.
inline int count(unsigned bits) { return int(0x4332322132212110u >> 4 * bits & 7); }

// A box on the grid of a node: its origin in three numbers and, behind them, the steps of its axes. Rounded
// outward to whole steps.
struct BoxSteps {
    Bytes from, to;
    BoxSteps(const float (&origin)[3], const NodeBox& box)
    {
        Floats base, grain;
        __builtin_memcpy(&base, origin, sizeof(base));
        __builtin_memcpy(&grain, &origin[2], sizeof(grain));
        grain = __builtin_shufflevector(grain, grain, 1, 2, 3, 3);
        from = steps((box.lo - base) / grain + floats(0.99f)), to = steps((box.hi - base) / grain);
    }
};

}  // namespace mesh_lanes

inline unsigned MeshNode::there() const
{
    using namespace mesh_lanes;
    Ints children;
    __builtin_memcpy(&children, child, sizeof(children));
    return bits(children != Ints{kNone, kNone, kNone, kNone});
}

// The box goes onto the grid, which is less work than the children leaving it, and all its bounds are
// compared at once. What that rounds is far less than kMeshMargin.
inline unsigned MeshNode::met_by(const NodeBox& box) const
{
    using namespace mesh_lanes;
    const BoxSteps on(origin, box);
    // The bounds of the three axes are 12 bytes; what lies behind them is not looked at.
    const unsigned met = bits(Bytes((bytes_at(lo[0]) <= on.to) & (bytes_at(hi[0]) >= on.from)));
    return met & met >> 4 & met >> 8 & there();
}

inline unsigned MeshNode::met_by(const HalfSpace& space) const
{
    using namespace mesh_lanes;
    Floats least{};
    for (int i = 0; i < 3; ++i) {
        const Floats nearest = floats(origin[i]) + places(space.n[i] > 0 ? lo[i] : hi[i]) * floats(step[i]);
        least += floats(space.n[i]) * nearest;
    }
    return bits(least <= floats(space.d)) & there();
}

inline MetNodes MeshNode::met_by(const NodeRay& ray, float reach) const
{
    using namespace mesh_lanes;
    Floats first = Floats{}, last = floats(reach);
    for (int i = 0; i < 3; ++i) {
        const Floats base = floats((origin[i] - ray.origin[i]) * ray.inverse[i]);
        const Floats grain = floats(step[i] * ray.inverse[i]);
        const Floats a = base + places(ray.down[i] ? hi[i] : lo[i]) * grain;
        const Floats b = base + places(ray.down[i] ? lo[i] : hi[i]) * grain;
        first = larger(a, first);
        last = smaller(b, last);
    }
    Ints children;
    __builtin_memcpy(&children, child, sizeof(children));
    return {(first <= last) & (children != Ints{kNone, kNone, kNone, kNone}), first};
}

}  // namespace epode
