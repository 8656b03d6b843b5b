// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The command `epode` in this process: for `python -m epode`, which ends with it.
#include <nanobind/stl/vector.h>

#include "calls.h"

#ifdef EPODE_HAVE_COMMAND
#include "cli/command.h"
#endif

void bind_command(nb::module_& m)
{
#ifdef EPODE_HAVE_COMMAND
    m.def("run_command", [](const std::vector<std::string>& words) {
        std::vector<char*> pointers;
        for (const std::string& word : words) pointers.push_back(const_cast<char*>(word.c_str()));
        pointers.push_back(nullptr);
        const WithoutGil released;
        return epode::cli::run_command(int(words.size()), pointers.data());
    });
#else
    (void)m;
#endif
}
