// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A weight on a vertical slider with a spring of ERP and CFM: it settles where the spring carries it, m g / k
// lower.
#include <cmath>

#include "stage.h"

constexpr double kStiffness = 2000, kDamping = 120;
static dGeomID weight;
static dJointID slider;

static void build()
{
    demo::paint(weight = demo::cylinder(0, 0, 1, 0.2, 0.25), 0.85f, 0.35f, 0.3f);
    for (int side = -1; side <= 1; side += 2) {
        const dGeomID rod = demo::draw(dCreateCylinder(demo::space, 0.03, 1.8));
        dGeomSetPosition(rod, 0.3 * side, 0, 0.9);
    }
    slider = dJointCreateSlider(demo::world, nullptr);
    dJointAttach(slider, demo::body(weight), nullptr);
    dJointSetSliderAxis(slider, 0, 0, 1);
    const double h = demo::kStep;
    dJointSetSliderParam(slider, dParamLoStop, 0);
    dJointSetSliderParam(slider, dParamHiStop, 0);
    dJointSetSliderParam(slider, dParamStopERP, h * kStiffness / (h * kStiffness + kDamping));
    dJointSetSliderParam(slider, dParamStopCFM, 1 / (h * kStiffness + kDamping));
}

static void judge()
{
    dMass mass;
    dBodyGetMass(demo::body(weight), &mass);
    const double expected = mass.mass * 9.81 / kStiffness, found = std::fabs(dJointGetSliderPosition(slider));
    demo::claim(demo::near(found, expected, 0.01 * expected), "it sank by %g m instead of %g", found,
                expected);
    demo::claim(demo::near(demo::place(weight)[2], 1 - expected, 0.01), "it stands at %g m",
                demo::place(weight)[2]);
    const dReal* p = demo::place(weight);
    demo::claim(std::hypot(p[0], p[1]) < 1e-4, "it left its way by %g m", std::hypot(p[0], p[1]));
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{1.6f, -2, 1.5f}, {128, -15, 0}, 4, build, judge});
}
