// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Linked into clients that are not ours: before main, prints which libode.so.8 is in this process, from the
// process map ("#library PATH INODE"), so that the judge knows what was measured.
#include <cstdio>
#include <cstring>

namespace {

struct Preamble {
    Preamble()
    {
        char line[4096];
        std::FILE* maps = std::fopen("/proc/self/maps", "r");
        while (maps && std::fgets(line, sizeof line, maps)) {
            unsigned long inode = 0;
            char path[4096] = "";
            if (std::strstr(line, "/libode.so") &&
                std::sscanf(line, "%*s %*s %*s %*s %lu %4095s", &inode, path) == 2) {
                std::printf("#library %s %lu\n", path, inode);
                break;
            }
        }
        if (maps) std::fclose(maps);
        std::fflush(stdout);
    }
} preamble;

}  // namespace
