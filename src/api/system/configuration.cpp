// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How this library was built, in ODE's words: those of Debian's libode8, since a program asks for a token to
// learn which interface it may use, and meshes are ODE's own (OPCODE), not GIMPACT's.
#include "ode/common.h"

#include <cstring>

#include "base/check.h"

using namespace epode;

#ifdef dIDESINGLE
#define EPODE_PRECISION_TOKEN "ODE_single_precision"
#else
#define EPODE_PRECISION_TOKEN "ODE_double_precision"
#endif

namespace {

constexpr const char* kConfiguration =
    "ODE ODE_EXT_trimesh ODE_EXT_opcode ODE_OPC_new_collider ODE_EXT_threading "
    "ODE_THR_builtin_impl " EPODE_PRECISION_TOKEN;

// Is the text at `place`, of this length, bounded by spaces or the ends of the configuration?
bool is_word(const char* place, std::size_t length)
{
    const bool begins = place == kConfiguration || place[-1] == ' ';
    return begins && (place[length] == ' ' || place[length] == 0);
}

}  // namespace

extern "C" const char* dGetConfiguration(void) { return kConfiguration; }

extern "C" int dCheckConfiguration(const char* token)
{
    EPODE_USER(token, 0);
    const std::size_t length = std::strlen(token);
    if (length == 0 || std::strchr(token, ' ')) return 1;  // as ODE answers what is no word
    for (const char* at = std::strstr(kConfiguration, token); at; at = std::strstr(at + 1, token))
        if (is_word(at, length)) return 1;
    return 0;
}
