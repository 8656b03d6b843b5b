// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The writer of MJCF: couplings, tendons, actuators, contacts, start poses and sensors; see mjcf_writer.h. A coupling  f1 q1 + f2 q2 = o
// becomes
//     q1 - r1 = c0 + c1 (q2 - r2),    c1 = -f2/f1,    c0 = o/f1 - r1 + c1 r2.
#include <cmath>

#include "robots/files/mjcf_custom.h"
#include "robots/sensor_kinds.h"
#include "robots/write/mjcf_writer.h"

namespace epode::robots {

namespace {

using Node = pugi::xml_node;

// What the short kinds do not say is a general one.
std::string kind_of(const Actuator& a)
{
    if (a.muscle.acts) return "muscle";
    if (a.kind == "adhesion") return a.kind;
    const bool is_plain = a.bias == 0 && a.activation.empty() && a.gain_position == 0 && a.gain_velocity == 0;
    if (a.kind == "position" && is_plain && a.gain == a.bias_position) return a.kind;
    if (a.kind == "velocity" && is_plain && a.gain == a.bias_velocity && a.bias_position == 0) return a.kind;
    const bool is_motor =
        a.kind == "motor" && is_plain && a.gain == 1 && a.bias_position == 0 && a.bias_velocity == 0;
    return is_motor ? a.kind : "general";
}

}  // namespace

// The tendons that it came from, or a tendon of its own.
void MjcfWriter::write_tendon_equality(const Coupling& coupling)
{
    const auto [one, two] = coupling.tendons;
    Node its = section("equality").append_child("tendon");
    name_it(its, equality_names_, coupling.name);
    if (one < 0) {
        Tendon own;
        own.terms = coupling.terms;
        tendons_.push_back(tendon_names_.unique("", "coupling", tendons_.size()));
        write_tendon(own, tendons_.back());
    }
    set(its, "tendon1", one < 0 ? tendons_.back() : tendons_[size_t(one)]);
    if (two >= 0) set(its, "tendon2", tendons_[size_t(two)]);
    std::vector<double> c{coupling.offset, coupling.ratio};
    for (const Coupling::Term& term : coupling.terms)
        c[0] -= term.factor * model_.joints[size_t(term.joint)].reference;
    c.insert(c.end(), coupling.polynomial.begin(), coupling.polynomial.end());
    c.resize(5, 0);
    set(its, "polycoef", list_text(c));
}

void MjcfWriter::write_ties()
{
    for (const Tie& tie : model_.ties) {
        Node its = section("equality").append_child("tendon");
        name_it(its, equality_names_, tie.name);
        set(its, "tendon1", tendons_[size_t(tie.tendon1)]);
        if (tie.tendon2 >= 0) set(its, "tendon2", tendons_[size_t(tie.tendon2)]);
        set(its, "polycoef", list_text({tie.curve.begin(), tie.curve.end()}));
    }
}

void MjcfWriter::write_couplings()
{
    for (const Coupling& coupling : model_.couplings) {
        const auto& terms = coupling.terms;
        if (terms.empty()) continue;
        if (coupling.tendons[0] >= 0 || terms.size() > 2 || terms[0].factor == 0) {
            write_tendon_equality(coupling);
            continue;
        }
        const double f1 = terms[0].factor, r1 = model_.joints[size_t(terms[0].joint)].reference;
        std::vector<double> c{coupling.offset / f1 - r1, 0};
        Node its = section("equality").append_child("joint");
        name_it(its, equality_names_, coupling.name);
        set(its, "joint1", joints_[size_t(terms[0].joint)]);
        if (terms.size() == 2) {
            set(its, "joint2", joints_[size_t(terms[1].joint)]);
            c[1] = -terms[1].factor / f1;
            c[0] += c[1] * model_.joints[size_t(terms[1].joint)].reference;
            c.insert(c.end(), coupling.polynomial.begin(), coupling.polynomial.end());
        }
        c.resize(5, 0);
        set(its, "polycoef", list_text(c));
    }
}

// Of a path's part the site, or the geom, which is made where there is none.
void MjcfWriter::write_part(Node tendon, const PathPart& part)
{
    using Kind = PathPart::Kind;
    if (part.kind == Kind::kPulley) return set(tendon.append_child("pulley"), "divisor", part.divisor);
    if (part.kind == Kind::kSite)
        return set(tendon.append_child("site"), "site", site_at(part.link, part.pose));
    Node its = tendon.append_child("geom");
    set(its, "geom", surface_of(part));
    if (part.side_link >= 0) set(its, "sidesite", site_at(part.side_link, {part.side, {}}, true));
}

std::string MjcfWriter::surface_of(const PathPart& part)
{
    const ShapeKind kind = part.kind == PathPart::Kind::kSphere ? ShapeKind::kSphere : ShapeKind::kCylinder;
    const Link& link = model_.links[size_t(part.link)];
    size_t number = 0;
    for (const auto* shapes : {&link.shapes, &link.visuals})
        for (const Shape& shape : *shapes) {
            const std::string& name = geom_names_[size_t(part.link)][number++];
            if (!name.empty() && shape.kind == kind && shape.size.x == part.radius &&
                is_near(shape.pose, part.pose))
                return name;
        }
    Shape own;
    own.kind = kind, own.pose = part.pose, own.size = {part.radius, part.radius, 0};
    own.name = "around", own.color[3] = 0;
    return write_geom(bodies_[size_t(part.link)], own, false);
}

void MjcfWriter::write_tendon(const Tendon& tendon, const std::string& name)
{
    Node its = section("tendon").append_child(tendon.path.empty() ? "fixed" : "spatial");
    const bool is_limited = std::isfinite(tendon.low) || std::isfinite(tendon.high);
    set(its, "name", name), set(its, "limited", yes(is_limited));
    if (is_limited) set(its, "range", range_of(tendon.low, tendon.high));
    if (tendon.stiffness != 0) set(its, "stiffness", tendon.stiffness);
    if (tendon.damping != 0) set(its, "damping", tendon.damping);
    if (tendon.friction != 0) set(its, "frictionloss", tendon.friction);
    if (tendon.armature != 0) set(its, "armature", tendon.armature);
    if (tendon.has_rest) set(its, "springlength", range_of(tendon.rest, tendon.rest_high));
    for (const PathPart& part : tendon.path) write_part(its, part);
    for (const Coupling::Term& term : tendon.terms) {
        Node joint = its.append_child("joint");
        set(joint, "joint", joints_[size_t(term.joint)]), set(joint, "coef", term.factor);
    }
}

void MjcfWriter::write_tendons()
{
    for (size_t i = 0; i < model_.tendons.size(); ++i) write_tendon(model_.tendons[i], tendons_[i]);
}

void MjcfWriter::write_gains(Node actuator, const Actuator& from, const std::string& kind)
{
    if (kind == "adhesion") set(actuator, "gain", from.gain);
    if (kind == "position") set(actuator, "kp", from.gain);
    if (kind == "position" || kind == "velocity") set(actuator, "kv", from.bias_velocity);
    if (kind == "muscle") {
        const Muscle& m = from.muscle;
        set(actuator, "timeconst", list_text({from.filter.time, from.filter.slower}));
        set(actuator, "tausmooth", from.filter.smooth), set(actuator, "range", range_of(m.low, m.high));
        set(actuator, "lengthrange", range_of(m.length_low, m.length_high));
        const std::pair<const char*, double> numbers[] = {{"force", m.force},   {"lmin", m.shortest},
                                                          {"lmax", m.longest},  {"vmax", m.fastest},
                                                          {"fpmax", m.passive}, {"fvmax", m.eccentric}};
        for (const auto& [name, value] : numbers) set(actuator, name, value);
    }
    if (kind != "general") return;
    const bool is_affine = from.gain_position != 0 || from.gain_velocity != 0;
    if (is_affine) set(actuator, "gaintype", "affine");
    set(actuator, "gainprm",
        is_affine ? list_text({from.gain, from.gain_position, from.gain_velocity}) : text_of(from.gain));
    set(actuator, "biastype", "affine");
    set(actuator, "biasprm", list_text({from.bias, -from.bias_position, -from.bias_velocity}));
}

void MjcfWriter::write_target(Node node, const Actuator& actuator)
{
    const SiteWrench& wrench = actuator.wrench;
    if (actuator.joint >= 0) set(node, "joint", joints_[size_t(actuator.joint)]);
    if (actuator.tendon >= 0) set(node, "tendon", tendons_[size_t(actuator.tendon)]);
    if (actuator.adhesive_link >= 0) set(node, "body", links_[size_t(actuator.adhesive_link)]);
    if (wrench.link < 0) return;
    if (wrench.is_crank()) {
        set(node, "cranksite", site_at(wrench.link, wrench.pose));
        set(node, "slidersite", site_at(wrench.reference_link, wrench.reference));
        return set(node, "cranklength", wrench.rod), set(node, "gear", wrench.force.x);
    }
    set(node, "site", site_at(wrench.link, wrench.pose));
    if (wrench.reference_link >= 0) set(node, "refsite", site_at(wrench.reference_link, wrench.reference));
    set(node, "gear", text_of(wrench.force) + " " + text_of(wrench.torque));
}

void MjcfWriter::write_actuators()
{
    for (const Actuator& actuator : model_.actuators) {
        const std::string kind = kind_of(actuator);
        Node its = section("actuator").append_child(kind.c_str());
        name_it(its, actuator_names_, actuator.name);
        write_target(its, actuator);
        if (length(actuator.direction) > 0)
            set(its, "gear", text_of(actuator.direction) + " 0 0 0");
        else if (actuator.wrench.link < 0 && actuator.adhesive_link < 0)
            set(its, "gear", actuator.gear);
        const bool clamps_control = std::isfinite(actuator.low) || std::isfinite(actuator.high),
                   clamps_force = std::isfinite(actuator.force_low) || std::isfinite(actuator.force_high);
        if (kind != "adhesion") set(its, "ctrllimited", yes(clamps_control));  // which always is
        set(its, "forcelimited", yes(clamps_force));
        if (clamps_control) set(its, "ctrlrange", range_of(actuator.low, actuator.high));
        if (clamps_force) set(its, "forcerange", range_of(actuator.force_low, actuator.force_high));
        write_gains(its, actuator, kind);
        for (const auto& [name, text] : actuator.activation) set(its, name.c_str(), text);
    }
}

std::string MjcfWriter::written_geom(const std::string& name) const
{
    for (size_t i = 0; i < model_.links.size(); ++i) {
        size_t number = 0;
        for (const auto* shapes : {&model_.links[i].shapes, &model_.links[i].visuals})
            for (const Shape& shape : *shapes)
                if (const std::string& written = geom_names_[i][number++]; shape.name == name) return written;
    }
    return name;
}

void MjcfWriter::write_pair(const ShapePair& pair)
{
    Node its = section("contact").append_child("pair");
    name_it(its, pair_names_, pair.name);
    set(its, "geom1", written_geom(pair.shape1)), set(its, "geom2", written_geom(pair.shape2));
    set(its, "condim", pair.dimensions > 3 || pair.friction > 0 ? pair.dimensions : 1);
    set(its, "friction",
        list_text({pair.friction, pair.friction, pair.torsional_friction, pair.rolling_friction,
                   pair.rolling_friction}));
    write_softness(its, "solref", "solimp", pair.softness);
}

void MjcfWriter::write_contacts_and_keys()
{
    for (const auto& pair : model_.excluded) {
        Node its = section("contact").append_child("exclude");
        set(its, "body1", links_[size_t(pair[0])]), set(its, "body2", links_[size_t(pair[1])]);
    }
    for (const ShapePair& pair : model_.pairs) write_pair(pair);
    for (const auto& pair : model_.excluded_still) {
        Node its = section("contact").append_child("exclude");
        set(its, "body1", links_[size_t(pair[0])]), set(its, "body2", still_[size_t(pair[1]) - 1]);
    }
    for (const Start& start : model_.starts) {
        Node its = section("keyframe").append_child("key");
        name_it(its, key_names_, start.name);
        set(its, "qpos", list_text(start.positions));
        if (!start.controls.empty()) set(its, "ctrl", list_text(start.controls));
        std::vector<double> places, turns;
        for (const Pose& pose : start.mocap) {
            places.insert(places.end(), {pose.p.x, pose.p.y, pose.p.z});
            turns.insert(turns.end(), {pose.q.w, pose.q.x, pose.q.y, pose.q.z});
        }
        if (!places.empty()) set(its, "mpos", list_text(places)), set(its, "mquat", list_text(turns));
    }
}

// Of a body the geoms of its link, where no other body's are among them.
MjcfWriter::Sensed MjcfWriter::geom_object(const std::string& type, const std::string& name,
                                           const char* number) const
{
    if (type == "geom") return {std::string("geom") + number, "", written_geom(name)};
    for (size_t i = 0; i < model_.links.size(); ++i) {
        if (model_.links[i].name != name) continue;
        for (const auto* shapes : {&model_.links[i].shapes, &model_.links[i].visuals})
            for (const Shape& shape : *shapes)
                if (!shape.body.empty()) return {};
        return {std::string("body") + number, "", links_[i]};
    }
    return {};
}

MjcfWriter::Node MjcfWriter::write_sensor(const Sensor& sensor, const Sensed& on)
{
    Node its = section("sensor").append_child(sensor.kind.c_str());
    name_it(its, sensor_names_, sensor.name);
    if (!on.type.empty()) set(its, "objtype", on.type);
    if (!on.attribute.empty()) set(its, on.attribute.c_str(), on.object);
    if (sensor.cutoff > 0) set(its, "cutoff", sensor.cutoff);
    return its;
}

// Kinds that are not computed as their file has named them, if it is MJCF.
void MjcfWriter::write_sensors()
{
    for (const Sensor& sensor : model_.sensors) {
        const bool of_frame = values_of_frame_sensor(sensor.kind) > 0,
                   of_geoms = values_of_geom_sensor(sensor.kind) > 0;
        const Sensed on = values_of(sensor.kind) == 0
                              ? Sensed{sensor.attribute, sensor.object_type, sensor.object}
                          : of_geoms ? geom_object(sensor.object_type, sensor.object, "1")
                          : of_frame ? frame_object(sensor.kind, sensor.object_type, sensor.object)
                                     : joint_object(sensor);
        const Sensed other = of_geoms ? geom_object(sensor.reference_type, sensor.reference, "2") : on;
        const bool is_whole = values_of_whole_sensor(sensor.kind) > 0;  // the robot's
        if ((on.attribute.empty() || other.attribute.empty()) && !is_whole) {
            losses_.add("sensors of kind <" + sensor.kind + "> on '" + sensor.object + "' are not written");
            continue;
        }
        Node its = write_sensor(sensor, is_whole ? Sensed{} : on);
        if (of_geoms) {
            set(its, other.attribute.c_str(), other.object);
            continue;
        }
        const bool is_force = sensor.kind == "force" || sensor.kind == "torque";
        if (is_force && !sensor.is_on_child && !sensor.name.empty()) {
            Node element = tuple(kOnParentName).append_child("element");
            set(element, "objtype", "sensor"), set(element, "objname", its.attribute("name").value());
        }
        write_reference(its, sensor);
        if (is_force && !sensor.is_on_child)
            losses_.add(
                "force and torque sensors of MJCF read what acts on a link, not on its parent: the sign "
                "differs, but for Epode");
    }
}

void MjcfWriter::write_reference(Node its, const Sensor& sensor) const
{
    if (sensor.reference.empty()) return;
    const Sensed to = values_of(sensor.kind) == 0
                          ? Sensed{"refname", sensor.reference_type, sensor.reference}
                          : frame_object("frame", sensor.reference_type, sensor.reference);
    if (sensor.kind == "insidesite") return set(its, "site", to.object);
    if (!to.object.empty()) set(its, "reftype", to.type), set(its, "refname", to.object);
}

MjcfWriter::Sensed MjcfWriter::joint_object(const Sensor& sensor) const
{
    if (sensor.kind.starts_with("actuator")) return {"actuator", "", sensor.object};
    if (const int tendon = model_.tendon_named(sensor.object);
        sensor.kind.starts_with("tendon") && tendon >= 0)
        return {"tendon", "", tendons_[size_t(tendon)]};
    const int joint = model_.joint_named(sensor.object);
    if (values_of_joint_sensor(sensor.kind) == 0 || joint < 0) return {};
    return {"joint", "", joints_[size_t(joint)]};
}

// A body is its centre of mass, a link's own frame an xbody.
MjcfWriter::Sensed MjcfWriter::frame_object(const std::string& kind, const std::string& type,
                                            const std::string& name) const
{
    Frame whole;
    if (kind.starts_with("subtree"))
        return model_.frame_named(name, whole) ? Sensed{"body", "", links_[size_t(whole.link)]} : Sensed{};
    const bool says_type = kind.rfind("frame", 0) == 0 || kind == "insidesite",
               is_body = type == "body" || type == "xbody";
    const auto link = [&]() -> Sensed {
        for (size_t i = 0; i < model_.links.size(); ++i)
            if (says_type && model_.links[i].name == name)
                return {"objname", type == "body" ? "body" : "xbody", links_[i]};
        return {};
    };
    if (const Sensed its = link(); is_body && !its.attribute.empty()) return its;
    for (size_t i = 0; i < model_.frames.size(); ++i)
        if (!name.empty() && model_.frames[i].name == name)
            return {says_type ? "objname" : "site", says_type ? "site" : "", frames_[i]};
    return link();
}

}  // namespace epode::robots
