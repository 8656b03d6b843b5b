// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See tendon.h.
#include "robots/tendon.h"

#include <numeric>

#include "robots/kinematics.h"
#include "robots/mass_factor.h"
#include "robots/wrap.h"

namespace epode::robots {

namespace {

struct End {
    int link = 0;
    Vec p;
};

class PathMaker {
  public:
    explicit PathMaker(const std::vector<Pose>& poses) : poses_(poses) {}
    Path make(const std::vector<PathPart>& parts)
    {
        for (const PathPart& part : parts) {
            if (part.kind == PathPart::Kind::kPulley)
                last_ = nullptr, around_ = nullptr, divisor_ = part.divisor;
            else if (part.kind == PathPart::Kind::kSite)
                reach(part);
            else
                around_ = &part;
        }
        return std::move(path_);
    }

  private:
    void reach(const PathPart& site)
    {
        const End here{site.link, poses_[size_t(site.link)] * site.pose.p};
        if (last_ && around_)
            go_round(*around_, end_, here);
        else if (last_)
            go_straight(end_, here);
        last_ = &site, around_ = nullptr, end_ = here;
    }
    void go_straight(const End& from, const End& to)
    {
        const Vec way = to.p - from.p;
        const double size = length(way);
        const Vec direction = size > 1e-12 ? (1 / (size * divisor_)) * way : Vec{};
        path_.length += size / divisor_;
        path_.pieces.push_back({from.link, to.link, from.p, to.p, direction});
    }
    void go_round(const PathPart& part, const End& from, const End& to)
    {
        const Pose at = poses_[size_t(part.link)] * part.pose, back = inverse(at);
        Surface surface{part.kind == PathPart::Kind::kCylinder, part.radius, part.side_link >= 0, {}};
        if (surface.has_side) surface.side = back * (poses_[size_t(part.side_link)] * part.side);
        const Wrap wrap = wrap_around(surface, back * from.p, back * to.p);
        if (!wrap.touches) return go_straight(from, to);
        go_straight(from, {part.link, at * wrap.first});
        go_straight({part.link, at * wrap.last}, to);
        path_.length += wrap.length / divisor_;
    }

    const std::vector<Pose>& poses_;
    Path path_;
    const PathPart *last_ = nullptr, *around_ = nullptr;
    End end_;
    double divisor_ = 1;
};

std::vector<double> moments_of(const RobotModel& model, const Tendon& tendon, const PointForces& forces)
{
    if (!tendon.path.empty()) return forces.along_velocities();
    std::vector<double> out(size_t(number_of_velocities(model)), 0);
    for (const Coupling::Term& term : tendon.terms)
        out[size_t(velocity_of(model, term.joint))] += term.factor;
    return out;
}

// A unit of force along the length of each path.
void load(const Tendon& tendon, const std::vector<Pose>& poses, PointForces& forces)
{
    for (const Piece& piece : path_of(tendon, poses).pieces) {
        forces.add(piece.link1, piece.p1, -piece.direction);
        forces.add(piece.link2, piece.p2, piece.direction);
    }
}

}  // namespace

Path path_of(const Tendon& tendon, const std::vector<Pose>& poses)
{
    return PathMaker(poses).make(tendon.path);
}

std::vector<double> tendon_lengths(const RobotModel& model, const std::vector<double>& positions)
{
    const std::vector<Pose> poses = forward_kinematics(model, positions);
    std::vector<double> out;
    for (const Tendon& tendon : model.tendons) {
        double sum = 0;
        for (const Coupling::Term& term : tendon.terms)
            sum += term.factor * positions[size_t(model.joints[size_t(term.joint)].position)];
        out.push_back(tendon.path.empty() ? sum : path_of(tendon, poses).length);
    }
    return out;
}

std::vector<double> tendon_moments(const RobotModel& model, const std::vector<double>& positions,
                                   std::span<const int> tendons)
{
    PointForces forces(model, positions);
    std::vector<double> out;
    for (int number : tendons) {
        const Tendon& tendon = model.tendons[size_t(number)];
        forces.clear();
        load(tendon, forces.poses(), forces);
        const std::vector<double> row = moments_of(model, tendon, forces);
        out.insert(out.end(), row.begin(), row.end());
    }
    return out;
}

std::vector<double> tendon_jacobian(const RobotModel& model, const std::vector<double>& positions)
{
    std::vector<int> all(model.tendons.size());
    std::iota(all.begin(), all.end(), 0);
    return tendon_moments(model, positions, all);
}

}  // namespace epode::robots
