// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "vehicles/wheel_forces_newton.h"

#include <algorithm>
#include <cmath>

namespace epode {
namespace {

constexpr Real kLeastPivot = Real(0.05);                      // of a velocity
constexpr Real kShared = kSingle ? Real(1e-5) : Real(1e-10);  // of the response

}  // namespace

WheelForces::Newton::Newton(WheelForces& all) : all_(all)
{
    int next = kBody + all.speeds_;
    if (all.row_count_ > 0 && all.rows_[0].engine != 0) engine_ = next++;
    velocities_ = place_grounds(next);
    if (velocities_ + all.row_count_ + all.speeds_ > kMostUnknowns) return;
    for (int i = 0; i < all.vehicle_.wheel_count; ++i) place_wheel(i);
}

int WheelForces::Newton::place_grounds(int next)
{
    for (int g = 0; g < all_.ground_count_; ++g) {
        ground_[g] = all_.grounds_[g].inv_mass > 0 ? next : -1;
        if (ground_[g] >= 0) next += kBody;
    }
    return next;
}

void WheelForces::Newton::place_ground(Wheel& wheel, int line, const Line& of, const MovedBody& ground) const
{
    const Vec3 turn = cross(of.arm_ground, of.d), turned = ground.inv_inertia * turn;
    for (int c = 0; c < 3; ++c) {
        const int moves = kBody + 1 + c, turns = moves + 3;
        wheel.j[line][moves] = -of.d[c], wheel.mj[line][moves] = -ground.inv_mass * of.d[c];
        wheel.j[line][turns] = -turn[c], wheel.mj[line][turns] = -turned[c];
    }
}

void WheelForces::Newton::place_wheel(int i)
{
    const Stand& at = all_.stands_[i];
    Wheel& wheel = wheels_[i];
    wheel.of = i, wheel.count = 0, wheel.f[kLineN] = wheel.d[kLineN][kLineN] = 0;
    if (!at.stands) return;
    const int k = speed_of_wheel(all_.vehicle_, i), ground = ground_[at.ground];
    const Real radius = all_.vehicle_.wheels[i].settings.radius;
    wheel.count = ground < 0 ? kBody + 1 : kWheel;
    for (int c = 0; c < kBody; ++c) wheel.index[c] = c, wheel.index[kBody + 1 + c] = ground + c;
    wheel.index[kBody] = kBody + k;
    const Line* const lines[] = {&at.normal, &at.x, &at.y};
    for (int line = 0; line < kLines; ++line) {
        const Line& of = *lines[line];
        for (int c = 0; c < 3; ++c) {
            wheel.j[line][c] = of.d[c], wheel.mj[line][c] = all_.chassis_.inv_mass * of.d[c];
            wheel.j[line][3 + c] = of.turn[c], wheel.mj[line][3 + c] = of.turned[c];
        }
        if (ground >= 0) place_ground(wheel, line, of, all_.grounds_[at.ground]);
        wheel.j[line][kBody] = line == kLineX ? -radius : Real(0);
        wheel.mj[line][kBody] = wheel.j[line][kBody] * all_.inv_spin_inertia_[k];
    }
}

// f and D at the velocities that there are.
void WheelForces::Newton::take_law(Wheel& wheel) const
{
    const Stand& at = all_.stands_[wheel.of];
    for (int line = 0; line < kLines; ++line) {
        wheel.f[line] = 0;
        for (int by = 0; by < kLines; ++by) wheel.d[line][by] = 0;
    }
    const Real a = all_.h_ / at.slope, b = at.resists / at.slope;
    const Real normal = a * (at.spring - b * all_.relative(at, at.normal));
    if (!(normal > 0)) return;
    wheel.f[kLineN] = normal, wheel.d[kLineN][kLineN] = -a * b;
    take_tyre(wheel);
}

void WheelForces::Newton::take_tyre(Wheel& wheel) const
{
    const Stand& at = all_.stands_[wheel.of];
    const dVehicleWheel& w = all_.vehicle_.wheels[wheel.of].settings;
    const Real normal = wheel.f[kLineN], load = normal / all_.h_, grip = load_factor(w, load) * at.factor;
    if (!(grip > 0)) return;
    const Tyre tyre{w, at.rolling};
    const Real rim = all_.speed_[speed_of_wheel(all_.vehicle_, wheel.of)] * w.radius;
    const Real s[] = {at.start_x + at.gain * (rim - all_.relative(at, at.x)),
                      at.start_y - at.gain * all_.relative(at, at.y)};
    const Real scale[] = {tyre.scale_x() / grip, tyre.scale_y() / grip},
               stiffness[] = {w.stiffness_x, w.stiffness_y};
    const Real zx = scale[0] * s[0], zy = scale[1] * s[1], z = std::sqrt(zx * zx + zy * zy);
    const Real secant = tyre_secant(z, w.sliding), falls = tyre_secant_slope(z, w.sliding);
    const Real by_load =
        secant - normal * falls * z * load_factor_slope(w, load) * at.factor / (grip * all_.h_);
    for (int p = 0; p < 2; ++p) {
        Real* const d = wheel.d[kLineX + p];
        wheel.f[kLineX + p] = stiffness[p] * s[p] * secant * normal;
        d[kLineN] = stiffness[p] * s[p] * by_load * wheel.d[kLineN][kLineN];
        for (int q = 0; q < 2; ++q) {
            const Real turns = z > 0 ? falls * s[p] * scale[q] * scale[q] * s[q] / z : Real(0);
            d[kLineX + q] = -at.gain * stiffness[p] * normal * (turns + (p == q ? secant : Real(0)));
        }
    }
}

void WheelForces::Newton::clear()
{
    size_ = velocities_ + all_.row_count_ + all_.speeds_;  // at most
    for (int r = 0; r < size_; ++r) {
        std::fill(matrix_[r], matrix_[r] + size_, Real(0));
        right_[r] = 0;
    }
    for (int r = 0; r < velocities_; ++r) matrix_[r][r] = 1;
    size_ = velocities_;
}

void WheelForces::Newton::add_wheel(const Wheel& wheel)
{
    const Stand& at = all_.stands_[wheel.of];
    const Real missing[] = {wheel.f[kLineN] - at.normal.impulse, wheel.f[kLineX] - at.x.impulse,
                            wheel.f[kLineY] - at.y.impulse};
    Real dj[kLines][kWheel];
    for (int p = 0; p < kLines; ++p)
        for (int c = 0; c < wheel.count; ++c)
            dj[p][c] =
                wheel.d[p][0] * wheel.j[0][c] + wheel.d[p][1] * wheel.j[1][c] + wheel.d[p][2] * wheel.j[2][c];
    for (int r = 0; r < wheel.count; ++r) {
        Real* const row = matrix_[wheel.index[r]];
        const Real a = wheel.mj[0][r], b = wheel.mj[1][r], c = wheel.mj[2][r];
        for (int k = 0; k < wheel.count; ++k)
            row[wheel.index[k]] -= a * dj[0][k] + b * dj[1][k] + c * dj[2][k];
        right_[wheel.index[r]] += a * missing[0] + b * missing[1] + c * missing[2];
    }
}

// What a row turns: the unknown, J and M^-1 J^T.
template <typename Function>
void WheelForces::Newton::each_of(const ShaftRow& row, Function&& function) const
{
    const Vec3 turned = all_.chassis_.inv_inertia * row.axle;
    for (int c = 0; c < 3; ++c) function(3 + c, -row.axle[c], -turned[c]);
    for (int k = row.first; k < row.end; ++k)
        function(kBody + k, row.factor[k], row.factor[k] * all_.inv_spin_inertia_[k]);
    if (row.engine != 0) function(engine_, row.engine, row.engine * all_.inv_engine_);
}

void WheelForces::Newton::add_held(ShaftRow& row)
{
    const int u = size_++;
    held_[u] = &row;
    each_of(row, [&](int i, Real j, Real mj) { matrix_[u][i] = j, matrix_[i][u] = -mj; });
    matrix_[u][u] = kShared * row.response;
    right_[u] = -all_.rate_of(row);
}

void WheelForces::Newton::add_brake(int k)
{
    ShaftRow& brake = all_.brakes_[k];
    slides_[k] = false;
    if (!(brake.limit > 0) || !(brake.response > 0)) return;
    if (std::fabs(brake.impulse) < brake.limit) return add_held(brake);
    slides_[k] = true;
    add_sliding(brake, k);
}

// A brake that slips: its limit follows the loads.
void WheelForces::Newton::add_sliding(const ShaftRow& brake, int k)
{
    const Real sign = brake.impulse < 0 ? Real(-1) : Real(1);
    Real missing = -brake.impulse;
    for (int i = 0; i < all_.vehicle_.wheel_count; ++i) {
        if (speed_of_wheel(all_.vehicle_, i) != k) continue;
        const Wheel& wheel = wheels_[i];
        const Braking braking = all_.braking(i, wheel.f[kLineN]);
        const Real slope = sign * braking.slope * wheel.d[kLineN][kLineN];
        missing += sign * braking.impulse;
        each_of(brake, [&](int r, Real, Real mj) {
            for (int c = 0; c < wheel.count; ++c)
                matrix_[r][wheel.index[c]] -= mj * slope * wheel.j[kLineN][c];
        });
    }
    each_of(brake, [&](int r, Real, Real mj) { right_[r] += mj * missing; });
}

bool WheelForces::Newton::eliminate()
{
    for (int k = 0; k < size_; ++k) {
        const Real pivot = matrix_[k][k];
        if (!(pivot > (k < velocities_ ? kLeastPivot : Real(0)))) return false;
        for (int r = k + 1; r < size_; ++r) {
            const Real times = matrix_[r][k] / pivot;
            if (times == 0) continue;
            for (int c = k + 1; c < size_; ++c) matrix_[r][c] -= times * matrix_[k][c];
            right_[r] -= times * right_[k];
        }
    }
    for (int k = size_; k-- > 0;) {
        for (int c = k + 1; c < size_; ++c) right_[k] -= matrix_[k][c] * right_[c];
        right_[k] /= matrix_[k][k];
    }
    return true;
}

// The impulse of a line at the velocities of the solution.
Real WheelForces::Newton::impulse_of(const Wheel& wheel, int line) const
{
    Real sum = wheel.f[line];
    for (int by = 0; by < kLines; ++by) {
        Real rate = 0;
        for (int c = 0; c < wheel.count; ++c) rate += wheel.j[by][c] * right_[wheel.index[c]];
        sum += wheel.d[line][by] * rate;
    }
    return sum;
}

void WheelForces::Newton::give_wheel(int i)
{
    Stand& at = all_.stands_[i];
    const int k = speed_of_wheel(all_.vehicle_, i);
    const Real normal = impulse_of(wheels_[i], kLineN), before = at.x.impulse;
    const bool stands = normal > 0;
    all_.give(at, at.normal, stands ? normal : Real(0));
    all_.give(at, at.x, stands ? impulse_of(wheels_[i], kLineX) : Real(0));
    all_.give(at, at.y, stands ? impulse_of(wheels_[i], kLineY) : Real(0));
    const Real radius = all_.vehicle_.wheels[i].settings.radius;
    all_.speed_[k] -= radius * (at.x.impulse - before) * all_.inv_spin_inertia_[k];
}

void WheelForces::Newton::give_rows()
{
    for (int k = 0; k < all_.speeds_; ++k) {
        ShaftRow& brake = all_.brakes_[k];
        all_.set_brake_limit(k);
        if (brake.limit > 0 && slides_[k]) all_.give(brake, std::copysign(brake.limit, brake.impulse));
    }
    for (int u = velocities_; u < size_; ++u) {
        ShaftRow& row = *held_[u];
        all_.give(row, std::clamp(row.impulse + right_[u], -row.limit, row.limit));
    }
}

bool WheelForces::Newton::step()
{
    if (velocities_ + all_.row_count_ + all_.speeds_ > kMostUnknowns) return false;
    clear();
    for (Wheel& wheel : std::span(wheels_, std::size_t(all_.vehicle_.wheel_count)))
        if (wheel.count > 0) take_law(wheel), add_wheel(wheel);
    for (int k = 0; k < all_.speeds_; ++k) add_brake(k);
    for (ShaftRow& row : std::span(all_.rows_, std::size_t(all_.row_count_)))
        if (row.response > 0 && std::fabs(row.impulse) < row.limit) add_held(row);
    if (!eliminate()) return false;
    for (int i = 0; i < all_.vehicle_.wheel_count; ++i)
        if (wheels_[i].count > 0) give_wheel(i);
    give_rows();
    return true;
}

}  // namespace epode
