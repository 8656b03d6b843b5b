// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// robots_mutated COUNT SEED FILE ...: COUNT mutations of the files in turn, read next to the file so that its meshes are found. What
// loads becomes a robot that makes two steps. Prints how many were refused and loaded, the most processor time that one took and
// the process's largest memory. A file that takes more than 2 s (EPODE_MUTATED_SECONDS: another limit; SDF's files take their time in
// libsdformat) or 1 GB is left in mutated_slow.ENDING, and the exit code is 1.
#include <sys/resource.h>
#include <time.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>

#include "mutate.h"
#include "robots/build.h"
#include "robots/load.h"

namespace {

using namespace epode::robots;

constexpr long kMaxKilobytes = 1000L * 1000;

struct Counts {
    long loaded = 0, refused = 0;
    double slowest = 0, all = 0;
    std::string slow;  // of which file
};

double seconds()
{
    timespec now;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return double(now.tv_sec) + 1e-9 * double(now.tv_nsec);
}

long kilobytes()
{
    rusage use;
    getrusage(RUSAGE_SELF, &use);
    return use.ru_maxrss;
}

void ignore_message(int, const char*, va_list) {}

std::string contents_of(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

void step(RobotModel model)
{
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dWorldUseDefaults(world, dDefaultsRobot);
    dWorldSetContactSpace(world, space);
    {
        const Robot robot(std::make_shared<const Prepared>(std::move(model)), world, space, {}, {});
        for (int i = 0; i < 2; ++i) dWorldStep(world, dReal(0.002));
    }
    dSpaceDestroy(space);
    dWorldDestroy(world);
}

bool judge(const std::string& path, const std::string& text, double limit, Counts& counts)
{
    const double begin = seconds();
    RobotModel model = load_robot_text(path, text);
    ++(model.has_errors() ? counts.refused : counts.loaded);
    if (!model.has_errors()) step(std::move(model));
    const double took = seconds() - begin;
    counts.all += took;
    if (took > counts.slowest) counts.slowest = took, counts.slow = path;
    if (took <= limit && kilobytes() <= kMaxKilobytes) return true;
    const std::string left = "mutated_slow" + path.substr(path.rfind('.'));
    std::ofstream(left, std::ios::binary) << text;
    std::printf("%s: of %s: %.2f s, %ld kB\n", left.c_str(), path.c_str(), took, kilobytes());
    return false;
}

}  // namespace

int main(int count, char** arguments)
{
    if (count < 4) return std::fprintf(stderr, "robots_mutated COUNT SEED FILE ...\n"), 2;
    const char* given = std::getenv("EPODE_MUTATED_SECONDS");
    const double limit = given ? std::atof(given) : 2;
    dInitODE2(0);
    dSetMessageHandler(&ignore_message);
    dSetErrorHandler(&ignore_message);
    dSetDebugHandler(&ignore_message);
    std::mt19937 random{unsigned(std::atol(arguments[2]))};
    Counts counts;
    bool good = true;
    for (long i = 0, files = count - 3; i < std::atol(arguments[1]) && good; ++i) {
        const std::string path = arguments[3 + i % files];
        good = judge(path, mutated(contents_of(path), random), limit, counts);
    }
    std::printf("%ld refused, %ld loaded; slowest %.3f s (%s), mean %.5f s, %ld kB\n", counts.refused,
                counts.loaded, counts.slowest, counts.slow.c_str(),
                counts.all / double(std::max(1L, counts.refused + counts.loaded)), kilobytes());
    dCloseODE();
    return good ? 0 : 1;
}
