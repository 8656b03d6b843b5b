// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The calls of one frame become one picture: plain shapes, triangles and lines, with the colour, texture and
// mode that were set when they were drawn. Nothing is drawn while the program speaks, so it needs no OpenGL,
// and a frame nobody will see costs next to nothing.
#pragma once

#include <cmath>

#include "viewer/picture.h"

namespace epode::drawstuff {

class DrawList {
  public:
    // White, no texture, an empty picture but for the pyramids.
    void begin_frame();

    void set_color(float r, float g, float b, float alpha);
    void set_texture(int number);
    void set_wire(bool wire) { wire_ = wire; }
    void set_sphere_quality(int n);
    void set_capsule_quality(int n);

    template <class Scalar>
    void shape(viewer::ShapeKind kind, const Scalar* pos, const Scalar* R, float a, float b, float c)
    {
        if (!pos || !R) return;
        viewer::Shape shape = styled(kind);
        viewer::set_pose(shape, pos, R);
        shape.size[0] = a;
        shape.size[1] = b;
        shape.size[2] = c;
        picture_.shapes.push_back(shape);
    }

    template <class Scalar>
    void line(const Scalar* a, const Scalar* b)
    {
        if (!a || !b) return;
        viewer::Line line;
        for (int i = 0; i < 3; ++i) {
            line.a[i] = static_cast<float>(a[i]);
            line.b[i] = static_cast<float>(b[i]);
        }
        line.color = color_;
        picture_.lines.push_back(line);
    }

    template <class Scalar>
    void triangle(const Scalar* pos, const Scalar* R, const Scalar* v0, const Scalar* v1, const Scalar* v2,
                  bool solid)
    {
        if (!pos || !R || !v0 || !v1 || !v2) return;
        const Scalar* corners[3] = {v0, v1, v2};
        float local[3][3], world[3][3];
        for (int k = 0; k < 3; ++k) {
            for (int i = 0; i < 3; ++i) {
                local[k][i] = static_cast<float>(corners[k][i]);
                world[k][i] = static_cast<float>(pos[i] + R[4 * i] * corners[k][0] +
                                                 R[4 * i + 1] * corners[k][1] + R[4 * i + 2] * corners[k][2]);
            }
        }
        if (solid) {
            add_triangle(world, local);
        } else {
            for (int k = 0; k < 3; ++k) line(world[k], world[(k + 1) % 3]);
        }
    }

    const viewer::Picture& picture() const { return picture_; }

  private:
    viewer::Shape styled(viewer::ShapeKind kind) const;
    void add_triangle(const float (&world)[3][3], const float (&local)[3][3]);
    void add_pyramid(float x, float y);

    viewer::Picture picture_;
    viewer::Color color_{1, 1, 1};
    float alpha_ = 1;
    viewer::Texture texture_ = viewer::Texture::kNone;
    bool wire_ = false;
    int sphere_quality_ = 1, capsule_quality_ = 3;
};

// The one that the C functions fill. Colours and modes may be set when no loop runs.
DrawList& draw_list();

}  // namespace epode::drawstuff
