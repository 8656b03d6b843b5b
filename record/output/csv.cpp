// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// 17 digits: every double comes back as itself.
#include "record/output/csv.h"

#include <cerrno>
#include <cstdio>
#include <cstring>

#include "record/output/digits.h"

namespace epode::record {

bool write_csv(const Recording& recording, const std::string& path, std::string& problem)
{
    std::FILE* file = std::fopen(path.c_str(), "w");
    if (!file) {
        problem = std::strerror(errno);
        return false;
    }
    std::fputs("step,time,body,x,y,z,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n", file);
    for (size_t step = 0; step < recording.steps.size(); ++step) {
        const auto numbers = recording.living(step);
        const Step& now = recording.steps[step];
        for (size_t i = 0; i < now.bodies.size(); ++i) {
            const BodyState& body = now.bodies[i];
            std::fprintf(file, "%zu,%s,%u", step, digits_of(now.time, 17).c_str(), numbers[i]);
            const auto write = [&](const auto& values) {
                for (double value : values) std::fprintf(file, ",%s", digits_of(value, 17).c_str());
            };
            write(body.pose.pos), write(body.pose.turn), write(body.linear), write(body.angular);
            std::fputc('\n', file);
        }
    }
    const bool written = std::ferror(file) == 0;
    if (std::fclose(file) == 0 && written) return true;
    problem = errno ? std::strerror(errno) : "write error";
    return false;
}

}  // namespace epode::record
