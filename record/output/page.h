// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recording as one page for a browser: a template that holds the viewer (record/page, made once by npm and
// installed as a data file) with the recording put into it. What moves is packed: of each carrier, for the
// moments in which it moves, position in 3 x 16 bits of the box it moves in (error: its extent / 131070) and
// quaternion in 4 x 16 bits; 14 bytes a moment. Contacts are 11 bytes each, and fewer pictures of them where
// they would take more than 4 MB.
#pragma once

#include "record/file/recording.h"

namespace epode::record {

// The template's text; "" and where it was sought when there is none. It is sought where EPODE_PAGE says,
// else in ../share/epode/replay.html from the program (installed), else in ../../page/replay.html (build
// tree).
std::string page_template(std::string& problem);

bool write_page(const Recording& recording, const std::string& path, double fps, std::string& problem);

}  // namespace epode::record
