// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How what has stopped at a time of a step is carried on by the body that it met: rigidly with that for the rest of the step.
#pragma once

#include "query/motion.h"

namespace epode {

class Carriage {
  public:
    // From `time` of the carrier's motion on, 0 ... 1.
    Carriage(const Motion& carrier, Real time)
        : turn(turn_by((1 - time) * carrier.turn)),
          angle((1 - time) * length(carrier.turn)),
          centre_(carrier.centre + time * carrier.shift),
          shift_((1 - time) * carrier.shift),
          R_(to_matrix(turn))
    {}

    Vec3 end_of(Vec3 point) const { return centre_ + shift_ + R_ * (point - centre_); }
    // Of a body whose points are no farther than `arm` from its centre: the longest way of one of them.
    Real max_way(Vec3 centre, Real arm) const { return length(end_of(centre) - centre) + angle * arm; }

    const Quat turn;
    const Real angle;

  private:
    Vec3 centre_, shift_;
    Mat3 R_;
};

}  // namespace epode
