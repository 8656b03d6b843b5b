// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One buffer: first the surfaces (points, normals, corners), then times, then the tracks. Every piece is a
// multiple of four bytes, so everything is aligned. Final poses are those of the last state in floats.
#include "record/output/glb.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "record/file/bytes.h"
#include "record/file/whole_file.h"
#include "record/output/animation.h"
#include "record/output/json.h"
#include "record/output/palette.h"
#include "record/output/tessellate.h"

namespace epode::record {

namespace {

enum Target { kPoints = 34962, kCorners = 34963, kTracks = 0 };
constexpr int kFloat = 5126, kUnsigned = 5125;

struct Accessor {
    size_t view, count;
    int component;
    const char* type;
    std::vector<float> low, high;
};

struct View {
    size_t offset, size;
    int target;
};

double linear(double srgb) { return srgb <= 0.04045 ? srgb / 12.92 : std::pow((srgb + 0.055) / 1.055, 2.4); }

// glTF's quaternions have their real part last.
std::array<float, 4> xyzw(const Quat& q) { return {float(q[1]), float(q[2]), float(q[3]), float(q[0])}; }

class GlbBuilder {
  public:
    GlbBuilder(const Recording& recording, double fps) : animation_(make_animation(recording, fps)) {}

    std::vector<std::uint8_t> build()
    {
        json_.object();
        json_.key("asset").object().key("version").value("2.0").key("generator").value("epode").end_object();
        json_.key("scene").value(0);
        json_.key("scenes")
            .array()
            .object()
            .key("nodes")
            .array()
            .value(0)
            .end_array()
            .end_object()
            .end_array();
        make_meshes();
        make_nodes();
        make_tracks();
        write_accessors();
        json_.end_object();
        return packed();
    }

  private:
    // -- the buffer -----------------------------------------------------------------------------------------
    size_t add_view(size_t offset, int target)
    {
        views_.push_back({offset, data_.bytes().size() - offset, target});
        return views_.size() - 1;
    }

    template <size_t n>
    size_t add_floats(const std::vector<std::array<float, n>>& rows, int target, const char* type,
                      bool bounds)
    {
        const size_t offset = data_.bytes().size();
        Accessor accessor{0, rows.size(), kFloat, type, {}, {}};
        for (const auto& row : rows) {
            for (float value : row) data_.f32(value);
        }
        for (size_t i = 0; i < n && bounds; ++i) {
            const auto [low, high] = std::minmax_element(
                rows.begin(), rows.end(), [i](const auto& a, const auto& b) { return a[i] < b[i]; });
            accessor.low.push_back((*low)[i]);
            accessor.high.push_back((*high)[i]);
        }
        accessor.view = add_view(offset, target);
        accessors_.push_back(accessor);
        return accessors_.size() - 1;
    }

    size_t add_corners(const std::vector<std::uint32_t>& corners)
    {
        const size_t offset = data_.bytes().size();
        for (std::uint32_t corner : corners) data_.u32(corner);
        accessors_.push_back({add_view(offset, kCorners), corners.size(), kUnsigned, "SCALAR", {}, {}});
        return accessors_.size() - 1;
    }

    // -- meshes: a mesh is a shape in a colour
    // ----------------------------------------------------------------
    struct Mesh {
        size_t points, normals, corners;
        bool empty = true;
    };

    Mesh mesh_of(const Shape& shape)
    {
        const Surface surface = tessellate(shape, std::max(10.0, 1.5 * animation_.reach));
        if (surface.empty()) return {};
        Mesh mesh;
        mesh.points = add_floats(surface.points, kPoints, "VEC3", true);
        mesh.normals = add_floats(surface.normals, kPoints, "VEC3", false);
        mesh.corners = add_corners(surface.corners);
        mesh.empty = false;
        return mesh;
    }

