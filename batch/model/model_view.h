// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A BatchModel as kernels see it: plain pointers. What is compiled for better machines than the baseline must call no function that
// others share, or the linker might keep that machine's for all; everything here is inlined always.
#pragma once

#include "batch/model/batch_model.h"

#define EPODE_ALWAYS [[gnu::always_inline]] inline

namespace epode::batch {

template <typename X>
struct Items {
    const X* first = nullptr;
    int count = 0;

    EPODE_ALWAYS const X& operator[](int i) const { return first[i]; }
    EPODE_ALWAYS int size() const { return count; }
    EPODE_ALWAYS const X* begin() const { return first; }
    EPODE_ALWAYS const X* end() const { return first + count; }
};

template <typename X>
Items<X> items_of(const std::vector<X>& from)
{
    return {from.data(), int(from.size())};
}

struct ModelView {
    explicit ModelView(const BatchModel& model)
        : links(items_of(model.links)),
          joints(items_of(model.joints)),
          dofs(items_of(model.dofs)),
          chains(items_of(model.chains)),
          actuators(items_of(model.actuators)),
          shapes(items_of(model.shapes)),
          pairs(items_of(model.pairs)),
          supports(items_of(model.supports)),
          support_dofs(items_of(model.support_dofs)),
          asked(items_of(model.asked.pairs)),
          boxes(items_of(model.boxes)),
          sums(items_of(model.sums)),
          sum_terms(items_of(model.sum_terms)),
          sum_dofs(items_of(model.sum_dofs)),
          sensors(items_of(model.sensors)),
          loops(items_of(model.loops)),
          loop_dofs(items_of(model.loop_dofs)),
          loop_places(items_of(model.loop_places)),
          places(items_of(model.places)),
          positions(model.positions),
          velocities(model.velocities),
          controls(model.controls),
          trees(model.trees),
          slots(model.slots),
          entries(model.entries),
          limits(model.limits),
          dry(model.dry),
          servos(model.servos),
          gravity(model.gravity),
          wind(model.wind),
          terrain(model.terrain),
          sum_rows(model.sum_rows),
          filters(model.filters),
          turns(model.turns),
          sensor_values(model.sensor_values),
          accelerations(model.accelerations),
          loop_rows(model.loop_rows),
          wide(model.wide)
    {}

    Items<BatchLink> links;
    Items<BatchJoint> joints;
    Items<Dof> dofs;
    Items<int> chains;
    Items<BatchActuator> actuators;
    Items<BatchShape> shapes;
    Items<BatchPair> pairs;
    Items<Support> supports;
    Items<int> support_dofs;
    Items<AskedPair> asked;
    Items<BatchBox> boxes;
    Items<BatchSum> sums;
    Items<SumTerm> sum_terms;
    Items<int> sum_dofs;
    Items<BatchSensor> sensors;
    Items<BatchLoop> loops;
    Items<int> loop_dofs, loop_places, places;
    int positions, velocities, controls, trees, slots, entries, limits, dry, servos, gravity, wind, terrain,
        sum_rows, filters, turns, sensor_values, accelerations, loop_rows, wide;

    EPODE_ALWAYS int first_sum() const { return 3 * slots + limits + dry + servos; }
    EPODE_ALWAYS int first_turn() const { return first_sum() + sum_rows; }
    EPODE_ALWAYS int first_loop() const { return first_turn() + 3 * turns; }
    EPODE_ALWAYS int impulses() const { return first_loop() + loop_rows; }
};

}  // namespace epode::batch
