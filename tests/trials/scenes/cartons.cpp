// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Packed boxes: the collider finds the contact that there is and no other, and what is laid down stays.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr Vec kCarton{0.071, 0.071, 0.05};
constexpr double kInner = 0.214;

// 3 x 3 x 3 cartons in a tray, laid down with gaps, turned by up to so much.
void pack(Run& run, double gap, double yaw)
{
    Stage stage(run);
    stage.toys();
    stage.surface.friction = 0.5;
    stage.block({kInner, kInner, 0.02}, {0, 0, -0.01});
    for (double side : {1.0, -1.0}) {
        stage.block({0.02, kInner + 0.04, 0.3}, {side * (kInner / 2 + 0.01), 0, 0.13});
        stage.block({kInner + 0.04, 0.02, 0.3}, {0, side * (kInner / 2 + 0.01), 0.13});
    }
    Lcg random(5);
    std::vector<dBodyID> cartons;
    for (int k = 0; k < 3; ++k)
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                cartons.push_back(
                    stage.box(kCarton, 0.15,
                              {i * (kCarton.x + gap), j * (kCarton.y + gap), 0.025 + k * (0.05 + gap) + gap},
                              turn(kZ, random.uniform(-yaw, yaw))));
    stage.advance(0.2);
    stage.advance(1.3, [&] {
        for (dBodyID carton : cartons) run.record("speed", length(velocity(carton)));
    });
    for (size_t n = 0; n < cartons.size(); ++n) {
        const double layer = double(n / 9);
        const double off = position(cartons[n]).z - 0.025 - layer * 0.05;
        run.record("height", 1000 * std::max(off, -off - (layer + 1) * 7.1e-5 / 2));
        run.record("rest", length(velocity(cartons[n])));
    }
}

void pack_all(Run& run)
{
    for (double gap : {0.0, 1e-7, 1e-5, 5e-5}) pack(run, gap, 1e-6);
    pack(run, 0, 1e-4);
}

// Two cartons face to face by all sorts of small angles and offsets.
void collide(Run& run)
{
    dGeomID a = dCreateBox(nullptr, kCarton.x, kCarton.y, kCarton.z),
            b = dCreateBox(nullptr, kCarton.x, kCarton.y, kCarton.z);
    for (const char* law : {"missing", "phantom", "depth", "normal"}) run.record(law, 0);
    for (double yaw : {0.0, 1e-9, 1e-6, 1e-4, 1e-3}) {
        const dQuaternion q = {std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)};
        dGeomSetQuaternion(b, q);
        for (double aside : {0.0, 1e-6, 0.01, 0.0355}) {
            for (int k = -1000; k <= 1000; ++k) {
                const double overlap = -1e-7 * k;
                dGeomSetPosition(b, aside, 0, kCarton.z - overlap);
                dContactGeom contacts[16];
                const int count = dCollide(a, b, 16, contacts, sizeof contacts[0]);
                if (overlap > 1e-9) run.record("missing", count == 0 ? 1 : 0);
                if (overlap < -1e-9) run.record("phantom", count);
                for (int i = 0; i < count; ++i) {
                    run.record("depth", 1e6 * (contacts[i].depth - overlap));
                    run.record("normal", 1 + contacts[i].normal[2]);
                }
            }
        }
    }
    dGeomDestroy(a);
    dGeomDestroy(b);
}

// A light cube below a heavy one.
void load(Run& run, double mass, double drop, double yaw)
{
    Stage stage(run);
    stage.surface.friction = 0.5;
    stage.floor();
    const dBodyID light = stage.box({0.5, 0.5, 0.5}, 1, {0, 0, 0.25 + drop}),
                  heavy = stage.box({0.5, 0.5, 0.5}, mass, {0, 0, 0.75 + 2 * drop}, turn(kZ, yaw));
    double highest = 0, lowest = HUGE_VAL;
    stage.advance(3, [&] {
        const double z = position(heavy).z;
        lowest = std::min(lowest, z);
        if (z > lowest) highest = std::max(highest, z - lowest);
    });
    run.record("rebound", highest);
    const double z = position(heavy).z, allowed = 2 * stage.layer();
    const char* law = mass <= 10 ? "to_10" : mass <= 100 ? "to_100" : "to_10000";
    run.record(law,
               1000 * std::max(std::fabs(position(light).z - 0.25) - allowed, std::fabs(z - 0.75) - allowed));
    stage.advance(2);
    run.record(mass <= 100 ? "sinks" : "sinks_more", 1000 * (z - position(heavy).z));
}

