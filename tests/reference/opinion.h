// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What another library thinks of two convex solids. Each library is one file and one entry of kOpinions.
#pragma once

#include "solid.h"

namespace epode::reference {

struct Verdict {
    bool meet = false;
    bool silent = false;  // they meet, but it finds no depth
    double depth = 0;     // if they meet
    Point way{};          // unit, along which one must be moved by the depth
};

using Opinion = Verdict (*)(const Solid&, const Solid&);

#ifdef EPODE_WITH_CCD
Verdict ccd_opinion(const Solid& a, const Solid& b);
#endif
#ifdef EPODE_WITH_FCL
Verdict fcl_opinion(const Solid& a, const Solid& b);
#endif

struct NamedOpinion {
    const char* name;
    Opinion ask;
    const char* absent;  // the kind of solid that it has no shape for, or ""
    int misses;  // of ten thousand poses at most, known to be its own: another opinion is with the library
};

inline constexpr NamedOpinion kOpinions[] = {
#ifdef EPODE_WITH_CCD
    {"libccd", ccd_opinion, "", 1},  // spheres
#endif
#ifdef EPODE_WITH_FCL
    {"libfcl", fcl_opinion, "tapered", 5},  // polyhedra
#endif
};

}  // namespace epode::reference
