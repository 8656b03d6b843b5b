// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One picture, in passes:
//   1. the depth of all shapes as the sun sees them, then as each point of the sky sees them (coarser meshes:
//   these shadows are soft);
//   2. shapes and ground as the camera sees them: place, normal and paint of four samples a pixel, not yet
//   lit;
//   3. light and sky, once per pixel and surface; 4. lines over it, faint where hidden; 5. the canvas is read
//   back.
// Shapes are instanced: one draw call per mesh and pass, however many there are. A shadow volume or ray
// tracer would give sharper truth, but a rasteriser in software draws a thousand shapes in a second and a GPU
// draws them in no time, with the same text.
#include "renderer.h"

#include <algorithm>
#include <cstddef>

#include "frame.h"
#include "gl_tools.h"
#include "meshes.h"

namespace epode::viewer {

namespace {

// Instances that share a mesh, at two levels of detail.
struct Batch {
    GLuint fine = 0, coarse = 0;
    GLsizei fine_count = 0, coarse_count = 0, instances = 0;
};

class Renderer {
  public:
    explicit Renderer(const Picture& picture) : picture_(picture), frame_(make_frame(picture)) {}
    bool prepare(std::string& error);
    bool draw(std::vector<std::uint8_t>& rgb, std::string& error);

  private:
    bool make_programs(std::string& error);
    void make_batches();
    void make_lines();
    void use_shapes_view(GLuint program, const Mat4& view);
    void draw_shapes(bool fine);
    bool draw_maps(std::string& error);
    bool draw_surfaces(std::string& error);
    bool draw_light(std::string& error);
    void draw_lines();
    void read_back(std::vector<std::uint8_t>& rgb);

    const Picture& picture_;
    Frame frame_;
    GLuint depth_ = 0, shape_ = 0, ground_ = 0, light_ = 0, line_ = 0;
    std::vector<Batch> batches_;
    GLuint lines_ = 0, empty_ = 0;
    GLsizei line_count_ = 0;
};

void set_pointer(GLuint location, GLint size, std::size_t stride, std::size_t offset, GLuint divisor)
{
    glEnableVertexAttribArray(location);
    glVertexAttribPointer(location, size, GL_FLOAT, GL_FALSE, static_cast<GLsizei>(stride),
                          reinterpret_cast<const void*>(offset));
    glVertexAttribDivisor(location, divisor);
}

GLuint make_buffer(GLenum target, const void* data, std::size_t bytes)
{
    GLuint buffer = 0;
    glGenBuffers(1, &buffer);
    glBindBuffer(target, buffer);
    glBufferData(target, static_cast<GLsizeiptr>(bytes), data, GL_STATIC_DRAW);
    return buffer;
}

GLuint make_array()
{
    GLuint array = 0;
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    return array;
}

GLuint make_mesh_array(const Mesh& mesh, GLuint instances)
{
    const GLuint array = make_array();
    make_buffer(GL_ARRAY_BUFFER, mesh.vertices.data(), mesh.vertices.size() * sizeof(Vertex));
    set_pointer(0, 3, sizeof(Vertex), offsetof(Vertex, corner), 0);
    set_pointer(1, 3, sizeof(Vertex), offsetof(Vertex, normal), 0);
    make_buffer(GL_ELEMENT_ARRAY_BUFFER, mesh.indices.data(), mesh.indices.size() * sizeof(std::uint32_t));
    glBindBuffer(GL_ARRAY_BUFFER, instances);
    for (GLuint i = 0; i < 3; ++i)
        set_pointer(2 + i, 4, sizeof(Instance), offsetof(Instance, row) + i * sizeof(float[4]), 1);
    set_pointer(5, 4, sizeof(Instance), offsetof(Instance, core), 1);
    set_pointer(6, 3, sizeof(Instance), offsetof(Instance, color), 1);
    return array;
}

Batch make_batch(const std::vector<Instance>& instances, const Mesh& fine, const Mesh& coarse)
{
    Batch batch;
    const GLuint buffer = make_buffer(GL_ARRAY_BUFFER, instances.data(), instances.size() * sizeof(Instance));
    batch.fine = make_mesh_array(fine, buffer);
    batch.coarse = make_mesh_array(coarse, buffer);
    batch.fine_count = static_cast<GLsizei>(fine.indices.size());
    batch.coarse_count = static_cast<GLsizei>(coarse.indices.size());
    batch.instances = static_cast<GLsizei>(instances.size());
    return batch;
}

// From the map's [0, 1]^3 back to OpenGL's [-1, 1]^3.
Mat4 clip_of_map(const Mat4& map)
{
    const Mat4 widen = {{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, -1, -1, 1}};
    return widen * map;
}

bool Renderer::make_programs(std::string& error)
{
    return (depth_ = make_program(kDepthProgram, error)) && (shape_ = make_program(kShapeProgram, error)) &&
           (ground_ = make_program(kGroundProgram, error)) && (light_ = make_program(kLightProgram, error)) &&
           (line_ = make_program(kLineProgram, error));
}

void Renderer::make_batches()
{
    std::vector<Instance> boxes, round, cylinders;
    for (const Shape& shape : picture_.shapes) {
        if (!drawable(shape)) continue;
        const bool is_round = shape.kind == ShapeKind::kSphere || shape.kind == ShapeKind::kCapsule;
        (is_round ? round : shape.kind == ShapeKind::kBox ? boxes : cylinders).push_back(instance_of(shape));
    }
    if (!boxes.empty()) batches_.push_back(make_batch(boxes, rounded_box(2), rounded_box(1)));
    if (!round.empty()) batches_.push_back(make_batch(round, rounded_box(6), rounded_box(2)));
    if (!cylinders.empty())
        batches_.push_back(make_batch(cylinders, rounded_cylinder(48, 2), rounded_cylinder(12, 1)));
}

void Renderer::make_lines()
{
    std::vector<Line> lines;
    for (const Line& line : picture_.lines) {
        if (finite(vec(line.a)) && finite(vec(line.b))) lines.push_back(line);
    }
    line_count_ = static_cast<GLsizei>(lines.size());
    lines_ = make_array();
    make_buffer(GL_ARRAY_BUFFER, lines.data(), lines.size() * sizeof(Line));
    set_pointer(0, 3, sizeof(Line), offsetof(Line, a), 1);
    set_pointer(1, 3, sizeof(Line), offsetof(Line, b), 1);
    set_pointer(2, 3, sizeof(Line), offsetof(Line, color), 1);
}

bool Renderer::prepare(std::string& error)
{
    if (!make_programs(error)) return false;
    make_batches();
    make_lines();
    empty_ = make_array();
    const GLuint block = make_buffer(GL_UNIFORM_BUFFER, &frame_, sizeof frame_);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glEnable(GL_CULL_FACE);
    return true;
}

void Renderer::use_shapes_view(GLuint program, const Mat4& view)
{
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, view.m);
}

void Renderer::draw_shapes(bool fine)
{
    for (const Batch& batch : batches_) {
        glBindVertexArray(fine ? batch.fine : batch.coarse);
        glDrawElementsInstanced(GL_TRIANGLES, fine ? batch.fine_count : batch.coarse_count, GL_UNSIGNED_INT,
                                nullptr, batch.instances);
    }
}

bool Renderer::draw_maps(std::string& error)
{
    GLuint target = 0;
    glGenFramebuffers(1, &target);
    glBindFramebuffer(GL_FRAMEBUFFER, target);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glEnable(GL_DEPTH_CLAMP);
    const GLuint sun_map = make_depth_map(GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, kSunMapSide, 0);
    const GLuint sky_map = make_depth_map(GL_TEXTURE_2D_ARRAY, GL_DEPTH_COMPONENT16, kSkyMapSide, kSkyLights);
    for (int i = -1; i < kSkyLights; ++i) {
        const bool is_sun = i < 0;
        if (is_sun) {
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, sun_map, 0);
        } else {
            glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, sky_map, 0, i);
        }
        if (i <= 0 && !complete("a shadow map", error)) return false;
        const int side = is_sun ? kSunMapSide : kSkyMapSide;
        glViewport(0, 0, side, side);
        glClear(GL_DEPTH_BUFFER_BIT);
        use_shapes_view(depth_, clip_of_map(is_sun ? frame_.sun : frame_.sky[i]));
        draw_shapes(is_sun);
    }
    glDisable(GL_DEPTH_CLAMP);
    const GLuint plain = make_depth_sampler(false), comparing = make_depth_sampler(true);
    const GLuint samplers[3] = {plain, comparing, comparing};
    for (GLuint unit = 0; unit < 3; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(unit < 2 ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY, unit < 2 ? sun_map : sky_map);
        glBindSampler(unit, samplers[unit]);
    }
    return true;
}

