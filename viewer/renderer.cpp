// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One picture, in passes:
//   1. the depth of all shapes as the sun sees them, then as each point of the sky sees them (coarser meshes:
//   these shadows are soft);
//   2. shapes, triangles and ground as the camera sees them: place, normal and paint of four samples a pixel,
//   not yet lit;
//   3. light and sky, once per pixel and surface; 4. what is translucent, lit as it is drawn, on a veil
//   before the depth of pass 2, which is then laid over; 5. lines over it, faint where hidden.
// Shapes are instanced: one draw call per mesh and pass, however many there are. A shadow volume or ray
// tracer would give sharper truth, but a rasteriser in software draws a thousand shapes in a second and a GPU
// draws them in no time, with the same text.
#include "renderer.h"

#include <algorithm>

#include "frame.h"
#include "geometry.h"
#include "gl_tools.h"

namespace epode::viewer {

namespace {

// From the map's [0, 1]^3 back to OpenGL's [-1, 1]^3.
Mat4 clip_of_map(const Mat4& map)
{
    const Mat4 widen = {{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0, -1, -1, -1, 1}};
    return widen * map;
}

void use_with_view(GLuint program, const Mat4& view)
{
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, view.m);
}

void bind(GLuint unit, GLenum target, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
}

bool wants_textures(const Picture& picture)
{
    const auto textured = [](const auto& shape) { return shape.texture != Texture::kNone; };
    return picture.clouds || (picture.ground && picture.floor == Floor::kTextured) ||
           std::any_of(picture.shapes.begin(), picture.shapes.end(), textured) ||
           std::any_of(picture.triangles.begin(), picture.triangles.end(), textured);
}

}  // namespace

struct Renderer::Passes {
    bool open(std::string& error);
    bool draw(const Picture& picture, std::string& error);
    bool read(std::vector<std::uint8_t>& rgb, std::string& error);
    void show(GLuint framebuffer, int left);

    Image own[kTextures];  // given instead of ours

  private:
    bool make_programs(std::string& error);
    void make_textures();
    bool fit_maps(std::string& error);
    bool fit_canvas(const Picture& picture, std::string& error);
    void draw_map(const Mat4& view, bool fine, int side);
    void draw_maps();
    void draw_surfaces(const Picture& picture);
    void draw_light();
    bool draw_veil(std::string& error);
    void draw_lines();

    Frame frame_{};
    Quality quality_{0, 0, 0, 0};
    Geometry geometry_;
    GLuint depth_ = 0, shape_ = 0, veil_ = 0, triangle_depth_ = 0, triangle_ = 0, triangle_veil_ = 0;
    GLuint ground_ = 0, light_ = 0, line_ = 0, over_ = 0, show_ = 0;
    GLuint empty_ = 0, block_ = 0, map_target_ = 0, sun_map_ = 0, sky_map_ = 0, textures_ = 0;
    Surfaces surfaces_;
    Canvas canvas_;
    int width_ = 0, height_ = 0;
};

bool Renderer::Passes::make_programs(std::string& error)
{
    const auto make = [&](GLuint& program, const ProgramText& text) {
        return (program = make_program(text, error)) != 0;
    };
    return make(depth_, kDepthProgram) && make(shape_, kShapeProgram) && make(veil_, kVeilProgram) &&
           make(triangle_depth_, kTriangleDepthProgram) && make(triangle_, kTriangleProgram) &&
           make(triangle_veil_, kTriangleVeilProgram) && make(ground_, kGroundProgram) &&
           make(light_, kLightProgram) && make(line_, kLineProgram) && make(over_, kVeilOverProgram) &&
           make(show_, kShowProgram);
}

bool Renderer::Passes::open(std::string& error)
{
    if (!make_programs(error)) return false;
    geometry_.open();
    glGenVertexArrays(1, &empty_);
    glGenBuffers(1, &block_);
    glGenFramebuffers(1, &map_target_);
    const GLuint plain = make_depth_sampler(false), comparing = make_depth_sampler(true);
    const GLuint samplers[3] = {plain, comparing, comparing};
    for (GLuint unit = 0; unit < 3; ++unit) glBindSampler(unit, samplers[unit]);
    glDepthFunc(GL_LEQUAL);
    glClearColor(0, 0, 0, 0);
    return true;
}

