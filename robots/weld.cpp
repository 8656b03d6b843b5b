// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See weld.h. One pass in the order of the tree: `into` is the link that an old one becomes part of, `where` its
// pose there. What is fixed to the world becomes part of link 0, which has shapes and no mass.
#include "robots/weld.h"
#include "robots/inertia.h"

namespace epode::robots {

namespace {

struct Merged {
    int link = 0;
    Pose pose;
};

void merge(const Link& from, const Pose& pose, Link& into)
{
    const auto take = [&](Shape shape, std::vector<Shape>& all) {
        if (shape.body.empty()) shape.body = from.name;
        shape.pose = pose * shape.pose, all.push_back(std::move(shape));
    };
    for (const Shape& shape : from.shapes) take(shape, into.shapes);
    for (const Shape& visual : from.visuals) take(visual, into.visuals);
    if (into.parent < 0) return;
    for (Lift lift : from.lifts) lift.centre = pose * lift.centre, into.lifts.push_back(lift);
    for (FluidBox box : from.boxes) box.pose = pose * box.pose, into.boxes.push_back(box);
    if (from.mass > into.mass) into.is_weightless = from.is_weightless;
    const Inertia sum =
        sum_of({into.mass, into.centre, into.inertia}, moved({from.mass, from.centre, from.inertia}, pose));
    into.mass = sum.mass, into.centre = sum.centre, into.inertia = sum.tensor;
    into.has_inertial = into.has_inertial || from.has_inertial;
}

// Whether it stands still: neither it nor what carries it has joints or is moved by the program.
bool stands(const RobotModel& model, int link)
{
    for (; link > 0; link = model.links[size_t(link)].parent)
        if (!model.links[size_t(link)].joints.empty() || model.links[size_t(link)].is_mocap) return false;
    return true;
}

// Exclusions of what becomes part of the world's link, which touches all others: its shapes remember whose they are.
void set_still_apart(RobotModel& model)
{
    std::vector<int> number(model.links.size(), 0);
    const auto number_of = [&](int link) {
        if (number[size_t(link)] > 0) return number[size_t(link)];
        model.still.push_back(model.links[size_t(link)].name);
        for (Shape& shape : model.links[size_t(link)].shapes) shape.still = int(model.still.size());
        return number[size_t(link)] = int(model.still.size());
    };
    std::erase_if(model.excluded, [&](const std::array<int, 2>& pair) {
        const bool first = stands(model, pair[0]), second = stands(model, pair[1]);
        if (first && !second) model.excluded_still.push_back({pair[1], number_of(pair[0])});
        if (second && !first) model.excluded_still.push_back({pair[0], number_of(pair[1])});
        return first || second;
    });
}

}  // namespace

void merge_fixed_links(RobotModel& model)
{
    set_still_apart(model);
    std::vector<Link> kept;
    std::vector<Merged> place(model.links.size());
    for (size_t i = 0; i < model.links.size(); ++i) {
        Link& link = model.links[i];
        const Merged parent = link.parent < 0 ? Merged{} : place[size_t(link.parent)];
        const Pose pose = parent.pose * link.pose;
        if (i > 0 && link.joints.empty() && !link.is_mocap) {
            place[i] = {parent.link, pose};
            const Link& into = kept[size_t(parent.link)];
            if (into.mass > 0 && link.mass > 0 && into.is_weightless != link.is_weightless)
                model.report.push_back(
                    {Note::kApproximated, model.path, link.line,
                     "'" + link.name + "' merges with a link of other gravity: the heavier's counts"});
            merge(link, pose, kept[size_t(parent.link)]);
            model.frames.push_back({link.name, int(i), {}});
            continue;
        }
        place[i] = {int(kept.size()), {}};
        if (i > 0) link.parent = parent.link, link.pose = pose;
        kept.push_back(std::move(link));
    }
    model.links = std::move(kept);
    const auto move = [&](Frame& frame) {
        const Merged& its = place[size_t(frame.link)];
        frame.pose = its.pose * frame.pose, frame.link = its.link;
    };
    for (Frame& frame : model.frames) move(frame);
    for (Camera& camera : model.cameras) move(camera.frame);
    for (Joint& joint : model.joints) joint.link = place[size_t(joint.link)].link;
    for (Closure& closure : model.closures) {
        const Merged &a = place[size_t(closure.link1)], &b = place[size_t(closure.link2)];
        closure.pose1 = a.pose * closure.pose1, closure.link1 = a.link;
        closure.pose2 = b.pose * closure.pose2, closure.link2 = b.link;
    }
    for (Tendon& tendon : model.tendons)
        for (PathPart& part : tendon.path) {
            const Merged& its = place[size_t(part.link)];
            part.pose = its.pose * part.pose, part.link = its.link;
            if (part.side_link < 0) continue;
            const Merged& sides = place[size_t(part.side_link)];
            part.side = sides.pose * part.side, part.side_link = sides.link;
        }
    for (Actuator& actuator : model.actuators) {
        SiteWrench& its = actuator.wrench;
        const auto put = [&](int& link, Pose& pose) {
            if (link >= 0) pose = place[size_t(link)].pose * pose, link = place[size_t(link)].link;
        };
        put(its.link, its.pose), put(its.reference_link, its.reference);
        if (actuator.adhesive_link >= 0) actuator.adhesive_link = place[size_t(actuator.adhesive_link)].link;
    }
    for (auto& pair : model.excluded)
        for (int& link : pair) link = place[size_t(link)].link;
    for (auto& pair : model.excluded_still) pair[0] = place[size_t(pair[0])].link;
}

}  // namespace epode::robots
