// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Tendons: see mjcf.h.
#include <algorithm>

#include "robots/read/mjcf.h"

namespace epode::robots {

namespace {

// Whether sites and surfaces follow each other as a path can: two sites or more from pulley to pulley, each surface between two sites.
bool is_whole(const std::vector<PathPart>& path)
{
    using Kind = PathPart::Kind;
    int sites = 0;
    bool after_site = false, good = !path.empty();
    for (const PathPart& part : path) {
        const bool is_site = part.kind == Kind::kSite, is_pulley = part.kind == Kind::kPulley;
        good = good && (is_site || after_site || (is_pulley && sites == 0));
        if (is_pulley) good = good && sites != 1;
        sites = is_pulley ? 0 : sites + is_site;
        after_site = is_site;
    }
    return good && after_site && sites >= 2;
}

}  // namespace

void Mjcf::read_terms(const Element& element, Tendon& tendon)
{
    for (const Element& joint : element.children("joint")) {
        Coupling::Term term{model_.joint_named(joint.text("joint")), 0};
        reading_.number(joint, "coef", term.factor);
        if (term.joint < 0 || !model_.joints[size_t(term.joint)].is_scalar())
            reading_.error(joint, "the tendon '" + tendon.name + "' names '" + joint.text("joint") +
                                      "', which is no hinge or slider");
        else if (std::any_of(tendon.terms.begin(), tendon.terms.end(),
                             [&](const Coupling::Term& other) { return other.joint == term.joint; }))
            reading_.error(joint,
                           "the tendon '" + tendon.name + "' names '" + joint.text("joint") + "' twice");
        else
            tendon.terms.push_back(term);
    }
    if (element.children("joint").empty())
        reading_.error(element, "the tendon '" + tendon.name + "' names no joint");
}

// False and an error of what no tendon can go round.
bool Mjcf::read_surface(const Element& element, PathPart& part)
{
    const Shape* const shape = model_.any_shape_named(element.text("geom"), part.link);
    if (!shape || (shape->kind != ShapeKind::kSphere && shape->kind != ShapeKind::kCylinder))
        return reading_.error(element, "'" + element.text("geom") + "' is no sphere or cylinder"), false;
    part.kind = shape->kind == ShapeKind::kSphere ? PathPart::Kind::kSphere : PathPart::Kind::kCylinder;
    part.pose = shape->pose, part.radius = shape->size.x;
    if (!element.has("sidesite")) return true;
    const Frame* const side = site_named(element.text("sidesite"));
    if (!side) return reading_.error(element, "there is no site '" + element.text("sidesite") + "'"), false;
    part.side_link = side->link, part.side = side->pose.p;
    return true;
}

void Mjcf::read_path(const Element& element, Tendon& tendon)
{
    for (const Element& child : element.children()) {
        PathPart part;
        if (child.name() == "site") {
            const Frame* const site = site_named(child.text("site"));
            if (!site) return reading_.error(child, "there is no site '" + child.text("site") + "'");
            part.link = site->link, part.pose = site->pose;
        } else if (child.name() == "geom") {
            if (!read_surface(child, part)) return;
        } else if (child.name() == "pulley") {
            part.kind = PathPart::Kind::kPulley;
            reading_.number(child, "divisor", part.divisor);
            if (!(part.divisor > 0)) return reading_.error(child, "a pulley's divisor is above 0");
        } else {
            reading_.note(Note::kIgnored, child, "<" + child.name() + "> in a tendon");
            continue;
        }
        tendon.path.push_back(part);
    }
    if (!is_whole(tendon.path))
        return reading_.error(element,
                              "the tendon '" + tendon.name +
                                  "' has less than two sites from pulley to pulley, or a geom that is "
                                  "not between two sites");
    reading_.note_once(Note::kChanged, element,
                       "spatial tendons act where dRobotAddForces is called before a step");
}

// What all kinds have.
void Mjcf::read_tendon(const Attributes& a, Tendon& tendon)
{
    const Element& element = a.element();
    std::vector<double> range;
    if (is_limited(a, "limited", "range") && list(a, "range", 2, 2, range))
        tendon.low = range[0], tendon.high = range[1];
    if (tendon.low > tendon.high)
        reading_.error(element, "the tendon '" + tendon.name + "' has a range that ends before it begins");
    if (list(a, "springlength", 1, 2, range) && range[0] != -1) {
        tendon.has_rest = true, tendon.rest = range.front(), tendon.rest_high = range.back();
        if (tendon.path.empty() && range.front() != range.back()) {
            tendon.rest = tendon.rest_high = (range.front() + range.back()) / 2;
            reading_.note(Note::kApproximated, element, "a tendon's range of rest is its middle");
        }
    }
    coefficient(a, "stiffness", tendon.stiffness), coefficient(a, "damping", tendon.damping);
    number(a, "frictionloss", tendon.friction), number(a, "armature", tendon.armature);
    if (tendon.friction < 0 || tendon.armature < 0)
        reading_.error(element, "the tendon '" + tendon.name + "' has a negative frictionloss or armature");
    double value = 0;
    if (number(a, "margin", value) && value != 0)
        reading_.note_once(Note::kApproximated, element, "tendon margin");
    for (const char* name : {"solreflimit", "solimplimit", "solreffriction", "solimpfriction"})
        if (a.has(name)) reading_.note_once(Note::kApproximated, element, std::string("tendon ") + name);
}

void Mjcf::read_tendons(const Element& section)
{
    for (const Element& element : expand(section)) {
        const Attributes a = defaults_.of(element, "", reading_);
        const bool is_fixed = element.name() == "fixed";
        if (!is_fixed && element.name() != "spatial") {
            reading_.note(Note::kIgnored, element, "a tendon of kind <" + element.name() + ">");
            continue;
        }
        Tendon tendon;
        tendon.name = element.text("name"), tendon.line = element.line();
        is_fixed ? read_terms(element, tendon) : read_path(element, tendon);
        read_tendon(a, tendon);
        model_.tendons.push_back(std::move(tendon));
    }
}

}  // namespace epode::robots
