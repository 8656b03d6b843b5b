// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "known.h"

#include <algorithm>
#include <cstdio>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace epode::trials {

namespace {

constexpr double kGood = -1;
// Ceilings leave so much above the figure: motion that is chaotic differs where the machine's sine does.
constexpr double kMargin = 1.25;

int column_of(const Setting& setting) { return setting.step_size + (setting.sleep ? kStepSizeCount : 0); }

std::string name_of_law(const Scene& scene, const Law& law)
{
    return std::string(scene.name) + "." + law.name;
}

std::vector<std::string> fields_of(const std::string& text)
{
    std::vector<std::string> fields;
    std::istringstream in(text);
    for (std::string field; std::getline(in, field, '\t');) fields.push_back(field);
    return fields;
}

std::string text_of_ceiling(double ceiling)
{
    char text[32];
    std::snprintf(text, sizeof text, "%.2g", ceiling);
    return ceiling < 0 ? "-" : text;
}

}  // namespace

Known::Known(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    int number = 0;
    for (std::string text; std::getline(file, text);) {
        ++number;
        try {
            if (!text.empty() && text[0] != '#') read(text);
        } catch (const std::exception& fault) {
            throw std::runtime_error(path + ":" + std::to_string(number) + ": " + fault.what());
        }
    }
}

void Known::read(const std::string& text)
{
    const std::vector<std::string> fields = fields_of(text);
    if (fields.size() == 3 && fields[0] == "reason") {
        reasons_.emplace_back(fields[1], fields[2]);
        return;
    }
    if (fields.size() != 10 || fields[0] != "fails")
        throw std::runtime_error("neither a reason nor a line of ten fields");
    Line line{fields[1], fields[2], fields[3], {}};
    const size_t dot = line.law.find('.');
    const Scene* scene = scene_named(line.law.substr(0, dot));
    if (!scene || dot == std::string::npos || !scene->law(line.law.substr(dot + 1)))
        throw std::runtime_error("no law " + line.law);
    const auto named = [&](const auto& reason) { return reason.first == line.reason; };
    if (std::none_of(reasons_.begin(), reasons_.end(), named))
        throw std::runtime_error("no reason " + line.reason);
    for (size_t i = 0; i < 6; ++i) line.ceilings[i] = fields[4 + i] == "-" ? kGood : std::stod(fields[4 + i]);
    lines_.push_back(line);
}

const Known::Line* Known::line(const std::string& law, const std::string& method) const
{
    for (const Line& line : lines_)
        if (line.law == law && line.method == method) return &line;
    return nullptr;
}

double Known::ceiling(const Scene& scene, const Law& law, const Setting& setting) const
{
    const Line* found = line(name_of_law(scene, law), name_of(setting.method));
    return found ? found->ceilings[column_of(setting)] : kGood;
}

std::string Known::reason(const Scene& scene, const Law& law, Method method) const
{
    const Line* found = line(name_of_law(scene, law), name_of(method));
    return found ? found->reason : "";
}

void Known::write(const std::vector<Result>& results, const std::string& path) const
{
    std::vector<Line> lines = lines_;
    const auto cell_of = [&](const Result& result, const Law& law, bool create) -> double* {
        const std::string name = name_of_law(*result.cell.scene, law),
                          method = name_of(result.cell.setting.method);
        for (Line& line : lines)
            if (line.law == name && line.method == method)
                return &line.ceilings[column_of(result.cell.setting)];
        if (!create) return nullptr;
        lines.push_back({name, method, "new", {kGood, kGood, kGood, kGood, kGood, kGood}});
        return &lines.back().ceilings[column_of(result.cell.setting)];
    };
    for (const Result& result : results) {
        for (const Law& law : result.cell.scene->laws) {
            const double figure = result.figure(law);
            const bool fails = figure > law.kept(result.cell.setting);
            if (double* ceiling = cell_of(result, law, fails)) *ceiling = fails ? kMargin * figure : kGood;
        }
    }
    std::ofstream file(path);
    file << "# Cells of tests/trials that fail, why, and how bad they may be (tests/trials/known.h).\n";
    for (const auto& [name, text] : reasons_) file << "reason\t" << name << '\t' << text << '\n';
    for (const Scene* scene : all_scenes()) {
        for (const Line& line : lines) {
            if (line.law.substr(0, line.law.find('.')) != scene->name) continue;
            if (std::all_of(line.ceilings, line.ceilings + 6, [](double c) { return c < 0; })) continue;
            file << "fails\t" << line.law << '\t' << line.method << '\t' << line.reason;
            for (double ceiling : line.ceilings) file << '\t' << text_of_ceiling(ceiling);
            file << '\n';
        }
    }
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

std::string fault_of(const Known& known, const Result& result, const Law& law)
{
    const Setting& setting = result.cell.setting;
    const double figure = result.figure(law), bound = law.kept(setting),
                 ceiling = known.ceiling(*result.cell.scene, law, setting);
    char text[160];
    if (figure <= bound && ceiling < 0) return "";
    if (figure <= bound)
        std::snprintf(text, sizeof text, "now good (%.3g %s): remove the ceiling from known.tsv", figure,
                      law.unit);
    else if (ceiling < 0)
        std::snprintf(text, sizeof text, "%.3g %s, at most %.3g", figure, law.unit, bound);
    else if (figure > ceiling)
        std::snprintf(text, sizeof text, "%.3g %s, worse than the %.3g that known.tsv has", figure, law.unit,
                      ceiling);
    else
        return "";
    return name_of_law(*result.cell.scene, law) + ", " + text_of(setting) + ": " + text;
}

}  // namespace epode::trials
