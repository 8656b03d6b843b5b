// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Euler's equations by the implicit midpoint rule, made to fit the exponential map. In the body's frame, with
// the momentum l = I W at the ends of a step and W the spin in its middle,
//
//   l1 - l0 = -u x (l0 + l1),   (l0 + l1)/2 = I W,   u = tan(h |W| / 2) W / |W|
//
// The first says l1 = cay(2u)^T l0, and the turn by the Rodrigues vector u is exp(h W): with q1 = q0 exp(h W)
// the momentum in the world, R l, is kept to rounding. Since u is parallel to W, W.(l1 - l0) = 0, hence
// l.I^-1 l is kept: energy too. One vector equation remains, solved by Newton's method:
//
//   F(W) = I W + u x I W - l0 = 0        (torques have entered l0 before)
//
// Constraints act in the middle: v* = W, they add I^-1 J^T p, the pose turns by the sum, and l1 follows from
// what has been added. The stored velocity of a constrained body stays that of the middle, which satisfies
// the constraints; e = l - I W ("excess") carries the rest over to the next step. A free body ends with I^-1
// l1.
//
// Joints hold W and cannot see e. Where a step turns a body so far that e is a good part of l, the two drive each other without
// bound: 24 of 60 random trees at 1/60 s. There a body on joints has e put into its velocity, which keeps l, and then the implicit
// gyroscopic torque of dynamics/integrate.h, which damps. A blow changes W and not e, and as the pose turns with the new W, e comes to lie
// along other axes: of a rod that lands, along its own, where little momentum is much energy (25 rad/s became 97). What contacts hold
// begins again without e where its energy e.I^-1 e is no small part of W.I W.
//
// A wheel on an axle a spins with s = m.a and turns with what carries it by the rest r = m - s a. By exp(h m) the axle would go round m, on
// a cone: off the carrier's by h |r| (1 - sin(h s)/(h s)), h |r| itself where h s is some radians, and a fast car spun out. exp(h r) exp(h s a)
// turns a as the carrier turns it. Of a hinge the spin is what the wheel turns by more than its carrier, and r what the carrier does: rows let the two
// differ by s along the carrier's axle a', and with s a of the wheel's own r would have s (a' - a), which turned a by h s round a' and not to it, so
// that errors grew by (1 + (h s)^2)^(1/2) a step (a car of hinged wheels at 20 m/s and 1/60 s left its line after 2 s). Rejected: the same for every
// link; those between two hinges gained 2.6 % of a tree's energy (0.7 %), and joints of figures opened by 67 mm (44).
//
// Source: the midpoint rule's two invariants and their Cayley form: Austin, Krishnaprasad & Wang, "Almost
// Poisson Integration of Rigid Body Systems", J. Comp. Phys. 107 (1993); the scaling of W by tan(x)/x, which
// trades Cayley's angle 2 atan(h |W|/2) for the exact h |W|, is ours. Rejected: the momentum kept in the
// world and w = I(q)^-1 L at the middle (energy only bounded), and the unscaled rule (turns too slowly by (h
// w)^3/12).
#include "dynamics/exact_spin.h"

#include "dynamics/integrate.h"
#include "dynamics/joint.h"
#include "math/trig.h"

