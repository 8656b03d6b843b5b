// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// differences ours|debian DIFFERENCES.TSV: runs every check in a process of its own. On ours all must hold;
// on the original none may, or the difference has no right to be one. Every row of the table must have a
// check, or a reason below why it has none. `differences one ID` runs the checks of one by hand.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>
#include <cstring>
#include <fstream>
#include <set>
#include <string>

#include "difference.h"

namespace differences {

void note(const char* name, double value) { std::printf("    %s %.12g\n", name, value); }

void turn_at_random(dGeomID geom, Dice& dice)
{
    dMatrix3 R;
    dRFromAxisAndAngle(R, dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1), dice.in(-3, 3));
    dGeomSetRotation(geom, R);
}

namespace {

// Differences that no program can call wrong or right.
const std::set<std::string> kWithoutCheck = {
    "C14",  // touching exactly: rounding decides in both
    "C23",  // the answer is not unique
    "C35",  // which of two triangles owns an edge
};

void start()
{
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
}

const char* outcome_of(const Difference& difference)
{
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        if (!std::freopen("/dev/null", "w", stderr) || !std::freopen("/dev/null", "w", stdout)) _exit(2);
        alarm(5);
        start();
        _exit(difference.holds() ? 0 : 1);
    }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) return WTERMSIG(status) == SIGALRM ? "does not end" : "ends the program";
    return WEXITSTATUS(status) == 0   ? "holds"
           : WEXITSTATUS(status) == 1 ? "does not hold"
                                      : "ends the program";
}

int check_table(const char* path)
{
    std::set<std::string> known = kWithoutCheck;
    for (const Difference& d : list()) known.insert(d.id);
    std::ifstream table(path);
    int missing = 0, rows = 0;
    for (std::string line; std::getline(table, line);) {
        if (line.empty() || line[0] == '#') continue;
        const std::string id = line.substr(0, line.find('\t'));
        ++rows;
        if (known.count(id)) continue;
        std::printf("FAILED %s has no check\n", id.c_str());
        ++missing;
    }
    return rows ? missing : 1;
}

int run_all(bool ours)
{
    int bad = 0;
    for (const Difference& d : list()) {
        const char* outcome = outcome_of(d);
        const bool good = (std::strcmp(outcome, "holds") == 0) == ours;
        bad += !good;
        std::printf("%s %-4s %-16s %s\n", good ? "ok    " : "FAILED", d.id, outcome, d.promise);
    }
    return bad;
}

int run_one(const char* id)
{
    start();
    for (const Difference& d : list()) {
        if (std::strcmp(d.id, id) != 0) continue;
        std::printf("%s %s\n", d.id, d.promise);
        std::printf("    %s\n", d.holds() ? "holds" : "does not hold");
    }
    return 0;
}

}  // namespace
}  // namespace differences

int main(int argc, char** argv)
{
    using namespace differences;
    if (argc != 3) return 2;
    if (std::strcmp(argv[1], "one") == 0) return run_one(argv[2]);
    const int bad = run_all(std::strcmp(argv[1], "ours") == 0) + check_table(argv[2]);
    std::printf("%d checks, %d not as they must be\n", int(list().size()), bad);
    return bad ? 1 : 0;
}
