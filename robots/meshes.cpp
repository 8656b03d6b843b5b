// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See meshes.h. A solid is the sum of the tetrahedra from an inner point o to the triangles (a, b, c): volume
// V = a.(b x c)/6, centre (a + b + c)/4, and second moments  V/20 (sum_i r_i r_i^T + s s^T) with s = a + b + c, from
// which I = tr(M) 1 - M.
#include "robots/meshes.h"

#include <charconv>
#include <cstring>
#include <map>

#include "robots/collada.h"
#include "robots/files.h"

namespace epode::robots {

namespace {

constexpr size_t kMaxTriangles = 20'000'000;

// Corners at the same place become one vertex.
class Corners {
  public:
    explicit Corners(Mesh& mesh) : mesh_(mesh) {}
    void triangle(const std::array<Vec, 3>& corners)
    {
        std::array<std::uint32_t, 3> t;
        for (size_t i = 0; i < 3; ++i) t[i] = number_of(corners[i]);
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) mesh_.triangles.push_back(t);
    }

  private:
    std::uint32_t number_of(Vec v)
    {
        const auto [it, is_new] = numbers_.try_emplace({v.x, v.y, v.z}, std::uint32_t(mesh_.vertices.size()));
        if (is_new) mesh_.vertices.push_back(v);
        return it->second;
    }
    Mesh& mesh_;
    std::map<std::array<double, 3>, std::uint32_t> numbers_;
};

float float_at(const std::string& bytes, size_t offset)
{
    float value;
    std::memcpy(&value, bytes.data() + offset, 4);
    return value;
}

// 80 bytes, a count, and for each triangle twelve floats (the first three a normal) and two bytes.
bool is_binary_stl(const std::string& bytes, size_t& count)
{
    if (bytes.size() < 84) return false;
    std::uint32_t n;
    std::memcpy(&n, bytes.data() + 80, 4);
    count = n;
    return bytes.size() >= 84 + 50 * count &&
           (bytes.size() == 84 + 50 * count || !bytes.starts_with("solid"));
}

void read_binary_stl(const std::string& bytes, size_t count, Mesh& mesh)
{
    Corners corners(mesh);
    for (size_t t = 0; t < count; ++t) {
        std::array<Vec, 3> three;
        for (size_t i = 0; i < 3; ++i) {
            const size_t at = 84 + 50 * t + 12 + 12 * i;
            three[i] = {float_at(bytes, at), float_at(bytes, at + 4), float_at(bytes, at + 8)};
            if (!is_finite(three[i])) return;
        }
        corners.triangle(three);
    }
}

// Words of a text one after the other.
class Words {
  public:
    explicit Words(const std::string& text) : at_(text.data()), end_(text.data() + text.size()) {}
    bool next(std::string_view& word)
    {
        while (at_ != end_ && static_cast<unsigned char>(*at_) <= ' ') ++at_;
        const char* begin = at_;
        while (at_ != end_ && static_cast<unsigned char>(*at_) > ' ') ++at_;
        word = {begin, size_t(at_ - begin)};
        return begin != at_;
    }
    bool number(double& value)
    {
        std::string_view word;
        if (!next(word)) return false;
        if (word[0] == '+') word.remove_prefix(1);
        return std::from_chars(word.data(), word.data() + word.size(), value).ec == std::errc() &&
               std::isfinite(value);
    }
    bool vec(Vec& v) { return number(v.x) && number(v.y) && number(v.z); }
    // What is left of the line.
    std::string_view line()
    {
        const char* begin = at_;
        while (at_ != end_ && *at_ != '\n') ++at_;
        return {begin, size_t(at_ - begin)};
    }

