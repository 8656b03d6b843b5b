// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A file that is written at once. A full disk may show only when it is closed.
#pragma once

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <string>

namespace epode::record {

// `bytes`: a string or a vector of bytes. False and why where they cannot be written.
template <class Bytes>
bool write_whole(const std::string& path, const Bytes& bytes, std::string& problem)
{
    std::FILE* file = std::fopen(path.c_str(), "wb");
    const bool written = file && std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
    if (file && std::fclose(file) == 0 && written) return true;
    problem = errno ? std::strerror(errno) : "write error";
    return false;
}

}  // namespace epode::record
