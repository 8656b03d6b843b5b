// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "robots/read/mjcf_names.h"

#include "robots/read/counts.h"
#include "robots/read/mjcf_values.h"

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

// Meshes and textures without a name are called as their files.
std::string name_of_asset(const Element& element, const std::string& path)
{
    const bool may_lack = path == "asset/mesh" || path == "asset/texture" || path == "asset/hfield";
    if (!may_lack || element.has("name")) return element.text("name");
    const std::string file = element.text("file"), last = file.substr(file.find_last_of("/\\") + 1);
    return last.substr(0, last.rfind('.'));
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

void MjcfNames::check_name(const Element& element, const std::string& path)
{
    const std::string kind = named_kind(path), name = name_of_asset(element, path);
    if (kind.empty() || name.empty() || (path == "body" && element.name() != "body")) return;
    references_.add_name(kind, name);
    if (!element.has("name")) return;
    if (path == "body" && name == "world")
        return reading_.error(element, "a body is called 'world', as what bodies stand in");
    const auto [it, is_new] = lines_[kind].try_emplace(name, element.line());
    if (!is_new)
        reading_.error(element, "the name '" + name.substr(0, 60) + "' of a " + kind +
                                    " is that of the one in line " + std::to_string(it->second) + ", too");
}

void MjcfNames::check(const Element& element, const std::string& path)
{
    check_name(element, path);
    if (path.starts_with("body/composite")) return;
    check_attributes(element, path);
    check_mjcf_values(element, path, reading_);
    check_mjcf_counts(element, reading_);
    references_.note(element, path);
    user_data_.note(element, path, reading_);
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

void MjcfNames::judge(const std::vector<std::string>& begins)
{
    references_.judge(begins, reading_);
    user_data_.judge(reading_);
}

}  // namespace epode::robots
