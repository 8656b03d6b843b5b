// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See paths.h.
#include "cli/paths.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>

namespace epode::cli {

namespace {

// Of "a.png": "."; of "/a.png": "/".
std::string folder_of(const std::string& path)
{
    const size_t slash = path.rfind('/');
    if (slash == std::string::npos) return ".";
    return path.substr(0, slash == 0 ? 1 : slash);
}

bool fail(int reason, std::string& problem)
{
    problem = std::strerror(reason);
    return false;
}

}  // namespace

bool can_write(const std::string& path, std::string& problem)
{
    struct stat status;
    if (path.empty()) return fail(ENOENT, problem);
    if (stat(path.c_str(), &status) == 0) {
        if (S_ISDIR(status.st_mode)) return fail(EISDIR, problem);
        return access(path.c_str(), W_OK) == 0 || fail(errno, problem);
    }
    if (errno != ENOENT || path.back() == '/') return fail(path.back() == '/' ? EISDIR : errno, problem);
    const std::string folder = folder_of(path);
    if (stat(folder.c_str(), &status) != 0) return fail(errno, problem);
    if (!S_ISDIR(status.st_mode)) return fail(ENOTDIR, problem);
    return access(folder.c_str(), W_OK | X_OK) == 0 || fail(errno, problem);
}

}  // namespace epode::cli
