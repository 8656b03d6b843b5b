// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A robot's model as flat arrays, for kernels that step many copies of it side by side. Topology is whole numbers, the same for all
// copies; everything that has a unit is one of `numbers`, which copies may have of their own.
//
// A degree of freedom (dof) is one component of the velocity; its chain is those of its ancestors, from the root on, and itself. Chains
// of a tree are prefixes of one another, so a row of the mass matrix is stored along the chain of its dof.
#pragma once

#include <string>
#include <vector>

#include "batch/model/asked_pairs.h"
#include "robots/build.h"

namespace epode::batch {

using robots::JointKind;

// Numbers of an element, counted from its `first`.
namespace link_number {
enum : int {
    kPlace = 0,
    kTurn = 3,
    kMass = 7,
    kCentre = 8,
    kInertia = 11,
    kCount = 17
};  // inertia xx yy zz xy xz yz
}
namespace joint_number {
enum : int { kAxis = 0, kAnchor = 3, kReference = 6, kCount = 7 };
}
namespace dof_number {
enum : int {
    kArmature,
    kDamping,
    kStiffness,
    kRest,
    kFriction,
    kLow,
    kHigh,
    kStopStiffness,
    kStopDamping,
    kForceLimit,
    kCount
};
}
namespace actuator_number {
enum : int { kGear, kGain, kBias, kBiasPosition, kBiasVelocity, kLow, kHigh, kForceLow, kForceHigh, kCount };
}
namespace filter_number {
enum : int { kTime, kLow, kHigh, kCount };
}
namespace box_number {  // from kInertias on three of each, of moving along the axes; then of turning
enum : int { kPlace = 0, kTurn = 3, kInertias = 7, kQuadratic = 10, kLinear = 13, kSpin = 9, kCount = 25 };
}
namespace curve_number {  // x = sum f q - kZero; kFirst x^2 + ...
enum : int { kZero, kFirst, kCount = 4 };
}
namespace sum_number {
enum : int { kLow, kHigh, kRest, kStiffness, kDamping, kForceLimit, kCount };
}
namespace shape_number {
enum : int { kPlace = 0, kTurn = 3, kSize = 7, kCount = 10 };
}
namespace pair_number {
enum : int { kFriction, kStiffness, kDamping, kTorsion, kRolling, kCount };  // stiffness 0: rigid
}

struct BatchLink {
    int parent = 0, first_joint = 0, joints = 0;
    int tree = 0;           // which floating or fixed base carries it
    int first = 0;          // of its numbers
    int last_dof = -1;      // the deepest that moves it; -1: it stands still
    bool is_turned = true;  // against its parent, at the reference
    bool is_weightless = false;
};

struct BatchJoint {
    JointKind kind = JointKind::kHinge;
    int link = 0, position = 0, dof = 0, first = 0;
    bool is_at_origin = false;  // of its link's frame: its anchor is zero
};

struct Dof {
    int link = 0, joint = 0, depth = 0;  // depth: how many ancestors it has
    int chain = 0;                       // where its chain begins among all
    int row = 0;  // where its row of the mass matrix begins: along the chain, itself last
    int first = 0;
    bool is_limited = false, has_friction = false, is_scalar = false;
    int limit = -1, dry = -1, servo = -1;  // which warm impulse is whose
    int wide = -1, wide_y = 0;  // the support of its rows that loops widen, and where y is; -1: its chain
};

struct BatchActuator {
    int dof = 0, position = 0, first = 0;
    bool is_servo = false;
    int sum = -1;                       // that it pulls on, in place of a dof
    int filter = -1, filter_first = 0;  // which activation is its, and where the filter's numbers are
    robots::Activation::Kind kind = robots::Activation::Kind::kNone;
    bool is_early = false;  // what acts is the activation at the step's end
};

// What of a link a medium resists.
struct BatchBox {
    int link = 0, first = 0;
};

struct SumTerm {
    int dof = 0, position = 0, factor = 0;  // factor: which number
};

// A weighted sum of coordinates: a coupling, which keeps it at its low end, or a tendon (lanes/sums.h). A coupling may be bent: less a
// polynomial of another sum.
struct BatchSum {
    int first_term = 0, terms = 0;  // in sum_terms
    int first_inner = 0, inner = 0,
        curve = -1;              // of the other sum, and where its numbers are; -1: it is straight
    int support = 0, width = 0;  // in sum_dofs: its dofs with their ancestors, ascending
    int places = -1;             // of loops' dofs among them; -1: it moves none
    int first = 0;
    int stop = -1, drive = -1;  // which of the sums' rows keeps limits, which pulls
    bool is_equality = false;
};

enum class PointKind {  // of a pair: the shape of link a, then that of link b
    kSpherePlane,
    kCapsulePlane,
    kBoxPlane,
    kCylinderPlane,
    kEllipsoidPlane,
    kSphereSphere,
    kSphereCapsule,
    kCapsuleCapsule,
    kSphereBox,
    kAsked  // of the library, copy by copy
};
int points_of(PointKind kind);

struct BatchShape {
    int link = 0, first = 0;
    bool is_turned = true;
};

// Two shapes that may touch. The normal of a contact points from b to a.
struct BatchPair {
    PointKind kind = PointKind::kSpherePlane;
    int shape_a = 0, shape_b = 0, first = 0;
    int slots = 0, first_slot = 0;
    int first_turn = -1;      // of its slots' friction against turning; -1: it has none
    bool rolls = false;       // with friction against rolling
    int support = 0;          // of its rows, among all supports
    bool is_upright = false;  // a plane whose normal is z
    int asked = -1;           // which of those
};

// The dofs that a contact between two links moves: those that both have, whose own effects cancel, then those of one and of the other,
// then those that loops let move with them.
struct Support {
    int first = 0, common = 0, of_a = 0, of_b = 0,
        width = 0;  // dofs, from `first` on in support_dofs; width: all
    int tree_a = 0, tree_b = 0;
    int places = -1;  // of loops' dofs among them; -1: it moves none
    [[gnu::always_inline]] int of_chains() const { return common + of_a + of_b; }
};

// Two frames of links that stay on one another, as a whole (weld) or with their origins.
struct BatchLoop {
    int link_a = 0, link_b = 0, first_a = 0, first_b = 0;  // first: of a frame's numbers, place and turn
    int row = 0;                                           // its first among the loops'
    bool is_weld = false;
    [[gnu::always_inline]] int rows() const { return is_weld ? 6 : 3; }
};

// What sensors read (lanes/sensors.h): of joints, of actuators, of tendons, of the whole, of frames, and, from kAccelerometer on, of the
// last step.
enum class SensorKind {
    kPosition,
    kVelocity,
    kLimitPlace,
    kLimitRate,
    kLimitForce,  // of the last step
    kJointForce,
    kActuatorForce,
    kActuatorLength,
    kActuatorRate,
    kTendonLength,
    kTendonRate,
    kTendonLimitPlace,
    kTendonLimitRate,
    kTendonLimitForce,  // of the last step
    kKinetic,
    kPotential,
    kPlace,
    kTurn,
    kAxisX,
    kAxisY,
    kAxisZ,
    kLinear,
    kAngular,
    kVelocimeter,
    kGyro,
    kMagnetometer,
    kCentre,
    kCentreVelocity,
    kMomentum,
    kAccelerometer,
    kLinearAcceleration,
    kTurningAcceleration,
    kForce,
    kTorque,
    kTouch
};

struct BatchSensor {
    SensorKind kind = SensorKind::kPosition;
    int address = 0, values = 0;  // among all; 0: it is not computed
    int object = 0;               // position, dof, actuator or sum
    int link = 0, first = 0;      // of a frame, and where its place and turn are among the numbers
    int reference = -1,
        reference_first = 0;   // the frame that sees it; -1: the world, of a magnetometer with its field
    bool is_on_child = false;  // its force is that on the link, not on its parent
    double low = 0, high = 0;  // between which it reads; both 0: any
};

struct BatchModel {
    std::string name;
    std::vector<BatchLink> links;
    std::vector<BatchJoint> joints;
    std::vector<Dof> dofs;
    std::vector<int> chains;
    std::vector<BatchActuator> actuators;
    std::vector<BatchShape> shapes;
    std::vector<BatchPair> pairs;
    std::vector<Support> supports;
    std::vector<int> support_dofs;
    AskedPairs asked;
    std::vector<BatchBox> boxes;
    std::vector<BatchSum> sums;
    std::vector<SumTerm> sum_terms;
    std::vector<int> sum_dofs;
    std::vector<BatchSensor> sensors;
    std::vector<BatchLoop> loops;
    std::vector<int> loop_dofs, loop_places;  // ascending, with all ancestors; of each dof its place there
    std::vector<int> places;                  // of loops' dofs in rows that they widen
    std::vector<double> numbers;
    std::vector<double> reference;  // positions
    int positions = 0, velocities = 0, controls = 0, trees = 0, slots = 0,
        entries = 0;                                    // entries: of the mass matrix
    int limits = 0, dry = 0, servos = 0, sum_rows = 0;  // rows that they may make
    int turns = 0;                                      // slots with friction against turning
    int filters = 0;                                    // activations
    int sensor_values = 0, accelerations = 0;           // of sensors; kept for them: all, or none
    int loop_rows = 0, wide = 0;                        // wide: entries of y of dofs that loops widen
    int gravity = 0, wind = 0,
        terrain = 0;  // where their three numbers begin; terrain: a shift of all that stands still
    // Of all rows of constraints the impulses of the last step, three a slot of contact; at the end three more, of its turning, then of
    // loops.
    int impulses() const { return 3 * slots + limits + dry + servos + sum_rows + 3 * turns + loop_rows; }
};

// False: what a batch cannot take, as a sentence that names the element.
bool compile(const std::shared_ptr<const robots::Prepared>& prepared, BatchModel& out, std::string& refusal);

}  // namespace epode::batch
