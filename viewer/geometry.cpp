// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Filling and drawing the buffers of geometry.h. Meshes of boxes are for faces with bevels, round ones for
// balls and capsules; how finely a mesh is cut is part of its key, so each is made once. Triangles come in
// world coordinates in one buffer, sorted into ranges: solid, wire, translucent (from the farthest to the
// nearest), and once more those translucent ones that throw a shadow.
#include "geometry.h"

#include <algorithm>
#include <cstddef>

#include "camera.h"

namespace epode::viewer {

namespace {

constexpr float kOpaqueShadow = 0.5f;  // opacity from which on a shadow is thrown
constexpr int kBoxMesh = 0, kRoundMesh = 1, kCylinderMesh = 2;

void set_pointer(GLuint location, GLint size, std::size_t stride, std::size_t offset, GLuint divisor)
{
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
}

GLuint make_buffer(GLenum target)
{
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    return buffer;
}

template <class T>
void upload(GLenum target, const std::vector<T>& data, GLenum usage)
{
    glBufferData(target, static_cast<GLsizeiptr>(data.size() * sizeof(T)), data.data(), usage);
}

GLuint make_array()
{
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    return array;
}

void set_vertex_pointers(GLuint vertices, GLuint indices)
{
    glBindBuffer(GL_ARRAY_BUFFER, vertices);
    set_pointer(0, 3, sizeof(Vertex), offsetof(Vertex, corner), 0);
    set_pointer(1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, indices);
}

void set_instance_pointers(GLuint instances)
{
    glBindBuffer(GL_ARRAY_BUFFER, instances);
    for (GLuint i = 0; i < 3; ++i)
        set_pointer(2 + i, 4, sizeof(Instance), offsetof(Instance, row) + i * sizeof(float[4]), 1);
    set_pointer(5, 4, sizeof(Instance), offsetof(Instance, core), 1);
    set_pointer(6, 4, sizeof(Instance), offsetof(Instance, color), 1);
    set_pointer(7, 1, sizeof(Instance), offsetof(Instance, texture), 1);
}

Mesh mesh_of(int kind, int steps, bool fine)
{
    if (kind == kBoxMesh) return rounded_box(fine ? 2 : 1);
    if (kind == kCylinderMesh) return fine ? rounded_cylinder(48, 2) : rounded_cylinder(12, 1);
    return rounded_box(fine ? steps : std::min(steps, 2));
}

float distance_to(const Picture& picture, Vec p) { return length(p - vec(picture.camera.eye)); }

}  // namespace

Geometry::Batch Geometry::make_batch(const Key& key)
{
    Batch batch;
    batch.buffer = make_buffer(GL_ARRAY_BUFFER);
    for (const bool fine : {true, false}) {
        const Mesh mesh = mesh_of(std::get<0>(key), std::get<1>(key), fine);
        Level& level = fine ? batch.fine : batch.coarse;
        level.count = static_cast<GLsizei>(mesh.indices.size());
        level.single = make_array();
        const GLuint vertices = make_buffer(GL_ARRAY_BUFFER);
        upload(GL_ARRAY_BUFFER, mesh.vertices, GL_STATIC_DRAW);
        const GLuint indices = make_buffer(GL_ELEMENT_ARRAY_BUFFER);
        upload(GL_ELEMENT_ARRAY_BUFFER, mesh.indices, GL_STATIC_DRAW);
        set_vertex_pointers(vertices, indices);
        level.array = make_array();
        set_vertex_pointers(vertices, indices);
        set_instance_pointers(batch.buffer);
    }
    return batch;
}

void Geometry::open()
{
    triangles_ = make_array();
    triangle_buffer_ = make_buffer(GL_ARRAY_BUFFER);
    constexpr std::size_t kStride = sizeof(TriangleVertex);
    set_pointer(0, 3, kStride, offsetof(TriangleVertex, place), 0);
    set_pointer(1, 3, kStride, offsetof(TriangleVertex, normal), 0);
    set_pointer(2, 3, kStride, offsetof(TriangleVertex, local), 0);
    set_pointer(3, 3, kStride, offsetof(TriangleVertex, local_normal), 0);
    set_pointer(4, 4, kStride, offsetof(TriangleVertex, color), 0);
    set_pointer(5, 1, kStride, offsetof(TriangleVertex, texture), 0);
    lines_ = make_array();
    line_buffer_ = make_buffer(GL_ARRAY_BUFFER);
    set_pointer(0, 3, sizeof(Line), offsetof(Line, a), 1);
    set_pointer(1, 3, sizeof(Line), offsetof(Line, b), 1);
    set_pointer(2, 3, sizeof(Line), offsetof(Line, color), 1);
}

void Geometry::fill(const Picture& picture)
{
    fill_shapes(picture);
    fill_triangles(picture);
    fill_lines(picture);
}

void Geometry::add_shape(const Shape& shape, const Picture& picture)
{
    constexpr int kDefaultSteps = 6, kMaxSteps = 16;
    const bool is_round = shape.kind == ShapeKind::kSphere || shape.kind == ShapeKind::kCapsule;
    const int kind = is_round ? kRoundMesh : shape.kind == ShapeKind::kBox ? kBoxMesh : kCylinderMesh;
    const int requested = shape.steps > 0 ? std::min(shape.steps, kMaxSteps) : kDefaultSteps;
    const Key key{kind, is_round ? requested : 0, shape.wire};
    const auto found = batches_.find(key);
    Batch& batch =
        found != batches_.end() ? found->second : batches_.emplace(key, make_batch(key)).first->second;
    if (shape.alpha < 1) {
        veiled_.push_back({distance_to(picture, vec(shape.pos)), &batch, instance_of(shape), shape.wire});
    } else {
        batch.instances.push_back(instance_of(shape));
    }
}

void Geometry::fill_shapes(const Picture& picture)
{
    veiled_.clear();
    for (auto& [key, batch] : batches_) batch.instances.clear();
    for (const Shape& shape : picture.shapes) {
        if (drawable(shape)) add_shape(shape, picture);
    }
    for (auto& [key, batch] : batches_) {
        glBindBuffer(GL_ARRAY_BUFFER, batch.buffer);
        upload(GL_ARRAY_BUFFER, batch.instances, GL_STREAM_DRAW);
    }
    std::stable_sort(veiled_.begin(), veiled_.end(),
                     [](const Veiled& a, const Veiled& b) { return a.distance > b.distance; });
}

void Geometry::fill_triangles(const Picture& picture)
{
    std::vector<const Triangle*> members[kRanges];
    for (const Triangle& triangle : picture.triangles) {
        if (!drawable(triangle)) continue;
        const bool veiled = triangle.alpha < 1;
        members[veiled ? (triangle.wire ? kVeilWire : kVeil) : (triangle.wire ? kWire : kSolid)].push_back(
            &triangle);
        if (veiled && !triangle.wire && triangle.alpha >= kOpaqueShadow)
            members[kShadowOnly].push_back(&triangle);
    }
    const auto middle = [&](const Triangle* t) {
        const Corner* c = t->corners;
        return distance_to(picture, (1.0f / 3) * (vec(c[0].pos) + vec(c[1].pos) + vec(c[2].pos)));
    };
    for (const Range range : {kVeil, kVeilWire}) {
        std::stable_sort(members[range].begin(), members[range].end(),
                         [&](const Triangle* a, const Triangle* b) { return middle(a) > middle(b); });
    }
    std::vector<TriangleVertex> vertices;
    for (int range = 0; range < kRanges; ++range) {
        first_[range] = static_cast<GLint>(vertices.size());
        for (const Triangle* triangle : members[range]) {
            const Corner* c = triangle->corners;
            const Vec across = cross(vec(c[1].pos) - vec(c[0].pos), vec(c[2].pos) - vec(c[0].pos));
            const bool turned = dot(across, vec(c[0].normal)) < 0;
            const Vec local = normalize(
                cross(vec(c[1].local) - vec(c[0].local), vec(c[2].local) - vec(c[0].local)), {0, 0, 1});
            for (const int i : {0, turned ? 2 : 1, turned ? 1 : 2}) {
                TriangleVertex vertex{};
                std::copy(c[i].pos, c[i].pos + 3, vertex.place);
                std::copy(c[i].normal, c[i].normal + 3, vertex.normal);
                std::copy(c[i].local, c[i].local + 3, vertex.local);
                const float rest[] = {local.x, local.y, local.z};
                std::copy(rest, rest + 3, vertex.local_normal);
                const float color[] = {triangle->color.r, triangle->color.g, triangle->color.b,
                                       triangle->alpha};
                std::copy(color, color + 4, vertex.color);
                vertex.texture = static_cast<float>(triangle->texture);
                vertices.push_back(vertex);
            }
        }
    }
    first_[kRanges] = static_cast<GLint>(vertices.size());
    glBindBuffer(GL_ARRAY_BUFFER, triangle_buffer_);
    upload(GL_ARRAY_BUFFER, vertices, GL_STREAM_DRAW);
}

void Geometry::fill_lines(const Picture& picture)
{
    std::vector<Line> lines;
    for (const Line& line : picture.lines) {
        if (finite(vec(line.a)) && finite(vec(line.b))) lines.push_back(line);
    }
    line_count_ = static_cast<GLsizei>(lines.size());
    glBindBuffer(GL_ARRAY_BUFFER, line_buffer_);
    upload(GL_ARRAY_BUFFER, lines, GL_STREAM_DRAW);
}

void Geometry::draw_batches(Look look) const
{
    for (const auto& [key, batch] : batches_) {
        if (batch.instances.empty() || std::get<2>(key) != look.wire) continue;
        const Level& level = look.fine ? batch.fine : batch.coarse;
        glBindVertexArray(level.array);
        glDrawElementsInstanced(GL_TRIANGLES, level.count, GL_UNSIGNED_INT, nullptr,
                                static_cast<GLsizei>(batch.instances.size()));
    }
}

void Geometry::draw_range(Range range) const
{
    if (count(range) == 0) return;
    glBindVertexArray(triangles_);
    glDrawArrays(GL_TRIANGLES, first_[range], count(range));
}

namespace {

// Arrays of instances are off in a `single` array, so these values hold for the whole call.
void set_instance(const Instance& instance)
{
    for (GLuint i = 0; i < 3; ++i) glVertexAttrib4fv(2 + i, instance.row[i]);
    glVertexAttrib4fv(5, instance.core);
    glVertexAttrib4fv(6, instance.color);
    glVertexAttrib1f(7, instance.texture);
}

// Edges, of the far side too, for as long as this lives.
class Wires {
  public:
    explicit Wires(bool wanted) : wanted_(wanted)
    {
        if (!wanted_) return;
        glPolygonMode(GL_FRONT_AND_BACK, GL_LINE);
        glDisable(GL_CULL_FACE);
    }
    ~Wires()
    {
        if (wanted_) glPolygonMode(GL_FRONT_AND_BACK, GL_FILL);
    }
    Wires(const Wires&) = delete;
    Wires& operator=(const Wires&) = delete;

