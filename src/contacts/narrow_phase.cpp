// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/narrow_phase.h"

#include <algorithm>
#include <cmath>

#include "collide/collide.h"
#include "collide/solid_type.h"
#include "contacts/ahead/pair_ahead.h"
#include "contacts/ahead/pair_separation.h"
#include "contacts/manifold_points.h"
#include "contacts/material.h"
#include "contacts/pair_rules.h"

namespace epode {
namespace {

constexpr Real kReuse = Real(0.02);  // of the size, for manifolds that miss nothing
// Of the carried size, the layer at most: where nobody has set it, and where the program has. A tower of toy bricks would sink by as much as each
// keeps, 1 mm in 15 in dDefaultsGame.
constexpr Real kLayerShare = Real(1e-3), kSetLayerShare = Real(5e-3);
constexpr Real kReuseLayer = Real(0.25);       // of the layer, for others
constexpr Real kSwift = Real(0.02);            // of the size, a way in one step
constexpr Real kNear = Real(0.3);              // of the size, at most, for points that do not touch yet
constexpr Real kShallow = Real(0.1);           // of the thickness
constexpr int kSolidPoints = kManifoldPoints;  // that are asked for
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

// The size that the layer of a pair follows, of what is carried by it. Contacts that carry one thing together have one layer, or the
// deepest of them has no load: all of a body's geoms have the size of the body, and bodies that joints hold together are
// as good as large. What does not move has no say.
Real carried_size(Geom& geom, const Body* body)
{
    if (!moves(body) || body->lasting) return kInf;
    if (!geom.body_next && !geom.body_prev) return size_of(geom);
    constexpr Real kOfPlate = Real(1.22);  // half an edge of a plate over its radius of gyration
    const Real largest = std::max({body->inertia.xx, body->inertia.yy, body->inertia.zz});
    return kOfPlate * std::sqrt(largest * body->inv_mass);
}

// Functions of the program may have made it.
bool sound(const dContactGeom& c)
{
    return usable(c.pos, 3) && usable(c.normal, 3) && usable(c.depth) &&
           std::fabs(length2(load(c.normal)) - 1) < Real(1e-3);
}

class PairUpdate {
  public:
    PairUpdate(ContactPair& pair, const NarrowSettings& settings, CachedManifold* into, NearLeaves* leaves)
        : pair_(pair),
          g1_(*from_handle<Geom>(pair.id1)),
          g2_(*from_handle<Geom>(pair.id2)),
          parts_(into, pair.max_manifolds),
          settings_(settings),
          leaves_(leaves),
          pose1_(pose_of(g1_)),
          pose2_(pose_of(g2_)),
          x1_(pair.body1->position()),
          x2_(pair.body2 ? pair.body2->position() : Vec3{})
    {}

    void run(std::span<const CachedManifold> old)
    {
        pair_.count = 0;
        if (old.empty() && remains_separated()) return;
        frame2_ = frame_of_anchors(pose2_, x1_, !pair_.body2);
        offset_ = transposed_times(pose1_.R, frame2_.p - pose1_.p);
        turn_ = transpose(pose1_.R) * pose2_.R;
        if (!old.empty() && hardly_moved(old) && reuse(old)) return;
        pair_.count = 0;
        collide(old);
    }

  private:
    Real size() const
    {
        if (size_ < 0) size_ = size_of(g1_, g2_);
        return size_;
    }
    // It is small compared with the smaller one that is carried, too.
    Real layer() const
    {
        if (layer_ < 0) layer_ = fitting_layer();
        return layer_;
    }
    Real fitting_layer() const
    {
        const Real size = std::min(carried_size(g1_, pair_.body1), carried_size(g2_, pair_.body2));
        return std::min(settings_.layer, (settings_.is_set ? kSetLayerShare : kLayerShare) * size);
    }
    bool can_be_separated() const { return settings_.foresees && is_solid(g1_) && is_solid(g2_); }