bool Renderer::draw_surfaces(std::string& error)
{
    const Surfaces surfaces = make_surfaces(picture_.width, picture_.height);
    if (!complete("a canvas of this size", error)) return false;
    glViewport(0, 0, picture_.width, picture_.height);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    use_shapes_view(shape_, frame_.camera);
    draw_shapes(true);
    glDisable(GL_CULL_FACE);
    if (picture_.ground) {
        glBindVertexArray(empty_);
        glUseProgram(ground_);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
    for (GLuint i = 0; i < 3; ++i) {
        glActiveTexture(GL_TEXTURE3 + i);
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, surfaces.textures[i]);
    }
    return true;
}

bool Renderer::draw_light(std::string& error)
{
    make_canvas(picture_.width, picture_.height);
    if (!complete("a canvas of this size", error)) return false;
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(empty_);
    glUseProgram(light_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return true;
}

void Renderer::draw_lines()
{
    glBindVertexArray(lines_);
    glUseProgram(line_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, 4, line_count_);
}

void Renderer::read_back(std::vector<std::uint8_t>& rgb)
{
    const int width = picture_.width, height = picture_.height;
    const std::size_t row = static_cast<std::size_t>(width) * 3;
    rgb.resize(row * static_cast<std::size_t>(height));
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    for (int low = 0, high = height - 1; low < high; ++low, --high) {
        const auto first = rgb.begin() + static_cast<std::ptrdiff_t>(row) * low;
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row),
                         rgb.begin() + static_cast<std::ptrdiff_t>(row) * high);
    }
}

bool Renderer::draw(std::vector<std::uint8_t>& rgb, std::string& error)
{
    if (!draw_maps(error) || !draw_surfaces(error) || !draw_light(error)) return false;
    draw_lines();
    read_back(rgb);
    return complete("to read the picture back", error);
}

}  // namespace

bool render(const Picture& picture, std::vector<std::uint8_t>& rgb, std::string& error)
{
    Renderer renderer(picture);
    return renderer.prepare(error) && renderer.draw(rgb, error);
}

}  // namespace epode::viewer
