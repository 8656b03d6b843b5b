// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The frame of a recording on disk, without reading what is in it: how far it is whole, and how one that
// breaks off, since its program was ended, is made whole at the last state that reached the disk.
#pragma once

#include <cstdint>
#include <string>

#include "record/file/recording.h"

namespace epode::record {

struct FileEnd {
    Info about;
    std::uint64_t states = 0;
    std::uint64_t size = 0;  // of all that is whole
    bool complete = false;   // it ends as a recording does
};

// False and why: it cannot be read, or is no recording.
bool find_end(const std::string& path, FileEnd& end, std::string& problem);
// Takes off what is not whole and ends the file properly. False and why.
bool complete_file(const std::string& path, const FileEnd& end, std::string& problem);

}  // namespace epode::record
