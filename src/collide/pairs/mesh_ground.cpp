// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mesh_ground.h. A box has its corners by signs, c + sum of +-A_i, and so their places.
#include "collide/pairs/mesh_ground.h"

#include "collide/pairs/press.h"

namespace epode {

void MeshGround::press_edge(Vec3 p, const PrismPlace& a, Vec3 q, const PrismPlace& b)
{
    for (int k = 0; k < 3; ++k) {
        const Real at_p = a.beyond[k], at_q = b.beyond[k];
        const bool in_p = at_p <= m_.slack, in_q = at_q <= m_.slack;
        if (in_p == in_q || !ends_at(k) || (in_p ? at_p : at_q) >= 0)
            continue;  // an end on the wall is itself
        const Real t = at_p / (at_p - at_q);
        if (!low(a.height + t * (b.height - a.height))) continue;
        const int i = (k + 1) % 3, j = (k + 2) % 3;
        if (a.beyond[i] + t * (b.beyond[i] - a.beyond[i]) <= m_.slack &&
            a.beyond[j] + t * (b.beyond[j] - a.beyond[j]) <= m_.slack)
            give(p + t * (q - p));
    }
}

bool MeshGround::met() const
{
    const PrismPlace middle = place(m_.solid.pose.p);
    for (int i = 0; i < held_; ++i) {
        const PrismPlace at = place(holds_[i]);
        const Real down = at.height < 0 ? -at.height : 0;
        if (!(middle.height > 0)) return false;
        const Real t = down / (middle.height + down);
        bool in = true;
        for (int k = 0; k < 3; ++k)
            in = in && at.beyond[k] + t * (middle.beyond[k] - at.beyond[k]) <= m_.slack;
        if (in) return true;
    }
    return false;
}

// Corners of the triangle, brought down onto the face.
void MeshGround::press_corners(const Polygon& face)
{
    const Real fall = -dot(f_.n, face.normal);
    if (!(fall > 0)) return;
    for (int k = 0; k < 3; ++k) {
        if (!corner_counts(k)) continue;
        const Real depth = dot(face.points[0] - f_.v[k], face.normal) / fall;
        if (!(depth >= -m_.slack)) continue;
        const Vec3 p = f_.v[k] - depth * f_.n;
        bool in = true;
        for (int i = 0, j = face.count - 1; in && i < face.count; j = i++)
            in = dot(cross(face.normal, face.points[i] - face.points[j]), p - face.points[j]) >= 0;
        if (in) give(p);
    }
}

void MeshGround::press(const Polygon& face)
{
    Real height[Polygon::kMax];
    Real least = kInf;
    for (int i = 0; i < face.count; ++i) {
        height[i] = f_.height(face.points[i]);
        least = height[i] < least ? height[i] : least;
    }
    if (!low(least)) return;
    PrismPlace first{}, last{};
    bool known = false, crossed[3] = {};  // is the place of the last corner known?
    for (int i = 0, j = face.count - 1; i < face.count; j = i++) {
        const bool low_i = low(height[i]), low_j = low(height[j]);
        const bool was_known = known;
        if (!(known = low_i || low_j || low(height[(i + 1) % face.count]))) continue;
        const PrismPlace here = place(face.points[i]);
        if (i == 0) first = here;
        for (int k = 0; k < 3; ++k) crossed[k] = crossed[k] || here.beyond[k] > 0;
        if (low_i && within(here)) give(face.points[i]);
        if (i > 0 && was_known && (low_i || low_j)) press_edge(face.points[j], last, face.points[i], here);
        last = here;
    }
    const int end = face.count - 1;
    if (face.count > 2 && (low(height[0]) || low(height[end])))
        press_edge(face.points[end], last, face.points[0], first);
    if (face.count > 2 && crossed[0] + crossed[1] + crossed[2] > 1) press_corners(face);
}

namespace {

class BoxPress {
  public:
    BoxPress(const Box& box, const Pose& pose, const MeshFacet& f, MeshMeeting& m)
        : half_(box.half), pose_(pose), f_(f), to_(f, m), middle_(to_.place(pose.p))
    {
        for (int i = 0; i < 3; ++i) {
            arm_[i] = half_[i] * pose.R.column(i);
            step_[i] = to_.along(arm_[i]);
            lean_[i] = dot(pose.R.column(i), f.n);
            if (std::fabs(lean_[i]) < kFaceLean) continue;
            // The corners of the face across axis i that looks down: bit i of their numbers says plus.
            shown_ |= lean_[i] > 0 ? unsigned(~kPlus[i]) & 255u : kPlus[i];
            leans_[i] = true;
        }
    }