    // Now and at the end of the step, along the direction of the step before or another one.
    bool remains_separated()
    {
        if (!can_be_separated()) return false;
        if (!pair_.separating_axis && !find_separating_axis(pose1_, pose2_)) return false;
        const PairSeparation separation(g1_, g2_);
        const Vec3 n = unpack_direction(pair_.separating_axis);
        const Real gap = separation.gap(pose1_, pose2_, n);
        apart_ = gap > separation.hair();
        return apart_ && separation.lasts(pose1_, pose2_, n, gap, settings_.soon, pair_.body1, pair_.body2);
    }

    bool find_separating_axis(const Pose& A, const Pose& B)
    {
        const Vec3 guess = pair_.separating_axis ? unpack_direction(pair_.separating_axis) : A.p - B.p;
        pair_.separating_axis = pack_direction(PairSeparation(g1_, g2_).find(A, B, guess));
        return pair_.separating_axis != 0;
    }

    std::uint32_t changes() const { return changes_of(g1_) + changes_of(g2_); }
    bool may_have_changed() const { return pair_.asked || changes_unseen(g1_) || changes_unseen(g2_); }

    // How far any point of the smaller one can have moved in the other's frame.
    bool hardly_moved(std::span<const CachedManifold> old) const
    {
        const ManifoldFinding& was = old[0].found;
        if (was.changes != changes() || may_have_changed()) return false;
        const bool full =
            knows_corners() || (pair_.max_manifolds == 1 && old[0].manifold.count == kManifoldPoints);
        if (!full && (is_round(g1_) || is_round(g2_))) return false;
        const Real size = this->size();
        const Real max_motion = full ? kReuse * size : kReuseLayer * layer();
        const Mat3 turn = {widen(was.turn[0]), widen(was.turn[1]), widen(was.turn[2])};
        // |R - R'| in the sense of Frobenius is 2 sqrt(2) sin(angle / 2).
        Real turned2 = 0;
        for (int k = 0; k < 3; ++k) turned2 += length2(turn_.row(k) - turn.row(k));
        turned2 /= 2;
        // Of g2's place; of the solid's where the other is a landscape, whose place may be far away.
        const bool first = pair_.max_manifolds > 1 && is_solid(g1_);
        const Vec3 then = widen(was.offset),
                   way = offset_ - (first ? turn_ * transposed_times(turn, then) : then);
        const Real way2 = length2(way), reach2 = largest_reach2(first ? was.anchors.a1 : was.anchors.a2);
        // Mostly by far, and (a + b)^2 <= 2 (a^2 + b^2) needs no roots, for each of which the next would
        // wait.
        if (2 * (way2 + turned2 * std::max(size * size, reach2)) < Real(0.99) * max_motion * max_motion)
            return true;
        return std::sqrt(way2) + std::sqrt(turned2) * std::max(size, std::sqrt(reach2)) <= max_motion;
    }

    // False: they have come apart.
    bool reuse(std::span<const CachedManifold> old)
    {
        bool touches = false;
        for (std::size_t i = 0; i < old.size(); ++i) {
            parts_[i].found = old[i].found, parts_[i].manifold = old[i].manifold;
            touches = place(old[i], parts_[i]) || touches;
        }
        pair_.count = std::uint8_t(old.size());
        return touches;
    }

    // A copy of `was`, or itself, at the present poses; true if a point of it still touches. `was` is read,
    // since a copy just made takes its time to arrive.
    bool place(const CachedManifold& was, CachedManifold& part)
    {
        part.origin = x1_;
        part.layer = float(layer());
        const bool touches =
            place_points(pose1_, frame2_, x1_, pair_.body2 ? &x2_ : nullptr, layer(), was, part.manifold);
        combine_materials(g1_, g2_, x1_, part.manifold);
        return touches;
    }

