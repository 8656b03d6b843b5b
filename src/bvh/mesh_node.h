// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A node of the tree over a mesh: sixteen boxes on a grid of 256 steps per side, lo = origin + step * q.
// Vectors of 16 bytes exist on every supported machine; every operation works lane by lane, so results do not
// depend on how it is compiled.
//
//   box    is quantised to the grid; one bound of all 16 children is one vector of bytes, so testing sixteen
//          takes no more work than testing four.
//   ray    meets a slab between (origin - o) inv + q (step inv) for its two q; o, inv: the ray's origin and
//          the inverse of its direction, in which components next to zero are replaced by a tiny number. Four
//          children at a time. Nodes of four children would be as much work, but a tree larger than the cache
//          would wait for twice as many of them, one after the other.
#pragma once

#include <bit>
#include <cmath>

#include "geometry/shapes.h"

namespace epode {

inline constexpr float kMeshMargin = 0x1p-19f;
inline constexpr int kMeshLeaf = 4;    // most triangles in one (mesh_packet.h)
inline constexpr int kMeshDepth = 68;  // most levels of nodes

struct FloatBox {
    float lo[3], hi[3];
};

inline FloatBox float_box(const Aabb& b)
{
    return {{float(b.lo.x), float(b.lo.y), float(b.lo.z)}, {float(b.hi.x), float(b.hi.y), float(b.hi.z)}};
}

// One side of a grid of 256 steps: origin + step * q. A little larger than needed, so that its far end is
// within the 255th step whatever is rounded.
struct GridSteps {
    GridSteps(float low, float high) : origin(low), step((high - low) / 254) {}
    // Rounds outward, by the same expression that is evaluated in a query.
    void enclose(float low, float high, std::uint8_t& lo, std::uint8_t& hi) const;
    float origin, step;
};

// The half-space n . x <= d in the frame of the mesh.
struct HalfSpace {
    float n[3], d;
};

namespace mesh_lanes {

typedef float Floats __attribute__((vector_size(16)));
typedef int Ints __attribute__((vector_size(16)));
typedef std::uint8_t Bytes __attribute__((vector_size(16)));
typedef std::uint16_t Shorts __attribute__((vector_size(16)));

}  // namespace mesh_lanes

// A query box, prepared for nodes.
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

// A child and its distance, at least 0, as one number that grows with the distance: the bits of non-negative
// floats are ordered like the floats. Node 0 is no node's child, so 0 means none.
class WaitingNode {
  public:
    WaitingNode() {}  // uninitialised: stacks of them are left unwritten
    WaitingNode(int child, float near)
        : key_(std::uint64_t(std::bit_cast<std::uint32_t>(near)) << 32 | std::uint32_t(child))
    {}
    int child() const { return int(std::uint32_t(key_)); }
    float near() const { return std::bit_cast<float>(std::uint32_t(key_ >> 32)); }

    bool nearer(const WaitingNode& other) const { return key_ < other.key_; }

    friend void far_first(WaitingNode* four);

  private:
    std::uint64_t key_;
};

struct alignas(64) MeshNode {
    static constexpr int kMaxChildren = 16;

    float origin[3], step[3];
    int count;  // of the children
    std::uint8_t lo[3][kMaxChildren], hi[3][kMaxChildren];
    int child[kMaxChildren];  // a node, or -1 - a packet of triangles

    // The boxes of the children, on a grid over all of them.
    void place(const FloatBox* boxes, const FloatBox& all);

