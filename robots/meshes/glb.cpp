// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// GLB, the binary form of glTF 2.0: "glTF", version 2, length, then chunks (length, type, bytes): JSON, and BIN, the one
// buffer. Nodes have a matrix (by columns) or T R S; a mesh's primitives have positions and, mostly, indices, as views
// of the buffer. Axes stay those of the file: glTF says that y points up, but the GLB meshes of robots have the axes
// of their links, as the meshes of collisions next to them show. Materials, skins and animations are left out; buffers
// of other files and compressed primitives are refused. The JSON is nlohmann's; glTF libraries would decode pictures
// too, which nobody needs here.
#include <cstring>
#include <map>

#include "robots/meshes/formats.h"
#include "robots/meshes/scene.h"

#ifdef EPODE_HAVE_JSON
#include <nlohmann/json.hpp>
#endif

namespace epode::robots {

#ifdef EPODE_HAVE_JSON

namespace {

using Json = nlohmann::json;

constexpr std::uint32_t kMagic = 0x46546C67, kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr int kMaxDepth = 64;
constexpr int kFloat = 5126, kByte = 5121, kShort = 5123,
              kInt = 5125;  // component types; unsigned where whole
constexpr int kTriangleList = 4, kTriangleStrip = 5, kTriangleFan = 6;  // modes

std::uint32_t word_at(const std::string& bytes, size_t at)
{
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + at, 4);
    return value;
}

// False: no GLB of version 2, or its chunks are not as long as they say.
bool split(const std::string& bytes, std::string_view& json, std::string_view& binary)
{
    if (bytes.size() < 12 || word_at(bytes, 0) != kMagic || word_at(bytes, 4) != 2) return false;
    for (size_t at = 12; at + 8 <= bytes.size();) {
        const size_t length = word_at(bytes, at), kind = word_at(bytes, at + 4);
        if (length > bytes.size() - at - 8) return false;
        const std::string_view its = std::string_view(bytes).substr(at + 8, length);
        if (kind == kJsonChunk && json.empty()) json = its;
        if (kind == kBinaryChunk && binary.empty()) binary = its;
        at += 8 + length;
    }
    return !json.empty();
}

const Json kNothing;

const Json& field(const Json& object, const char* name)
{
    const auto it = object.find(name);  // end() of what is no object
    return it == object.end() ? kNothing : *it;
}

const Json& element(const Json& array, size_t index)
{
    return array.is_array() && index < array.size() ? array[index] : kNothing;
}

// A count, index or offset; -1 of what is none.
long long whole(const Json& object, const char* name, long long missing)
{
    const Json& its = field(object, name);
    if (its.is_null()) return missing;
    return its.is_number_unsigned() && its.get<std::uint64_t>() < (1ull << 32) ? its.get<long long>() : -1;
}

// As many numbers as wanted, or none.
std::vector<double> numbers(const Json& object, const char* name, size_t wanted)
{
    std::vector<double> out;
    const Json& its = field(object, name);
    if (!its.is_array() || its.size() != wanted) return out;
    for (const Json& one : its)
        if (one.is_number()) out.push_back(one.get<double>());
    if (out.size() != wanted) out.clear();
    return out;
}

Affine transform_of(const Json& node)
{
    Affine out;
    if (const auto m = numbers(node, "matrix", 16); !m.empty()) {
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) out.linear[i][j] = m[4 * j + i];
        out.shift = {m[12], m[13], m[14]};
        return out;
    }
    if (const auto t = numbers(node, "translation", 3); !t.empty()) out.shift = {t[0], t[1], t[2]};
    if (const auto r = numbers(node, "rotation", 4); !r.empty())
        out.linear = matrix_of(normalised({r[3], r[0], r[1], r[2]}));
    if (const auto s = numbers(node, "scale", 3); !s.empty())
        for (auto& row : out.linear)
            for (size_t j = 0; j < 3; ++j) row[j] *= s[j];
    return out;
}

class Glb {
  public:
    Glb(const Json& root, std::string_view buffer, Mesh& mesh) : root_(root), buffer_(buffer), mesh_(mesh) {}

    bool read(std::string& problem)
    {
        const Json& extensions = field(root_, "extensionsRequired");
        for (const Json& one : extensions)
            if (one.is_string() &&
                one.get_ref<const std::string&>().find("compression") != std::string::npos) {
                problem = "wants " + one.get<std::string>() + ", which is not read";
                return false;
            }
        const Json& scene = element(field(root_, "scenes"), size_t(whole(root_, "scene", 0)));
        return read_nodes(field(scene, "nodes"), {}, 0);
    }

  private:
    bool read_nodes(const Json& list, const Affine& outer, int depth)
    {
        if (depth > kMaxDepth) return false;
        for (const Json& index : list) {
            if (!index.is_number_unsigned() || ++instances_ > kMaxInstances) return false;
            const Json& node = element(field(root_, "nodes"), index.get<size_t>());
            const Affine here = outer * transform_of(node);
            const long long mesh = whole(node, "mesh", -1);
            if (mesh >= 0 && !add_mesh(size_t(mesh), here)) return false;
            if (!read_nodes(field(node, "children"), here, depth + 1)) return false;
        }
        return true;
    }

