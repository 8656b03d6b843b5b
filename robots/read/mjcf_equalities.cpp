// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Equalities: see mjcf.h.
#include "robots/read/mjcf.h"
#include "robots/tendon.h"

namespace epode::robots {

void Mjcf::read_closure(const Attributes& a, bool weld)
{
    const Element& element = a.element();
    Closure closure;
    const bool has_sites = element.has("site1") && element.has("site2");
    const bool has_body = element.has("body1") && (weld || a.has("anchor"));
    if (!has_sites && !has_body)
        return reading_.error(element, std::string("<") + element.name() +
                                           "> wants site1 and site2, or body1" + (weld ? "" : " and anchor"));
    closure.weld = weld, closure.name = element.text("name"), closure.line = element.line();
    if (element.has("site1") ? join_sites(element, closure) : join_bodies(a, closure))
        model_.closures.push_back(closure);
}

bool Mjcf::join_sites(const Element& element, Closure& closure)
{
    const Frame *one = site_named(element.text("site1")), *two = site_named(element.text("site2"));
    if (!one || !two) return reading_.error(element, "an equality of sites that are not there"), false;
    closure.link1 = one->link, closure.pose1 = one->pose;
    closure.link2 = two->link, closure.pose2 = two->pose;
    return true;
}

// The anchor is a point of body 1; what body 2 has there at the reference position stays there.
bool Mjcf::join_bodies(const Attributes& a, Closure& closure)
{
    const Element& element = a.element();
    closure.link1 = model_.link_named(element.text("body1"));
    closure.link2 = element.has("body2") ? model_.link_named(element.text("body2")) : 0;
    if (closure.link1 < 0 || closure.link2 < 0)
        return reading_.error(element, "an equality of the bodies '" + element.text("body1") + "' and '" +
                                           element.text("body2") + "'; one is not there"),
               false;
    const std::vector<Pose> poses = forward_kinematics(model_, reference_positions(model_));
    const Pose &one = poses[size_t(closure.link1)], &two = poses[size_t(closure.link2)];
    std::vector<double> p;
    if (!closure.weld) {
        vec(a, "anchor", closure.pose1.p);
        closure.pose2 = inverse(two) * (one * closure.pose1);
    } else if (list(a, "relpose", 7, 7, p) && (p[3] != 0 || p[4] != 0 || p[5] != 0 || p[6] != 0)) {
        closure.pose1 = {{p[0], p[1], p[2]}, normalised({p[3], p[4], p[5], p[6]})};
    } else {
        closure.pose1 = inverse(one) * two;
    }
    return true;
}

// An equality's polynomial.
bool Mjcf::read_curve(const Attributes& a, std::array<double, 5>& curve)
{
    std::vector<double> c;
    if (a.has("polycoef") && !list(a, "polycoef", 1, 5, c)) return false;
    curve = {0, 1, 0, 0, 0};
    std::copy(c.begin(), c.end(), curve.begin());
    return true;
}

// The first two coefficients of an equality's polynomial; those beyond go to the coupling, with a note. False where it is
// broken.
bool Mjcf::read_line(const Attributes& a, std::array<double, 2>& line, Coupling& coupling)
{
    std::array<double, 5> c{};
    if (!read_curve(a, c)) return false;
    line = {c[0], c[1]};
    if (c[2] == 0 && c[3] == 0 && c[4] == 0) return true;
    coupling.polynomial.assign(c.begin() + 2, c.end());
    reading_.note_once(
        Note::kChanged, a.element(),
        "equalities of joints that are no straight lines are followed where dRobotAddForces is "
        "called before a step");
    return true;
}

// q1 - r1 = c0 + c1 (q2 - r2) + c2 (q2 - r2)^2 + ..., with the references r; without a second joint q1 - r1 = c0.
void Mjcf::read_joint_equality(const Attributes& a)
{
    const Element& element = a.element();
    const int follower = model_.joint_named(element.text("joint1"));
    const int leader = element.has("joint2") ? model_.joint_named(element.text("joint2")) : -1;
    const auto is_axis = [&](int joint) { return joint >= 0 && model_.joints[size_t(joint)].is_scalar(); };
    if (!is_axis(follower) || (element.has("joint2") && !is_axis(leader)))
        return reading_.error(element, "an equality of the joints '" + element.text("joint1") + "' and '" +
                                           element.text("joint2") + "'; one is no hinge or slider");
    Coupling coupling;
    std::array<double, 2> c{};
    if (!read_line(a, c, coupling)) return;
    coupling.name = element.text("name"), coupling.line = element.line();
    coupling.terms = {{follower, 1}};
    coupling.offset = c[0] + model_.joints[size_t(follower)].reference;
    if (leader >= 0) {
        coupling.terms.push_back({leader, -c[1]});
        coupling.offset -= c[1] * model_.joints[size_t(leader)].reference;
    } else {
        coupling.polynomial.clear();
    }
    model_.couplings.push_back(coupling);
}

// The same of two fixed tendons, whose lengths are sums of coordinates.
void Mjcf::read_tendon_equality(const Attributes& a)
{
    const Element& element = a.element();
    const int one = model_.tendon_named(element.text("tendon1"));
    const int two = element.has("tendon2") ? model_.tendon_named(element.text("tendon2")) : -1;
    const auto is_path = [&](int i) { return i >= 0 && !model_.tendons[size_t(i)].path.empty(); };
    if (one < 0 || (element.has("tendon2") && two < 0))
        return reading_.note(Note::kIgnored, element, "an equality of tendons that are not read");
    if (is_path(one) || is_path(two)) return read_tie(a, one, two);
    Coupling coupling;
    std::array<double, 2> c{};
    if (!read_line(a, c, coupling)) return;
    coupling.name = element.text("name"), coupling.line = element.line(), coupling.offset = c[0];
    const auto add = [&](int tendon, double factor) {
        for (const Coupling::Term& term : model_.tendons[size_t(tendon)].terms) {
            coupling.terms.push_back({term.joint, factor * term.factor});
            coupling.offset += factor * term.factor * model_.joints[size_t(term.joint)].reference;
        }
    };
    add(one, 1);
    if (two >= 0) add(two, -c[1]);
    coupling.tendons = {one, two}, coupling.ratio = c[1];
    model_.couplings.push_back(coupling);
}

void Mjcf::read_tie(const Attributes& a, int one, int two)
{
    Tie tie;
    if (!read_curve(a, tie.curve)) return;
    tie.name = a.element().text("name"), tie.line = a.element().line();
    tie.tendon1 = one, tie.tendon2 = two;
    const std::vector<double> lengths = tendon_lengths(model_, reference_positions(model_));
    tie.rest1 = lengths[size_t(one)], tie.rest2 = two < 0 ? 0 : lengths[size_t(two)];
    model_.ties.push_back(tie);
    reading_.note_once(Note::kChanged, a.element(),
                       "equalities of spatial tendons act where dRobotAddForces is called before a step");
}

// Whether it names one thing twice, which is equal to itself.
bool Mjcf::names_one_twice(const Element& element)
{
    for (const auto& [one, two] :
         {std::pair{"joint1", "joint2"}, {"tendon1", "tendon2"}, {"body1", "body2"}, {"site1", "site2"}})
        if (element.has(one) && element.text(one) == element.text(two))
            return reading_.error(element,
                                  "<" + element.name() + "> of '" + element.text(one) + "' and itself"),
                   true;
    return false;
}

void Mjcf::read_equalities(const Element& section)
{
    for (const Element& element : expand(section)) {
        if (names_one_twice(element)) continue;
        const Attributes a = defaults_.of(element, "", reading_);
        const std::string kind = element.name();
        if (a.text("active") == "false")
            reading_.note(Note::kIgnored, element, "an equality that is not active");
        else if (kind == "connect" || kind == "weld")
            read_closure(a, kind == "weld");
        else if (kind == "joint")
            read_joint_equality(a);
        else if (kind == "tendon")
            read_tendon_equality(a);
        else
            reading_.note(Note::kIgnored, element, "an equality of kind <" + kind + ">");
    }
}

}  // namespace epode::robots
