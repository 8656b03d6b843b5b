// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "result.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace epode::trials {

namespace {

constexpr const char* kEndings[] = {"done", "time", "crash"};

// JSON has no infinity.
std::string number(double value)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.6g", value);
    return std::isfinite(value) ? text : "1e999";
}

std::string line_of(const Result& result)
{
    std::string line = std::string("{\"scene\": \"") + result.cell.scene->name + "\", \"setting\": \"" +
                       text_of(result.cell.setting) + "\", \"ending\": \"" + kEndings[int(result.ending)] +
                       "\", \"seconds\": " + number(result.seconds) + ", \"figures\": {";
    const char* comma = "";
    for (const auto& [law, value] : result.figures) {
        line += comma + ("\"" + law + "\": " + number(value));
        comma = ", ";
    }
    return line + "}}";
}

// The text after "key": up to one of the ends.
std::string field(const std::string& line, const std::string& key, const char* ends)
{
    const size_t at = line.find("\"" + key + "\": ");
    if (at == std::string::npos) throw std::runtime_error("no " + key + " in: " + line);
    size_t begin = at + key.size() + 4;
    if (line[begin] == '"') ++begin, ends = "\"";
    return line.substr(begin, line.find_first_of(ends, begin) - begin);
}

Result result_of(const std::string& line)
{
    Result result{{scene_named(field(line, "scene", ",")), {}}};
    if (!result.cell.scene || !setting_named(field(line, "setting", ","), result.cell.setting))
        throw std::runtime_error("unknown scene or setting: " + line);
    const std::string ending = field(line, "ending", ",");
    for (int i = 0; i < 3; ++i)
        if (ending == kEndings[i]) result.ending = Ending(i);
    result.seconds = std::atof(field(line, "seconds", ",").c_str());
    for (const Law& law : result.cell.scene->laws)
        if (line.find(std::string("\"") + law.name + "\": ", line.find("figures")) != std::string::npos)
            result.figures[law.name] =
                std::strtod(field(line.substr(line.find("figures")), law.name, ",}").c_str(), nullptr);
    return result;
}

}  // namespace

double Result::figure(const Law& law) const
{
    const auto found = figures.find(law.name);
    return ending == Ending::kDone && found != figures.end() ? found->second : HUGE_VAL;
}

void write_json(const std::vector<Result>& results, const std::string& path)
{
    std::ofstream file(path);
    file << "[\n";
    for (size_t i = 0; i < results.size(); ++i)
        file << line_of(results[i]) << (i + 1 < results.size() ? ",\n" : "\n");
    file << "]\n";
    if (!file) throw std::runtime_error(path + ": cannot be written");
}

std::vector<Result> read_json(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::runtime_error(path + ": cannot be read");
    std::vector<Result> results;
    for (std::string line; std::getline(file, line);)
        if (line.size() > 2) results.push_back(result_of(line));
    return results;
}

}  // namespace epode::trials
