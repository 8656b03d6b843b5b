// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// ODE's way: a near callback that asks dCollide and makes contact joints, a step, the joints thrown away.
// Runs on whichever libode.so.8 the loader finds. Friction scales with the normal force (dContactApprox1), as
// real friction does; pairs that a joint connects are left out, which a program with joints has
// to check.
#include <algorithm>

#include "bench/engines/ode_scene.h"
#include "bench/engines/stopwatch.h"
#include "scenes/extensions.h"

namespace epode::bench {

namespace {

constexpr int kMostContacts = 64;

class OdeEngine : public Engine {
  public:
    OdeEngine(const SceneData& data, const EngineOptions& options)
        : scene_(data, options),
          contact_group_(dJointGroupCreate(0)),
          wanted_(std::clamp(options.contacts, 1, kMostContacts)),
          wall_(options.threads > 1)
    {
        for (dContact& contact : contact_) {
            contact = {};
            contact.surface.mode = dContactApprox1;
            contact.surface.mu = dReal(data.friction);
        }
    }
    ~OdeEngine() override { dJointGroupDestroy(contact_group_); }

    std::string version() const override { return scenes::loaded_library(); }

    StageTimes step(double time) override
    {
        Stopwatch watch(wall_);
        contacts_ = 0;
        scene_.drive(time);
        dSpaceCollide(scene_.space(), this, &near_callback);
        StageTimes times;
        times.collide = watch.lap();
        scene_.advance();
        times.solve = watch.lap();
        dJointGroupEmpty(contact_group_);
        times.rest = watch.lap();
        return times;
    }

    void read(State& state) const override { scene_.read(state); }
    RayAnswer cast(const std::vector<RayData>& rays) override { return scene_.cast(rays); }
    int contacts() override { return contacts_; }

    int pairs_at(const std::vector<Vec>& places) override { return scene_.pairs_at(places); }

  private:
    static void near_callback(void* engine, dGeomID geom1, dGeomID geom2)
    {
        static_cast<OdeEngine*>(engine)->collide(geom1, geom2);
    }

    void collide(dGeomID geom1, dGeomID geom2)
    {
        if (!scene_.may_touch(geom1, geom2)) return;
        const int count = dCollide(geom1, geom2, wanted_, &contact_[0].geom, sizeof(dContact));
        dBodyID body1 = dGeomGetBody(geom1), body2 = dGeomGetBody(geom2);
        for (int i = 0; i < count; ++i)
            dJointAttach(dJointCreateContact(scene_.world(), contact_group_, &contact_[i]), body1, body2);
        contacts_ += count;
    }

    OdeScene scene_;
    dJointGroupID contact_group_;
    dContact contact_[kMostContacts];
    int wanted_;
    bool wall_;
    int contacts_ = 0;
};

std::unique_ptr<Engine> make(const SceneData& data, const EngineOptions& options, std::string& refusal)
{
    if (options.stepper == "fast" && !scenes::has_step_fast())
        refusal = scenes::loaded_library() + " has no dWorldStepFast1";
    if (options.threads > 1 && !scenes::has_step_threads())
        refusal = scenes::loaded_library() + " has no threads of its own";
    if (!refusal.empty()) return nullptr;
    return std::make_unique<OdeEngine>(data, options);
}

}  // namespace

extern const EngineEntry kOdeEngine = {"ode", "ODE's way: near callback and contact joints", make};

}  // namespace epode::bench
