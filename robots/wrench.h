// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Actuators of sites (MJCF). With the force f and torque t that the gear has along the axes of the reference site (of the site itself
// where there is none), the site's link gets f at the site p and t, the reference's -f at its place r and -t. Only joints that move the
// two against each other are to feel it: the link c on which both hang gets the torque -(p - r) x f, so that the three balance
// there. Of a place x and turn q of the site in the reference's frame, with the rotation vector v of q, the length is
//     L = gear . (x, v),    dL/dt = f . (v_p - v_r) + t . (w_p - w_r) - ((p - r) x f) . w_c
//
// Of a slider-crank with the rod l, the crank's place p, and the slider's place r and axis a (z of its site), the slide's position along a
// is, with w = p - r,
//     L = gear (a.w - d),   d = sqrt((a.w)^2 + l^2 - w.w);    L = gear a.w where the rod does not reach,
//     dL/dt = gear (n.(v_p - v_r) + (a x m).w_r),   n = (1 - a.w / d) a + w / d,   m = (1 - a.w / d) w;    n = a, m = w there.
#pragma once

#include "robots/kinematics.h"

namespace epode::robots {

// What acts on a link: a force at a point of the world, and a torque.
struct LinkLoad {
    int link = 0;
    Vec point, force, torque;
};

// Of a unit before the gear.
std::vector<LinkLoad> loads_of(const RobotModel& model, const SiteWrench& wrench,
                               const std::vector<Pose>& poses);
// 0 without a reference.
double length_of(const SiteWrench& wrench, const std::vector<Pose>& poses);
// A row of the derivatives of the length by the velocities.
std::vector<double> wrench_moments(const RobotModel& model, const std::vector<double>& positions,
                                   const SiteWrench& wrench);

}  // namespace epode::robots
