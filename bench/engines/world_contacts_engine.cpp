// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World-managed contacts: no callback, no contact joints, substeps. Of our library only; its
// names are asked for at run time, since this program runs on Debian's too.
#include <dlfcn.h>

#include <algorithm>
#include <iterator>

#include "bench/engines/ode_scene.h"
#include "bench/engines/stopwatch.h"
#include "scenes/extensions.h"

namespace epode::bench {

namespace {

using SetSpace = void (*)(dWorldID, dSpaceID);
using SetNumber = void (*)(dWorldID, int);
using Step = int (*)(dWorldID, dReal);
using GetContacts = int (*)(dWorldID, void*, int);

template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}

// The default material's friction is that of all scenes.
constexpr double kFriction = 0.6;

class WorldContactsEngine : public Engine {
  public:
    WorldContactsEngine(const SceneData& data, const EngineOptions& options)
        : scene_(data, options), wall_(options.threads > 1)
    {
        find<SetSpace>("dWorldSetContactSpace")(scene_.world(), scene_.space());
        if (options.manifold_friction) find<SetNumber>("dWorldSetManifoldFriction")(scene_.world(), 1);
    }

    std::string version() const override { return scenes::loaded_library(); }

    StageTimes step(double time) override
    {
        Stopwatch watch(wall_);
        scene_.drive(time);
        StageTimes times;
        times.rest = watch.lap();
        advance();
        times.solve = watch.lap();
        return times;
    }

    void read(State& state) const override { scene_.read(state); }
    RayAnswer cast(const std::vector<RayData>& rays) override { return scene_.cast(rays); }
    int contacts() override { return find<GetContacts>("dWorldGetContacts")(scene_.world(), nullptr, 0); }

    int pairs_at(const std::vector<Vec>& places) override { return scene_.pairs_at(places); }

  protected:
    virtual void advance() { scene_.advance(); }
    OdeScene scene_;

  private:
    bool wall_;
};

// Hybrid steps, each island in its own way, or all in the one that is asked for.
class HybridEngine : public WorldContactsEngine {
  public:
    HybridEngine(const SceneData& data, const EngineOptions& options) : WorldContactsEngine(data, options)
    {
        find<SetNumber>("dWorldSetHybridStepper")(scene_.world(), number_of(options.stepper));
        find<SetNumber>("dWorldSetHybridSubsteps")(scene_.world(), std::max(options.iterations, 4));
    }

  private:
    // As dStepper in ode/steppers.h.
    static int number_of(const std::string& stepper)
    {
        constexpr const char* kNames[] = {"", "exact", "joints", "fast", "quick"};
        return int(std::find(std::begin(kNames), std::end(kNames), stepper) - std::begin(kNames));
    }
    void advance() override { find<Step>("dWorldStepHybrid")(scene_.world(), dReal(scene_.data().dt)); }
};

bool has_all(const SceneData& data, const EngineOptions& options, std::string& refusal)
{
    if (!find<SetSpace>("dWorldSetContactSpace") || !scenes::has_step_fast())
        refusal = scenes::loaded_library() + " manages no contacts";
    if (options.manifold_friction && !find<SetNumber>("dWorldSetManifoldFriction"))
        refusal = scenes::loaded_library() + " has one friction per point";
    if (options.threads > 1 && !scenes::has_step_threads())
        refusal = scenes::loaded_library() + " has no threads of its own";
    if (data.friction != kFriction) refusal = "a scene of another friction than the default material's";
    return refusal.empty();
}

std::unique_ptr<Engine> make(const SceneData& data, const EngineOptions& options, std::string& refusal)
{
    if (!has_all(data, options, refusal)) return nullptr;
    EngineOptions substeps = options;
    substeps.stepper = "fast";
    substeps.iterations = options.iterations > 0 ? options.iterations : 5;
    return std::make_unique<WorldContactsEngine>(data, substeps);
}

std::unique_ptr<Engine> make_hybrid(const SceneData& data, const EngineOptions& options, std::string& refusal)
{
    if (!has_all(data, options, refusal)) return nullptr;
    if (!find<Step>("dWorldStepHybrid")) refusal = scenes::loaded_library() + " has no hybrid steps";
    return refusal.empty() ? std::make_unique<HybridEngine>(data, options) : nullptr;
}

}  // namespace

extern const EngineEntry kWorldContactsEngine = {"managed", "world-managed contacts, substeps", make};
extern const EngineEntry kHybridEngine = {"hybrid", "world-managed contacts, hybrid steps", make_hybrid};

}  // namespace epode::bench
