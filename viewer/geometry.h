// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a picture holds, as OpenGL buffers: filled again for each picture, kept from one to the next. Shapes
// are instanced: one draw call per mesh and pass, however many there are; only translucent ones are drawn one
// by one, the farthest first, since blending asks for an order.
#pragma once

#include <epoxy/gl.h>

#include <map>
#include <tuple>
#include <vector>

#include "meshes.h"

namespace epode::viewer {

class Geometry {
  public:
    void open();
    void fill(const Picture& picture);

    // With the program in use. Casters: what throws shadows; coarse meshes do for soft ones.
    void draw_caster_shapes(bool fine) const;
    void draw_caster_triangles() const;
    void draw_shapes() const;
    void draw_triangles() const;
    bool has_veil() const { return !veiled_.empty() || count(kVeil) + count(kVeilWire) > 0; }
    void draw_veiled_shapes() const;
    void draw_veiled_triangles() const;
    void draw_lines() const;

  private:
    struct Level {
        GLuint array = 0, single = 0;  // with instances from the buffer; with one instance, set by hand
        GLsizei count = 0;
    };
    struct Batch {
        Level fine, coarse;
        GLuint buffer = 0;
        std::vector<Instance> instances;
    };
    // Mesh (box, round, cylinder), steps, wire.
    using Key = std::tuple<int, int, bool>;
    struct Veiled {
        float distance;
        const Batch* batch;
        Instance instance;
        bool wire;
    };
    struct TriangleVertex {
        float place[3], normal[3], local[3], local_normal[3], color[4], texture;
    };
    enum Range { kSolid, kWire, kVeil, kVeilWire, kShadowOnly, kRanges };

    static Batch make_batch(const Key& key);
    void add_shape(const Shape& shape, const Picture& picture);
    void fill_shapes(const Picture& picture);
    void fill_triangles(const Picture& picture);
    void fill_lines(const Picture& picture);
    struct Look {
        bool wire = false, fine = false;
    };
    void draw_batches(Look look) const;
    void draw_range(Range range) const;
    GLsizei count(Range range) const { return first_[range + 1] - first_[range]; }

    std::map<Key, Batch> batches_;
    std::vector<Veiled> veiled_;
    GLuint triangles_ = 0, triangle_buffer_ = 0;
    GLint first_[kRanges + 1] = {0, 0, 0, 0, 0, 0};
    GLuint lines_ = 0, line_buffer_ = 0;
    GLsizei line_count_ = 0;
};

}  // namespace epode::viewer