void Renderer::Passes::make_textures()
{
    std::vector<Image> images;
    for (int i = 0; i < kTextures; ++i)
        images.push_back(own[i].rgb.empty() ? make_texture(static_cast<Texture>(i + 1)) : own[i]);
    glActiveTexture(GL_TEXTURE0 + kTexturesUnit);
    textures_ = make_picture_array(images, kTextureSide);
}

bool Renderer::Passes::fit_maps(std::string& error)
{
    const GLuint old[2] = {sun_map_, sky_map_};
    glDeleteTextures(2, old);
    sky_map_ = 0;
    glActiveTexture(GL_TEXTURE0);
    sun_map_ = make_depth_map(GL_TEXTURE_2D, GL_DEPTH_COMPONENT32F, quality_.sun_map, 0);
    if (quality_.sky_lights > 0)
        sky_map_ =
            make_depth_map(GL_TEXTURE_2D_ARRAY, GL_DEPTH_COMPONENT16, quality_.sky_map, quality_.sky_lights);
    glBindFramebuffer(GL_FRAMEBUFFER, map_target_);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, sun_map_, 0);
    if (!complete("a shadow map", error)) return false;
    if (!sky_map_) return true;
    glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, sky_map_, 0, 0);
    return complete("a shadow map", error);
}

bool Renderer::Passes::fit_canvas(const Picture& picture, std::string& error)
{
    surfaces_.free();
    canvas_.free();
    surfaces_ = {};
    canvas_ = {};
    width_ = height_ = 0;
    surfaces_.make(picture.width, picture.height);
    if (!complete("a canvas of this size", error)) return false;
    canvas_.make(picture.width, picture.height);
    if (!complete("a canvas of this size", error)) return false;
    width_ = picture.width;
    height_ = picture.height;
    return true;
}

void Renderer::Passes::draw_map(const Mat4& view, bool fine, int side)
{
    glViewport(0, 0, side, side);
    glClear(GL_DEPTH_BUFFER_BIT);
    use_with_view(depth_, clip_of_map(view));
    geometry_.draw_caster_shapes(fine);
    use_with_view(triangle_depth_, clip_of_map(view));
    geometry_.draw_caster_triangles();
}

void Renderer::Passes::draw_maps()
{
    glBindFramebuffer(GL_FRAMEBUFFER, map_target_);
    glEnable(GL_DEPTH_CLAMP);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, sun_map_, 0);
    draw_map(frame_.sun, true, quality_.sun_map);
    for (int i = 0; i < quality_.sky_lights; ++i) {
        glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, sky_map_, 0, i);
        draw_map(frame_.sky[i], false, quality_.sky_map);
    }
    glDisable(GL_DEPTH_CLAMP);
}

void Renderer::Passes::draw_surfaces(const Picture& picture)
{
    glBindFramebuffer(GL_FRAMEBUFFER, surfaces_.framebuffer);
    glViewport(0, 0, width_, height_);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    use_with_view(shape_, frame_.camera);
    geometry_.draw_shapes();
    use_with_view(triangle_, frame_.camera);
    geometry_.draw_triangles();
    glDisable(GL_CULL_FACE);
    if (picture.ground) {
        glBindVertexArray(empty_);
        glUseProgram(ground_);
        glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
    }
}

void Renderer::Passes::draw_light()
{
    bind(0, GL_TEXTURE_2D, sun_map_);
    bind(1, GL_TEXTURE_2D, sun_map_);
    bind(2, GL_TEXTURE_2D_ARRAY, sky_map_);
    for (GLuint i = 0; i < 3; ++i) bind(3 + i, GL_TEXTURE_2D_MULTISAMPLE, surfaces_.textures[i]);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas_.framebuffer);
    glDisable(GL_DEPTH_TEST);
    glBindVertexArray(empty_);
    glUseProgram(light_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

bool Renderer::Passes::draw_veil(std::string& error)
{
    if (!surfaces_.veil) {
        glActiveTexture(GL_TEXTURE0 + kVeilUnit);
        surfaces_.make_veil(width_, height_);
        if (!complete("a canvas of this size", error)) return false;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, surfaces_.veil_framebuffer);
    glClear(GL_COLOR_BUFFER_BIT);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_FALSE);
    glEnable(GL_BLEND);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    use_with_view(triangle_veil_, frame_.camera);
    geometry_.draw_veiled_triangles();
    use_with_view(veil_, frame_.camera);
    geometry_.draw_veiled_shapes();
    glDepthMask(GL_TRUE);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    bind(kVeilUnit, GL_TEXTURE_2D_MULTISAMPLE, surfaces_.veil);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas_.framebuffer);
    glBindVertexArray(empty_);
    glUseProgram(over_);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
    return true;
}

