// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "robots/muscle.h"

#include <algorithm>
#include <cmath>

namespace epode::robots {

namespace {

double square(double x) { return x * x; }

// 0 at both ends, 1 in the middle; each half is two parabolas that meet halfway.
double bump(double x, double from, double middle, double to)
{
    if (x <= from || x >= to) return 0;
    const double end = x < middle ? from : to, half = (end + middle) / 2;
    const bool is_outer = std::fabs(x - middle) > std::fabs(half - middle);
    return is_outer ? square((x - end) / (half - end)) / 2 : 1 - square((x - middle) / (half - middle)) / 2;
}

double by_speed(double v, double eccentric)
{
    const double y = eccentric - 1;
    if (v <= -1) return 0;
    if (v <= 0) return square(v + 1);
    return v <= y ? eccentric - square(y - v) / y : eccentric;
}

double passive_share(const Muscle& m, double length)
{
    const double middle = (1 + m.longest) / 2;
    if (length <= 1) return 0;
    const double x = (std::min(length, middle) - 1) / (middle - 1);
    return length <= middle ? m.passive * square(x) / 2
                            : m.passive * (0.5 + (length - middle) / (middle - 1));
}

// 0 to 1 over 0 ... 1, with slopes and curvatures of 0 at both ends.
double smooth_step(double x)
{
    x = std::clamp(x, 0.0, 1.0);
    return x * x * x * (x * (6 * x - 15) + 10);
}

}  // namespace

double muscle_force(const Muscle& m, double act, double l, double v)
{
    const double unit = std::max((m.length_high - m.length_low) / std::max(m.high - m.low, 1e-15), 1e-15);
    const double length = m.low + (l - m.length_low) / unit, speed = v / std::max(unit * m.fastest, 1e-15);
    const double active = bump(length, m.shortest, 1, m.longest) * by_speed(speed, m.eccentric);
    return -m.force * (active * act + passive_share(m, length));
}

double muscle_rate(const Activation& filter, double act, double control)
{
    const double u = std::clamp(control, 0.0, 1.0), a = std::clamp(act, 0.0, 1.0), change = u - act;
    const double rises = filter.time * (0.5 + 1.5 * a), falls = filter.slower / (0.5 + 1.5 * a);
    const double share =
        filter.smooth < 1e-15 ? double(change > 0) : smooth_step(change / filter.smooth + 0.5);
    return change / std::max(falls + (rises - falls) * share, 1e-15);
}

}  // namespace epode::robots
