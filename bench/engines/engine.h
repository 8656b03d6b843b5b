// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a benchmark asks of an engine. An engine is made from a scene's data and keeps it in its own form; a
// new one is one file with an EngineEntry and one line in engines.inc. Two ways to use one library are two
// engines: ODE's callback with contact joints is one, world-managed contacts are another on the
// same OdeScene.
#pragma once

#include <memory>

#include "bench/measure/quality.h"

namespace epode::bench {

struct EngineOptions {
    int iterations = 0;  // 0: the engine's own
    int threads = 1;
    std::string stepper;             // ODE: exact, quick or fast; empty: the scene's own
    std::string space = "hash";      // ODE: hash, quadtree or sap
    int contacts = 8;                // ODE: of a pair, at most
    bool manifold_friction = false;  // managed, hybrid: one for the points of a manifold
};

// Milliseconds of a step's stages.
struct StageTimes {
    double collide = 0, solve = 0, rest = 0;
    double total() const { return collide + solve + rest; }
};

struct RayAnswer {
    int hits = 0;
    double distance = 0;  // sum over the nearest hits
};

class Engine {
  public:
    virtual ~Engine() = default;
    virtual std::string version() const = 0;
    // One dt from `time` on.
    virtual StageTimes step(double time) = 0;
    virtual void read(State& state) const = 0;
    virtual RayAnswer cast(const std::vector<RayData>& rays) = 0;
    // Puts the bodies there; the number of pairs whose bounding boxes meet.
    virtual int pairs_at(const std::vector<Vec>& places) = 0;
    // Contact points of the last step.
    virtual int contacts() = 0;
};

struct EngineEntry {
    const char* name;
    const char* about;
    // Null, with the reason in `refusal`, when it cannot have this scene or these options.
    std::unique_ptr<Engine> (*make)(const SceneData&, const EngineOptions&, std::string& refusal);
};

const std::vector<const EngineEntry*>& engine_entries();

}  // namespace epode::bench
