// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// C's stdio rather than a stream: a full disk shows in ferror and fclose, and with its reason in errno.
#include "cli/trace.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

namespace epode::cli {

Trace::~Trace()
{
    if (file_) std::fclose(file_);
}

bool Trace::open(const std::string& path, const scenes::Scene& scene)
{
    file_ = std::fopen(path.c_str(), "w");
    if (!file_) {
        problem_ = std::strerror(errno);
        return false;
    }
    std::string line = "time,energy,kinetic,penetration,joint_error,residual,ms,contacts";
    for (size_t i = 0; i < scene.tracked.size(); ++i) line += fmt::format(",x{0},y{0},z{0}", i);
    put_line(line);
    return true;
}

void Trace::add(const scenes::Scene& scene, const scenes::Quality& quality, const scenes::RunRecord& record)
{
    if (!file_ || !problem_.empty()) return;
    std::string line = fmt::format("{:.9g},{:.9g},{:.9g},{:.6g},{:.6g},", scene.time(), quality.energy(),
                                   quality.kinetic, quality.penetration, quality.joint_error);
    if (record.has_residual) line += fmt::format("{:.6g}", record.last_residual);
    line += fmt::format(",{:.4g},{}", scene.times().total_ms(), scene.contacts().size());
    for (dBodyID body : scene.tracked) {
        const dReal* pos = dBodyGetPosition(body);
        line += fmt::format(",{:.9g},{:.9g},{:.9g}", pos[0], pos[1], pos[2]);
    }
    put_line(line);
}

// The reason of the first failure: errno says something else by the time the file is closed.
void Trace::put_line(const std::string& line)
{
    const bool written = std::fwrite(line.data(), 1, line.size(), file_) == line.size();
    if (!(written && std::fputc('\n', file_) != EOF)) problem_ = std::strerror(errno);
}

bool Trace::close()
{
    if (!file_) return true;
    if (std::fclose(file_) != 0 && problem_.empty()) problem_ = std::strerror(errno);
    file_ = nullptr;
    return problem_.empty();
}

}  // namespace epode::cli
