// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A polyhedron in files. Vertices and faces are kept with their bits, since the hull of its vertices would
// have others in the last place; what follows from them is computed again.
#include <algorithm>

#include "base/check.h"
#include "geometry/hulls/polyhedron.h"

namespace epode {
namespace {

constexpr const char* kBroken = "a convex geom in it is no closed solid";
constexpr Real kUnit = Real(1e-3);

bool is_sound(const PolyhedronFace& face, std::span<const int> corners, std::span<const Vec3> vertices)
{
    if (!(std::fabs(length2(face.normal) - 1) < kUnit)) return false;
    for (int k = 0; k < face.count; ++k) {
        const int corner = corners[std::size_t(face.first + k)];
        if (corner < 0 || corner >= int(vertices.size())) return false;
        if (dot(face.normal, vertices[std::size_t(corner)]) > face.offset) return false;
    }
    return true;
}

}  // namespace

void Polyhedron::structure(StructureStream& stream)
{
    stream.vector(centre_);
    const int vertices = stream.count(vertices_.size(), sizeof(Vec3), "corners of a solid");
    const int faces = stream.count(faces_.size(), sizeof(Face), "faces of a solid");
    const int corners = stream.count(corners_.size(), sizeof(int), "corners of faces");
    if (stream.loads() &&
        !stream.demand(vertices_.resize(vertices) && faces_.resize(faces) && corners_.resize(corners),
                       kOutOfMemory))
        return;
    for (Vec3& v : vertices_) stream.vector(v);
    for (Face& f : faces_) {
        stream.vector(f.normal), stream.real(f.offset);
        stream.number(f.first), stream.number(f.count);
    }
    stream.numbers(corners_.data(), std::size_t(corners));
    if (stream.loads() && !stream.failed()) (void)load_faces(stream);
}

bool Polyhedron::load_faces(StructureStream& stream)
{
    if (!stream.demand(usable(centre_.x) && usable(centre_.y) && usable(centre_.z), kBroken)) return false;
    if (!stream.demand(vertices_.size() >= 3 && faces_.size() >= 2, kBroken)) return false;
    for (const Vec3 v : vertices_) {
        if (!stream.demand(usable(v.x) && usable(v.y) && usable(v.z), kBroken)) return false;
        size_ = std::max(size_, length(v));
    }
    int first = 0;
    for (const Face& f : faces_) {
        const bool in_line = f.first == first && f.count >= 3 && f.count <= corners_.size() - first;
        if (!stream.demand(in_line && is_sound(f, corners_.span(), vertices_.span()), kBroken)) return false;
        first += f.count;
    }
    if (!stream.demand(first == corners_.size(), kBroken) || !stream.demand(take_all(), kOutOfMemory))
        return false;
    return stream.demand(vertices_.size() - seams_.size() + faces_.size() == 2, kBroken);
}

}  // namespace epode