    void collide(std::span<const CachedManifold> old)
    {
        dContactGeom found[kSurfacePoints];
        ContactArray out{found, int(sizeof(dContactGeom)),
                         pair_.max_manifolds > 1 ? kSurfacePoints : kSolidPoints, false};
        out.kept = leaves_;
        out.margin = margin();
        const Aabb &box1 = box_of(g1_), &box2 = box_of(g2_);
        if (!apart_ && overlap(box1, box2)) epode::collide(g1_, g2_, out);
        if (!settings_.foresees)
            return out.count > 0 ? take(out, pose1_, pose2_, old, Anchors::kTogether) : void();
        const PairAhead ahead(pair_, {g1_, pose1_}, {g2_, pose2_}, settings_.soon, size());
        if (out.count == 0) return ahead.way() > layer() ? foresee(ahead, out) : void();
        // More than gravity moves what rests.
        const bool moves = ahead.present_way() > layer();
        if ((moves || old.empty()) && !knows_corners()) ahead.add_far(pose1_, pose2_, out);
        if (moves && pair_.max_manifolds > 1) ahead.add_other_parts(out);
        take(out, pose1_, pose2_, old, Anchors::kTogether);
    }

    // What does not touch yet may do so at the end of the step, or before.
    void foresee(const PairAhead& ahead, ContactArray& out)
    {
        const SpeculativeMotion& soon = settings_.soon;
        const bool swift = ahead.is_swift();
        if (!ahead.may_meet(swift)) return;
        const Pose soon1 = ahead.first_after(soon), soon2 = ahead.second_after(soon);
        if (!swift && can_be_separated() && find_separating_axis(soon1, soon2)) return;
        if (are_loose_balls()) return meet(soon1, soon2);
        const SpeculativeMotion met = ahead.find(swift, out);
        expect(ahead, met, out);
        if (has_passed()) expect(ahead, ahead.find_earlier(met, out), out);
        drop_passed();
    }

    // The contacts of the two after `met`.
    void expect(const PairAhead& ahead, const SpeculativeMotion& met, ContactArray& out)
    {
        pair_.count = 0;
        if (out.count == 0) return;
        const Pose met1 = ahead.first_after(met), met2 = ahead.second_after(met);
        for (int i = 0; i < out.count; ++i) ahead.move_to_surface(*out.at(i), met);
        if (!knows_corners()) ahead.add_far(met1, met2, out);
        take(out, met1, met2, {}, Anchors::kOnSurfaces);
        if (rounds_on_what_stands(pair_))
            for (CachedManifold& part : parts_.first(pair_.count)) look_back(part, ahead, met);
    }

    // Balls on joints keep arms to one point: joints balance the blow where the bodies are as the step begins.
    bool are_loose_balls() const
    {
        const auto is_ball = [](const Geom& g) { return g.type->number == dSphereClass; };
        const auto is_loose = [](const Body* b) { return moves(b) && !b->lasting; };
        return is_ball(g1_) && is_ball(g2_) && is_loose(pair_.body1) && is_loose(pair_.body2);
    }

    // Of two balls that move the contact is that of the instant s in which they meet, |d + s way| = R: its normal, and arms along it, so
    // that a blow without friction gives them no spin. Where the step would leave them, one deep in the other, is another direction.
    void meet(const Pose& soon1, const Pose& soon2)
    {
        dContactGeom found;
        ContactArray out{&found, int(sizeof found), 1, false};
        const Vec3 d = pose1_.p - pose2_.p, way = soon1.p - soon2.p - d;
        const Real r1 = solid_view(g1_, pose1_).radius, r2 = solid_view(g2_, pose2_).radius, R = r1 + r2;
        const Real a = length2(way), b = dot(d, way), discriminant = b * b - a * (length2(d) - R * R);
        if (!(b < 0) || !(discriminant >= 0)) return;
        const Real s = (-b - std::sqrt(discriminant)) / a;
        if (!(s <= 1)) return;
        const Vec3 n = (1 / R) * (d + s * way);
        store(found.normal, n), store(found.pos, pose1_.p + s * (soon1.p - pose1_.p) - r1 * n);
        found.depth = 0, found.g1 = found.g2 = nullptr, found.side1 = found.side2 = -1;
        out.count = 1;
        take(out, at_instant(pose1_, soon1, s), at_instant(pose2_, soon2, s), {}, Anchors::kOnSurfaces);
        ManifoldPoint& point = parts_[0].manifold.points[0];
        point.r1 = narrow(pose1_.p - x1_ - r1 * n), point.r2 = narrow(pose2_.p - x2_ + r2 * n);
        point.separation = float(layer() - s * dot(n, way));
    }

