// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The benchmark problems A01 to A05 of the library of multibody benchmarks (Gonzalez, Dopico, Lugris,
// Cuadrado, Multibody Syst. Dyn. 16, 2006; iftomm-multibody.org) as worlds of bodies and joints.
#pragma once

#include <ode/ode.h>

#include <memory>
#include <string>
#include <vector>

namespace epode::iftomm {

class Problem {
  public:
    Problem();
    virtual ~Problem();
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;

    virtual void apply_forces(double) {}  // before each step of that length
    virtual std::vector<double> outputs() const = 0;
    virtual double energy() const;  // what should stay: kinetic + potential - work done on it

    dWorldID world;
    double up = 1;  // y is up (1) or z (2)
    double gravity = 0;
    std::vector<dBodyID> bodies;
    std::vector<dJointID> hinges;
    double gap() const;  // the widest of the hinges

  protected:
    dBodyID body(double mass, double ixx, double iyy, double izz, double x, double y, double z);
    dJointID hinge(dBodyID a, dBodyID b, double x, double y, double z, double nx, double ny, double nz);
};

// A01 ... A05; size: windows of A02.
std::unique_ptr<Problem> make_problem(const std::string& name, int size);

}  // namespace epode::iftomm
