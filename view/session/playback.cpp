// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See playback.h.
#include "view/session/playback.h"

#include "record/file/reader.h"
#include "view/session/ray.h"

namespace epode::view {

std::unique_ptr<Playback> Playback::open(const std::string& path, std::string& problem)
{
    auto playback = std::make_unique<Playback>();
    playback->stage_ = std::make_unique<Stage>();
    const record::ReadResult result = record::read_file(path, *playback->stage_);
    problem = result.problem;
    const bool usable = result.whole() || result.damage == record::Damage::kBreaksOff;
    if (!usable) return nullptr;
    if (playback->stage_->empty()) {
        if (problem.empty()) problem = "it has no state";
        return nullptr;
    }
    playback->title_ = path.substr(path.find_last_of('/') + 1);
    return playback;
}

bool Playback::seek(size_t number)
{
    if (number < stage_->first() || number > stage_->last()) return false;
    now_ = number;
    return true;
}

std::optional<Hit> Playback::pick(Vec origin, Vec direction)
{
    return closest_triangle(*stage_, moment(), origin, direction);
}

double Playback::next_dt() const
{
    if (now_ >= stage_->last()) return 0;
    const double dt = stage_->at(now_ + 1).step.time - stage_->at(now_).step.time;
    return dt > 0 ? dt : 1e-3;
}

}  // namespace epode::view