  private:
    const char *at_, *end_;
};

bool read_text_stl(const std::string& text, Mesh& mesh)
{
    Words words(text);
    Corners corners(mesh);
    std::array<Vec, 3> three;
    size_t filled = 0;
    for (std::string_view word; words.next(word);) {
        if (word != "vertex") continue;
        if (!words.vec(three[filled])) return false;
        if (++filled == 3) corners.triangle(three), filled = 0;
    }
    return true;
}

// Faces of more than three corners become fans. "7", "7/2", "7//3", "-1": the first number counts from 1, or from
// the last vertex backwards.
bool read_obj(const std::string& text, Mesh& mesh)
{
    Words words(text);
    for (std::string_view word; words.next(word);) {
        if (word == "v") {
            Vec v;
            if (!words.vec(v)) return false;
            mesh.vertices.push_back(v);
        } else if (word == "f") {
            std::vector<std::uint32_t> face;
            const std::string line(words.line());
            Words its(line);
            for (std::string_view corner; its.next(corner);) {
                long n = 0;
                std::from_chars(corner.data(), corner.data() + corner.size(), n);
                const long count = long(mesh.vertices.size()), index = n > 0 ? n - 1 : count + n;
                if (n == 0 || index < 0 || index >= count) return false;
                face.push_back(std::uint32_t(index));
            }
            for (size_t i = 2; i < face.size(); ++i) {
                if (mesh.triangles.size() >= kMaxTriangles) return false;
                mesh.triangles.push_back({face[0], face[i - 1], face[i]});
            }
        } else {
            words.line();
        }
    }
    return true;
}

// The mean place of the surface.
Vec middle_of(const Mesh& mesh)
{
    Vec sum;
    double area = 0;
    for (const auto& t : mesh.triangles) {
        const Vec a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
        const double its = length(cross(b - a, c - a)) / 2;
        sum = sum + (its / 3) * (a + b + c);
        area += its;
    }
    return area > 0 ? (1 / area) * sum : mesh.vertices[0];
}

struct Moments {
    double volume = 0;
    Vec first;
    Matrix second{};
};

Moments moments_about(const Mesh& mesh, Vec inner)
{
    Moments out;
    for (const auto& t : mesh.triangles) {
        const Vec r[3] = {mesh.vertices[t[0]] - inner, mesh.vertices[t[1]] - inner,
                          mesh.vertices[t[2]] - inner};
        const Vec s = r[0] + r[1] + r[2];
        double v = dot(r[0], cross(r[1], r[2])) / 6;
        if (mesh.counts_folds) v = std::fabs(v);
        out.volume += v;
        out.first = out.first + (v / 4) * s;
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j)
                out.second[size_t(i)][size_t(j)] +=
                    v / 20 * (r[0][i] * r[0][j] + r[1][i] * r[1][j] + r[2][i] * r[2][j] + s[i] * s[j]);
    }
    return out;
}

}  // namespace

bool read_mesh(const std::string& path, const std::string& bytes, Mesh& mesh, std::string& problem)
{
    const std::string ending = ending_of(path);
    mesh.path = path;
    bool is_read = true;
    size_t count = 0;
    if (ending == "stl" && is_binary_stl(bytes, count))
        read_binary_stl(bytes, count, mesh);
    else if (ending == "stl")
        is_read = read_text_stl(bytes, mesh);
    else if (ending == "obj")
        is_read = read_obj(bytes, mesh);
    else if (ending == "dae")
        is_read = read_collada(path, bytes, mesh, problem);
    else {
        problem = "'" + path + "': meshes are read from .stl, .obj and .dae";
        return false;
    }
    if (is_read && !mesh.triangles.empty() && mesh.triangles.size() <= kMaxTriangles) return true;
    if (problem.empty()) problem = "'" + path + "' is broken or has no triangles";
    return false;
}

void scale_mesh(Mesh& mesh, Vec factors)
{
    for (Vec& v : mesh.vertices) v = scaled(v, factors);
    if (factors.x * factors.y * factors.z < 0)
        for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
}
// Twice: about the middle of the surface for the centre of mass, and about that for mass and inertia.
bool solid_of(const Mesh& mesh, Solid& solid)
{
    if (mesh.vertices.empty()) return false;
    const Vec middle = middle_of(mesh);
    const Moments rough = moments_about(mesh, middle);
    if (rough.volume == 0 || !std::isfinite(rough.volume)) return false;
    solid.centre = middle + (1 / rough.volume) * rough.first;
    const Moments fine = moments_about(mesh, solid.centre);
    const double sign = fine.volume < 0 ? -1 : 1;  // inside out
    const Matrix& m = fine.second;
    const double trace = m[0][0] + m[1][1] + m[2][2];
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) solid.inertia[i][j] = sign * ((i == j ? trace : 0) - m[i][j]);
    solid.volume = sign * fine.volume;
    return solid.volume > 0 && is_finite(solid.inertia);
}

}  // namespace epode::robots
