// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// robots_round_trip ROOT FILE ...: reads each file, writes it in its own format and in the other one, and reads both. Prints
// a line for each file whose own format does not give the same model, or whose other one is not read; files with
// errors are left out. Exit code 1 if there is such a line. scripts/robots-corpus calls it.
#include <cstdio>

#include "robots/load.h"
#include "robots/write/write.h"
#include "same_model.h"

namespace {

using namespace epode::robots;

struct Counts {
    int files = 0, same = 0, other_is_read = 0;
};

std::string first_error(const RobotModel& model)
{
    for (const ReportLine& line : model.report)
        if (line.note == Note::kError) return line.text;
    return {};
}

// Next to the file, so that its meshes are found as before.
RobotModel written_and_read(const RobotModel& model, const std::string& path, bool as_urdf,
                            const LoadOptions& options)
{
    const std::string folder = path.substr(0, path.rfind('/'));
    const WrittenRobot written = as_urdf ? write_urdf(model, folder) : write_mjcf(model, folder);
    return load_robot_text(folder + (as_urdf ? "/written.urdf" : "/written.xml"), written.text, options);
}

void judge(const std::string& path, const LoadOptions& options, Counts& counts)
{
    const RobotModel model = load_robot(path, options);
    if (model.has_errors()) return;
    ++counts.files;
    const bool is_urdf = model.format == "URDF";
    const RobotModel again = written_and_read(model, path, is_urdf, options);
    const std::vector<std::string> found =
        again.has_errors() ? std::vector{first_error(again)} : differences(model, again);
    counts.same += found.empty();
    if (!found.empty())
        std::printf("%s: %zu differences, first: %s\n", path.c_str(), found.size(), found[0].c_str());
    const RobotModel other = written_and_read(model, path, !is_urdf, options);
    counts.other_is_read += !other.has_errors();
    if (other.has_errors())
        std::printf("%s: as %s: %s\n", path.c_str(), is_urdf ? "MJCF" : "URDF", first_error(other).c_str());
}

}  // namespace

int main(int count, char** arguments)
{
    LoadOptions options;
    options.keep_fixed = options.repair = options.inertia_from_shapes = true, options.missing_mass = 1e-3;
    if (count > 1) options.roots = {arguments[1]};
    Counts counts;
    for (int i = 2; i < count; ++i) judge(arguments[i], options, counts);
    std::printf("%d files: %d the same after writing and reading, %d read in the other format\n",
                counts.files, counts.same, counts.other_is_read);
    return counts.same == counts.files && counts.other_is_read == counts.files ? 0 : 1;
}
