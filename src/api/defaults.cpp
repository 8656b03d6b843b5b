// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Values for all parameters of a world's steps (ode/defaults.h). The table below is their only source: the
// calls, the text that lists them and the table of docs/guide/defaults.md follow from it. The column of ODE is
// what a new world has; tests hold the two together.
#include "ode/defaults.h"

#include <charconv>
#include <cmath>
#include <string_view>

#include "base/check.h"
#include "base/float_environment.h"
#include "ode/ext.h"
#include "ode/ode.h"
#include "step/step.h"

using namespace epode;

namespace {

struct Parameter {
    const char* name;  // of dWorldSet<name>
    void (*set)(dWorldID, double);
    double values[3];  // by dDefaults: ODE, game, robot
    const char* reason;
};

constexpr double kNoLimit = HUGE_VAL;
constexpr double kTolerance = kSingle ? 1e-3 : 1e-4;

#define PARAMETER(Type, Name, ode, game, robot, reason)                                               \
    {                                                                                                 \
#Name, [](dWorldID w, double x) { dWorldSet##Name(w, Type(x)); }, {ode, game, robot }, reason \
    }

// clang-format off
constexpr Parameter kParameters[] = {
    //        type      name                     ODE          game            robot          reason
    PARAMETER(int,      HybridStepper,           dStepperHybrid, dStepperHybrid, dStepperExact, "how dWorldStepHybrid solves an island: hybrid chooses for each"),
    PARAMETER(int,      HybridSubsteps,          4,           4,              4,             "substeps, where dWorldStepHybrid takes any"),
    PARAMETER(dReal,    HybridBudget,            1,           1,              1,             "time of exact solutions in dWorldStepHybrid, times that of substeps"),
    PARAMETER(int,      ExactSubsteps,           1,           1,              1,             "exact solves in a step"),
    PARAMETER(int,      ExactRotation,           0,           1,              1,             "1: spinning bodies keep energy and angular momentum"),
    PARAMETER(int,      JointCoordinates,        0,           1,              1,             "1: dWorldStep solves robots in the coordinates of their joints"),
    PARAMETER(int,      StepProjection,          0,           0,              2,             "Newton iterations that close joints; 8 under loads that open them"),
    PARAMETER(dReal,    StepProjectionTolerance, kTolerance,  kTolerance,     kTolerance,    "error that projection leaves"),
    PARAMETER(dReal,    StepWarmStarting,        1,           1,              1,             "share of the last forces that a step starts from"),
    PARAMETER(int,      FrictionCone,            0,           1,              1,             "1: Coulomb's friction: the same in all directions; in dWorldStep by the forces that act"),
    PARAMETER(int,      ManifoldFriction,        0,           0,              0,             "1: one friction for all points of a manifold"),
    PARAMETER(int,      StepThreads,             1,           0,              1,             "0: one for each processor; robots have a world each (dWorldsStep)"),
    PARAMETER(int,      QuickStepNumIterations,  20,          20,             20,            "sweeps of dWorldQuickStep"),
    PARAMETER(dReal,    QuickStepW,              1.3,         1.3,            1.3,           "its over-relaxation"),
    PARAMETER(dReal,    ERP,                     0.2,         0.2,            0.2,           "share of an error that a step removes"),
    PARAMETER(dReal,    CFM,                     kDefaultCfm, kDefaultCfm,    kDefaultCfm,   "softness: hard, and solvable where joints are redundant"),
    PARAMETER(dReal,    ContactMaxCorrectingVel, kNoLimit,    1,              1,             "m/s; bodies that overlap are not thrown apart"),
    PARAMETER(dReal,    ContactSurfaceLayer,     0,           0.001,          0,             "m of overlap that contacts keep, so that they stay"),
    PARAMETER(int,      AutoDisableFlag,         0,           1,              0,             "1: bodies at rest fall asleep"),
    PARAMETER(dReal,    AutoDisableLinearThreshold,  0.01,    0.02,           0.01,          "m/s; slower bodies are idle"),
    PARAMETER(dReal,    AutoDisableAngularThreshold, 0.01,    0.02,           0.01,          "rad/s"),
    PARAMETER(int,      AutoDisableSteps,        10,          20,             10,            "idle steps before sleep"),
    PARAMETER(dReal,    AutoDisableTime,         0,           0.3,            0,             "s of idleness before sleep"),
    PARAMETER(unsigned, AutoDisableAverageSamplesCount, 1,    1,              1,             "steps over which velocities are averaged"),
    PARAMETER(dReal,    LinearDamping,           0,           0,              0,             "share of the velocity that a step removes"),
    PARAMETER(dReal,    AngularDamping,          0,           0,              0,             "the same of rotation"),
    PARAMETER(dReal,    LinearDampingThreshold,  0.01,        0.01,           0.01,          "m/s; slower bodies are not damped"),
    PARAMETER(dReal,    AngularDampingThreshold, 0.01,        0.01,           0.01,          "rad/s"),
    PARAMETER(dReal,    MaxAngularSpeed,         kNoLimit,    kNoLimit,       kNoLimit,      "rad/s; no limit"),
};
// clang-format on
#undef PARAMETER

bool is_preset(int number) { return number >= dDefaultsOde && number <= dDefaultsRobot; }

// Text of any length in a buffer of limited size, with a zero byte at its end.
class Writer {
  public:
    Writer(char* text, int size) : text_(text), size_(size) {}

    void add(std::string_view piece)
    {
        for (char c : piece) {
            if (length_ < size_ - 1) text_[length_] = c;
            ++length_;
        }
    }

    void pad_to(int column)
    {
        do add(" ");
        while (length_ - line_ < column);
    }

    void end_line()
    {
        add("\n");
        line_ = length_;
    }

    int finish()
    {
        if (size_ > 0) text_[length_ < size_ ? length_ : size_ - 1] = 0;
        return length_;
    }

  private:
    char* text_;
    int size_, length_ = 0, line_ = 0;
};

// As a C program writes it, in any locale.
void add_value(Writer& out, const Parameter& parameter, double value)
{
    constexpr const char* kSteppers[] = {"dStepperHybrid", "dStepperExact"};
    if (parameter.name == std::string_view("HybridStepper")) return out.add(kSteppers[int(value)]);
    if (value == kNoLimit) return out.add("dInfinity");
    char digits[32];
    const char* const end = std::to_chars(digits, digits + sizeof digits, value).ptr;
    out.add({digits, std::size_t(end - digits)});
}

}  // namespace

extern "C" {

int dWorldUseDefaults(dWorldID w, int preset)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world, 0);
    EPODE_USER_SAY(is_preset(preset), "a preset that is no dDefaults", 0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    for (const Parameter& parameter : kParameters) parameter.set(w, parameter.values[preset]);
    return 1;
}

[[gnu::cold]] int dDefaultsText(int preset, char* text, int size)
{
    const FloatEnvironment floats;
    EPODE_USER_SAY(is_preset(preset), "a preset that is no dDefaults", 0);
    EPODE_USER(size >= 0 && (text || size == 0), 0);
    Writer out(text, size);
    for (const Parameter& parameter : kParameters) {
        out.add("dWorldSet");
        out.add(parameter.name);
        out.add("(world, ");
        add_value(out, parameter, parameter.values[preset]);
        out.add(");");
        out.pad_to(56);
        out.add("/* ");
        out.add(parameter.reason);
        out.add(" */");
        out.end_line();
    }
    return out.finish();
}

}  // extern "C"