    void make_meshes()
    {
        std::map<std::uint32_t, Mesh> solids;
        std::map<std::uint32_t, size_t> materials;
        std::vector<std::pair<std::uint32_t, std::uint32_t>> meshes;
        for (const Part& part : animation_.parts) {
            if (!solids.contains(part.solid)) solids[part.solid] = mesh_of(animation_.solids[part.solid]);
            const std::pair key{part.solid, color_number(part.body)};
            if (solids[part.solid].empty || mesh_number_.contains(key)) continue;
            mesh_number_[key] = meshes.size();
            meshes.push_back(key);
            materials.emplace(key.second, materials.size());
        }
        if (meshes.empty()) return;
        json_.key("meshes").array();
        for (const auto& [solid, color] : meshes) {
            const Mesh& mesh = solids[solid];
            json_.object().key("name").value(std::string(name_of(animation_.solids[solid].kind)) + " " +
                                             std::to_string(solid));
            json_.key("primitives").array().object();
            json_.key("attributes").object().key("POSITION").value(mesh.points);
            json_.key("NORMAL").value(mesh.normals).end_object();
            json_.key("indices").value(mesh.corners).key("material").value(materials[color]);
            json_.end_object().end_array().end_object();
        }
        json_.end_array();
        std::vector<std::uint32_t> colors(materials.size());
        for (const auto& [number, place] : materials) colors[place] = number;
        json_.key("materials").array();
        for (std::uint32_t number : colors) {
            const Color srgb = color(number);
            json_.object().key("pbrMetallicRoughness").object().key("baseColorFactor").array();
            for (double value : srgb) json_.value(linear(value));
            json_.value(1).end_array().key("metallicFactor").value(0).key("roughnessFactor").value(0.7);
            json_.end_object().end_object();
        }
        json_.end_array();
    }

    // -- nodes: 0 the root, then the carriers, then the parts
    // ---------------------------------------------------
    size_t node_of_carrier(size_t carrier) const { return 1 + carrier; }
    size_t node_of_part(size_t part) const { return 1 + animation_.carriers.size() + part; }

    void write_pose(const Pose& pose)
    {
        json_.key("translation").array();
        for (double value : pose.pos) json_.value(value);
        json_.end_array().key("rotation").values(xyzw(pose.turn));
    }

    void write_part(size_t number)
    {
        const Part& part = animation_.parts[number];
        json_.object().key("name").value("geom " + std::to_string(part.geom));
        write_pose(part.pose);
        json_.key("scale").values(part.scale);
        const auto mesh = mesh_number_.find({part.solid, color_number(part.body)});
        if (mesh != mesh_number_.end()) json_.key("mesh").value(mesh->second);
        json_.end_object();
    }

    void write_carrier(size_t number, const std::vector<size_t>& children)
    {
        const Carrier& carrier = animation_.carriers[number];
        json_.object().key("name").value(carrier.body == kNobody ? "moving geom"
                                                                 : "body " + std::to_string(carrier.body));
        if (!carrier.poses.empty()) write_pose(carrier.poses.front());
        if (!children.empty()) {
            json_.key("children").array();
            for (size_t child : children) json_.value(child);
            json_.end_array();
        }
        json_.end_object();
    }

    void make_nodes()
    {
        std::vector<std::vector<size_t>> children(animation_.carriers.size());
        json_.key("nodes").array().object().key("name").value("z up");
        json_.key("rotation")
            .array()
            .value(-std::sqrt(0.5))
            .value(0)
            .value(0)
            .value(std::sqrt(0.5))
            .end_array();
        if (!animation_.carriers.empty() || !animation_.parts.empty()) json_.key("children").array();
        for (size_t i = 0; i < animation_.carriers.size(); ++i) json_.value(node_of_carrier(i));
        for (size_t i = 0; i < animation_.parts.size(); ++i) {
            const std::int32_t carrier = animation_.parts[i].carrier;
            if (carrier == kNoCarrier) {
                json_.value(node_of_part(i));
            } else {
                children[size_t(carrier)].push_back(node_of_part(i));
            }
        }
        if (!animation_.carriers.empty() || !animation_.parts.empty()) json_.end_array();
        json_.end_object();
        for (size_t i = 0; i < animation_.carriers.size(); ++i) write_carrier(i, children[i]);
        for (size_t i = 0; i < animation_.parts.size(); ++i) write_part(i);
        json_.end_array();
    }

    // -- tracks
    // -------------------------------------------------------------------------------------------------
    struct Track {
        size_t node, output;
        const char* path;
        const char* interpolation;
    };

