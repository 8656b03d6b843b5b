// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions that not every library with ODE's interface has, by name at run time: null where there is none. They are
// sought in the very library that this code calls: in the Python package it is part of an extension module, whose
// names no other library sees, and a libode.so.8 of other code in the process is not meant.
#pragma once

#include <dlfcn.h>
#include <ode/ode.h>

namespace epode::record {

inline void* library_function(const char* name)
{
    static void* const library = [] {
        Dl_info info;
        if (!dladdr(reinterpret_cast<void*>(&dWorldCreate), &info)) return static_cast<void*>(RTLD_DEFAULT);
        return dlopen(info.dli_fname, RTLD_LAZY | RTLD_NOLOAD);
    }();
    return dlsym(library ? library : RTLD_DEFAULT, name);
}

}  // namespace epode::record