    void all()
    {
        PrismPlace at[8];
        Vec3 point[8];
        unsigned low = 0;
        for (int v = 0; v < 8; ++v) {
            at[v] = corner(v);
            low |= to_.low(at[v].height) ? 1u << v : 0;
        }
        if (!low) return;
        for (int v = 0; v < 8; ++v) {
            point[v] = pose_.p + sign(v, 0) * arm_[0] + sign(v, 1) * arm_[1] + sign(v, 2) * arm_[2];
            if ((low & shown_) >> v & 1 && to_.within(at[v])) to_.give(point[v]);
        }
        for (int i = 0; i < 3; ++i)
            for (int v = 0; v < 8; ++v) {
                const int w = v | 1 << i;
                if (v == w || !((low >> v | low >> w) & 1) || !edge_shown(v, i)) continue;
                to_.press_edge(point[v], at[v], point[w], at[w]);
            }
        triangle_corners();
    }

  private:
    static constexpr unsigned kPlus[3] = {0xaa, 0xcc, 0xf0};
    static Real sign(int v, int i) { return v >> i & 1 ? Real(1) : Real(-1); }

    PrismPlace corner(int v) const
    {
        PrismPlace a = middle_;
        for (int i = 0; i < 3; ++i) {
            const Real s = sign(v, i);
            a.height += s * step_[i].height;
            for (int k = 0; k < 3; ++k) a.beyond[k] += s * step_[i].beyond[k];
        }
        return a;
    }
    bool on_low_face(int v, int i) const { return leans_[i] && (lean_[i] > 0) != ((v >> i & 1) != 0); }
    // The edge from v along axis i: is one of its faces among those that look down?
    bool edge_shown(int v, int i) const { return on_low_face(v, (i + 1) % 3) || on_low_face(v, (i + 2) % 3); }

    bool crosses(int wall) const
    {
        Real most = middle_.beyond[wall];
        for (int i = 0; i < 3; ++i) most += std::fabs(step_[i].beyond[wall]);
        return most > 0;
    }

    // Those over the box, brought down onto the face by which the way down leaves it.
    void triangle_corners()
    {
        const bool crossed[3] = {crosses(0), crosses(1), crosses(2)};
        for (int k = 0; k < 3; ++k) {
            if (!crossed[k] || !crossed[(k + 2) % 3] || !to_.corner_counts(k)) continue;
            const Vec3 v = transposed_times(pose_.R, f_.v[k] - pose_.p);
            Real enters = -kInf, leaves = kInf;
            int by = 0;
            for (int i = 0; i < 3; ++i) {
                const Real way = -lean_[i], to_plus = half_[i] - v[i], to_minus = -half_[i] - v[i];
                if (way == 0) {
                    if (to_plus < 0 || to_minus > 0) enters = kInf;
                    continue;
                }
                const Real in = (way > 0 ? to_minus : to_plus) / way,
                           out = (way > 0 ? to_plus : to_minus) / way;
                enters = in > enters ? in : enters;
                if (out < leaves) leaves = out, by = i;
            }
            if (leans_[by] && enters <= leaves && leaves >= -to_.slack()) to_.give(f_.v[k] - leaves * f_.n);
        }
    }

    Vec3 half_;
    const Pose& pose_;
    const MeshFacet& f_;
    MeshGround to_;
    PrismPlace middle_, step_[3];
    Vec3 arm_[3];
    Real lean_[3];
    bool leans_[3] = {};
    unsigned shown_ = 0;  // corners of the faces that look down
};

}  // namespace

void press_box(const Box& box, const MeshFacet& f, MeshMeeting& m)
{
    BoxPress(box, m.solid.pose, f, m).all();
}

}  // namespace epode
