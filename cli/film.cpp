// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// posix_spawnp rather than popen: no shell reads the file's name, and a missing ffmpeg is not taken for a failing
// one. An encoder that dies closes the pipe; the write then fails instead of ending this program, which
// ignores SIGPIPE. The encoder is in a process group of its own, so that Ctrl+C does not end it before the
// film does.
#include "cli/film.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

#ifdef EPODE_HAVE_DRAWING
#include "viewer/png.h"
#endif

extern char** environ;

namespace epode::cli {

namespace {

bool write_all(int file, const std::uint8_t* bytes, size_t left)
{
    while (left > 0) {
        const ssize_t done = ::write(file, bytes, left);
        if (done < 0 && errno == EINTR) continue;
        if (done <= 0) return false;
        bytes += done;
        left -= size_t(done);
    }
    return true;
}

bool write_png([[maybe_unused]] const std::string& path, [[maybe_unused]] int width,
               [[maybe_unused]] int height, [[maybe_unused]] const std::vector<std::uint8_t>& rgb)
{
#ifdef EPODE_HAVE_DRAWING
    return viewer::write_rgb(path.c_str(), width, height, rgb.data());
#else
    return false;
#endif
}

}  // namespace

Film::~Film() { close(); }

// film.mp4 -> film-00001.png
std::string Film::png_name(int number) const
{
    const size_t dot = path_.rfind('.');
    return fmt::format("{}-{:05}.png", path_.substr(0, dot), number);
}

bool Film::start_encoder(const std::string& path, double fps)
{
    int ends[2];
    if (pipe2(ends, O_CLOEXEC) != 0) return false;
    const std::string size = fmt::format("{}x{}", width_, height_), rate = fmt::format("{:.9g}", fps);
    const std::vector<std::string> words = {
        "ffmpeg", "-loglevel", "error",    "-y",      "-f",        "rawvideo",   "-pix_fmt",
        "rgb24",  "-s",        size,       "-r",      rate,        "-i",         "-",
        "-c:v",   "libx264",   "-pix_fmt", "yuv420p", "-movflags", "+faststart", path};
    std::vector<char*> arguments;
    for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, ends[0], STDIN_FILENO);
    posix_spawnattr_t own_group;
    posix_spawnattr_init(&own_group);
    posix_spawnattr_setflags(&own_group, POSIX_SPAWN_SETPGROUP);
    const int failed = posix_spawnp(&encoder_, "ffmpeg", &actions, &own_group, arguments.data(), environ);
    posix_spawnattr_destroy(&own_group);
    posix_spawn_file_actions_destroy(&actions);
    ::close(ends[0]);
    if (failed) {
        ::close(ends[1]);
        encoder_ = -1;
        return false;
    }
    pipe_ = ends[1];
    return true;
}

bool Film::open(const std::string& path, int width, int height, double fps)
{
    path_ = path;
    width_ = width;
    height_ = height;
    // ffmpeg takes a name that begins with - for an option.
    if (!start_encoder(path.starts_with('-') ? "./" + path : path, fps)) first_png_ = png_name(1);
    return true;
}

bool Film::add(const std::vector<std::uint8_t>& rgb)
{
    if (!problem_.empty()) return false;
    ++pictures_;
    if (pipe_ >= 0) {
        if (!write_all(pipe_, rgb.data(), rgb.size())) problem_ = "ffmpeg stopped";
    } else if (!write_png(png_name(pictures_), width_, height_, rgb)) {
        problem_ = fmt::format("cannot write '{}': {}", png_name(pictures_), std::strerror(errno));
    }
    return problem_.empty();
}

bool Film::close()
{
    if (pipe_ >= 0) ::close(pipe_);
    pipe_ = -1;
    if (encoder_ > 0) {
        int status = 0;
        while (waitpid(encoder_, &status, 0) < 0 && errno == EINTR) {}
        if (status != 0 && problem_.empty()) problem_ = "ffmpeg failed";
        encoder_ = -1;
    }
    return problem_.empty();
}

}  // namespace epode::cli