    void add_tracks(size_t number, std::vector<Track>& tracks)
    {
        const Carrier& carrier = animation_.carriers[number];
        const size_t node = node_of_carrier(number);
        if (carrier.moves) {
            std::vector<std::array<float, 3>> positions;
            std::vector<std::array<float, 4>> turns;
            for (const Pose& pose : carrier.poses) {
                positions.push_back({float(pose.pos[0]), float(pose.pos[1]), float(pose.pos[2])});
                turns.push_back(xyzw(pose.turn));
            }
            tracks.push_back({node, add_floats(positions, kTracks, "VEC3", false), "translation", "LINEAR"});
            tracks.push_back({node, add_floats(turns, kTracks, "VEC4", false), "rotation", "LINEAR"});
        }
        if (!carrier.always_alive) {
            std::vector<std::array<float, 3>> scales;
            for (std::uint8_t alive : carrier.alive)
                scales.push_back({float(alive), float(alive), float(alive)});
            tracks.push_back({node, add_floats(scales, kTracks, "VEC3", false), "scale", "STEP"});
        }
    }

    void make_tracks()
    {
        const bool any = std::any_of(animation_.carriers.begin(), animation_.carriers.end(),
                                     [](const Carrier& c) { return c.moves || !c.always_alive; });
        if (!any) return;
        std::vector<std::array<float, 1>> times;
        for (float time : animation_.times) times.push_back({time});
        const size_t input = add_floats(times, kTracks, "SCALAR", true);
        std::vector<Track> tracks;
        for (size_t i = 0; i < animation_.carriers.size(); ++i) add_tracks(i, tracks);
        json_.key("animations").array().object().key("name").value("run").key("samplers").array();
        for (const Track& track : tracks) {
            json_.object().key("input").value(input).key("output").value(track.output);
            json_.key("interpolation").value(track.interpolation).end_object();
        }
        json_.end_array().key("channels").array();
        for (size_t i = 0; i < tracks.size(); ++i) {
            json_.object().key("sampler").value(i).key("target").object().key("node").value(tracks[i].node);
            json_.key("path").value(tracks[i].path).end_object().end_object();
        }
        json_.end_array().end_object().end_array();
    }

    void write_accessors()
    {
        if (accessors_.empty()) return;
        json_.key("accessors").array();
        for (const Accessor& accessor : accessors_) {
            json_.object()
                .key("bufferView")
                .value(accessor.view)
                .key("componentType")
                .value(accessor.component);
            json_.key("count").value(accessor.count).key("type").value(accessor.type);
            if (!accessor.low.empty()) json_.key("min").values(accessor.low).key("max").values(accessor.high);
            json_.end_object();
        }
        json_.end_array().key("bufferViews").array();
        for (const View& view : views_) {
            json_.object().key("buffer").value(0).key("byteOffset").value(view.offset);
            json_.key("byteLength").value(view.size);
            if (view.target != kTracks) json_.key("target").value(view.target);
            json_.end_object();
        }
        json_.end_array().key("buffers").array().object();
        json_.key("byteLength").value(data_.bytes().size()).end_object().end_array();
    }

    // Header, the JSON padded with spaces, the buffer.
    std::vector<std::uint8_t> packed() const
    {
        std::string text = json_.text();
        text.resize((text.size() + 3) / 4 * 4, ' ');
        const bool any = !data_.bytes().empty();
        ByteWriter out;
        out.u32(0x46546C67);
        out.u32(2);
        out.u32(std::uint32_t(12 + 8 + text.size() + (any ? 8 + data_.bytes().size() : 0)));
        out.u32(std::uint32_t(text.size()));
        out.u32(0x4E4F534A);
        for (char c : text) out.u8(std::uint8_t(c));
        std::vector<std::uint8_t> bytes = out.bytes();
        if (!any) return bytes;
        ByteWriter head;
        head.u32(std::uint32_t(data_.bytes().size()));
        head.u32(0x004E4942);
        bytes.insert(bytes.end(), head.bytes().begin(), head.bytes().end());
        bytes.insert(bytes.end(), data_.bytes().begin(), data_.bytes().end());
        return bytes;
    }

    Animation animation_;
    Json json_;
    ByteWriter data_;
    std::vector<View> views_;
    std::vector<Accessor> accessors_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, size_t> mesh_number_;
};

}  // namespace

bool write_glb(const Recording& recording, const std::string& path, double fps, std::string& problem)
{
    if (!can_animate(recording, fps, problem)) return false;
    const auto bytes = GlbBuilder(recording, fps).build();
    if (bytes.size() > UINT32_MAX - 64) {
        problem = "a .glb file cannot be larger than 4 GB; record fewer frames a second (--fps)";
        return false;
    }
    return write_whole(path, bytes, problem);
}

}  // namespace epode::record
