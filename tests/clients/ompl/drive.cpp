// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A client of Debian's libompl and libode-dev, and of nothing of ours: a box is pushed over the ground, round
// a wall, by a planner that simulates (OMPL's KPIECE over its OpenDE state space). Compiled once, run on two
// libode.so.8.
//
// The planner asks the library for thousands of short runs with contacts, so its plan depends on every
// rounding; what is compared between the libraries is therefore the answer of one list of pushes, and what is
// judged of the plan is that it is one: it ends at the goal, misses the wall, and gives the same states when
// its controls are run again. Prints lines "name numbers" after the library (preamble.cpp); judge.py reads
// them.
#include <ode/ode.h>
#include <ompl/base/goals/GoalRegion.h>
#include <ompl/control/planners/kpiece/KPIECE1.h>
#include <ompl/extensions/ode/OpenDESimpleSetup.h>
#include <ompl/util/RandomNumbers.h>

#include <cmath>
#include <cstdio>
#include <memory>
#include <vector>

namespace ob = ompl::base;
namespace oc = ompl::control;

namespace {

constexpr double kHalfHeight = 0.1, kMass = 2, kFriction = 0.3, kGravity = 9.81, kStep = 0.01;
constexpr double kGoal[2] = {3, 0}, kGoalRadius = 0.25;

class Yard : public oc::OpenDEEnvironment {
  public:
    Yard()
    {
        world_ = dWorldCreate();
        dWorldSetGravity(world_, 0, 0, -kGravity);
        space = dHashSpaceCreate(nullptr);
        ground = dCreatePlane(space, 0, 0, 1, 0);
        wall = dCreateBox(space, 0.2, 2, 1);
        dGeomSetPosition(wall, 1.5, 0, 0.5);
        dMass mass;
        dMassSetBoxTotal(&mass, kMass, 0.4, 0.4, 2 * kHalfHeight);
        box = dBodyCreate(world_);
        dBodySetMass(box, &mass);
        dBodySetPosition(box, 0, 0, kHalfHeight);
        const dGeomID shape = dCreateBox(space, 0.4, 0.4, 2 * kHalfHeight);
        dGeomSetBody(shape, box);
        stateBodies_.push_back(box);
        collisionSpaces_.push_back(space);
        stepSize_ = kStep;
        maxContacts_ = 4;
        minControlSteps_ = 10;
        maxControlSteps_ = 60;
    }
    ~Yard() override
    {
        dSpaceDestroy(space);
        dWorldDestroy(world_);
    }
    unsigned getControlDimension() const override { return 2; }
    void getControlBounds(std::vector<double>& low, std::vector<double>& high) const override
    {
        low.assign(2, -20);
        high.assign(2, 20);
    }
    void applyControl(const double* force) const override { dBodyAddForce(box, force[0], force[1], 0); }
    bool isValidCollision(dGeomID a, dGeomID b, const dContact&) const override
    {
        return a == ground || b == ground;
    }
    void setupContact(dGeomID, dGeomID, dContact& contact) const override
    {
        contact.surface.mode = dContactApprox1;
        contact.surface.mu = kFriction;
    }