    // Nobody looks at how the balls are turned then.
    static Pose at_instant(const Pose& now, const Pose& soon, Real s)
    {
        return {now.p + s * (soon.p - now.p), now.R};
    }

    // Points of round solids on what stands, found at the end of the way, seen from now. Solvers let a gap
    // change by n . (v + w x r), as if points moved straight on: r is therefore the arm where the two meet,
    // and the gap the one that so becomes what was found. (Fixed in the body, the lowest point of a ball that
    // rolls a millimetre above the ground is in front now, comes down, and throws it up. Corners of polyhedra
    // are fixed.)
    void look_back(CachedManifold& part, const PairAhead& ahead, const SpeculativeMotion& met) const
    {
        const Pose met1 = ahead.first_after(met), met2 = ahead.second_after(met);
        const Vec3 n = widen(part.manifold.normal);
        for (int i = 0; i < part.manifold.count; ++i) {
            ManifoldPoint& point = part.manifold.points[i];
            const Vec3 at1 = met1.p + met1.R * widen(part.found.anchors.first(i)),
                       at2 = second_frame(met2).to_world(widen(part.found.anchors.second(i)));
            const Vec3 at = ahead.straight_back(at1, at2, met);
            point.r1 = narrow(at - x1_);
            point.r2 = narrow(pair_.body2 ? at - x2_ : Vec3{});
            point.separation = float(dot(n, at1 - at2) + layer() - dot(n, ahead.approach(at, met)));
        }
    }

    // Whether a point has a negative separation: at the end of the step that part of the pair would be inside the other
    // geom and touch it from behind.
    static bool passed(const CachedManifold& part)
    {
        const auto points = std::span(part.manifold.points).first(std::size_t(part.manifold.count));
        return std::any_of(points.begin(), points.end(),
                           [](const ManifoldPoint& p) { return p.separation < 0; });
    }
    bool has_passed() const { return std::any_of(parts_.begin(), parts_.begin() + pair_.count, passed); }
    void drop_passed()
    {
        const auto end = std::remove_if(parts_.begin(), parts_.begin() + pair_.count, passed);
        pair_.count = std::uint8_t(end - parts_.begin());
    }

    // In which anchors of g2 lie where it is at `pose`.
    const Pose& second_frame(const Pose& pose) const { return pair_.body2 ? pose : frame2_; }

    // By the materials of the faces that it touches.
    int kind_of(const dContactGeom& c) const
    {
        if (!has_face_materials(g1_) && !has_face_materials(g2_)) return 0;
        const Vec3 at = load(c.pos), n = load(c.normal);
        return material_number_at(g1_, at, n) + (kMostFaceMaterials + 1) * material_number_at(g2_, at, n);
    }

    // The contacts of the two at A and B.
    void take(const ContactArray& out, const Pose& A, const Pose& B, std::span<const CachedManifold> old,
              Anchors how)
    {
        ManifoldMaker maker(parts_);
        for (int i = 0; i < out.count; ++i)
            if (sound(*out.at(i))) maker.add(*out.at(i), kind_of(*out.at(i)));
        maker.finish();
        pair_.count = std::uint8_t(maker.used());
        for (int part = 0; part < pair_.count; ++part) settle(part, maker, A, B, old, how);
    }

