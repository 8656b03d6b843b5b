// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The recorder's library lies in ../lib beside this program, in the build tree and where it is installed
// (../lib/TRIPLET too). Whatever was preloaded before stays.
#include "cli/capture.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "cli/plan.h"

namespace epode::cli {

namespace {

namespace fs = std::filesystem;
constexpr const char* kLibrary = "libepode_preload.so";

// "" where there is none.
std::string find_library()
{
    std::error_code error;
    const fs::path lib = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path() / "lib";
    if (fs::exists(lib / kLibrary, error)) return (lib / kLibrary).string();
    for (const fs::directory_entry& entry : fs::directory_iterator(lib, error)) {
        if (fs::exists(entry.path() / kLibrary, error)) return (entry.path() / kLibrary).string();
    }
    return {};
}

}  // namespace

int capture(const CaptureOptions& options)
{
    scenes::Stepper stepper;
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, stepper))
        return refuse(scenes::no_such_stepper(options.stepper));
    std::string library = find_library();
    if (library.empty()) return refuse(fmt::format("there is no {} beside this program", kLibrary));
    if (const char* before = std::getenv("LD_PRELOAD"); before && *before) library.append(":").append(before);
    setenv("LD_PRELOAD", library.c_str(), 1);
    setenv("EPODE_RECORD", fs::absolute(options.output).c_str(), 1);
    if (!options.stepper.empty()) setenv("EPODE_RECORD_STEPPER", options.stepper.c_str(), 1);
    std::vector<char*> arguments;
    for (const std::string& argument : options.command)
        arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    execvp(arguments[0], arguments.data());
    return refuse(fmt::format("cannot start '{}': {}", options.command[0], std::strerror(errno)));
}

}  // namespace epode::cli
