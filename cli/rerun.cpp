// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rerun.h. The recorded stepper gets the recorded contacts, another one contacts found again, unless
// --contacts says otherwise. A recording that another library made is another run: only distances then.
#include "cli/rerun.h"

#include <fmt/format.h>

#include "cli/about.h"
#include "cli/comparison.h"
#include "cli/console.h"
#include "cli/interrupt.h"
#include "cli/plan.h"
#include "cli/progress.h"
#include "record/file/writer.h"
#include "record/rerun/rerun.h"
#include "scenes/extensions.h"
#include "scenes/scene.h"

namespace epode::cli {

namespace {

// "" when it can be run again here.
std::string hindrance(const record::Recording& was)
{
    if (was.calls_made.empty()) return "it does not hold the program's calls, so it cannot be run again";
    return other_precision(was);
}

int say_interrupted(const ReplayOptions& options, size_t states, size_t of)
{
    warn("interrupted after state {} of {}", states, of);
    if (!options.output.empty()) warn("'{}' is whole and has the states until then", options.output);
    return interruption_code();
}

}  // namespace

int rerun(const ReplayOptions& options, const record::Recording& was)
{
    scenes::Stepper stepper;
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, stepper))
        return refuse(no_such_stepper(options.stepper));
    if (const std::string why = hindrance(was); !why.empty())
        return refuse(fmt::format("'{}': {}", options.file, why));
    const bool other = !options.stepper.empty() || options.iterations >= 0;
    const bool find = options.contacts.empty() ? other : options.contacts == "found";

    const scenes::Runtime runtime;
    record::Recording now;
    record::Rerun run(was, {options.stepper, options.iterations, find});
    Progress progress(was.about_value("program"), int(was.steps.size()), !options.quiet);
    const Interruptible file_is_made_whole;
    const bool whole = run.run(now, [&](size_t step) {
        progress.show(int(step), now.steps.back().contacts.size());
        return interruption() == 0;
    });
    if (!whole) return complain(options.file, run.problem());
    std::string problem;
    if (!options.output.empty() && !record::write_file(now, options.output, problem))
        return complain(options.output, problem);
    if (interruption()) return say_interrupted(options, now.steps.size(), was.steps.size());

    FieldList out;
    out.string("program", was.about_value("program"), "program", was.about_value("program"));
    const std::string recorded = was.about_value("stepper");
    out.string(
        "stepper", other && !options.stepper.empty() ? options.stepper : recorded, "stepper",
        options.stepper.empty() ? recorded : fmt::format("{}, recorded with {}", options.stepper, recorded));
    out.string("contacts", find ? "found" : "recorded", "contacts", find ? "found again" : "as recorded");
    const bool other_library = was.about_value("library") != scenes::loaded_library();
    return compare(was, now, other || find || other_library, out, options.json);
}

}  // namespace epode::cli