namespace epode {
namespace {

constexpr int kMaxNewtonSteps = 16;
constexpr Real kLargestExcess = Real(0.1);   // of the momentum, of a body on joints
constexpr Real kLargestEnergy = Real(0.05);  // of that of the velocity, of a body in contact
constexpr Real kFarTurn = Real(0.1);         // rad
constexpr Real kAlongAxle = Real(0.95);      // of the spin
constexpr Real kCentred = Real(0.01);        // of the square of the radius of gyration
constexpr Real kLargestHalfTurn2 =
    1;  // square of h |W| / 2 above which nothing is scaled: tan has a pole ahead

// s = tan(x)/x at x = h |W| / 2, and ds/dx / x.
void tangent_scale(Real x2, Real& s, Real& slope)
{
    if (x2 > kLargestHalfTurn2) {
        s = 1;
        slope = 0;
    } else if (x2 < Real(1e-4)) {
        s = 1 + x2 * (Real(1) / 3 + x2 * (Real(2) / 15 + x2 * (Real(17) / 315)));
        slope = Real(2) / 3 + x2 * (Real(8) / 15 + x2 * (Real(34) / 105));
    } else {
        const Real x = std::sqrt(x2);
        s = epode::sin(x) / (x * epode::cos(x));
        slope = (1 + s * s * x2 - s) / x2;
    }
}

constexpr Mat3 outer(Vec3 a, Vec3 b) { return {a.x * b, a.y * b, a.z * b}; }

// F(W) = 0 from l; false when Newton's method does not arrive. Without the scaling, at spins of radians per
// step, it still conserves energy and |l|.
bool solve_middle(const Sym3& I, const Sym3& inv_I, Vec3 l, Real h, bool scaled, Vec3& W)
{
    W = inv_I * l;
    const Real half = h / 2, small2 = length2(l) * (16 * kEpsilon * kEpsilon);
    Real before = kInf;
    for (int i = 0; i < kMaxNewtonSteps; ++i) {
        Real s = 1, slope = 0;
        if (scaled) tangent_scale(half * half * length2(W), s, slope);
        const Vec3 IW = I * W, turn = cross(W, IW);
        const Vec3 F = IW + (half * s) * turn - l;
        const Real now = length2(F);
        // At the limit of rounding, or no longer falling after having come near it.
        if (now <= small2 || (now >= before && now <= small2 * Real(1e6))) return true;
        before = now;
        const Mat3 dF = full(I) + (half * s) * (skew(W) * full(I) - skew(IW)) +
                        outer((half * slope * half * half) * turn, W);
        Mat3 inverse;
        if (!invert(dF, inverse)) return false;
        W -= inverse * F;
    }
    return false;
}

bool cap_spin(const Body& body, Vec3& w)
{
    if (!(body.max_angular_speed < kInf)) return false;
    const Real speed = length(w);
    if (!(speed > body.max_angular_speed)) return false;
    w *= body.max_angular_speed / speed;
    return true;
}

// With ODE's gyroscopic torque.
Vec3 turned_by_torque(const Body& body, const Mat3& R, Vec3 w, Vec3 torque, Real h)
{
    const Vec3 all = torque + gyroscopic_torque(body, R, w, h);
    return w + h * (R * (body.inv_inertia * transposed_times(R, all)));
}

}  // namespace

Vec3 kicked_spin(Body& body, Vec3 torque, Vec3 w, Real h)
{
    if (w == Vec3{} && torque == Vec3{} && body.spin_excess == Vec3{}) return w;
    return kicked_spin(body, body.rotation(), torque, w, h);
}

Vec3 kicked_spin(Body& body, const Mat3& R, Vec3 torque, Vec3 w, Real h)
{
    const Vec3 before = body.spin_excess;
    body.spin_excess = {};
    if (body.kinematic() || (w == Vec3{} && torque == Vec3{} && before == Vec3{})) return w;
    if (!body.gyroscopic || isotropic(body.inertia))
        return w + h * (R * (body.inv_inertia * transposed_times(R, torque)));

    const Vec3 l = body.inertia * transposed_times(R, w) + before + h * transposed_times(R, torque);
    Vec3 W;
    if (!solve_middle(body.inertia, body.inv_inertia, l, h, true, W) &&
        !solve_middle(body.inertia, body.inv_inertia, l, h, false, W))
        return turned_by_torque(body, R, w, torque, h);
    const Vec3 excess = l - body.inertia * W;
    if (body.lasting && length2(excess) > kLargestExcess * kLargestExcess * length2(l))
        return turned_by_torque(body, R, R * (body.inv_inertia * l), {}, h);
    body.spin_excess = excess;
    return R * W;
}

Vec3 spin_momentum(const Sym3& I, Vec3 W, Real h)
{
    Real s, slope;
    tangent_scale(h * h * length2(W) / 4, s, slope);
    const Vec3 IW = I * W;
    return IW + (h / 2 * s) * cross(W, IW);
}

namespace {

// Does the axle go through the body's centre, as that of a wheel and not of an arm?
bool is_centred(const Axle& axle, const Body& body)
{
    const Vec3 off = axle.point - dot(axle.point, axle.direction) * axle.direction;
    return body.mass.mass * length2(off) < kCentred * (body.inertia.xx + body.inertia.yy + body.inertia.zz);
}

// The only joint of a wheel that has an axle, and which of its bodies the wheel is; null: none, or several.
const JointNode* mount_of(const Body& body)
{
    const JointNode* mount = nullptr;
    for (const JointNode* n = body.lasting; n; n = n->next) {
        if (!n->joint->type->axle || n->joint->disabled) continue;
        if (mount) return nullptr;
        mount = n;
    }
    return mount;
}

// What a wheel spins by, of the rate m: if it turns far in the step, and about its axle.
Vec3 spin_of(const Body& body, const Mat3& R, Vec3 m, Real h, const Turning& turning)
{
    const JointNode* const mount = mount_of(body);
    if (!mount) return {};
    const Joint& joint = *mount->joint;
    const int side = int(mount - joint.node);
    const Axle axle = joint.type->axle(joint, side);
    const Vec3 a = R * axle.direction;
    const Real rate = dot(m, a);
    const bool far = std::fabs(rate) * h > kFarTurn && std::fabs(rate) > kAlongAxle * length(m);
    if (!far || !is_centred(axle, body)) return {};
    if (!axle.shared) return rate * a;
    const Body* const carrier = joint.node[1 - side].body;
    const Vec3 relative = m - (carrier ? turning.of(*carrier) : Vec3{});
    return std::fabs(dot(relative, a)) > kAlongAxle * length(relative) ? relative : rate * a;
}

// What spins about an axle turns about that first, and then by the rest, with whatever carries the axle.
Quat turned_by(const Body& body, Quat q, Vec3 m, Real h, const Turning& turning)
{
    if (body.finite_rotation && !(body.finite_axis == Vec3{})) return turned(body, q, m, h);
    if (!(length2(m) * h * h > kFarTurn * kFarTurn)) return turn_exactly(q, m, h);
    const Vec3 spin = spin_of(body, to_matrix(q), m, h, turning);
    return turn_exactly(turn_exactly(q, spin, h), m - spin, h);
}

// The momentum in the world stays while the body turns from R0 to R1.
void carry_excess(Body& body, const Mat3& R0, const Mat3& R1, Vec3 w)
{
    const Vec3 momentum = body.inertia * transposed_times(R0, w) + body.spin_excess,
               W = transposed_times(R1, w);
    const Vec3 moving = body.inertia * W, e = transposed_times(R1, R0 * momentum) - moving;
    const bool large = dot(e, body.inv_inertia * e) > kLargestEnergy * dot(W, moving);
    body.spin_excess = large && !body.lasting ? Vec3{} : e;
}

}  // namespace

Quat turned_exactly(Body& body, Quat q, Vec3 m, Vec3 w, Real h, const Turning& turning)
{
    const Quat after = turned_by(body, q, m, h, turning);
    if (!(body.spin_excess == Vec3{})) carry_excess(body, to_matrix(q), to_matrix(after), w);
    return after;
}

void advance_pose_exactly(Body& body, Real h, bool free)
{
    Vec3 w = body.angular_velocity();
    if (cap_spin(body, w)) {
        body.spin_excess = {};
        store(body.avel, w);
    }
    const Mat3 R0 = body.rotation();
    store(body.pos, body.position() + h * body.velocity());
    struct ByVelocities final : Turning {};
    Quat q = turned_by(body, body.orientation(), w, h, ByVelocities{});
    if (normalize(q)) set_orientation(body, q);
    if (body.spin_excess == Vec3{}) return;
    if (!free) return carry_excess(body, R0, body.rotation(), w);

    // l1 = 2 I W - l0: the same as exp(-h W) l0 where the scaling is exact, and no energy is lost where not.
    w = body.rotation() * (body.inv_inertia * (body.inertia * transposed_times(R0, w) - body.spin_excess));
    cap_spin(body, w);
    store(body.avel, w);
    body.spin_excess = {};
}

}  // namespace epode
