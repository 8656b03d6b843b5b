// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "robots/read/mjcf_names.h"

#include <algorithm>
#include <array>

#include "robots/read/counts.h"

namespace epode::robots {

namespace {

struct Row {
    const char *path, *attributes;
};

// clang-format off
constexpr Row kRows[] = {
#include "robots/read/mjcf_names.inc"
// What MuJoCo's schema leaves out, since it is replaced before it is judged.
{"body/frame", "name childclass pos quat axisangle xyaxes zaxis euler"},
{"body/replicate", "count offset euler sep childclass"},
{"body/composite", "type prefix count offset vertex initial curve size quat"},
{"include", "file"},
// What versions before 4.0 had.
{"equality/distance", "name class active geom1 geom2 distance solref solimp"},
};
// Words of older versions, which mean nothing any more.
constexpr Row kOlder[] = {
{"", "version"},
{"compiler", "convexhull exactmeshinertia"},
{"option", "apirate collision impedance mpr_iterations mpr_tolerance noslip_tolerance ccd_iterations"},
{"option/flag", "passive sensornoise multiccd nativeccd eulerdamp"},
{"visual/global", "realtime ellipsoidinertia treedepth"},
{"visual/map", "shadowscale"},
{"asset/mesh", "smoothnormal octree_maxdepth file_name convexhull"},
{"default/mesh", "smoothnormal maxhullvert"},
{"asset/texture", "file"},
{"body/light", "castshadow texture"},
{"sensor/user", "needstage"},
};
// clang-format on

using Words = std::set<std::string>;

Words words_of(const std::string& text)
{
    Words out;
    size_t begin = 0;
    while (begin < text.size()) {
        const size_t end = std::min(text.find(' ', begin), text.size());
        if (end > begin) out.insert(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

template <size_t N>
std::map<std::string, Words> table_of(const Row (&rows)[N])
{
    std::map<std::string, Words> out;
    for (const Row& row : rows) out[row.path].merge(words_of(row.attributes));
    return out;
}

const std::map<std::string, Words>& attributes()
{
    static const std::map<std::string, Words> table = table_of(kRows);
    return table;
}

const Words& older_of(const std::string& path)
{
    static const std::map<std::string, Words> table = table_of(kOlder);
    static const Words none;
    const auto found = table.find(path);
    return found == table.end() ? none : found->second;
}

bool is_body(const std::string& name)
{
    static const Words bodies{"worldbody", "body", "frame", "replicate"};
    return bodies.count(name) > 0;
}

// What may stand in an element of that path.
Words elements_in(const std::string& path)
{
    Words out{"include"};
    const std::string begin = path.empty() ? "" : path + "/";
    for (const auto& [its, unused] : attributes())
        if (!its.empty() && its.starts_with(begin) && its.find('/', begin.size()) == std::string::npos)
            out.insert(its.substr(begin.size()));
    if (path.empty()) out.erase("body"), out.insert({"worldbody", "default"});
    if (path == "body") out.insert("body");
    if (path == "default") out.insert("default");
    return out;
}

// Values that an attribute of some element must have, where another one would mean something else than MuJoCo's refusal.
const std::string* keywords_of(const std::string& element, const std::string& attribute)
{
    static const std::string shapes = "plane hfield sphere capsule ellipsoid cylinder box mesh sdf",
                             switches = "false true", limits = "false true auto", flags = "disable enable";
    static const std::map<std::string, std::string> table{{"joint type", "free ball slide hinge"},
                                                          {"geom type", shapes},
                                                          {"site type", shapes},
                                                          {"compiler angle", "radian degree"},
                                                          {"compiler autolimits", switches},
                                                          {"compiler inertiafromgeom", limits},
                                                          {"body mocap", switches},
                                                          {"mesh inertia", "convex exact legacy shell"}};
    static const std::set<std::string> limited{"limited", "ctrllimited", "forcelimited", "actlimited",
                                               "actuatorfrclimited"};
    if (element == "flag") return &flags;
    if (limited.count(attribute)) return &limits;
    const auto found = table.find(element + " " + attribute);
    return found == table.end() ? nullptr : &found->second;
}

// How many letters must be changed, added or left out.
size_t distance(const std::string& a, const std::string& b)
{
    std::vector<size_t> row(b.size() + 1);
    for (size_t k = 0; k <= b.size(); ++k) row[k] = k;
    for (size_t i = 1; i <= a.size(); ++i) {
        size_t before = row[0];
        row[0] = i;
        for (size_t k = 1; k <= b.size(); ++k) {
            const size_t changed = before + (a[i - 1] != b[k - 1]);
            before = row[k];
            row[k] = std::min({changed, row[k] + 1, row[k - 1] + 1});
        }
    }
    return row[b.size()];
}

std::string advice(const std::string& wrong, const Words& words)
{
    constexpr size_t kLongest = 60;
    std::string best;
    size_t least = wrong.size() / 2 + 1;
    if (wrong.size() <= kLongest)
        for (const std::string& word : words)
            if (const size_t its = distance(wrong, word); its < least) least = its, best = word;
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

// Of what its name is the name; empty: of nothing that may be named once only.
std::string named_kind(const std::string& path)
{
    static const std::map<std::string, std::string> kinds{
        {"body/freejoint", "joint"}, {"tendon/fixed", "tendon"}, {"tendon/spatial", "tendon"}};
    static const std::set<std::string> own{
        "body",         "body/joint",      "body/geom",    "body/site",      "body/camera", "body/light",
        "asset/mesh",   "asset/texture",   "asset/hfield", "asset/material", "asset/skin",  "asset/model",
        "contact/pair", "contact/exclude", "keyframe/key", "custom/numeric", "custom/text", "custom/tuple"};
    if (const auto found = kinds.find(path); found != kinds.end()) return found->second;
    for (const char* section : {"actuator/", "sensor/", "equality/"})
        if (path.starts_with(section) && path.find('/', path.find('/') + 1) == std::string::npos)
            return std::string(section, path.find('/'));
    return own.count(path) ? path.substr(path.find('/') + 1) : "";
}

}  // namespace

std::string MjcfNames::path_of(const std::string& parent, const std::string& element)
{
    if (element == "include") return parent;
    if ((parent.empty() && element == "worldbody") || (parent == "body" && is_body(element))) return "body";
    if (parent.empty() || (parent == "default" && element == "default")) return element;
    return parent + "/" + element;
}

void MjcfNames::check_attributes(const Element& element, const std::string& path)
{
    const std::string name = element.name();
    const bool is_frame = path == "body" && (name == "frame" || name == "replicate");
    const auto found = attributes().find(is_frame ? "body/" + name : path);
    if (found == attributes().end() || path.starts_with("body/composite")) return;
    if (name == "worldbody") return;
    for (const pugi::xml_attribute& attribute : element.node.attributes()) {
        const std::string word = attribute.name();
        if (found->second.count(word)) continue;
        if (older_of(path).count(word))
            reading_.note_once(
                Note::kIgnored, element,
                "<" + name + "> " + word + ": a word of older versions, which means nothing now");
        else
            reading_.error(element, "<" + name.substr(0, 40) + "> has no attribute '" + word.substr(0, 60) +
                                        "'" + advice(word, found->second));
    }
}

void MjcfNames::check_keywords(const Element& element)
{
    for (const pugi::xml_attribute& attribute : element.node.attributes()) {
        const std::string* const keywords = keywords_of(element.name(), attribute.name());
        const std::string value = attribute.value();
        if (!keywords) continue;
        const Words known = words_of(*keywords);
        if (!known.count(value))
            reading_.error(element, "<" + element.name() + "> " + attribute.name() + " is '" +
                                        value.substr(0, 60) + "', and there are " + *keywords +
                                        advice(value, known));
    }
}

void MjcfNames::check_name(const Element& element, const std::string& path)
{
    std::string kind = named_kind(path);
    const std::string name = element.text("name");
    if (kind.empty() || name.empty() || (path == "body" && element.name() != "body")) return;
    const auto [it, is_new] = lines_[kind].try_emplace(name, element.line());
    if (!is_new)
        reading_.error(element, "the name '" + name.substr(0, 60) + "' of a " + kind +
                                    " is that of the one in line " + std::to_string(it->second) + ", too");
}

void MjcfNames::check(const Element& element, const std::string& path)
{
    check_attributes(element, path);
    check_keywords(element);
    check_mjcf_counts(element, reading_);
    check_name(element, path);
    if (path.starts_with("body/composite")) return;
    const Words known = elements_in(path);
    for (const Element& child : element.children()) {
        const std::string name = child.name();
        if (name == "include") continue;
        if (known.count(name))
            check(child, path_of(path, name));
        else
            reading_.error(child, "there is no element <" + name.substr(0, 40) + "> in <" +
                                      (path.empty() ? "mujoco" : element.name().substr(0, 40)) + ">" +
                                      advice(name, known));
    }
}

}  // namespace epode::robots
