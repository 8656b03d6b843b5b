// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// COLLADA (DAE): the geometry of its scenes, in metres and z up. A node's transform is the product of its matrix, translate, rotate and scale elements in their order.
#include <map>

#include "robots/files/xml.h"
#include "robots/meshes/formats.h"
#include "robots/meshes/scene.h"

namespace epode::robots {

namespace {

constexpr double kDegree = 3.14159265358979323846 / 180;

std::vector<double> numbers_of(const Element& element)
{
    std::vector<double> out;
    parse_numbers(element.node.text().get(), out);
    return out;
}

// Of an element that is no transform: none.
Affine transform_of(const Element& element)
{
    const std::string name = element.name();
    const std::vector<double> n = numbers_of(element);
    Affine out;
    if (name == "matrix" && n.size() == 16) {
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) out.linear[i][j] = n[4 * i + j];
        out.shift = {n[3], n[7], n[11]};
    } else if (name == "translate" && n.size() == 3) {
        out.shift = {n[0], n[1], n[2]};
    } else if (name == "rotate" && n.size() == 4) {
        out.linear = matrix_of(turn({n[0], n[1], n[2]}, n[3] * kDegree));
    } else if (name == "scale" && n.size() == 3) {
        for (size_t i = 0; i < 3; ++i) out.linear[i][i] = n[i];
    }
    return out;
}

class Collada {
  public:
    Collada(Element root, Mesh& mesh) : root_(root), mesh_(mesh) {}

    bool read()
    {
        for (const Element& library : root_.children())
            for (const Element& item : library.children())
                by_id_[library.name() + '#' + item.text("id")] = item;
        const Affine axes = asset();
        for (const Element& library : root_.children("library_visual_scenes"))
            for (const Element& scene : library.children("visual_scene"))
                for (const Element& node : scene.children("node"))
                    if (!read_node(node, axes)) return false;
        return true;
    }

  private:
    Affine asset() const
    {
        Affine out;
        std::vector<double> meter;
        const Element asset = root_.child("asset");
        const double unit =
            parse_numbers(asset.child("unit").text("meter"), meter) && meter.size() == 1 ? meter[0] : 1;
        const std::string up = asset.child("up_axis").node.text().get();
        if (up == "Y_UP") out.linear = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
        if (up == "X_UP") out.linear = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};
        for (auto& row : out.linear)
            for (double& value : row) value *= unit;
        return out;
    }

    Element find(const std::string& library, const std::string& url) const
    {
        std::string key = library;
        if (!url.starts_with("#")) key += '#';
        const auto it = by_id_.find(key + url);
        return it == by_id_.end() ? Element{} : it->second;
    }

    bool read_node(const Element& node, const Affine& outer)
    {
        if (++instances_ > kMaxInstances) return false;
        Affine here = outer;
        for (const Element& child : node.children()) here = here * transform_of(child);
        for (const Element& child : node.children()) {
            if (child.name() == "node" && !read_node(child, here)) return false;
            if (child.name() == "instance_geometry" && !add_geometry(child.text("url"), here)) return false;
        }
        return true;
    }

    // The floats that the POSITION input of the vertices element means.
    std::vector<double> positions(const Element& mesh) const
    {
        std::string source;
        for (const Element& input : mesh.child("vertices").children("input"))
            if (input.text("semantic") == "POSITION") source = input.text("source");
        for (const Element& candidate : mesh.children("source"))
            if (source.starts_with("#") && candidate.text("id") == source.substr(1))
                return numbers_of(candidate.child("float_array"));
        return {};
    }

    // Read once, however often it is instanced: a small file must not cost much time.
    bool add_geometry(const std::string& url, const Affine& here)
    {
        const auto [it, is_new] = parts_.try_emplace(url);
        if (is_new && !read_geometry(find("library_geometries", url).child("mesh"), it->second)) return false;
        return add_part(it->second, here, mesh_);
    }

    bool read_geometry(const Element& mesh, Part& part) const
    {
        const std::vector<double> floats = positions(mesh);
        for (size_t i = 0; i + 3 <= floats.size(); i += 3)
            part.vertices.push_back({floats[i], floats[i + 1], floats[i + 2]});
        for (const Element& list : mesh.children()) {
            const std::string kind = list.name();
            const bool has_faces = kind == "triangles" || kind == "polylist" || kind == "polygons";
            if (has_faces && !read_faces(list, part)) return false;
        }
        return true;
    }

    // Of a corner's indices, one for each input, that of VERTEX counts.
    struct Layout {
        size_t stride = 1, offset = 0;
    };
    static bool read_layout(const Element& list, Layout& layout)
    {
        for (const Element& input : list.children("input")) {
            std::vector<double> n;
            if (!parse_numbers(input.text("offset"), n) || n.size() != 1 || !(n[0] >= 0 && n[0] < 64))
                return false;
            layout.stride = std::max(layout.stride, size_t(n[0]) + 1);
            if (input.text("semantic") == "VERTEX") layout.offset = size_t(n[0]);
        }
        return true;
    }

    // The faces of a p element: three corners each, as many as vcount says, or all.
    static bool read_faces(const Element& list, Part& part)
    {
        Layout layout;
        if (!read_layout(list, layout)) return false;
        const std::string kind = list.name();
        const std::vector<double> sizes = numbers_of(list.child("vcount"));
        for (const Element& p : list.children("p")) {
            const std::vector<double> indices = numbers_of(p);
            const size_t corners = indices.size() / layout.stride;
            size_t corner = 0;
            for (size_t face = 0; corner < corners; ++face) {
                double size = kind == "polygons" ? double(corners) : 3;
                if (kind == "polylist") size = face < sizes.size() ? sizes[face] : 0;
                if (!(size >= 1 && size <= double(corners - corner))) return false;
                if (!add_face(&indices[corner * layout.stride], size_t(size), layout, part)) return false;
                corner += size_t(size);
            }
        }
        return true;
    }

    static bool add_face(const double* indices, size_t size, const Layout& layout, Part& part)
    {
        std::vector<std::uint32_t> fan;
        for (size_t i = 0; i < size; ++i) {
            const double index = indices[i * layout.stride + layout.offset];
            if (!(index >= 0 && index < double(part.vertices.size()))) return false;
            fan.push_back(std::uint32_t(index));
        }
        for (size_t i = 2; i < fan.size(); ++i) part.triangles.push_back({fan[0], fan[i - 1], fan[i]});
        return part.triangles.size() <= kMaxTriangles;
    }

    Element root_;
    Mesh& mesh_;
    std::map<std::string, Element> by_id_;
    std::map<std::string, Part> parts_;
    size_t instances_ = 0;
};

}  // namespace

bool read_collada(const std::string& path, const std::string& text, Mesh& mesh, std::string& problem)
{
    const auto document = parse_xml(path, text, problem);
    if (!document) return false;
    return Collada({document->tree.child("COLLADA"), document.get()}, mesh).read();
}

}  // namespace epode::robots
