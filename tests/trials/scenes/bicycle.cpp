// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The benchmark bicycle of Meijaard, Papadopoulos, Ruina and Schwab (2007): frame, fork and two wheels that roll without slip, nobody
// rides it. At 5 m/s it steadies itself. A small lean p and steer d follow
//     M q'' + v C q' + (g K0 + v^2 K2) q = 0,   q = (p, d),
// with the matrices below; the equations have the eigenvalues -0.775 +- 4.465i, -14.08 and -0.323.
#include "energy_kept.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kSpeed = 5, kBase = 1.02, kTrail = 0.08, kHeadAngle = kPi / 10, kLeanRate = 0.05;

class Bicycle {
  public:
    explicit Bicycle(Stage& stage) : stage_(stage), contacts_(dJointGroupCreate(0))
    {
        rear_ = part(2, 0.0603, 0.12, 0.0603, 0, {0, 0, 0.3});
        frame_ = part(85, 9.2, 11, 2.8, -2.4, {0.3, 0, 0.9});
        fork_ = part(4, 0.05892, 0.06, 0.00708, 0.00756, {0.9, 0, 0.7});
        front_ = part(3, 0.1405, 0.28, 0.1405, 0, {kBase, 0, 0.35});
        stage.hinge(rear_, frame_, {0, 0, 0.3}, kY);
        stage.hinge(front_, fork_, {kBase, 0, 0.35}, kY);
        head_ = stage.hinge(fork_, frame_, {kBase + kTrail, 0, 0},
                            {-std::sin(kHeadAngle), 0, std::cos(kHeadAngle)});
        // All leans at one rate about the line between the wheels' lowest points.
        for (dBodyID body : {rear_, frame_, fork_, front_}) {
            const double rolls = body == rear_ ? kSpeed / 0.3 : body == front_ ? kSpeed / 0.35 : 0;
            set_velocity(body, {kSpeed, -kLeanRate * position(body).z, 0}, {kLeanRate, rolls, 0});
        }
    }
    ~Bicycle() { dJointGroupDestroy(contacts_); }
    Bicycle(const Bicycle&) = delete;
    Bicycle& operator=(const Bicycle&) = delete;

    void step()
    {
        dJointGroupEmpty(contacts_);
        touch(rear_, 0.3);
        touch(front_, 0.35);
        stage_.step();
    }
    double lean() const { return std::asin(rotate(orientation(frame_), kY).z); }
    double steer() const { return dJointGetHingeAngle(head_); }

  private:
    // Moments about the centre; xz is the entry of the tensor.
    dBodyID part(double mass, double x, double y, double z, double xz, Vec at)
    {
        dMass m;
        dMassSetParameters(&m, mass, 0, 0, 0, x, y, z, 0, xz, 0);
        return stage_.part(m, at);
    }
    // A contact that does not slip, at the lowest point of the rim.
    void touch(dBodyID wheel, double radius)
    {
        const Vec axle = rotate(orientation(wheel), kY), up = kZ - axle.z * axle;
        const Vec at = position(wheel) - (radius / length(up)) * up;
        dContact contact = {};
        contact.surface.mode = dContactApprox1;
        contact.surface.mu = dInfinity;
        contact.geom.pos[0] = at.x, contact.geom.pos[1] = at.y, contact.geom.pos[2] = at.z;
        contact.geom.normal[2] = 1;
        contact.geom.depth = std::max(0.0, -at.z);
        dJointAttach(dJointCreateContact(stage_.world, contacts_, &contact), wheel, nullptr);
    }

    Stage& stage_;
    dJointGroupID contacts_;
    dBodyID rear_, frame_, fork_, front_;
    dJointID head_;
};

// The linear equations, by steps so small that their error is of no account.
struct Linear {
    double q[2] = {0, 0}, v[2] = {kLeanRate, 0};

    void advance(double seconds)
    {
        constexpr int kSteps = 400;
        for (int i = 0; i < kSteps; ++i) {
            const double h = seconds / kSteps;
            double a[2];
            acceleration(a);
            for (int k = 0; k < 2; ++k) v[k] += h * a[k], q[k] += h * v[k];
        }
    }
    void acceleration(double* a) const
    {
        constexpr double kM[2][2] = {{80.81722, 2.31941332208709}, {2.31941332208709, 0.29784188199686}};
        constexpr double kC[2][2] = {{0, 33.86641391492494}, {-0.85035641456978, 1.68540397397560}};
        constexpr double kK0[2][2] = {{-80.95, -2.59951685249872}, {-2.59951685249872, -0.80329488458618}};
        constexpr double kK2[2][2] = {{0, 76.59734589573222}, {0, 2.65431523794604}};
        double f[2] = {0, 0};
        for (int i = 0; i < 2; ++i)
            for (int k = 0; k < 2; ++k)
                f[i] -=
                    kSpeed * kC[i][k] * v[k] + (kGravity * kK0[i][k] + kSpeed * kSpeed * kK2[i][k]) * q[k];
        const double det = kM[0][0] * kM[1][1] - kM[0][1] * kM[1][0];
        a[0] = (kM[1][1] * f[0] - kM[0][1] * f[1]) / det;
        a[1] = (kM[0][0] * f[1] - kM[1][0] * f[0]) / det;
    }
};

double ride_error(Stage& stage)
{
    Bicycle bicycle(stage);
    const double start = energy(stage), scale = kinetic_energy(stage);
    double worst = 0;
    for (int i = stage.steps_in(3); i-- > 0;) {
        bicycle.step();
        worst = std::max(worst, std::fabs(energy(stage) - start));
    }
    return worst / scale;
}

void ride(Run& run)
{
    record_energy(run, &ride_error);
    Stage stage(run);
    Bicycle bicycle(stage);
    Linear linear;
    double largest = 0, worst = 0;
    for (int i = stage.steps_in(3); i-- > 0;) {
        bicycle.step();
        linear.advance(stage.h);
        largest = std::max(largest, std::fabs(linear.q[0]));
        worst = std::max(worst, std::fabs(bicycle.lean() - linear.q[0]));
    }
    run.record("lean", 100 * worst / largest);
}

double lean_bound(const Setting& setting) { return 100 * kSpeed / 0.3 * setting.h() + 0.5; }

std::vector<Law> ride_laws()
{
    std::vector<Law> laws = energy_laws(0.1);
    laws.push_back({"lean", "lean, off that of the linear equations, of its largest", "%", &lean_bound});
    return laws;
}

}  // namespace

extern const Scene kBicycle{
    "Machines", "bicycle",
    "the benchmark bicycle without a rider at 5 m/s, pushed to lean by 0.05 rad/s, 3 s", ride_laws(), &ride};

}  // namespace epode::trials
