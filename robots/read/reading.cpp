// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See reading.h.
#include "robots/read/reading.h"

#include <algorithm>

#include "robots/meshes/meshes.h"

namespace epode::robots {

namespace {

constexpr size_t kMaxReport = 10'000;
constexpr size_t kMaxShown = 60;  // of a broken value

std::string shown(const std::string& text)
{
    return "'" + text.substr(0, kMaxShown) + (text.size() > kMaxShown ? "..." : "") + "'";
}

size_t words_in(const std::string& text)
{
    size_t count = 0;
    bool is_within = false;
    for (char c : text) {
        const bool is_blank = c == ' ' || (c >= '\t' && c <= '\r');
        count += !is_blank && !is_within;
        is_within = !is_blank;
    }
    return count;
}

}  // namespace

void Reading::note(Note kind, const std::string& file, int line, const std::string& text)
{
    const bool loses = kind == Note::kApproximated || kind == Note::kIgnored;
    if (options.strict && loses) kind = Note::kError;
    if (model.report.size() < kMaxReport || kind == Note::kError)
        model.report.push_back({kind, file, line, text});
}

void Reading::note_once(Note kind, const Element& where, const std::string& text)
{
    if (noted_.insert(text).second) note(kind, where, text);
}

bool Reading::numbers(const Element& element, const std::string& text, const char* attribute, size_t least,
                      size_t largest, std::vector<double>& out)
{
    if (text.empty() || (!noted_.empty() && noted_.count(attribute + text))) return false;
    if (parse_numbers(text, out) && out.size() >= least && out.size() <= largest) return true;
    const std::string count =
        least == largest ? std::to_string(least) : std::to_string(least) + " to " + std::to_string(largest);
    error(element, element.name() + " " + attribute + " = " + shown(text) + ", wanted " + count +
                       (largest == 1 ? " finite number" : " finite numbers"));
    return false;
}

void Reading::check_count(const Element& element, const std::string& attribute, const std::string& text,
                          size_t limit)
{
    const size_t count = words_in(text);
    if (count <= limit) return;
    noted_.insert(attribute + text);
    error(element, element.name() + (attribute.empty() ? "" : " ") + attribute + " = " + shown(text) +
                       ", wanted " + std::to_string(limit) +
                       (limit == 1 ? " finite number" : " finite numbers") + " at most, not " +
                       std::to_string(count));
}

void Reading::check_numbers(const Element& element, const std::string& attribute, const std::string& text)
{
    std::vector<double> values;
    if (text.empty() || noted_.count(attribute + text) || parse_numbers(text, values)) return;
    noted_.insert(attribute + text);
    error(element, element.name() + " " + attribute + " = " + shown(text) + ", wanted finite numbers");
}

bool Reading::number(const Element& element, const char* attribute, double& out)
{
    std::vector<double> values;
    if (!numbers(element, element.text(attribute), attribute, 1, 1, values)) return false;
    out = values[0];
    return true;
}

bool Reading::vec(const Element& element, const char* attribute, Vec& out)
{
    std::vector<double> values;
    if (!numbers(element, element.text(attribute), attribute, 3, 3, values)) return false;
    out = {values[0], values[1], values[2]};
    return true;
}

int Reading::mesh(const Place& where, const MeshFile& wanted)
{
    std::string problem;
    const auto miss = [&] { return note(where.missing, where.file, where.line, "mesh " + problem), -1; };
    const std::string path = files.resolve(wanted.reference, wanted.folder, problem);
    if (path.empty() || !is_mesh_path(path, problem)) return miss();
    const Vec s = wanted.scale;
    const auto [it, is_new] = meshes_.try_emplace({path, {s.x, s.y, s.z}, wanted.counts_folds}, -1);
    if (!is_new) return it->second;
    Mesh mesh;
    const auto bytes = files.read(path, problem);
    if (!bytes || !read_mesh(path, *bytes, mesh, problem)) return miss();
    scale_mesh(mesh, s);
    mesh.counts_folds = wanted.counts_folds;
    it->second = int(model.meshes.size());
    model.meshes.push_back(std::move(mesh));
    return it->second;
}

void Reading::add_motor(int joint, const std::string& name, int line)
{
    Actuator motor;
    motor.kind = "motor", motor.joint = joint, motor.line = line, motor.name = name;
    const double largest = model.joints[size_t(joint)].max_force;
    if (largest > 0) motor.force_low = -largest, motor.force_high = largest;
    model.actuators.push_back(motor);
}

void Reading::add_motors()
{
    const auto follows = [&](int joint) {
        return std::any_of(model.couplings.begin(), model.couplings.end(), [&](const Coupling& coupling) {
            return !coupling.terms.empty() && coupling.terms.front().joint == joint;
        });
    };
    for (size_t i = 0; i < model.joints.size(); ++i)
        if (model.joints[i].is_scalar() && !follows(int(i)))
            add_motor(int(i), model.joints[i].name, model.joints[i].line);
}

}  // namespace epode::robots
