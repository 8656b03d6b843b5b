// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The recorder's library is in ../lib next to this program in the build tree, in ../lib/epode where it is installed, or in
// ../lib/TRIPLET/epode. Whatever was preloaded before stays. The program runs as a child, so that somebody is
// left to say what was recorded, or that nothing was, and to make whole what a signal has cut off.
#include "cli/capture.h"

#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>

#include "cli/console.h"
#include "cli/paths.h"
#include "cli/plan.h"
#include "record/file/file_end.h"
#include "record/file/file_names.h"

extern char** environ;

namespace epode::cli {

namespace {

namespace fs = std::filesystem;
constexpr const char* kLibrary = "libepode_preload.so";

// "" where there is none.
std::string find_library()
{
    std::error_code error;
    const fs::path lib = fs::read_symlink("/proc/self/exe", error).parent_path().parent_path() / "lib";
    std::vector<fs::path> folders{lib, lib / "epode"};
    for (const fs::directory_entry& entry : fs::directory_iterator(lib, error))
        folders.push_back(entry.path() / "epode");
    for (const fs::path& folder : folders)
        if (fs::exists(folder / kLibrary, error)) return (folder / kLibrary).string();
    return {};
}

// What changes when a file is written, whatever its name was before.
struct FileState {
    bool there = false;
    ino_t inode = 0;
    off_t size = 0;
    long seconds = 0, nanoseconds = 0;
    bool operator==(const FileState&) const = default;
};

FileState state_of(const std::string& path)
{
    struct stat status;
    if (stat(path.c_str(), &status) != 0) return {};
    return {true, status.st_ino, status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec};
}

pid_t child = -1;

// Ctrl+C reaches the program by itself; what is sent to us alone is passed on.
void pass_on(int signal)
{
    if (child > 0) kill(child, signal);
}
void wait_on(int) {}

void watch_signals()
{
    struct sigaction action = {};
    action.sa_flags = SA_RESTART;
    // Handlers, which the program does not inherit, rather than SIG_IGN, which it would.
    action.sa_handler = wait_on;
    for (int signal : {SIGINT, SIGQUIT}) sigaction(signal, &action, nullptr);
    action.sa_handler = pass_on;
    for (int signal : {SIGTERM, SIGHUP}) sigaction(signal, &action, nullptr);
}

// 0, or errno.
int start(const std::vector<std::string>& command)
{
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    sigset_t as_usual;
    sigemptyset(&as_usual);
    sigaddset(&as_usual, SIGPIPE);
    posix_spawnattr_t attributes;
    posix_spawnattr_init(&attributes);
    posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETSIGDEF);
    posix_spawnattr_setsigdefault(&attributes, &as_usual);
    const int failed = posix_spawnp(&child, arguments[0], nullptr, &attributes, arguments.data(), environ);
    posix_spawnattr_destroy(&attributes);
    return failed;
}

// Of one world. False where there is a file that is no good.
bool report_file(const std::string& path, bool quiet)
{
    record::FileEnd end;
    std::string problem;
    if (!record::find_end(path, end, problem)) return complain(path, problem) == kFine;
    const bool cut_off = !end.complete;
    if (cut_off && !record::complete_file(path, end, problem)) return complain(path, problem) == kFine;
    if (!quiet || cut_off)
        warn(
            "'{}': {} states on {} {}{}", path, end.states, end.about["library_kind"], end.about["library"],
            cut_off ? "; the program did not end it, so it was made whole after the last state on disk" : "");
    return true;
}

int report_nothing(const std::string& program, int code)
{
    warn(
        "nothing was recorded: '{}' made no body and no step of a libode.so.8 that is loaded at run time. It "
        "uses no ODE, or one that is linked statically, in single precision, or looked up by dlsym.",
        program);
    return code == kFine ? int(kProblem) : code;
}

}  // namespace

int capture(const CaptureOptions& options)
{
    scenes::Stepper stepper;
    std::string problem;
    if (!options.stepper.empty() && !scenes::stepper_named(options.stepper, stepper))
        return refuse(no_such_stepper(options.stepper));
    if (!can_write(options.output, problem)) return complain(options.output, problem);
    std::string library = find_library();
    if (library.empty()) return refuse(fmt::format("there is no {} next to this program", kLibrary));
    if (const char* before = secure_getenv("LD_PRELOAD"); before && *before)
        library.append(":").append(before);
    const std::string output = fs::absolute(options.output).string();
    setenv("LD_PRELOAD", library.c_str(), 1);
    setenv("EPODE_RECORD", output.c_str(), 1);
    if (!options.stepper.empty()) setenv("EPODE_RECORD_STEPPER", options.stepper.c_str(), 1);

    std::vector<FileState> before;
    for (int number = 1; number == 1 || before.back().there; ++number)
        before.push_back(state_of(record::numbered_path(output, number)));
    watch_signals();
    if (const int failed = start(options.command))
        return refuse(fmt::format("cannot start '{}': {}", options.command[0], std::strerror(failed)));
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    int code = WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
    if (WIFSIGNALED(status))
        warn("'{}' was ended by signal {} ({})", options.command[0], WTERMSIG(status),
             strsignal(WTERMSIG(status)));

    for (int number = 1;; ++number) {
        const FileState was = size_t(number) <= before.size() ? before[size_t(number - 1)] : FileState{};
        const std::string path = record::numbered_path(output, number);
        if (state_of(path) == was) return number == 1 ? report_nothing(options.command[0], code) : code;
        if (!report_file(path, options.quiet) && code == kFine) code = kProblem;
    }
}

}  // namespace epode::cli
