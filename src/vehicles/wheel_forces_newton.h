// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Newton's step for all impulses of WheelForces together, between two of its sweeps. A wheel of 1 kg m^2 is held by its
// tyre on one side and by an engine of I_e G^2 on the other, both much stiffer than itself; sweeps carry little of the
// one to the other. With the velocities q of chassis, moving grounds, wheels and engine, and J the lines' and rows':
//   P_i = f_i(J q)      of suspensions and tyres, and of brakes that slip, whose limit depends on the load
//   J_r q = 0           of rows that hold, with unknown impulses
//   (1 - M^-1 J^T D J) dq - M^-1 J_r^T dP_r = M^-1 J^T (f - P),   J_r dq = -J_r q,   D = f'
// so that a few steps reach the sweeps' fixed point, and the sweep that follows tells whether they did.
// Eliminated in order: while D takes energy, the pivots of velocities are about 1 or more. Where friction that falls with
// slip makes them less, the solution is not stable, and there is no step. Rows that say the same (a locked differential
// between two held brakes) share, by kShared of their response.
// Rejected: a solution of the shafts alone with the chassis held, which stiff tyres under a high load make unstable.
#pragma once

#include "vehicles/wheel_forces.h"

namespace epode {

class WheelForces::Newton {
  public:
    explicit Newton(WheelForces& all);
    // False: there is no step, and nothing has changed.
    bool step();

  private:
    static constexpr int kBody = 6, kWheel = 2 * kBody + 1, kMostUnknowns = 64;
    enum { kLineN, kLineX, kLineY, kLines };

    // The lines of a wheel, of the velocities of chassis, wheel and ground.
    struct Wheel {
        int of, count, index[kWheel];
        Real j[kLines][kWheel], mj[kLines][kWheel];  // J and M^-1 J^T
        Real f[kLines], d[kLines][kLines];           // D
    };

    int place_grounds(int next);
    void place_wheel(int i);
    void place_ground(Wheel& wheel, int line, const Line& of, const MovedBody& ground) const;
    void take_law(Wheel& wheel) const;
    void take_tyre(Wheel& wheel) const;
    void clear();
    void add_wheel(const Wheel& wheel);
    void add_brake(int k);
    void add_sliding(const ShaftRow& brake, int k);
    void add_held(ShaftRow& row);
    template <typename Function>
    void each_of(const ShaftRow& row, Function&& function) const;
    bool eliminate();
    Real impulse_of(const Wheel& wheel, int line) const;
    void give_wheel(int i);
    void give_rows();

    WheelForces& all_;
    int engine_ = -1, velocities_ = 0, size_ = 0;
    int ground_[dVehicleMaxWheels];  // where its velocity begins; -1: it does not move
    Wheel wheels_[dVehicleMaxWheels];
    bool slides_[dVehicleMaxWheels];  // the brake, at its limit
    ShaftRow* held_[kMostUnknowns];   // of the unknown
    Real matrix_[kMostUnknowns][kMostUnknowns];
    Real right_[kMostUnknowns];  // and then dq and dP_r
};

}  // namespace epode
