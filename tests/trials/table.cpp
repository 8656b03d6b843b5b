// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "table.h"

#include <algorithm>
#include <cstdio>
#include <set>

namespace epode::trials {

namespace {

constexpr const char* kHead =
    "# Quality: laws in every setting\n"
    "\n"
    "**Which method keeps which law, at which step size?** Scenes with a known right outcome, each run with "
    "every stepper, both presets,\n"
    "three step sizes, and with sleeping allowed and not. The tables are made by one command, which takes "
    "about twenty minutes on two cores:\n"
    "\n"
    "    cmake --build --preset release --target trials && build/release/bin/trials check --write "
    "docs/quality.md\n"
    "\n"
    "| column | parameters | contacts | step |\n"
    "|---|---|---|---|\n"
    "| ode exact, ode quick | `dDefaultsOde` | joints made in a near callback | `dWorldStep`, "
    "`dWorldQuickStep` |\n"
    "| exact, quick, substeps | `dDefaultsOde` | world-managed contacts | `dWorldStep`, `dWorldQuickStep`, "
    "`dWorldStepFast1(world, h, 4)` |\n"
    "| game | `dDefaultsGame` | world-managed contacts | `dWorldStepHybrid` |\n"
    "| robot | `dDefaultsRobot` | world-managed contacts | `dWorldStepHybrid` |\n"
    "\n"
    "A cell is one figure: how far the scene is off the law, in the unit of its row; the row names the "
    "bound. After a slash stands the figure with\n"
    "sleeping allowed, where it differs. A **bold** figure exceeds the bound, and its letter is the reason, "
    "[below](#reasons). A figure with a number\n"
    "exceeds the bound as the guide says that this method does; the [list](#what-methods-cannot) has the "
    "weaker bound that it keeps. `time`: the cell\n"
    "took too long. A preset's bold cell is a fault of the preset. `tests/trials` has the scenes.\n"
    "\n";

std::string text_of_figure(double figure)
{
    char text[32];
    if (std::fabs(figure) < 1e-12) figure = 0;
    std::snprintf(text, sizeof text, std::fabs(figure) >= 1000 && figure < 1e6 ? "%.0f" : "%.2g", figure);
    return std::isfinite(figure) ? text : "inf";
}

// The results by cell, and the letters and numbers of reasons in the order in which they come.
class Page {
  public:
    Page(const std::vector<Result>& results, const Known& known) : known_(known)
    {
        for (const Result& result : results)
            cells_[key_of(*result.cell.scene, result.cell.setting)] = &result;
    }
    std::string text();

  private:
    struct Tally {
        int cells = 0, good = 0, weaker = 0, failing = 0;
    };

    static std::string key_of(const Scene& scene, const Setting& setting)
    {
        return std::string(scene.name) + '/' + text_of(setting);
    }
    const Result* find(const Scene& scene, const Setting& setting) const
    {
        const auto found = cells_.find(key_of(scene, setting));
        return found == cells_.end() ? nullptr : found->second;
    }
    std::string table(const std::string& subject);
    std::string rows(const Scene& scene, const Law& law);
    std::string cell(const Scene& scene, const Law& law, Method method, int step_size);
    std::string figure(const Result& result, const Law& law);
    std::string summary() const;
    std::string reasons() const;
    static std::string letter(size_t number);

