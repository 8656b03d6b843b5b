// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// mechanism_step FIRST COUNT NOISE: one dWorldStep of random mechanisms on whichever libode.so.8 the loader
// finds, a line each: number, messages of the library (-1: it ended the program), cfm, then linear and
// angular velocities. NOISE > 0 moves every position and velocity by that many ulps at random before the
// step, which shows how far a library's own answer can be trusted. Only <ode/ode.h>: the program runs on both
// libraries (compare.py).
#include <sys/wait.h>
#include <unistd.h>

#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "mechanism.h"

namespace {

using namespace epode::mechanisms;

int said = 0;
void count_message(int, const char*, va_list) { ++said; }

std::string mapped_library()
{
    std::ifstream maps("/proc/self/maps");
    for (std::string line; std::getline(maps, line);) {
        const std::size_t path = line.find('/');
        if (path != std::string::npos && line.find("/libode.so", path) != std::string::npos)
            return line.substr(path);
    }
    return "none";
}

void shake(Mechanism& m, int number, double noise)
{
    parity::Random random("noise " + std::to_string(number) + " " + std::to_string(noise));
    const auto ulps = [&](dReal& x) { x += dReal(double(x) * noise * 2.2e-16 * random.range(-1, 1)); };
    std::vector<BodyState> all = m.state();
    for (BodyState& s : all)
        for (int i = 0; i < 3; ++i) ulps(s.pos[i]), ulps(s.v[i]), ulps(s.w[i]);
    m.put(all);
}

// Those on nothing turn exactly in ours (docs/compat.md, D49): here they keep their spin.
void leave_out_free_rotation(const Mechanism& m)
{
    for (dBodyID body : m.bodies)
        if (dBodyGetNumJoints(body) == 0) dBodySetGyroscopicMode(body, 0);
}

void run(int number, double noise)
{
    Mechanism m(number);
    m.collide();
    leave_out_free_rotation(m);
    if (noise > 0) shake(m, number, noise);
    said = 0;
    m.step();
    std::printf("%d %d %.3g", number, said, m.cfm);
    for (const BodyState& s : m.state())
        std::printf(" %.17g %.17g %.17g %.17g %.17g %.17g", double(s.v[0]), double(s.v[1]), double(s.v[2]),
                    double(s.w[0]), double(s.w[1]), double(s.w[2]));
    std::printf("\n");
}

// In a process of its own: the original ends the program when its answer is not a number.
void run_apart(int number, double noise)
{
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) {
        run(number, noise);
        std::fflush(stdout);
        _exit(0);
    }
    int status = 0;
    if (child < 0 || waitpid(child, &status, 0) != child || !WIFEXITED(status))
        std::printf("%d -1 0\n", number);
}

}  // namespace

int main(int argc, char** argv)
{
    if (argc < 4) {
        std::fprintf(stderr, "usage: mechanism_step FIRST COUNT NOISE\n");
        return 2;
    }
    std::printf("#library %s\n", mapped_library().c_str());
    dInitODE2(0);
    dSetMessageHandler(&count_message);
    const int first = std::atoi(argv[1]), count = std::atoi(argv[2]);
    for (int i = first; i < first + count; ++i) run_apart(i, std::atof(argv[3]));
    dCloseODE();
    return 0;
}