    // Polyhedra touch at corners and where edges cross, and all of these nearby can be told at once. Round
    // solids gain little by it: half a millimetre of depth in the mean of a pile of all kinds. Functions of
    // the program may mean anything.
    bool knows_corners() const { return looks_ahead() && !is_round(g1_) && !is_round(g2_); }
    bool looks_ahead() const { return settings_.foresees && pair_.max_manifolds == 1 && !pair_.asked; }

    // Corners within this distance are contacts although they do not touch yet. It covers the motion until the pair is
    // collided again. A fast pair gets twice its motion: a body that lands on one corner turns about it, and the opposite
    // corner comes down at twice the speed or more.
    Real margin() const
    {
        if (!looks_ahead()) return 0;
        const Real size = this->size();
        const Real way = PairAhead(pair_, {g1_, pose1_}, {g2_, pose2_}, settings_.soon, size).way();
        return way > kSwift * size ? std::min(2 * way, kNear * size) : kReuse * size;
    }

    // Anchors, and impulses from the points that were near.
    void settle(int index, const ManifoldMaker& maker, const Pose& A, const Pose& B,
                std::span<const CachedManifold> old, Anchors how)
    {
        CachedManifold& part = parts_[std::size_t(index)];
        ManifoldFinding& found = part.found;
        ContactManifold& manifold = part.manifold;
        found.changes = changes();
        found.offset = narrow(offset_);
        for (int k = 0; k < 3; ++k) found.turn[k] = narrow(turn_.row(k));
        found.normal = narrow(transposed_times(pose1_.R, widen(manifold.normal)));
        manifold.rolling_impulse = {}, manifold.struck = false;
        manifold.at_border = maker.at_border(index);
        for (int i = 0; i < manifold.count; ++i)
            manifold.points[i].normal_impulse = 0, manifold.points[i].friction_impulse = {};
        fix_points(maker, index, A, second_frame(B), how, found.anchors);
        place(part, part);
        if (how == Anchors::kTogether) place_found(maker, index, x1_, pair_.body2 ? &x2_ : nullptr, manifold);
        const Real size = this->size();
        for (const CachedManifold& was : old) inherit_impulses(was, size, part);
    }

    ContactPair& pair_;
    Geom &g1_, &g2_;
    const std::span<CachedManifold> parts_;
    const NarrowSettings& settings_;
    NearLeaves* const leaves_;
    const Pose pose1_, pose2_;
    const Vec3 x1_, x2_;
    mutable Real size_ = -1, layer_ = -1;  // not known yet
    bool apart_ = false;                   // at present, as has been proved
    Pose frame2_;                          // of g2's anchors now
    Vec3 offset_;                          // of that in g1's frame
    Mat3 turn_;
};

}  // namespace

void update_pair(ContactPair& pair, std::span<const CachedManifold> old, const NarrowSettings& settings,
                 CachedManifold* into, NearLeaves* leaves)
{
    PairUpdate(pair, settings, into, leaves).run(old);
}

void place_again(const ContactPair& pair, CachedManifold& kept)
{
    Geom *g1 = from_handle<Geom>(pair.id1), *g2 = from_handle<Geom>(pair.id2);
    const Body* const body1 = g1 ? body_of(*g1) : nullptr;
    if (!body1 || !g2) return;
    const Body* const body2 = body_of(*g2);
    float separation[kManifoldPoints];
    for (int i = 0; i < kManifoldPoints; ++i) separation[i] = kept.manifold.points[i].separation;
    kept.origin = body1->position();
    const Vec3 x2 = body2 ? body2->position() : Vec3{};
    const Pose frame2 = frame_of_anchors(pose_of(*g2), kept.origin, !body2);
    (void)place_points(pose_of(*g1), frame2, kept.origin, body2 ? &x2 : nullptr, 0, kept, kept.manifold);
    combine_materials(*g1, *g2, kept.origin, kept.manifold);
    for (int i = 0; i < kManifoldPoints; ++i) kept.manifold.points[i].separation = separation[i];
}

}  // namespace epode
