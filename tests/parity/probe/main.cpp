// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// parity_probe: drives libode through its public C interface and prints what comes out.
//
//   parity_probe [--poses N] CASE... | --all | --list
//
// One binary, two libraries: the dynamic linker decides by LD_LIBRARY_PATH which libode.so.8 is measured, and
// the first record, "#library PATH", is read from the process map, so that no one can compare a library
// with itself by accident. Linking twice was rejected: the headers used would then differ as well.
#include "case_list.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <string>

namespace parity {

int& poses_of_a_pair()
{
    static int poses = 1000;
    return poses;
}

std::vector<Case>& case_list()
{
    static std::vector<Case> list;
    return list;
}

namespace {

std::string mapped_library()
{
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const std::size_t path = line.find('/');
        if (path != std::string::npos && line.find("/libode.so", path) != std::string::npos) {
            return line.substr(path);
        }
    }
    return "none";
}

void run_case(const Case& chosen)
{
    Output out(chosen.name);
    Random random(chosen.name);
    chosen.run(out, random);
}

int list_cases()
{
    for (const Case& one : case_list()) { std::printf("%s\n", one.name); }
    return 0;
}

int run_all()
{
    for (const Case& one : case_list()) { run_case(one); }
    return 0;
}

int run_named(int count, char** names)
{
    for (int i = 0; i < count; ++i) {
        const auto same = [&](const Case& one) { return std::strcmp(one.name, names[i]) == 0; };
        const auto found = std::find_if(case_list().begin(), case_list().end(), same);
        if (found == case_list().end()) {
            std::fprintf(stderr, "parity_probe: unknown case '%s' (try --list)\n", names[i]);
            return 2;
        }
        run_case(*found);
    }
    return 0;
}

int run(int argc, char** argv)
{
    const auto by_name = [](const Case& a, const Case& b) { return std::strcmp(a.name, b.name) < 0; };
    std::sort(case_list().begin(), case_list().end(), by_name);
    if (argc > 3 && std::strcmp(argv[1], "--poses") == 0) {
        poses_of_a_pair() = std::atoi(argv[2]);
        argc -= 2, argv += 2;
    }
    if (argc < 2) {
        std::fprintf(stderr, "usage: parity_probe [--poses N] CASE... | --all | --list\n");
        return 2;
    }
    if (std::strcmp(argv[1], "--list") == 0) { return list_cases(); }
    std::printf("#library %s\n", mapped_library().c_str());
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
    count_library_messages();
    const int status = std::strcmp(argv[1], "--all") == 0 ? run_all() : run_named(argc - 1, argv + 1);
    dCloseODE();
    return status;
}

}  // namespace
}  // namespace parity

int main(int argc, char** argv) { return parity::run(argc, argv); }