    // Read once, however often it is instanced: a small file must not cost much time.
    bool add_mesh(size_t number, const Affine& here)
    {
        const auto [it, is_new] = parts_.try_emplace(number);
        if (is_new)
            for (const Json& primitive : field(element(field(root_, "meshes"), number), "primitives"))
                if (!read_primitive(primitive, it->second)) return false;
        return add_part(it->second, here, mesh_);
    }

    // Elements of an accessor in the buffer.
    struct View {
        const char* first = nullptr;
        size_t count = 0, stride = 0;
        long long type = 0;
    };

    static size_t bytes_of(long long type) { return type == kByte ? 1 : type == kShort ? 2 : 4; }

    bool view_of(long long number, const char* shape, size_t components, View& out) const
    {
        const Json& accessor = element(field(root_, "accessors"), size_t(number));
        const Json& view = element(field(root_, "bufferViews"), size_t(whole(accessor, "bufferView", -1)));
        if (field(accessor, "type") != shape || !field(accessor, "sparse").is_null() || view.is_null())
            return false;
        out.type = whole(accessor, "componentType", -1);
        const size_t size = components * bytes_of(out.type);
        const long long count = whole(accessor, "count", -1), inner = whole(accessor, "byteOffset", 0);
        const long long offset = whole(view, "byteOffset", 0), length = whole(view, "byteLength", -1);
        const long long stride = whole(view, "byteStride", (long long)size);
        if (count < 1 || inner < 0 || offset < 0 || length < 0 || stride < (long long)size) return false;
        if (whole(view, "buffer", -1) != 0 || size_t(offset + length) > buffer_.size()) return false;
        const long long needed = inner + (long long)size;
        if (needed > length || count - 1 > (length - needed) / stride) return false;
        out.first = buffer_.data() + offset + inner, out.count = size_t(count), out.stride = size_t(stride);
        return true;
    }

    bool read_primitive(const Json& primitive, Part& part) const
    {
        const long long mode = whole(primitive, "mode", kTriangleList);
        if (mode < kTriangleList || mode > kTriangleFan) return mode >= 0;  // points and lines
        View positions;
        const size_t base = part.vertices.size();
        if (!view_of(whole(field(primitive, "attributes"), "POSITION", -1), "VEC3", 3, positions) ||
            positions.type != kFloat || base + positions.count > kMaxVertices)
            return false;
        for (size_t i = 0; i < positions.count; ++i) {
            float v[3];
            std::memcpy(v, positions.first + i * positions.stride, sizeof v);
            part.vertices.push_back({v[0], v[1], v[2]});
        }
        std::vector<std::uint32_t> corners;
        if (!read_corners(primitive, positions.count, corners)) return false;
        for (std::uint32_t& corner : corners) corner += std::uint32_t(base);
        add_triangles(mode, corners, part);
        return part.triangles.size() <= kMaxTriangles;
    }

    // Without indices the vertices in their order.
    bool read_corners(const Json& primitive, size_t vertices, std::vector<std::uint32_t>& out) const
    {
        const long long accessor = whole(primitive, "indices", -2);
        View indices;
        if (accessor != -2 && !view_of(accessor, "SCALAR", 1, indices)) return false;
        if (accessor != -2 && indices.type != kByte && indices.type != kShort && indices.type != kInt)
            return false;
        if (indices.count > 3 * kMaxTriangles) return false;
        out.resize(accessor == -2 ? vertices : indices.count, 0);
        for (size_t i = 0; i < out.size(); ++i) {
            if (accessor == -2)
                out[i] = std::uint32_t(i);
            else  // little-endian, as the format is
                std::memcpy(&out[i], indices.first + i * indices.stride, bytes_of(indices.type));
            if (out[i] >= vertices) return false;
        }
        return true;
    }

    static void add_triangles(long long mode, const std::vector<std::uint32_t>& corners, Part& part)
    {
        const size_t step = mode == kTriangleList ? 3 : 1;
        for (size_t i = 0; i + 3 <= corners.size(); i += step) {
            std::array<std::uint32_t, 3> t{corners[i], corners[i + 1], corners[i + 2]};
            if (mode == kTriangleFan) t[0] = corners[0];
            if (mode == kTriangleStrip && i % 2 == 1) std::swap(t[1], t[2]);
            part.triangles.push_back(t);
        }
    }

    const Json& root_;
    std::string_view buffer_;
    Mesh& mesh_;
    std::map<size_t, Part> parts_;
    size_t instances_ = 0;
};

}  // namespace

bool read_glb(const std::string&, const std::string& bytes, Mesh& mesh, std::string& problem)
{
    std::string_view json, binary;
    if (!split(bytes, json, binary)) return false;
    const Json root = Json::parse(json.begin(), json.end(), nullptr, false);
    return root.is_object() && Glb(root, binary, mesh).read(problem);
}

#else

bool read_glb(const std::string&, const std::string&, Mesh&, std::string& problem)
{
    problem = "is GLB, which this build does not read: it wants nlohmann-json3-dev, then cmake again";
    return false;
}

#endif

}  // namespace epode::robots
