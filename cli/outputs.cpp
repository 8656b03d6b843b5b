// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The ending of a name decides the format (export.h). What is written at the end is tried at the start, so
// that a wrong path costs no time.
#include "cli/outputs.h"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>

#include "cli/about.h"
#include "cli/export.h"

namespace epode::cli {

void Outputs::Fan::info(const record::Info& info)
{
    for (record::Sink* sink : sinks) sink->info(info);
}

void Outputs::Fan::shape(const record::Shape& shape)
{
    for (record::Sink* sink : sinks) sink->shape(shape);
}

void Outputs::Fan::body(const record::Body& body)
{
    for (record::Sink* sink : sinks) sink->body(body);
}

void Outputs::Fan::geom(const record::Geom& geom)
{
    for (record::Sink* sink : sinks) sink->geom(geom);
}

void Outputs::Fan::joint(const record::Joint& joint)
{
    for (record::Sink* sink : sinks) sink->joint(joint);
}

void Outputs::Fan::gone(record::ObjectKind kind, std::uint32_t number)
{
    for (record::Sink* sink : sinks) sink->gone(kind, number);
}

void Outputs::Fan::moved(std::uint32_t geom, std::int32_t body, const record::Pose& pose)
{
    for (record::Sink* sink : sinks) sink->moved(geom, body, pose);
}

void Outputs::Fan::calls(const record::CallBlock& block)
{
    for (record::Sink* sink : sinks) sink->calls(block);
}

void Outputs::Fan::step(const record::Step& step)
{
    for (record::Sink* sink : sinks) sink->step(step);
}

bool Outputs::fail(const std::string& path, const std::string& why)
{
    if (problem_.empty()) problem_ = fmt::format("cannot write the recording '{}': {}", path, why);
    return false;
}

bool Outputs::open(const RunOptions& options, const RunPlan& plan, scenes::Scene& scene)
{
    fps_ = options.fps;
    for (const std::string& path : options.records) {
        if (format_of(path) == Format::kRecording) {
            auto writer = std::make_unique<record::FileWriter>();
            if (!writer->open(path)) return fail(path, writer->problem());
            fan_.sinks.push_back(writer.get());
            files_.emplace_back(path, std::move(writer));
            continue;
        }
        std::FILE* file = std::fopen(path.c_str(), "wb");
        if (!file) return fail(path, std::strerror(errno));
        std::fclose(file);
        exports_.push_back(path);
    }
    if (!exports_.empty()) {
        memory_ = std::make_unique<record::Recording>();
        fan_.sinks.push_back(memory_.get());
    }
    if (fan_.sinks.empty()) return true;
    fan_.info(about(scene, plan));
    recorder_ = std::make_unique<view::SceneRecorder>(scene, fan_);
    recorder_->state(scenes::measure(scene), 0);
    dt_ = plan.dt;
    return true;
}

void Outputs::step(const scenes::Quality& quality)
{
    if (recorder_) recorder_->state(quality, dt_);
}

void Outputs::diagnosis(const std::vector<scenes::Cause>& causes)
{
    record::Info info;
    for (size_t i = 0; i < causes.size(); ++i)
        info[fmt::format("{}{}", record::kDiagnosisKey, i + 1)] = causes[i].text;
    if (!info.empty()) fan_.info(info);
}

bool Outputs::close()
{
    for (auto& [path, writer] : files_) {
        if (!writer->close()) fail(path, writer->problem());
    }
    for (const std::string& path : exports_) {
        std::string why;
        if (!export_recording(*memory_, path, fps_, why)) fail(path, why);
    }
    return problem_.empty();
}

}  // namespace epode::cli