// Light cubes between heavy plates.
void sandwich(Run& run)
{
    Stage stage(run);
    stage.surface.friction = 0.5;
    stage.floor();
    std::vector<std::pair<dBodyID, double>> layers;
    double top = 0;
    for (int i = 0; i < 5; ++i) {
        const double high = i % 2 ? 0.5 : 0.1;
        layers.emplace_back(stage.box({0.5, 0.5, high}, i % 2 ? 1 : 1000, {0, 0, top + high / 2}),
                            top + high / 2);
        top += high;
    }
    stage.advance(3);
    for (size_t i = 0; i < layers.size(); ++i) {
        const double off = std::fabs(position(layers[i].first).z - layers[i].second);
        run.record("sandwich", 1000 * (off - double(i + 1) * stage.layer()));
    }
}

void load_all(Run& run)
{
    sandwich(run);
    for (double mass : {1.0, 10.0, 100.0, 1000.0, 10000.0}) {
        load(run, mass, 0.001, 0);
        load(run, mass, 0.5, kPi / 4);
    }
}

constexpr const char* kRatio =
    "A light body under a heavy one is hard for methods that iterate (guide/howto/mass_ratios.md)";
constexpr const char* kFalls = "The heavy body falls through the light one (guide/howto/mass_ratios.md)";
constexpr unsigned kIterative = kSweeps | Method::kSubsteps;

}  // namespace

extern const Scene kCartons{
    "Rest",
    "cartons",
    "27 cartons in a tray, with gaps of 0 to 50 um and turned by up to 1e-4 rad (C22)",
    {{"speed", "speed after 0.2 s", "m/s", 0.1},
     {"rest", "speed after 1.5 s", "m/s", 1e-3},
     {"height", "height of a carton, off its layer's", "mm", 0.5}},
    &pack_all};

extern const Scene kCartonPairs{"Queries",
                                "carton_pairs",
                                "two boxes face to face, 40,020 offsets and angles (C22)",
                                {{"missing", "no contact with an overlap above 1 nm", "1", 0},
                                 {"phantom", "contacts of separated boxes", "1", 0},
                                 {"depth", "depth beyond the penetration", "um", 1},
                                 {"normal", "1 - cosine of the normal's angle", "1", 1e-6}},
                                &collide,
                                true};

extern const Scene kHeavyOnLight{
    "Rest",
    "heavy_on_light",
    "a cube of 1 to 10,000 kg on one of 1 kg, put down, and dropped from 0.5 m turned by 45 degrees (C25)",
    {{"to_10",
      "heights, off those of rest, up to 1 : 10",
      "mm",
      1,
      {{kIterative | Method::kGame, 4, kRatio}}},
     {"to_100",
      "the same, 1 : 100",
      "mm",
      1,
      {{kSweeps, 1000, kFalls}, {set_of(Method::kSubsteps), 35, kRatio}}},
     {"to_10000", "the same, 1 : 1,000 and 1 : 10,000", "mm", 1, {{kIterative, 1000, kFalls}}},
     {"sandwich",
      "heights of cubes of 1 kg between three plates of 1,000 kg, off those of rest",
      "mm",
      1,
      {{kIterative, 1000, kFalls}}},
     {"sinks", "sinking in the last 2 s, up to 1 : 100", "mm", 0.1, {{kSweeps, 1000, kFalls}}},
     {"sinks_more", "the same, 1 : 1,000 and 1 : 10,000", "mm", 0.1, {{kIterative, 1000, kFalls}}},
     {"rebound", "rebound without restitution", "m", 0.3}},
    &load_all};

}  // namespace epode::trials
