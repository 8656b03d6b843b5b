// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Actuators, contacts and keys: see mjcf.h.
#include <algorithm>

#include "robots/kinematics.h"
#include "robots/pairs.h"
#include "robots/read/mjcf.h"
#include "robots/tendon.h"
#include "robots/wrench.h"

namespace epode::robots {

bool Mjcf::find_target(const Attributes& a, Actuator& actuator)
{
    std::string joint = a.element().text("joint");
    if (joint.empty()) joint = a.element().text("jointinparent");
    const std::string tendon = a.element().text("tendon");
    if (a.element().has("site")) return find_site(a, actuator);
    if (a.element().has("cranksite")) return find_crank(a, actuator);
    if (a.element().has("body")) return find_body(a, actuator);
    if (joint.empty() && tendon.empty()) {
        reading_.error(a.element(), "actuator '" + actuator.name +
                                        "' names nothing to act on: a joint, tendon, site or body");
        return false;
    }
    actuator.joint = joint.empty() ? -1 : model_.joint_named(joint);
    actuator.tendon = tendon.empty() ? -1 : model_.tendon_named(tendon);
    if (!joint.empty() && actuator.joint < 0) {
        reading_.error(a.element(), "there is no joint '" + joint + "'");
        return false;
    }
    if (!tendon.empty() && actuator.tendon < 0) {
        reading_.note(Note::kIgnored, a.element(),
                      "actuator '" + actuator.name + "' of the tendon '" + tendon + "', which is not read");
        return false;
    }
    if (actuator.joint < 0 || model_.joints[size_t(actuator.joint)].is_scalar()) return true;
    return find_direction(a, actuator);
}

// A rod from the crank to a slide along z of the slider.
bool Mjcf::find_crank(const Attributes& a, Actuator& actuator)
{
    const Element& element = a.element();
    for (const char* name : {"cranksite", "slidersite"})
        if (!site_named(element.text(name)))
            return reading_.error(element, std::string("the ") + name + " '" + element.text(name) +
                                               "' of a slider-crank is not there"),
                   false;
    const Frame crank = *site_named(element.text("cranksite")),
                slider = *site_named(element.text("slidersite"));
    double gear = 1, rod = 0;
    std::vector<double> values;
    if (list(a, "gear", 1, 6, values)) gear = values[0];
    if (!number(a, "cranklength", rod) || !(rod > 0))
        return reading_.error(element, "a slider-crank has no cranklength above 0"), false;
    actuator.wrench = {crank.link, crank.pose, slider.link, slider.pose, {gear, 0, 0}, {}, rod};
    note_wrench(element);
    return true;
}

void Mjcf::note_wrench(const Element& element)
{
    reading_.note_once(Note::kChanged, element,
                       "actuators of sites act where dRobotAddForces is called before a step");
}

bool Mjcf::find_site(const Attributes& a, Actuator& actuator)
{
    const Element& element = a.element();
    const Frame *const site = site_named(element.text("site")), *const reference =
                                                                    site_named(element.text("refsite"));
    for (const char* name : {"site", "refsite"})
        if (element.has(name) && !site_named(element.text(name)))
            return reading_.error(element, "there is no site '" + element.text(name) + "'"), false;
    std::vector<double> gear;
    list(a, "gear", 1, 6, gear);
    if (gear.empty()) gear = {1};
    gear.resize(6, 0);
    SiteWrench& wrench = actuator.wrench;
    wrench.link = site->link, wrench.pose = site->pose;
    if (reference) wrench.reference_link = reference->link, wrench.reference = reference->pose;
    wrench.force = {gear[0], gear[1], gear[2]}, wrench.torque = {gear[3], gear[4], gear[5]};
    note_wrench(element);
    return true;
}

bool Mjcf::find_body(const Attributes& a, Actuator& actuator)
{
    const std::string name = a.element().text("body");
    actuator.adhesive_link = model_.link_named(name);
    if (actuator.adhesive_link < 0)
        return reading_.error(a.element(), "there is no body '" + name + "'"), false;
    reading_.note_once(Note::kChanged, a.element(),
                       "adhesion acts where dRobotAddForces is called before a step, at the contacts of the "
                       "step before");
    return true;
}

// Of a ball's: the gear is along the link's axes. A servo along one of them alone is a drive's.
bool Mjcf::find_direction(const Attributes& a, Actuator& actuator)
{
    const bool is_ball = model_.joints[size_t(actuator.joint)].kind == JointKind::kBall;
    std::vector<double> gear;
    list(a, "gear", 1, 6, gear);
    gear.resize(3, 0);
    if (!a.has("gear")) gear[0] = 1;
    actuator.direction = {gear[0], gear[1], gear[2]};
    const bool is_aligned = (gear[0] != 0) + (gear[1] != 0) + (gear[2] != 0) == 1;
    if (is_ball && (actuator.kind == "motor" || is_aligned) && !a.element().has("jointinparent")) return true;
    reading_.note(Note::kIgnored, a.element(),
                  "actuator '" + actuator.name +
                      (is_ball ? "' of a ball, which is neither a motor nor along one of the link's axes"
                               : "' of a free joint"));
    return false;
}

void Mjcf::read_gains(const Attributes& a, Actuator& actuator)
{
    double kp = 1, kv = actuator.kind == "velocity" ? 1 : 0;
    if (actuator.kind == "general") {
        read_general_gains(a, actuator);
    } else if (actuator.kind == "cylinder") {
        read_cylinder(a, actuator);
    } else if (actuator.kind == "muscle") {
        read_muscle(a, actuator);
    } else if (actuator.kind == "adhesion") {
        number(a, "gain", actuator.gain);
        if (actuator.gain < 0 || !(actuator.low >= 0))
            reading_.error(a.element(), "the adhesion of '" + a.element().text("body") +
                                            "' has a gain below 0, or no ctrlrange from 0 or more");
    } else if (actuator.kind == "damper") {
        actuator.gain = 0;
        number(a, "kv", kv), actuator.gain_velocity = -(a.has("kv") ? kv : 1);
        if (actuator.gain_velocity > 0 || actuator.low < 0)
            reading_.error(a.element(), "the damper '" + actuator.name + "' has a negative kv or control");
    } else if (actuator.kind != "motor") {
        check_servo(a);
        number(a, "kp", kp), number(a, "kv", kv);
        const bool is_servo = actuator.kind != "velocity";
        actuator.bias_position = is_servo ? kp : 0, actuator.bias_velocity = kv;
        actuator.gain = is_servo ? kp : kv;
        double ratio = 0;
        if (is_servo && number(a, "dampratio", ratio) && ratio > 0 && kp > 0)
            actuator.bias_velocity = damping_of(actuator, ratio);
    }
    if (!actuator.muscle.acts) read_activation(a, actuator);
}

// What a servo has: one damping, and nothing below 0.
void Mjcf::check_servo(const Attributes& a)
{
    if (a.element().name() == "velocity") return;
    if (a.element().has("kv") && a.element().has("dampratio"))
        reading_.error(a.element(), "a servo with kv and dampratio: one of them");
    for (const char* name : {"kv", "dampratio", "timeconst"}) {
        double value = 0;
        if (number(a, name, value) && value < 0)
            reading_.error(a.element(), "<" + a.element().name() + "> " + name + " is below 0");
    }
}

// 2 z sqrt(kp m), with the mass m that the actuator feels through its gear at the reference position.
double Mjcf::damping_of(const Actuator& actuator, double ratio)
{
    if (!masses().is_good()) return 0;
    return 2 * ratio * std::sqrt(actuator.gain / masses().inverse_mass(moment_of(actuator).data()));
}

// What stands between control and force, as words to be written again (the kinds that are written as others need those) and, of
// filters and integrators, as what acts. An intvelocity's control is the speed of its position servo's target.
void Mjcf::read_activation(const Attributes& a, Actuator& actuator)
{
    std::vector<double> values;
    auto& out = actuator.activation;
    const std::string dynamics = actuator.kind == "intvelocity" ? "integrator" : a.text("dyntype");
    const bool says_it = actuator.kind == "general" || actuator.kind == "intvelocity";
    if (says_it && !dynamics.empty() && dynamics != "none") {
        out.push_back({"dyntype", dynamics});
        if (a.has("actearly")) out.push_back({"actearly", a.text("actearly")});
        if (a.has("actrange"))
            out.push_back({"actlimited", is_limited(a, "actlimited", "actrange") ? "true" : "false"});
        for (const char* name : {"dynprm", "actrange"})
            if (list(a, name, 1, 10, values)) out.push_back({name, a.text(name)});
    }
    double time = 0;
    if (actuator.kind == "position" && number(a, "timeconst", time) && time > 0)
        out = {{"dyntype", "filterexact"}, {"dynprm", a.text("timeconst")}};
    if (actuator.kind == "cylinder")
        out = {{"dyntype", "filter"}, {"dynprm", a.has("timeconst") ? a.text("timeconst") : "1"}};
    if (!out.empty()) read_filter(a, actuator);
}

void Mjcf::read_filter(const Attributes& a, Actuator& actuator)
{
    using Kind = Activation::Kind;
    static const std::map<std::string, Kind> kinds{
        {"integrator", Kind::kIntegrator}, {"filter", Kind::kFilter}, {"filterexact", Kind::kExactFilter}};
    const auto kind = kinds.find(actuator.activation[0][1]);
    if (kind == kinds.end())
        return reading_.note(Note::kApproximated, a.element(),
                             "actuator '" + actuator.name + "' acts without its filter");
    Activation& filter = actuator.filter;
    std::vector<double> values;
    filter.kind = kind->second;
    for (const auto& [name, text] : actuator.activation)
        if (name == "dynprm" && parse_numbers(text, values) && !values.empty()) filter.time = values[0];
    if (is_limited(a, "actlimited", "actrange") && list(a, "actrange", 2, 2, values))
        filter.low = values[0], filter.high = values[1];
    filter.is_early = a.text("actearly") == "true";
    if (filter.low > filter.high)
        return reading_.error(a.element(),
                              "actuator '" + actuator.name + "' has a range that ends before it begins");
    reading_.note_once(Note::kChanged, a.element(),
                       "filters of actuators act where dRobotAddForces is called before a step");
}

// A pneumatic one: the force is area times pressure, which the control approaches, plus a bias.
void Mjcf::read_cylinder(const Attributes& a, Actuator& actuator)
{
    std::vector<double> bias;
    double diameter = 0;
    number(a, "area", actuator.gain);
    if (number(a, "diameter", diameter) && diameter > 0) actuator.gain = kPi / 4 * diameter * diameter;
    if (list(a, "bias", 3, 3, bias))
        actuator.bias = bias[0], actuator.bias_position = -bias[1], actuator.bias_velocity = -bias[2];
}

void Mjcf::read_general_gains(const Attributes& a, Actuator& actuator)
{
    std::vector<double> values;
    if (list(a, "gainprm", 1, 10, values)) actuator.gain = values[0];
    if (list(a, "biasprm", 1, 10, values) && a.text("biastype") == "affine") {
        values.resize(3, 0);
        actuator.bias = values[0], actuator.bias_position = -values[1], actuator.bias_velocity = -values[2];
        if (values[2] > 0 && actuator.gain == -values[1] && actuator.gain > 0)  // a servo's damping ratio
            actuator.bias_velocity = damping_of(actuator, values[2]);
    }
    if (a.text("gaintype") == "muscle" && a.text("biastype") == "muscle") return read_muscle(a, actuator);
    for (const char* kind : {"gaintype", "biastype"}) {
        const std::string text = a.text(kind);
        if (!text.empty() && text != "fixed" && text != "none" && text != "affine")
            reading_.note(Note::kIgnored, a.element(), std::string(kind) + " " + text);
    }
    if (a.text("gaintype") != "affine" || !list(a, "gainprm", 1, 10, values)) return;
    values.resize(3, 0);
    actuator.gain_position = values[1], actuator.gain_velocity = values[2];
}

// Of a <muscle> by name, of a <general> in this order.
void Mjcf::read_muscle(const Attributes& a, Actuator& actuator)
{
    Muscle& m = actuator.muscle;
    double* const all[] = {&m.low,     &m.high,    &m.force,   &m.scale,    &m.shortest,
                           &m.longest, &m.fastest, &m.passive, &m.eccentric};
    std::vector<double> values;
    m.acts = true;
    if (actuator.kind == "general") {
        if (list(a, "gainprm", 1, 10, values))
            for (size_t i = 0; i < std::min(values.size(), std::size(all)); ++i) *all[i] = values[i];
    } else {
        if (list(a, "range", 2, 2, values)) m.low = values[0], m.high = values[1];
        const char* const names[] = {"force", "scale", "lmin", "lmax", "vmax", "fpmax", "fvmax"};
        for (size_t i = 0; i < std::size(names); ++i) number(a, names[i], *all[2 + i]);
    }
    Activation& filter = actuator.filter;
    filter.kind = Activation::Kind::kMuscle, filter.time = 0.01, filter.slower = 0.04;
    const char* const times = actuator.kind == "general" ? "dynprm" : "timeconst";
    if (list(a, times, 1, 10, values)) {
        filter.time = values[0];
        if (values.size() > 1) filter.slower = values[1];
        if (values.size() > 2) filter.smooth = values[2];
    }
    if (actuator.kind != "general") number(a, "tausmooth", filter.smooth);
    if (list(a, "lengthrange", 2, 2, values) && values[0] < values[1])
        m.length_low = values[0], m.length_high = values[1];
    else
        find_lengths(a, actuator);
    if (m.force < 0) m.force = m.scale / acceleration_of(actuator);
    const bool is_good = m.high > m.low && m.shortest < 1 && m.longest > 1 && m.fastest > 0 &&
                         m.eccentric > 1 && filter.time > 0 && filter.slower > 0 && std::isfinite(m.force);
    if (!is_good)
        reading_.error(a.element(), "actuator '" + actuator.name + "' is no muscle: its numbers do not fit");
    reading_.note_once(Note::kChanged, a.element(),
                       "muscles act where dRobotAddForces is called before a step");
}

// Where the file does not say between which lengths a muscle acts: MuJoCo looks for them, by pulling.
void Mjcf::find_lengths(const Attributes& a, Actuator& actuator)
{
    Muscle& m = actuator.muscle;
    const Joint* const joint = actuator.joint >= 0 ? &model_.joints[size_t(actuator.joint)] : nullptr;
    const Tendon* const tendon = actuator.tendon >= 0 ? &model_.tendons[size_t(actuator.tendon)] : nullptr;
    const double low = joint    ? joint->low
                       : tendon ? tendon->low
                                : -kInfinity,
                 high = joint    ? joint->high
                        : tendon ? tendon->high
                                 : kInfinity;
    if (!std::isfinite(low) || !std::isfinite(high) || low >= high)
        return reading_.error(a.element(),
                              "the muscle '" + actuator.name +
                                  "' says no lengthrange, and what it moves has no limits; MuJoCo "
                                  "finds one by simulation: state it");
    const auto [from, to] = std::minmax({actuator.gear * low, actuator.gear * high});
    m.length_low = from, m.length_high = to;
    reading_.note(Note::kApproximated, a.element(),
                  "the muscle '" + actuator.name + "' acts between the limits of what it moves");
}

// |M^-1 b|, of the accelerations that a force of 1 N on the actuator causes at the reference position.
double Mjcf::acceleration_of(const Actuator& actuator)
{
    if (!masses().is_good()) return 0;
    const std::vector<double> force = masses().halfway(moment_of(actuator).data());
    double sum = 0;
    for (size_t i = 0; i < masses().size(); ++i) {
        std::vector<double> unit(masses().size(), 0);
        unit[i] = 1;
        const std::vector<double> its = masses().halfway(unit.data());
        double part = 0;
        for (size_t k = 0; k < its.size(); ++k) part += its[k] * force[k];
        sum += part * part;
    }
    return std::sqrt(sum);
}

std::vector<double> Mjcf::moment_of(const Actuator& actuator)
{
    std::vector<double> moment(masses().size(), 0);
    if (actuator.wrench.link >= 0)
        return wrench_moments(model_, reference_positions(model_), actuator.wrench);
    if (actuator.joint >= 0)
        moment[size_t(velocity_of(model_, actuator.joint))] = 1;
    else
        moment = tendon_moments(model_, reference_positions(model_), std::array{actuator.tendon});
    for (double& one : moment) one *= actuator.gear;
    return moment;
}

void Mjcf::read_actuator(const Attributes& a)
{
    Actuator actuator;
    actuator.name = a.element().text("name"), actuator.kind = a.element().name(),
    actuator.line = a.element().line();
    const std::string& kind = actuator.kind;
    static const std::set<std::string> known{"motor",       "position", "velocity", "general", "cylinder",
                                             "intvelocity", "muscle",   "damper",   "adhesion"};
    if (!known.count(kind)) return reading_.note(Note::kIgnored, a.element(), "an actuator <" + kind + ">");
    if (!find_target(a, actuator)) return;
    std::vector<double> values;
    if (list(a, "gear", 1, 6, values)) actuator.gear = values[0];
    if (length(actuator.direction) > 0 || actuator.wrench.link >= 0 || actuator.adhesive_link >= 0)
        actuator.gear = 1;
    if (is_limited(a, "ctrllimited", "ctrlrange") && list(a, "ctrlrange", 2, 2, values))
        actuator.low = values[0], actuator.high = values[1];
    if (is_limited(a, "forcelimited", "forcerange") && list(a, "forcerange", 2, 2, values))
        actuator.force_low = values[0], actuator.force_high = values[1];
    read_gains(a, actuator);
    if (actuator.low > actuator.high || actuator.force_low > actuator.force_high)
        return reading_.error(a.element(),
                              "actuator '" + actuator.name + "' has a range that ends before it begins");
    double inherit = 0;  // of a class it counts for servos alone, and less than the element's own range
    const bool may_inherit =
        (actuator.kind == "position" || actuator.kind == "general") && !a.element().has("ctrlrange");
    if (may_inherit && number(a, "inheritrange", inherit) && inherit > 0 && actuator.joint >= 0) {
        const Joint& joint = model_.joints[size_t(actuator.joint)];
        const double middle = (joint.low + joint.high) / 2, half = (joint.high - joint.low) / 2;
        if (joint.limited) actuator.low = middle - inherit * half, actuator.high = middle + inherit * half;
    }
    model_.actuators.push_back(actuator);
}

void Mjcf::read_actuators(const Element& section)
{
    for (const Element& element : expand(section)) {
        ++actuators_;
        read_actuator(defaults_.of(element, "", reading_));
    }
}

// A geom that touches nothing by itself is no look any more.
bool Mjcf::find_touching(const Element& element, const char* attribute, int& link)
{
    const std::string name = element.text(attribute);
    if (shape_named(model_, name, link)) return true;
    for (link = 0; link < int(model_.links.size()); ++link) {
        Link& its = model_.links[size_t(link)];
        const auto found = std::find_if(its.visuals.begin(), its.visuals.end(), [&](const Shape& shape) {
            return !name.empty() && shape.name == name;
        });
        if (found == its.visuals.end()) continue;
        its.shapes.push_back(*found), its.visuals.erase(found);
        return true;
    }
    reading_.error(element, "a pair of the geoms '" + element.text("geom1") + "' and '" +
                                element.text("geom2") + "'; one is not there");
    return false;
}

void Mjcf::read_pair(const Attributes& a)
{
    const Element& element = a.element();
    ShapePair pair;
    pair.name = element.text("name"), pair.line = element.line();
    pair.shape1 = element.text("geom1"), pair.shape2 = element.text("geom2");
    int one = 0, two = 0;
    if (!touches_ || !find_touching(element, "geom1", one) || !find_touching(element, "geom2", two)) return;
    read_pair_friction(a, pair);
    read_softness(a, {"solref", "solimp"}, pair.softness);
    for (const char* soft : {"solref", "solimp", "solreffriction", "margin", "gap"})
        if (a.has(soft)) reading_.note_once(Note::kApproximated, element, std::string("pair ") + soft);
    if (are_kept_apart(model_, one, two))
        return reading_.note(Note::kIgnored, element,
                             "the pair of '" + pair.shape1 + "' and '" + pair.shape2 +
                                 "', which are of one body, of two that a joint connects, or of two that are "
                                 "excluded: such do not touch");
    model_.pairs.push_back(pair);
}

// Two coefficients of sliding, one of torsion, two of rolling.
void Mjcf::read_pair_friction(const Attributes& a, ShapePair& pair)
{
    std::vector<double> values;
    std::array<double, 5> its{1, 1, 0.005, 0.0001, 0.0001};
    if (list(a, "friction", 1, 5, values))
        for (size_t i = 0; i < values.size(); ++i) its[i] = std::max(0.0, values[i]);
    double condim = 3;
    if (number(a, "condim", condim) && condim != 1 && condim != 3 && condim != 4 && condim != 6)
        reading_.error(a.element(), "pair condim is " + a.text("condim") + ", and there are 1 3 4 6");
    pair.dimensions = condim >= 6 ? 6 : condim >= 4 ? 4 : 3;
    pair.friction = condim == 1 ? 0 : its[0];
    pair.torsional_friction = its[2], pair.rolling_friction = its[3];
    if (condim > 1 && its[0] != its[1])
        reading_.note(Note::kApproximated, a.element(),
                      "the pair of '" + pair.shape1 + "' and '" + pair.shape2 +
                          "' has two coefficients of sliding: the first counts in all directions");
    if (pair.dimensions == 4)
        reading_.note_once(Note::kApproximated, a.element(),
                           "condim 4: only batches have friction of torsion alone");
}

void Mjcf::read_contacts(const Element& section)
{
    for (const Element& element : expand(section)) {
        if (element.name() == "pair") {
            read_pair(defaults_.of(element, "", reading_));
            continue;
        }
        if (element.name() != "exclude") continue;
        const int one = model_.link_named(element.text("body1")),
                  two = model_.link_named(element.text("body2"));
        if (one < 0 || two < 0)
            reading_.error(element, "an exclusion of the bodies '" + element.text("body1") + "' and '" +
                                        element.text("body2") + "'; one is not there");
        else
            model_.excluded.push_back({one, two});
    }
}

void Mjcf::read_mocap(const Element& element, Start& start)
{
    for (const Link& link : model_.links)
        if (link.is_mocap) start.mocap.push_back(link.pose);
    const size_t n = start.mocap.size();
    std::vector<double> p, q;
    if (reading_.numbers(element, element.text("mpos"), "mpos", 3 * n, 3 * n, p))
        for (size_t i = 0; i < n; ++i) start.mocap[i].p = {p[3 * i], p[3 * i + 1], p[3 * i + 2]};
    if (reading_.numbers(element, element.text("mquat"), "mquat", 4 * n, 4 * n, q))
        for (size_t i = 0; i < n; ++i)
            start.mocap[i].q = normalised({q[4 * i], q[4 * i + 1], q[4 * i + 2], q[4 * i + 3]});
}

// How many numbers a key has of what moves, and that a start pose begins at rest.
void Mjcf::check_key(const Element& element)
{
    if (attached_.empty()) {
        const auto is_filtered = [](const Actuator& its) {
            return its.filter.kind != Activation::Kind::kNone || !its.activation.empty();
        };
        const size_t unread = actuators_ - std::min(actuators_, model_.actuators.size());
        const auto filtered = std::count_if(model_.actuators.begin(), model_.actuators.end(), is_filtered);
        reading_.check_count(element, "qvel", element.text("qvel"), size_t(number_of_velocities(model_)));
        reading_.check_count(element, "ctrl", element.text("ctrl"), actuators_);
        reading_.check_count(element, "act", element.text("act"), size_t(filtered) + unread);
    }
    for (const char* name : {"qvel", "act"}) {
        std::vector<double> values;
        reading_.numbers(element, element.text(name), name, 0, 1'000'000, values);
        if (std::any_of(values.begin(), values.end(), [](double value) { return value != 0; }))
            reading_.note_once(Note::kApproximated, element,
                               std::string("key ") + name + ": start poses begin at rest");
    }
}

void Mjcf::read_keys(const Element& section)
{
    for (const Element& element : expand(section)) {
        Start start;
        start.name = element.text("name");
        const size_t count = size_t(model_.coordinates);
        if (!element.has("qpos"))
            start.positions = reference_positions(model_);
        else if (!reading_.numbers(element, element.text("qpos"), "qpos", 1, count, start.positions))
            continue;
        const std::vector<double> reference = reference_positions(model_);
        start.positions.insert(start.positions.end(),
                               reference.begin() + long(std::min(start.positions.size(), count)),
                               reference.end());
        check_key(element);
        parse_numbers(element.text("ctrl"), start.controls);
        read_mocap(element, start);
        model_.starts.push_back(start);
    }
}

}  // namespace epode::robots
