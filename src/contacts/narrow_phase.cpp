// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/narrow_phase.h"

#include <algorithm>
#include <cmath>

#include "collide/collide.h"
#include "contacts/material.h"
#include "contacts/patch_points.h"
#include "dynamics/integrate.h"
#include "math/rotation.h"

namespace epode {
namespace {

constexpr Real kReuse = Real(0.02);         // of the size, for full patches
constexpr Real kReuseLayer = Real(0.25);    // of the layer, for others
constexpr int kSolidPoints = kPatchPoints;  // that are asked for
constexpr int kSurfacePoints = 16;

// Half the longest side of the box, or nothing for what has no bounds.
Real size_of(Geom& geom)
{
    const Aabb& box = box_of(geom);
    const Vec3 side = box.hi - box.lo;
    const Real longest = std::max({side.x, side.y, side.z});
    return longest < kInf ? longest / 2 : kInf;
}

// That of the smaller one.
Real size_of(Geom& a, Geom& b)
{
    const Real size = std::min(size_of(a), size_of(b));
    return size < kInf ? size : 1;
}

// Functions of the program may have made it.
bool sound(const dContactGeom& c)
{
    return usable(c.pos, 3) && usable(c.normal, 3) && usable(c.depth) &&
           std::fabs(length2(load(c.normal)) - 1) < Real(1e-3);
}

class PairUpdate {
  public:
    PairUpdate(std::span<ContactPair> parts, const NarrowSettings& settings)
        : parts_(parts),
          head_(parts[0]),
          settings_(settings),
          pose1_(pose_of(*head_.g1)),
          pose2_(pose_of(*head_.g2)),
          x1_(head_.body1->position()),
          x2_(head_.body2 ? head_.body2->position() : Vec3{})
    {}

    void run(std::span<const ContactPair> old)
    {
        const Vec3 offset = transposed_times(pose1_.R, pose2_.p - pose1_.p);
        const Mat3 turn = transpose(pose1_.R) * pose2_.R;
        if (!old.empty() && hardly_moved(old, offset, turn) && reuse(old)) return;
        head_.offset = narrow(offset);
        for (int k = 0; k < 3; ++k) head_.turn[k] = narrow(turn.row(k));
        collide(old);
    }

  private:
    // How far any point of the smaller one can have moved in the other's frame.
    bool hardly_moved(std::span<const ContactPair> old, Vec3 offset, const Mat3& turn) const
    {
        const ContactPair& was = old[0];
        bool full = old.size() == 1, touches = false;
        for (const ContactPair& part : old) {
            touches = touches || part.patch.count > 0;
            full = full && part.patch.count == kPatchPoints;
        }
        if (!touches) return false;
        const Real size = size_of(*head_.g1, *head_.g2);
        const Real most = full ? kReuse * size : kReuseLayer * settings_.layer;
        // |R - R'| in the sense of Frobenius is 2 sqrt(2) sin(angle / 2).
        Real turned2 = 0;
        for (int k = 0; k < 3; ++k) turned2 += length2(turn.row(k) - widen(was.turn[k]));
        const Real turned = std::sqrt(turned2 / 2);
        return length(offset - widen(was.offset)) + turned * std::max(size, reach(was)) <= most;
    }

    // Of the points from g2's place: what a turn of g2 moves them by.
    static Real reach(const ContactPair& was)
    {
        float most = 0;
        for (int i = 0; i < was.patch.count; ++i) {
            const Float3 a = was.anchors[i].a2;
            most = std::max(most, a.x * a.x + a.y * a.y + a.z * a.z);
        }
        return std::sqrt(Real(most));
    }

    // False: they have come apart.
    bool reuse(std::span<const ContactPair> old)
    {
        bool touches = false;
        for (std::size_t i = 0; i < parts_.size(); ++i) {
            ContactPair& part = parts_[i];
            part.offset = old[i].offset;
            std::copy(std::begin(old[i].turn), std::end(old[i].turn), part.turn);
            part.normal = old[i].normal;
            part.patch = old[i].patch;
            std::copy_n(old[i].anchors, part.patch.count, part.anchors);
            touches = place(part) || touches;
        }
        return touches;
    }

    // Arms and gaps of the points at the present poses. True if one of them still touches.
    bool place(ContactPair& part)
    {
        Patch& patch = part.patch;
        if (patch.count == 0) return false;
        part.origin = x1_;
        part.layer = float(settings_.layer);
        const Vec3 n = pose1_.R * widen(part.normal);
        patch.normal = narrow(n);
        combine_materials(*head_.g1, *head_.g2, patch);
        bool touches = false;
        for (int i = 0; i < patch.count; ++i) {
            const ContactAnchor& anchor = part.anchors[i];
            const Vec3 at1 = pose1_.p + pose1_.R * widen(anchor.a1);
            const Vec3 at2 = pose2_.p + pose2_.R * widen(anchor.a2);
            const Vec3 at = Real(0.5) * (at1 + at2);
            const Real gap = Real(anchor.gap) + dot(n, at1 - at2);
            PatchPoint& point = patch.points[i];
            point.r1 = narrow(at - x1_);
            point.r2 = narrow(head_.body2 ? at - x2_ : Vec3{});
            point.gap = float(gap + settings_.layer);
            touches = touches || gap <= 0;
        }
        return touches;
    }