    const Known& known_;
    std::map<std::string, const Result*> cells_;
    std::vector<std::string> letters_, numbers_;
    std::map<std::string, Tally> tallies_;
};

template <class List>
size_t index_of(List& list, const std::string& value)
{
    const auto found = std::find(list.begin(), list.end(), value);
    if (found != list.end()) return size_t(found - list.begin());
    list.push_back(value);
    return list.size() - 1;
}

std::string Page::letter(size_t number)
{
    const std::string last(1, char('a' + number % 26));
    return number < 26 ? last : letter(number / 26 - 1) + last;
}

std::string Page::figure(const Result& result, const Law& law)
{
    const Setting& setting = result.cell.setting;
    Tally& tally = tallies_[name_of(setting.method)];
    ++tally.cells;
    const double value = result.figure(law);
    const std::string text = result.ending == Ending::kTime    ? "time"
                             : result.ending == Ending::kCrash ? "crash"
                                                               : text_of_figure(value);
    if (value <= law.bound(setting)) return ++tally.good, text;
    if (value <= law.kept(setting)) {
        ++tally.weaker;
        return text + "<sup>" +
               std::to_string(1 +
                              index_of(numbers_, std::string(result.cell.scene->name) + ": " + law.text +
                                                     ". " + law.reason(setting) + ": at most " +
                                                     text_of_figure(law.kept(setting)) + " " + law.unit)) +
               "</sup>";
    }
    ++tally.failing;
    std::string reason = known_.reason(*result.cell.scene, law, setting.method);
    if (reason.empty()) reason = "new";
    return "**" + text + "**<sup>" + letter(index_of(letters_, reason)) + "</sup>";
}

std::string Page::cell(const Scene& scene, const Law& law, Method method, int step_size)
{
    const Result* awake = find(scene, {method, step_size, false});
    const Result* asleep = find(scene, {method, step_size, true});
    const std::string first = awake ? figure(*awake, law) : "";
    const std::string second = asleep ? figure(*asleep, law) : "";
    if (first.empty() || second.empty() || first == second) return first.empty() ? second : first;
    return first + " / " + second;
}

std::string Page::rows(const Scene& scene, const Law& law)
{
    std::string text;
    for (int step_size = 0; step_size < kStepSizeCount; ++step_size) {
        const double bound = law.bound({Method::kExact, step_size, false});
        text +=
            step_size == 0 ? "| **" + std::string(scene.name) + "**: " + law.text + ", " + law.unit : "| ";
        text += std::string(" | ") + name_of_step(step_size) + " | " + text_of_figure(bound);
        for (Method method : kMethods) text += " | " + cell(scene, law, method, step_size);
        text += " |\n";
    }
    return text;
}

std::string Page::table(const std::string& subject)
{
    std::string text, single, titles;
    for (const Scene* scene : all_scenes()) {
        if (scene->subject != subject) continue;
        titles += std::string("- **") + scene->name + "**: " + scene->title + ".\n";
        for (const Law& law : scene->laws) {
            if (!scene->one_setting)
                text += rows(*scene, law);
            else if (const Result* result = find(*scene, {}))
                single += std::string("| **") + scene->name + "**: " + law.text + ", " + law.unit + " | " +
                          text_of_figure(law.bound({})) + " | " + figure(*result, law) + " |\n";
        }
    }
    std::string page = "## " + subject + "\n" + titles + "\n";
    if (!text.empty()) {
        page += "| law | h | bound";
        std::string line = "|---|---|---";
        for (Method method : kMethods) page += std::string(" | ") + name_of(method), line += "|---";
        page += " |\n" + line + "|\n" + text + "\n";
    }
    if (!single.empty()) page += "| law, in any setting | bound | figure |\n|---|---|---|\n" + single + "\n";
    return page;
}

std::string Page::summary() const
{
    std::string text =
        "| | figures | keep the law | keep what the guide says | fail |\n|---|---|---|---|---|\n";
    for (Method method : kMethods) {
        const auto found = tallies_.find(name_of(method));
        const Tally tally = found == tallies_.end() ? Tally{} : found->second;
        text += std::string("| ") + name_of(method) + " | " + std::to_string(tally.cells) + " | " +
                std::to_string(tally.good) + " | " + std::to_string(tally.weaker) + " | " +
                std::to_string(tally.failing) + " |\n";
    }
    return text + "\n";
}

std::string Page::reasons() const
{
    std::string text = "## Reasons\nWhy bold figures exceed their bounds.\n\n| | |\n|---|---|\n";
    for (size_t i = 0; i < letters_.size(); ++i) {
        const auto found = std::find_if(known_.reasons().begin(), known_.reasons().end(),
                                        [&](const auto& reason) { return reason.first == letters_[i]; });
        text += "| " + letter(i) + " | " +
                (found == known_.reasons().end() ? "not yet explained" : found->second) + " |\n";
    }
    text += "\n## What methods cannot\nWeaker bounds, as the guide has them.\n\n| | |\n|---|---|\n";
    for (size_t i = 0; i < numbers_.size(); ++i)
        text += "| " + std::to_string(i + 1) + " | " + numbers_[i] + " |\n";
    return text;
}

std::string Page::text()
{
    std::vector<std::string> subjects;
    std::string tables;
    for (const Scene* scene : all_scenes()) index_of(subjects, scene->subject);
    for (const std::string& subject : subjects) tables += table(subject);
    return kHead + summary() + tables + reasons();
}

}  // namespace

std::string quality_page(const std::vector<Result>& results, const Known& known)
{
    return Page(results, known).text();
}

std::string ranking(const std::vector<Result>& results, const Known& known)
{
    struct Entry {
        bool preset;
        double excess;
        std::string text;
    };
    std::vector<Entry> entries;
    for (const Result& result : results) {
        const Setting& setting = result.cell.setting;
        for (const Law& law : result.cell.scene->laws) {
            const double value = result.figure(law), bound = law.kept(setting);
            if (value <= bound) continue;
            char text[300];
            std::snprintf(text, sizeof text, "%-10s %-24s %-22s %10s %-6s bound %-8.3g %s: %s\n",
                          text_of_figure(value / bound).c_str(), text_of(setting).c_str(),
                          (std::string(result.cell.scene->name) + "." + law.name).c_str(),
                          result.ending == Ending::kTime    ? "time"
                          : result.ending == Ending::kCrash ? "crash"
                                                            : text_of_figure(value).c_str(),
                          law.unit, bound, law.text,
                          known.reason(*result.cell.scene, law, setting.method).c_str());
            entries.push_back({(Method::kGame | Method::kRobot) >> int(setting.method) & 1 ? true : false,
                               value / bound, text});
        }
    }
    std::stable_sort(entries.begin(), entries.end(), [](const Entry& a, const Entry& b) {
        return a.preset != b.preset ? a.preset : a.excess > b.excess;
    });
    std::string text;
    for (const Entry& entry : entries) text += entry.text;
    return text;
}

}  // namespace epode::trials
