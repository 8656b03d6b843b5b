// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_files.h.
#include "integrations/gazebo/mesh_files.h"

#include <filesystem>

#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/shapes.h"

namespace epode::gazebo {

namespace {

constexpr unsigned kMaxSide = 8193;  // samples of a height map

std::string without_scheme(const std::string& uri)
{
    return uri.rfind("file://", 0) == 0 ? uri.substr(7) : uri;
}

// Empty where there is no such file.
std::string find_file(const std::string& uri, const std::string& named_by)
{
    const std::filesystem::path path = without_scheme(uri);
    std::error_code problem;
    const auto near = std::filesystem::path(named_by).parent_path() / path;
    if (!named_by.empty() && std::filesystem::is_regular_file(near, problem)) return near.string();
    if (std::filesystem::is_regular_file(path, problem)) return path.string();
    return gz::common::findFile(uri);
}

std::string found_file(const Shape& shape, const std::string& uri, const std::string& named_by)
{
    const std::string path = find_file(uri, named_by);
    if (path.empty())
        EPODE_GAZEBO_ERROR << "collision '" << shape.name << "' of link '" << shape.link->name << "': file '"
                           << uri << "' was not found\n";
    return path;
}

}  // namespace

robots::Mesh mesh_of(const gz::common::Mesh& mesh)
{
    robots::Mesh out;
    for (unsigned i = 0; i < mesh.SubMeshCount(); ++i) {
        const auto part = mesh.SubMeshByIndex(i).lock();
        if (!part || part->SubMeshPrimitiveType() != gz::common::SubMesh::TRIANGLES) continue;
        const auto first = std::uint32_t(out.vertices.size());
        for (unsigned k = 0; k < part->VertexCount(); ++k) out.vertices.push_back(vec_of(part->Vertex(k)));
        const auto corner = [&](unsigned k) { return first + std::uint32_t(part->Index(k)); };
        for (unsigned k = 0; k + 2 < part->IndexCount(); k += 3)
            out.triangles.push_back({corner(k), corner(k + 1), corner(k + 2)});
    }
    for (const auto& t : out.triangles)
        for (std::uint32_t corner : t)
            if (corner >= out.vertices.size()) out.triangles.clear(), out.vertices.clear();
    return out;
}

bool make_mesh_of(Shape& shape, const gz::common::Mesh& mesh, Vec scale)
{
    shape.kind = ShapeKind::kMesh, shape.scale = scale;
    return make_mesh(shape, mesh_of(mesh));
}

// The first of the samples is the corner of the least x and the largest y, as in the picture; turned over the rows run up from the
// least y.
bool make_heights_of(Shape& shape, gz::common::HeightmapData& heights, Vec size, int sampling)
{
    shape.kind = ShapeKind::kHeightmap, shape.size = size;
    const unsigned many = unsigned(std::clamp(sampling, 1, 16));
    const unsigned side = (heights.Width() - 1) * many + 1;
    const double top = heights.MaxElevation();
    if (heights.Width() < 2 || side > kMaxSide || !(size.x > 0 && size.y > 0)) {
        EPODE_GAZEBO_ERROR << "collision '" << shape.name << "': a height map of " << side
                           << " samples a side and " << size.x << " m by " << size.y
                           << " m was refused; 2 ... 8193 samples are wanted\n";
        return false;
    }
    const gz::math::Vector3d scale(size.x / heights.Width(), size.y / heights.Height(),
                                   top > 0 ? std::abs(size.z) / top : 1);
    std::vector<float> samples;
    heights.FillHeightMap(int(many), side, gz::math::Vector3d(size.x, size.y, size.z), scale, true, samples);
    if (samples.size() < std::size_t(side) * side) return false;
    return make_heights(shape, {samples.begin(), samples.end()}, int(side), int(side));
}

bool read_mesh_file(const ::sdf::Mesh& from, Shape& shape)
{
    const std::string path = found_file(shape, from.Uri(), from.FilePath());
    if (path.empty()) return false;
    const gz::common::Mesh* const mesh = gz::common::MeshManager::Instance()->Load(path);
    if (mesh) return make_mesh_of(shape, *mesh, vec_of(from.Scale()));
    EPODE_GAZEBO_ERROR << "collision '" << shape.name << "': mesh '" << path << "' could not be read\n";
    return false;
}

bool read_height_file(const ::sdf::Heightmap& from, Shape& shape)
{
    const std::string path = found_file(shape, from.Uri(), from.FilePath());
    if (path.empty()) return false;
    gz::common::ImageHeightmap heights;
    if (heights.Load(path) < 0) {
        EPODE_GAZEBO_ERROR << "collision '" << shape.name << "': height map '" << path
                           << "' could not be read\n";
        return false;
    }
    shape.pose.p = shape.pose.p + rotate(shape.pose.q, vec_of(from.Position()));
    return make_heights_of(shape, heights, vec_of(from.Size()), int(from.Sampling()));
}

}  // namespace epode::gazebo
