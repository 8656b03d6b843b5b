// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Calls of the file system that POSIX and Windows name or mean differently, or WebAssembly lacks. Each
// returns what its POSIX original does; errno tells why it fails. On Windows a path is in the program's code
// page.
#pragma once

#include <fcntl.h>
#include <sys/stat.h>
#if defined(_WIN32)
#include <io.h>
#include <process.h>
#include <cerrno>
#ifndef NOMINMAX
#define NOMINMAX
#endif
#include <windows.h>
#else
#include <unistd.h>
#endif

#include <climits>
#include <cstdio>
#include <cstdlib>

namespace epode {

#if defined(_WIN32)

inline int open_to_read(const char* path) { return ::_open(path, _O_RDONLY | _O_BINARY | _O_NOINHERIT); }

inline int open_new(const char* path)
{
    return ::_open(path, _O_WRONLY | _O_CREAT | _O_EXCL | _O_BINARY | _O_NOINHERIT, _S_IREAD | _S_IWRITE);
}

inline int flush_to_disk(int file) { return ::_commit(file); }

// Programs make none here without rights of their own.
inline const char* end_of_links(const char*, char*) { return nullptr; }

// Over an existing file, too, which rename() refuses here.
inline int replace_file(const char* from, const char* to)
{
    if (::MoveFileExA(from, to, MOVEFILE_REPLACE_EXISTING)) return 0;
    errno = EACCES;
    return -1;
}

#else

// A pipe without a writer must not keep the caller waiting.
inline int open_to_read(const char* path) { return ::open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK); }

inline int open_new(const char* path) { return ::open(path, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666); }

inline int flush_to_disk(int file) { return ::fsync(file); }

// The file that the path leads to through symbolic links, in `to` of PATH_MAX bytes. Null: none, or it is no link.
inline const char* end_of_links(const char* path, char* to)
{
#if defined(__wasm__)
    (void)path, (void)to;
    return nullptr;
#else
    struct stat about;
    return ::lstat(path, &about) == 0 && S_ISLNK(about.st_mode) ? ::realpath(path, to) : nullptr;
#endif
}
inline int replace_file(const char* from, const char* to) { return ::rename(from, to); }

#endif

// Differs between the processes that may write a file at the same time; in WebAssembly they are unknown.
inline long process_number()
{
#if defined(__wasm__)
    return 0;
#else
    return long(::getpid());
#endif
}

}  // namespace epode