    void collide(std::span<const ContactPair> old)
    {
        dContactGeom found[kSurfacePoints];
        ContactArray out{found, int(sizeof(dContactGeom)), parts_.size() > 1 ? kSurfacePoints : kSolidPoints,
                         false};
        const Aabb &box1 = box_of(*head_.g1), &box2 = box_of(*head_.g2);
        if (overlap(box1, box2)) epode::collide(*head_.g1, *head_.g2, out);
        if (out.count > 0) return take(out, pose1_, pose2_, old);
        if (!draws_near() || !overlap(after_step(head_.body1, box1), after_step(head_.body2, box2))) return;
        const Pose soon1 = after_step(head_.body1, pose1_), soon2 = after_step(head_.body2, pose2_);
        collide_at(*head_.g1, soon1, *head_.g2, soon2, out);
        take(out, soon1, soon2, {});
        for (ContactPair& part : parts_)
            if (is_through(part)) part.patch.count = 0;
    }

    // Is it worth while to look where the two will be? Functions of the program are asked about the present.
    bool draws_near() const
    {
        if (asks_program(*head_.g1, *head_.g2)) return false;
        const Vec3 v = velocity(head_.body1) - velocity(head_.body2);
        const Real turned = spin(head_.body1) + spin(head_.body2);
        const Real size = size_of(*head_.g1, *head_.g2);
        return settings_.h * (length(v) + size * turned) > settings_.layer;
    }

    // At the end of the step, as far as is known.
    Vec3 velocity(const Body* body) const
    {
        if (!body) return {};
        const bool falls = body->gravity && !body->kinematic();
        return falls ? body->velocity() + settings_.h * settings_.gravity : body->velocity();
    }
    static Real spin(const Body* body) { return body ? length(body->angular_velocity()) : 0; }

    Pose after_step(const Body* body, const Pose& pose) const
    {
        if (!body) return pose;
        Quat q = turned(*body, body->angular_velocity(), settings_.h);
        if (!normalize(q)) return pose;
        const Mat3 turn = to_matrix(q) * transpose(body->rotation());
        const Vec3 x = body->position();
        return {x + settings_.h * velocity(body) + turn * (pose.p - x), turn * pose.R};
    }

    // Holds what has the pose's box then.
    Aabb after_step(const Body* body, const Aabb& box) const
    {
        if (!body) return box;
        const Vec3 way = settings_.h * velocity(body);
        const Real turn = settings_.h * spin(body) * length(box.hi - box.lo);
        const Vec3 round{turn, turn, turn};
        return {box.lo + way - round, box.hi + way + round};
    }

    // Too fast to be stopped: what meets it there is the other side.
    bool is_through(const ContactPair& part) const
    {
        for (int i = 0; i < part.patch.count; ++i)
            if (part.patch.points[i].gap < 0) return true;
        return false;
    }

    // The contacts of the two at A and B.
    void take(const ContactArray& out, const Pose& A, const Pose& B, std::span<const ContactPair> old)
    {
        PatchMaker maker(parts_);
        for (int i = 0; i < out.count; ++i)
            if (sound(*out.at(i))) maker.add(*out.at(i));
        maker.finish();
        for (ContactPair& part : parts_) settle(part, maker, A, B, old);
    }

    // Anchors, and impulses from the points that were near.
    void settle(ContactPair& part, const PatchMaker& maker, const Pose& A, const Pose& B,
                std::span<const ContactPair> old)
    {
        Patch& patch = part.patch;
        if (patch.count == 0) return;
        part.normal = narrow(transposed_times(A.R, widen(patch.normal)));
        for (int i = 0; i < patch.count; ++i) {
            const dContactGeom& c = maker.source(part.part, i);
            const Vec3 p = load(c.pos);
            patch.points[i].push = 0;
            patch.points[i].friction = {};
            part.anchors[i] = {narrow(transposed_times(A.R, p - A.p)), narrow(transposed_times(B.R, p - B.p)),
                               float(-c.depth)};
        }
        place(part);
        const Real size = size_of(*head_.g1, *head_.g2);
        for (const ContactPair& was : old) inherit_impulses(was, size, part);
    }

    std::span<ContactPair> parts_;
    ContactPair& head_;
    const NarrowSettings& settings_;
    const Pose pose1_, pose2_;
    const Vec3 x1_, x2_;
};

}  // namespace

void update_pair(std::span<ContactPair> parts, std::span<const ContactPair> old,
                 const NarrowSettings& settings)
{
    PairUpdate(parts, settings).run(old);
}

}  // namespace epode