    // Bits of the children met.
    unsigned met_by(const NodeBox& box) const;
    unsigned met_by(const HalfSpace& space) const;
    unsigned met_by(const NodeRay& ray, float reach,
                    float (&near)[kMaxChildren]) const;  // and how far each is
    unsigned there() const { return (1u << count) - 1; }
};
static_assert(sizeof(MeshNode) == 192);

namespace mesh_lanes {

inline Floats floats(float x) { return Floats{x, x, x, x}; }
inline Floats places(const std::uint8_t* q)
{
    // In two steps of one instruction each; a conversion in one step is done number by number.
    std::uint32_t four;
    __builtin_memcpy(&four, q, 4);
    constexpr bool kLittle = std::endian::native == std::endian::little;  // the zero is behind the number
    const Bytes bytes = Bytes(Ints{int(four), 0, 0, 0}), low = kLittle ? bytes : Bytes{},
                high = kLittle ? Bytes{} : bytes;
    const Shorts shorts =
        Shorts(__builtin_shufflevector(low, high, 0, 16, 1, 17, 2, 18, 3, 19, 4, 20, 5, 21, 6, 22, 7, 23));
    const Shorts first = kLittle ? shorts : Shorts{}, second = kLittle ? Shorts{} : shorts;
    const Ints ints = Ints(__builtin_shufflevector(first, second, 0, 8, 1, 9, 2, 10, 3, 11));
    return __builtin_convertvector(ints, Floats);
}
inline Floats smaller(Floats a, Floats b) { return a < b ? a : b; }
inline Floats larger(Floats a, Floats b) { return a > b ? a : b; }
inline unsigned bits(Ints yes)
{
#if defined(__SSE2__)
    typedef float Vector __attribute__((vector_size(16)));
    return unsigned(__builtin_ia32_movmskps(Vector(yes)));
#elif defined(__wasm_simd128__)
    return unsigned(__builtin_wasm_bitmask_i32x4(yes));
#else
    return unsigned((yes[0] & 1) | (yes[1] & 2) | (yes[2] & 4) | (yes[3] & 8));
#endif
}

inline unsigned bits(Bytes yes)
{
#if defined(__SSE2__)
    typedef char Vector __attribute__((vector_size(16)));
    return unsigned(__builtin_ia32_pmovmskb128(Vector(yes)));
#elif defined(__wasm_simd128__)
    typedef signed char Vector __attribute__((vector_size(16)));
    return unsigned(__builtin_wasm_bitmask_i8x16(Vector(yes)));
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

// A box on the grid of a node: its origin in three numbers, followed by the steps along its axes, rounded
// outward.
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

// The rounding of the grid is far smaller than kMeshMargin.
inline unsigned MeshNode::met_by(const NodeBox& box) const
{
    using namespace mesh_lanes;
    const BoxSteps on(origin, box);
    const Ints from = Ints(on.from), to = Ints(on.to);
    const Bytes met = (bytes_at(lo[0]) <= Bytes(__builtin_shufflevector(to, to, 0, 0, 0, 0))) &
                      (bytes_at(hi[0]) >= Bytes(__builtin_shufflevector(from, from, 0, 0, 0, 0))) &
                      (bytes_at(lo[1]) <= Bytes(__builtin_shufflevector(to, to, 1, 1, 1, 1))) &
                      (bytes_at(hi[1]) >= Bytes(__builtin_shufflevector(from, from, 1, 1, 1, 1))) &
                      (bytes_at(lo[2]) <= Bytes(__builtin_shufflevector(to, to, 2, 2, 2, 2))) &
                      (bytes_at(hi[2]) >= Bytes(__builtin_shufflevector(from, from, 2, 2, 2, 2)));
    return bits(met) & there();
}

inline unsigned MeshNode::met_by(const HalfSpace& space) const
{
    using namespace mesh_lanes;
    unsigned met = 0;
    for (int k = 0; k < kMaxChildren; k += 4) {
        Floats least{};
        for (int i = 0; i < 3; ++i) {
            const std::uint8_t* nearest = space.n[i] > 0 ? lo[i] : hi[i];
            least += floats(space.n[i]) * (floats(origin[i]) + places(nearest + k) * floats(step[i]));
        }
        met |= bits(Ints(least <= floats(space.d))) << k;
    }
    return met & there();
}

inline unsigned MeshNode::met_by(const NodeRay& ray, float reach, float (&near)[kMaxChildren]) const
{
    using namespace mesh_lanes;
    Floats base[3], grain[3];
    const std::uint8_t *in[3], *out[3];
    for (int i = 0; i < 3; ++i) {
        base[i] = floats((origin[i] - ray.origin[i]) * ray.inverse[i]);
        grain[i] = floats(step[i] * ray.inverse[i]);
        in[i] = ray.down[i] ? hi[i] : lo[i], out[i] = ray.down[i] ? lo[i] : hi[i];
    }
    unsigned met = 0;
    for (int k = 0; k < kMaxChildren; k += 4) {
        Floats first = Floats{}, last = floats(reach);
        for (int i = 0; i < 3; ++i) {
            first = larger(base[i] + places(in[i] + k) * grain[i], first);
            last = smaller(base[i] + places(out[i] + k) * grain[i], last);
        }
        __builtin_memcpy(near + k, &first, sizeof(first));
        met |= bits(Ints(first <= last)) << k;
    }
    return met & there();
}

}  // namespace epode