void Renderer::Passes::draw_lines()
{
    glUseProgram(line_);
    glEnable(GL_BLEND);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    geometry_.draw_lines();
    glDisable(GL_BLEND);
}

bool Renderer::Passes::draw(const Picture& picture, std::string& error)
{
    const Quality requested = bounded(picture.quality);
    if (requested != quality_) {
        quality_ = requested;
        if (!fit_maps(error)) return false;
    }
    if ((picture.width != width_ || picture.height != height_) && !fit_canvas(picture, error)) return false;
    if (!textures_ && wants_textures(picture)) make_textures();
    if (textures_) bind(kTexturesUnit, GL_TEXTURE_2D_ARRAY, textures_);
    frame_ = make_frame(picture);
    glBindBuffer(GL_UNIFORM_BUFFER, block_);
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame_, &frame_, GL_STREAM_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block_);
    geometry_.fill(picture);
    glEnable(GL_DEPTH_TEST);
    glEnable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_BLEND);
    if (picture.shadows) draw_maps();
    draw_surfaces(picture);
    draw_light();
    if (geometry_.has_veil() && !draw_veil(error)) return false;
    draw_lines();
    return complete("to draw the picture", error);
}

bool Renderer::Passes::read(std::vector<std::uint8_t>& rgb, std::string& error)
{
    rgb = read_pixels(canvas_.framebuffer, width_, height_);
    return complete("to read the picture back", error);
}

void Renderer::Passes::show(GLuint framebuffer, int left)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(left, 0, width_, height_);
    glDisable(GL_FRAMEBUFFER_SRGB);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_CULL_FACE);
    bind(kCanvasUnit, GL_TEXTURE_2D, canvas_.color);
    glBindVertexArray(empty_);
    glUseProgram(show_);
    glUniform1i(glGetUniformLocation(show_, "left"), left);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

// OpenGL's rows come from below.
std::vector<std::uint8_t> read_pixels(unsigned framebuffer, int width, int height)
{
    const std::size_t row = static_cast<std::size_t>(width) * 3;
    std::vector<std::uint8_t> rgb(row * static_cast<std::size_t>(height));
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGB, GL_UNSIGNED_BYTE, rgb.data());
    for (int low = 0, high = height - 1; low < high; ++low, --high) {
        const auto first = rgb.begin() + static_cast<std::ptrdiff_t>(row) * low;
        std::swap_ranges(first, first + static_cast<std::ptrdiff_t>(row),
                         rgb.begin() + static_cast<std::ptrdiff_t>(row) * high);
    }
    return rgb;
}

Renderer::Renderer() : passes_(std::make_unique<Passes>()) {}
Renderer::~Renderer() = default;
bool Renderer::open(std::string& error) { return passes_->open(error); }
bool Renderer::draw(const Picture& picture, std::string& error)
{
    return check_picture(picture, error) && passes_->draw(picture, error);
}
bool Renderer::read(std::vector<std::uint8_t>& rgb, std::string& error) { return passes_->read(rgb, error); }
void Renderer::show(unsigned framebuffer, int left) { passes_->show(framebuffer, left); }

void Renderer::lay(unsigned framebuffer, const Panel& panel, int x, int y, int below)
{
    GLuint texture = 0, from = 0;
    glGenTextures(1, &texture);
    glActiveTexture(GL_TEXTURE0 + kCanvasUnit);
    glBindTexture(GL_TEXTURE_2D, texture);
    glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB8, panel.width, panel.height, 0, GL_RGB, GL_UNSIGNED_BYTE,
                 panel.rgb);
    glGenFramebuffers(1, &from);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, from);
    glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    glBlitFramebuffer(0, 0, panel.width, panel.height, x, below - y, x + panel.width,
                      below - y - panel.height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glDeleteFramebuffers(1, &from);
    glDeleteTextures(1, &texture);
}

void Renderer::set_texture(Texture texture, const Image& image)
{
    if (texture != Texture::kNone) passes_->own[static_cast<int>(texture) - 1] = fitted(image);
}

}  // namespace epode::viewer
