/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Opens the library that is named, binding everything at once, and asks it for its precision.
 */
#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

int main(int argc, char** argv)
{
    void* library = argc == 2 ? dlopen(argv[1], RTLD_NOW | RTLD_LOCAL) : NULL;
    const char* (*configuration)(void) = NULL;
    if (library == NULL) {
        fprintf(stderr, "%s\n", dlerror());
        return 1;
    }
    *(void**)&configuration = dlsym(library, "dGetConfiguration");
    if (configuration == NULL) return 1;
    printf("opens: %s: %s\n", argv[1], configuration());
    return strstr(configuration(), strstr(argv[1], "single") ? "single" : "double") ? 0 : 1;
}