  private:
    bool wanted_;
};

}  // namespace

void Geometry::draw_caster_shapes(bool fine) const
{
    glEnable(GL_CULL_FACE);
    draw_batches({.fine = fine});
    for (const Veiled& veiled : veiled_) {
        if (veiled.wire || veiled.instance.color[3] < kOpaqueShadow) continue;
        const Level& level = fine ? veiled.batch->fine : veiled.batch->coarse;
        glBindVertexArray(level.single);
        set_instance(veiled.instance);
        glDrawElements(GL_TRIANGLES, level.count, GL_UNSIGNED_INT, nullptr);
    }
}

void Geometry::draw_caster_triangles() const
{
    glDisable(GL_CULL_FACE);
    draw_range(kSolid);
    draw_range(kShadowOnly);
}

void Geometry::draw_shapes() const
{
    glEnable(GL_CULL_FACE);
    draw_batches({.fine = true});
    const Wires wires(true);
    draw_batches({.wire = true, .fine = true});
}

void Geometry::draw_triangles() const
{
    glDisable(GL_CULL_FACE);
    draw_range(kSolid);
    const Wires wires(true);
    draw_range(kWire);
}

void Geometry::draw_veiled_shapes() const
{
    for (const Veiled& veiled : veiled_) {
        glEnable(GL_CULL_FACE);
        const Wires wires(veiled.wire);
        glBindVertexArray(veiled.batch->fine.single);
        set_instance(veiled.instance);
        glDrawElements(GL_TRIANGLES, veiled.batch->fine.count, GL_UNSIGNED_INT, nullptr);
    }
}

void Geometry::draw_veiled_triangles() const
{
    glDisable(GL_CULL_FACE);
    draw_range(kVeil);
    const Wires wires(true);
    draw_range(kVeilWire);
}

void Geometry::draw_lines() const
{
    glBindVertexArray(lines_);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, line_count_);
}

}  // namespace epode::viewer
