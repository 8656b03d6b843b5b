// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Scenes only ever add.
#include "view/session/scene_recorder.h"

#include <algorithm>

namespace epode::view {

SceneRecorder::SceneRecorder(scenes::Scene& scene, record::Sink& sink) : scene_(scene), recorder_(sink)
{
    scene.want_forces(true);
}

void SceneRecorder::add_new()
{
    for (; bodies_ < scene_.bodies().size(); ++bodies_) recorder_.add(scene_.bodies()[bodies_]);
    for (; geoms_ < scene_.geoms().size(); ++geoms_) recorder_.add(scene_.geoms()[geoms_]);
    for (; joints_ < scene_.joints().size(); ++joints_) recorder_.add(scene_.joints()[joints_].joint);
}

void SceneRecorder::state(const scenes::Quality& quality, double dt)
{
    add_new();
    contacts_.clear();
    for (const scenes::ContactRecord& from : scene_.contacts()) {
        record::ContactSeen& to = contacts_.emplace_back();
        to.geom[0] = from.geom1;
        to.geom[1] = from.geom2;
        to.depth = from.depth;
        std::copy_n(from.pos, 3, to.pos);
        std::copy_n(from.normal, 3, to.normal);
        std::copy_n(from.force, 3, to.force);
    }
    record::StepFigures figures;
    figures.time = scene_.time();
    figures.dt = dt;
    figures.kinetic = quality.kinetic;
    figures.potential = quality.potential;
    figures.joint_error = quality.joint_error;
    figures.ms = scene_.times().total_ms();
    recorder_.step(figures, contacts_, true);
}

}  // namespace epode::view
