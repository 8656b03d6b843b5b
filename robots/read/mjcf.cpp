// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The document: see mjcf.h.
#include "robots/read/mjcf.h"
#include "robots/files/mjcf_custom.h"
#include "robots/fluid.h"

#include <algorithm>

namespace epode::robots {

namespace {

constexpr size_t kMaxIncludeDepth = 64, kMaxIncludes = 2000;
constexpr double kDegree = 3.14159265358979323846 / 180;

std::string joined(const std::string& folder, const std::string& path)
{
    return folder.empty() || path.starts_with("/") ? path : folder + "/" + path;
}

}  // namespace

bool Mjcf::list(const Attributes& attributes, const char* name, size_t least, size_t largest,
                std::vector<double>& out)
{
    return reading_.numbers(attributes.element(), attributes.text(name), name, least, largest, out);
}

bool Mjcf::number(const Attributes& attributes, const char* name, double& out)
{
    std::vector<double> values;
    if (!list(attributes, name, 1, 1, values)) return false;
    out = values[0];
    return true;
}

bool Mjcf::vec(const Attributes& attributes, const char* name, Vec& out)
{
    std::vector<double> values;
    if (!list(attributes, name, 3, 3, values)) return false;
    out = {values[0], values[1], values[2]};
    return true;
}

bool Mjcf::is_limited(const Attributes& attributes, const char* flag, const char* range) const
{
    const std::string text = attributes.text(flag);
    std::vector<double> ends;
    const bool has_ends = parse_numbers(attributes.text(range), ends) && ends.size() == 2;
    if (text != "true") return text != "false" && compiler_.autolimits && has_ends && ends[0] != ends[1];
    if (!has_ends || ends[0] > ends[1])
        reading_.error(attributes.element(), "<" + attributes.element().name() + "> " + flag +
                                                 " is true, and no " + range +
                                                 " says from where to where, the lower end first");
    return true;
}

double Mjcf::angle(double value) const { return compiler_.degrees ? value * kDegree : value; }

std::vector<Element> Mjcf::expand(const Element& element)
{
    static const std::set<std::string> users{"actuator", "sensor", "equality", "contact"};
    std::vector<Element> out;
    for (const Element& child : element.children()) {
        if (child.name() == "include")
            include(child, out);
        else if (child.name() == "replicate")
            replicate(child, out);
        else if (users.count(element.name()))
            copy_user(child, out);
        else
            out.push_back(child);
    }
    return out;
}

std::string Mjcf::path_of(const Element& element) const
{
    if (!element.node || element.node.type() == pugi::node_document) return "body";  // in a copy
    const auto place = places_.find(element.document);
    if (element.node == element.document->tree.document_element())
        return place == places_.end() ? "" : place->second;
    return MjcfNames::path_of(path_of({element.node.parent(), element.document}), element.name());
}

void Mjcf::include(const Element& element, std::vector<Element>& out)
{
    std::string problem;
    std::string path = reading_.files.resolve(element.text("file"), folder_of(root_.file()), problem);
    if (path.empty()) path = reading_.files.resolve(element.text("file"), folder_of(element.file()), problem);
    if (path.empty()) return reading_.error(element, "include " + problem);
    if (std::find(including_.begin(), including_.end(), path) != including_.end())
        return reading_.error(element, "'" + path + "' includes itself");
    if (including_.size() >= kMaxIncludeDepth || ++includes_ > kMaxIncludes)
        return reading_.error(element, "includes are deeper than 64 or more than 2000");
    auto& document = documents_[path];
    if (!document) {
        const auto text = reading_.files.read(path, problem);
        if (text) document = parse_xml(path, *text, problem);
        if (!document) return reading_.error(element, "include '" + path + "': " + problem);
    }
    including_.push_back(path);
    const Element inner{document->tree.document_element(), document.get()};
    places_[document.get()] = path_of({element.node.parent(), element.document});
    names_.check(inner, places_[document.get()]);
    for (const Element& child : expand(inner)) out.push_back(child);
    including_.pop_back();
}

void Mjcf::read_compiler(const Element& element)
{
    Compiler& c = compiler_;
    const auto flag = [&](const char* name, bool& value) {
        if (element.has(name)) value = element.text(name) == "true";
    };
    const auto word = [&](const char* name, std::string& value) {
        if (element.has(name)) value = element.text(name);
    };
    if (element.has("angle")) c.degrees = element.text("angle") != "radian";
    flag("autolimits", c.autolimits), flag("balanceinertia", c.balance), flag("strippath", c.strip_path);
    flag("alignfree", c.align_free);
    word("inertiafromgeom", c.from_geoms), word("eulerseq", c.euler), word("meshdir", c.mesh_dir);
    word("assetdir", c.asset_dir);
    std::vector<double> groups;
    if (reading_.numbers(element, element.text("inertiagrouprange"), "inertiagrouprange", 2, 2, groups)) {
        c.low_group = int(std::clamp(groups[0], 0.0, 1e6)),
        c.high_group = int(std::clamp(groups[1], 0.0, 1e6));
    }
    reading_.number(element, "settotalmass", c.total_mass),
        reading_.number(element, "boundmass", c.bound_mass);
    reading_.number(element, "boundinertia", c.bound_inertia);
    const bool is_euler = c.euler.size() == 3 && c.euler.find_first_not_of("xyzXYZ") == std::string::npos;
    if (!is_euler) reading_.error(element, "eulerseq is three letters of xyz or XYZ"), c.euler = "xyz";
    if (element.text("coordinate") == "global")
        reading_.error(element, "global coordinates were given up in MuJoCo 2.3.4");
}

void Mjcf::read_option(const Element& element)
{
    reading_.vec(element, "gravity", model_.gravity);
    if (reading_.number(element, "timestep", model_.stepsize) && !(model_.stepsize > 0))
        reading_.error(element, "timestep is not above 0");
    reading_.number(element, "density", model_.medium.density);
    reading_.number(element, "viscosity", model_.medium.viscosity);
    reading_.vec(element, "wind", model_.medium.wind);
    reading_.vec(element, "magnetic", model_.magnetic);
    if (model_.medium.acts())
        reading_.note_once(Note::kChanged, element,
                           "the forces of the medium act where dRobotAddForces is called before a step");
    for (const Element& flag : element.children("flag")) read_flag(flag);
}

void Mjcf::read_flag(const Element& flag)
{
    static const std::set<std::string> known{"gravity",      "contact",  "spring",     "damper",   "limit",
                                             "frictionloss", "equality", "constraint", "clampctrl"};
    for (const pugi::xml_attribute& attribute : flag.node.attributes()) {
        const std::string name = attribute.name();
        if (std::string(attribute.value()) != "disable") continue;
        if (known.count(name)) off_.insert(name);
        if (name == "actuation") reading_.note(Note::kIgnored, flag, "actuation is switched off: it is on");
    }
    if (is_off("constraint")) off_.insert({"contact", "limit", "frictionloss", "equality"});
    if (!is_off("contact") || !touches_) return;
    touches_ = false;
    reading_.note(Note::kChanged, flag, "contacts are switched off: geoms are looks");
}

void Mjcf::switch_off()
{
    if (is_off("gravity")) model_.gravity = {};
    for (Joint& joint : model_.joints) {
        if (is_off("spring")) joint.stiffness = 0;
        if (is_off("damper")) joint.damping = 0;
        if (is_off("frictionloss")) joint.friction = 0;
        if (is_off("limit")) joint.limited = false, joint.low = -kInfinity, joint.high = kInfinity;
    }
    for (Tendon& tendon : model_.tendons) {
        if (is_off("spring")) tendon.stiffness = 0;
        if (is_off("damper")) tendon.damping = 0;
        if (is_off("frictionloss")) tendon.friction = 0;
        if (is_off("limit")) tendon.low = -kInfinity, tendon.high = kInfinity;
    }
    if (is_off("clampctrl"))
        for (Actuator& actuator : model_.actuators) actuator.low = -kInfinity, actuator.high = kInfinity;
}

// Of what stands there, what we write ourselves.
void Mjcf::read_custom(const Element& section)
{
    for (const Element& element : expand(section)) {
        const std::string name = element.text("name"), data = element.text("data");
        if (name == kOverlapsName && data == kOverlapsApart) model_.touches_itself = false;
        if (name == kFrictionName && data == kFrictionMean) model_.largest_friction = false;
        if (name != kVelocitiesName && name != kOnParentName) continue;
        for (const Element& its : element.children("element")) {
            const std::string object = its.text("objname");
            const int joint = model_.joint_named(object);
            double velocity = 0;
            if (name == kVelocitiesName && joint >= 0 && reading_.number(its, "prm", velocity) &&
                velocity > 0)
                model_.joints[size_t(joint)].max_velocity = velocity;
            for (Sensor& sensor : model_.sensors)
                if (name == kOnParentName && sensor.name == object) sensor.is_on_child = false;
        }
    }
}

// Of a mesh or height field, as the compiler's folders have it.
std::string Mjcf::asset_file(const Element& element) const
{
    std::string file = element.text("file");
    if (compiler_.strip_path) file = name_of(file);
    return joined(compiler_.mesh_dir.empty() ? compiler_.asset_dir : compiler_.mesh_dir, file);
}

void Mjcf::read_assets(const Element& section)
{
    for (const Element& element : expand(section)) {
        const std::string file = asset_file(element), named = element.text("name");
        const std::string name = named.empty() ? stem_of(file) : named;
        if (element.name() == "hfield") fields_[name] = {element, file, -1, false};
        if (element.name() == "model") models_[name] = {element, element.text("file"), nullptr};
        if (element.name() == "skin") reading_.note(Note::kIgnored, element, "asset <skin>");
        if (element.name() == "material") {
            std::vector<double> color{1, 1, 1, 1};
            list(defaults_.of(element, "", reading_), "rgba", 4, 4, color);
            materials_[name] = {float(color[0]), float(color[1]), float(color[2]), float(color[3])};
        }
        if (element.name() != "mesh") continue;
        const Attributes attributes = defaults_.of(element, "", reading_);
        Asset asset;
        asset.element = element;
        asset.file = file, asset.inertia = attributes.text("inertia");
        vec(attributes, "scale", asset.scale), vec(attributes, "refpos", asset.reference.p);
        std::vector<double> q;
        if (list(attributes, "refquat", 4, 4, q)) asset.reference.q = normalised({q[0], q[1], q[2], q[3]});
        assets_[name] = asset;
    }
}

void Mjcf::set_total_mass()
{
    double sum = 0;
    for (const Link& link : model_.links) sum += link.mass;
    if (!(compiler_.total_mass > 0) || !(sum > 0)) return;
    for (Link& link : model_.links) {
        link.mass *= compiler_.total_mass / sum;
        for (auto& row : link.inertia)
            for (double& value : row) value *= compiler_.total_mass / sum;
    }
}

const MassFactor& Mjcf::masses()
{
    if (!masses_) masses_.emplace(model_);
    return *masses_;
}

// springdamper: stiffness m / (T z)^2 and damping 2 m / T on the mass m that a joint feels at the reference position, for the
// time constant T and the damping ratio z.
void Mjcf::set_springs()
{
    for (const auto& [number, values] : springs_) {
        if (!masses().is_good()) return;
        Joint& joint = model_.joints[size_t(number)];
        const double m = 1 / masses().inverse_mass(model_, number), rate = 1 / (values[0] * values[1]);
        joint.stiffness = m * rate * rate, joint.damping = 2 * m / values[0];
    }
}

// All sections of one name, wherever they stand.
void Mjcf::read_sections(const std::vector<Element>& sections, const char* name,
                         void (Mjcf::*action)(const Element&))
{
    for (const Element& section : sections)
        if (section.name() == name) (this->*action)(section);
}

void Mjcf::note_other_sections(const std::vector<Element>& sections)
{
    static const std::set<std::string> known{"compiler", "option",   "default", "asset",     "worldbody",
                                             "contact",  "equality", "tendon",  "actuator",  "keyframe",
                                             "sensor",   "visual",   "size",    "statistic", "custom"};
    for (const Element& section : sections)
        if (!known.count(section.name())) reading_.note(Note::kIgnored, section, "<" + section.name() + ">");
}

void Mjcf::read()
{
    model_.name = root_.text("model");
    model_.largest_friction = true;
    Link world;
    world.name = "world";
    model_.links.push_back(world);
    including_.push_back(root_.file());
    names_.check(root_, "");
    const std::vector<Element> sections = expand(root_);
    read_sections(sections, "compiler", &Mjcf::read_compiler);
    read_sections(sections, "option", &Mjcf::read_option);
    read_sections(sections, "default", &Mjcf::read_defaults);
    read_sections(sections, "asset", &Mjcf::read_assets);
    read_sections(sections, "worldbody", &Mjcf::read_world);
    set_total_mass();
    for (Link& link : model_.links)
        for (Lift& lift : link.lifts) lift.mass = link.mass, lift.centre = link.centre;
    make_fluid_boxes(model_);
    number_coordinates(model_);
    if (model_.has_errors()) return;
    set_springs();
    read_sections(sections, "contact", &Mjcf::read_contacts);
    read_sections(sections, "tendon", &Mjcf::read_tendons);
    if (!is_off("equality")) read_sections(sections, "equality", &Mjcf::read_equalities);
    read_sections(sections, "actuator", &Mjcf::read_actuators);
    read_sections(sections, "sensor", &Mjcf::read_sensors);
    read_sections(sections, "custom", &Mjcf::read_custom);
    read_sections(sections, "keyframe", &Mjcf::read_keys);
    finish_attached();
    switch_off();
    note_other_sections(sections);
    std::vector<std::string> copied;
    for (const auto& [name, unused] : copies_) copied.push_back(name);
    names_.judge(copied);
}

void read_mjcf(const Element& mujoco, Reading& reading) { Mjcf(mujoco, reading).read(); }

}  // namespace epode::robots