    dSpaceID space;
    dGeomID ground, wall;
    dBodyID box;
};

struct Goal : ob::GoalRegion {
    explicit Goal(const ob::SpaceInformationPtr& si) : ob::GoalRegion(si) { threshold_ = kGoalRadius; }
    double distanceGoal(const ob::State* state) const override
    {
        const double* p = state->as<oc::OpenDEStateSpace::StateType>()->getBodyPosition(0);
        return std::hypot(p[0] - kGoal[0], p[1] - kGoal[1]);
    }
};

struct Projection : ob::ProjectionEvaluator {
    explicit Projection(const ob::StateSpace* space) : ob::ProjectionEvaluator(space) {}
    unsigned getDimension() const override { return 2; }
    void defaultCellSizes() override { cellSizes_.assign(2, 0.3); }
    void project(const ob::State* state, Eigen::Ref<Eigen::VectorXd> out) const override
    {
        const double* p = state->as<oc::OpenDEStateSpace::StateType>()->getBodyPosition(0);
        out[0] = p[0], out[1] = p[1];
    }
};

struct Floor : oc::OpenDEStateSpace {
    explicit Floor(const oc::OpenDEEnvironmentPtr& yard) : oc::OpenDEStateSpace(yard) {}
    double distance(const ob::State* a, const ob::State* b) const override
    {
        const double* p = a->as<StateType>()->getBodyPosition(0);
        const double* q = b->as<StateType>()->getBodyPosition(0);
        return std::hypot(p[0] - q[0], p[1] - q[1]);
    }
    void registerProjections() override { registerDefaultProjection(std::make_shared<Projection>(this)); }
};

void show(const char* name, const ob::State* state)
{
    const auto* s = state->as<oc::OpenDEStateSpace::StateType>();
    const double *p = s->getBodyPosition(0), *v = s->getBodyLinearVelocity(0);
    std::printf("%s %.17g %.17g %.17g %.17g %.17g %.17g\n", name, p[0], p[1], p[2], v[0], v[1], v[2]);
}

// A hard push along x against friction, then let go: a = F/m - mu g, stops after v^2 / (2 mu g).
void straight_drives(const oc::OpenDESimpleSetup& setup)
{
    const double controls[][2] = {{10, 0}, {0, 0}, {-12, 8}, {0, 0}, {4, -3}, {0, 20}, {0, 0}};
    const auto space = setup.getSpaceInformation();
    ob::State* state = space->cloneState(setup.getCurrentState().get());
    oc::Control* control = space->allocControl();
    for (const auto& force : controls) {
        control->as<oc::RealVectorControlSpace::ControlType>()->values[0] = force[0];
        control->as<oc::RealVectorControlSpace::ControlType>()->values[1] = force[1];
        for (int i = 0; i < 5; ++i) {
            space->propagate(state, control, 10, state);
            show("push", state);
        }
    }
    space->freeControl(control);
    space->freeState(state);
}

bool find_path(oc::OpenDESimpleSetup& setup)
{
    if (setup.solve(60) != ob::PlannerStatus::EXACT_SOLUTION) return false;
    const oc::PathControl& path = setup.getSolutionPath();
    const auto space = setup.getSpaceInformation();
    ob::State* state = space->cloneState(path.getState(0));
    show("plan", state);
    bool again = true;
    for (std::size_t i = 0; i < path.getControlCount(); ++i) {
        const auto steps =
            static_cast<int>(std::lround(path.getControlDuration(i) / space->getPropagationStepSize()));
        for (int k = 0; k < steps; ++k) {
            space->propagate(state, path.getControl(i), 1, state);
            show("plan", state);
            again = again && space->isValid(state);
        }
        const double off = space->distance(state, path.getState(i + 1));
        std::printf("again %zu %d %.17g\n", i, steps, off);
    }
    std::printf("valid %d\n", again ? 1 : 0);
    space->freeState(state);
    return true;
}

}  // namespace

int main()
{
    dInitODE2(0);
    std::setvbuf(stdout, nullptr, _IOLBF, 0);
    ompl::RNG::setSeed(7);
    ompl::msg::setLogLevel(ompl::msg::LOG_ERROR);
    bool solved = false;
    {
        const oc::OpenDEEnvironmentPtr yard = std::make_shared<Yard>();
        const auto floor = std::make_shared<Floor>(yard);
        oc::OpenDESimpleSetup setup(floor);
        setup.setGoal(std::make_shared<Goal>(setup.getSpaceInformation()));
        ob::RealVectorBounds bounds(3);
        bounds.setLow(-5), bounds.setHigh(5);
        floor->setVolumeBounds(bounds);
        floor->setLinearVelocityBounds(bounds);
        bounds.setLow(-20), bounds.setHigh(20);
        floor->setAngularVelocityBounds(bounds);
        setup.setup();
        straight_drives(setup);
        solved = find_path(setup);
    }
    dCloseODE();
    std::puts("#end");
    return solved ? 0 : 1;
}
