// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every event of a sensor that begins ends once, sleeping bodies stay inside, and nothing wakes them. Sensor events need the space of
// world-managed contacts; where contacts are joints the scene has nothing to judge.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

struct SensorEvent {
    int kind;
    double time;
    dGeomID other;
};

class Watched {
  public:
    Watched(const Run& run, Vec gravity) : stage(run, gravity)
    {
        dEventSettings settings;
        dEventSettingsInit(&settings, sizeof settings);
        settings.kinds = 1u << dEventSensorBegin | 1u << dEventSensorEnd;
        dWorldSetEventSettings(stage.world, &settings);
    }
    void step()
    {
        stage.step();
        time += stage.h;
        dEvent list[32];
        const int count = dWorldGetEvents(stage.world, list, 32);
        for (int i = 0; i < std::min(count, 32); ++i) events.push_back({list[i].kind, time, list[i].g2});
    }
    void advance_to(double until)
    {
        while (time < until - stage.h / 2) step();
    }
    // How many of this kind there are from then on, until now.
    int count(int kind, double from) const
    {
        return int(std::count_if(events.begin(), events.end(),
                                 [&](const SensorEvent& e) { return e.kind == kind && e.time > from; }));
    }

    Stage stage;
    double time = 0;
    std::vector<SensorEvent> events;
};

void count_off(Run& run, const Watched& watched, int kind, double from, int right)
{
    run.record("events", std::abs(watched.count(kind, from) - right));
}

// A continuous sensor ball crosses a wall of 1 m.
void cross_wall(Run& run, double speed)
{
    Watched watched(run, {});
    Stage& stage = watched.stage;
    stage.block({1, 20, 20}, {1.5, 0, 0});
    const dBodyID ball = stage.ball(0.1, 1, {7.398, 0, 0});
    const dGeomID geom = dBodyGetFirstGeom(ball);
    dGeomSetContinuous(geom, dContinuousOn);
    dGeomSetSensor(geom, 1);
    set_velocity(ball, {-speed, 0, 0});
    watched.advance_to(1);
    const int begins = watched.count(dEventSensorBegin, 0), ends = watched.count(dEventSensorEnd, 0);
    run.record("events", std::abs(begins - ends));
    if (speed > 100) return;
    count_off(run, watched, dEventSensorBegin, 0, 1);
    if (begins != 1 || ends != 1) return;
    const double stay = watched.events[1].time - watched.events[0].time;
    run.record("duration", std::max(std::fabs(stay - 1.2 / speed) / stage.h - 1, 0.0));
}

void visit(Run& run)
{
    Watched watched(run, {0, 0, -kGravity});
    Stage& stage = watched.stage;
    stage.floor();
    const dGeomID sensor = stage.block({2, 2, 2}, {0, 0, 1});
    dGeomSetSensor(sensor, 1);
    dBodyID box = stage.box({0.5, 0.5, 0.5}, 5, {0, 0, 3.25});
    const dBodyID sleeper = stage.box({0.5, 0.5, 0.5}, 5, {10, 0, 0.25});
    watched.advance_to(5.9);
    count_off(run, watched, dEventSensorBegin, 0, 1);
    count_off(run, watched, dEventSensorEnd, 0, 0);
    // An unrelated pair collides, then nothing may have happened until the box is pushed out.
    const dBodyID far = stage.ball(0.3, 1, {20, 0, 0.3}), other = stage.ball(0.3, 1, {22, 0, 0.3});
    set_velocity(far, {2, 0, 0});
    watched.advance_to(8);
    count_off(run, watched, dEventSensorBegin, 5.9, 0);
    count_off(run, watched, dEventSensorEnd, 5.9, 0);
    dBodyEnable(box);
    dBodySetLinearVel(box, 6, 0, 2);
    watched.advance_to(10);
    count_off(run, watched, dEventSensorEnd, 8, 1);
    dBodySetPosition(box, 0, 0, 0.25);
    dBodyEnable(box);
    set_velocity(box, {});
    watched.advance_to(11);
    count_off(run, watched, dEventSensorBegin, 10, 1);
    dGeomDestroy(dBodyGetFirstGeom(box));
    dBodyDestroy(box);
    watched.advance_to(12);
    count_off(run, watched, dEventSensorEnd, 11, 1);
    const bool slept = !dBodyIsEnabled(sleeper);
    dGeomSetPosition(sensor, 10, 0, 1);
    watched.advance_to(13);
    count_off(run, watched, dEventSensorBegin, 12, 1);
    run.record("woken", slept && dBodyIsEnabled(sleeper) ? 1 : 0);
    dGeomSetCollideBits(sensor, 0);
    dGeomSetCategoryBits(sensor, 0);
    watched.advance_to(14);
    count_off(run, watched, dEventSensorEnd, 13, 1);
    (void)other;
}

void watch_all(Run& run)
{
    for (const char* law : {"events", "duration", "woken"}) run.record(law, 0);
    if (contains(kCallback, run.setting.method)) return;
    cross_wall(run, 20);
    cross_wall(run, 300);
    visit(run);
}

}  // namespace

extern const Scene kSensors{
    "States and events",
    "sensors",
    "a ball that is a sensor crosses a wall; a box falls into a sensor, sleeps, leaves, comes back and is "
    "destroyed; "
    "the sensor moves over a body that sleeps (C24)",
    {{"events", "begins and ends too many or too few", "1", 0},
     {"duration", "time between begin and end, off the law, beyond one step", "steps", 1e-6},
     {"woken", "sleeping bodies that the sensor has woken", "1", 0}},
    &watch_all};

}  // namespace epode::trials
