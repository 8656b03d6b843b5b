// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A robot as plain data, between files and worlds. Readers make it, the builder makes worlds of it.
// The links are a tree in which a parent has a smaller number than its children; link 0 is the world. A link's pose
// is given in its parent's frame at the reference position of its joints, all of which act between the two in the
// order of the list. A joint's anchor and axis are given in the link's frame: with the coordinate q, link pose
//     X = X_parent * pose * J_1(q_1) * J_2(q_2) ...,    J(q) = T(anchor) R(axis, q - reference) T(-anchor)
// for a hinge, T((q - reference) axis) for a slider. A ball's q is a quaternion in place of R; a free joint's is
// X itself: position, then quaternion. Units are SI.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "robots/geometry.h"
#include "robots/parts/settings.h"

namespace epode::robots {

constexpr double kInfinity = HUGE_VAL;

enum class ShapeKind { kSphere, kBox, kCapsule, kCylinder, kEllipsoid, kPlane, kHull, kTriangles, kHeights };
const char* name_of(ShapeKind kind);

struct Mesh {
    std::string path;
    Vec scale{1, 1, 1};
    std::vector<Vec> vertices;  // scaled
    std::vector<std::array<std::uint32_t, 3>> triangles;
    bool counts_folds = false;  // its volume is the sum of all pyramids' sizes, inward ones too
};

// Ground over a rectangle about the origin, z up, in two triangles a cell that meet in the corners of the smallest
// and the largest x and y alike.
struct HeightField {
    std::string path;                                  // of the file that the samples come from
    double half_x = 0, half_y = 0, top = 0, base = 0;  // m; heights are 0 ... top, the base is below 0
    int rows = 0, columns = 0;
    std::vector<double> samples;  // 0 ... 1, row by row from the least y, the least x first
};

// How MJCF softens a contact or a limit: its solref and solimp (softness.h).
struct Softness {
    bool stated = false;  // false: rigid
    // Time constant, s, and damping ratio; where the first is not above 0, stiffness and damping, negated.
    double time = 0.02, ratio = 1;
    double low = 0.9, high = 0.95, width = 0.001, middle = 0.5, power = 2;  // impedance over the violation
};

struct Shape {
    std::string name;
    std::string body;  // of the file, where that has become part of the link; empty: the link's own
    ShapeKind kind = ShapeKind::kSphere;
    Pose pose;       // in the link's frame
    Vec size;        // sphere: radius; box, ellipsoid: half sizes; capsule, cylinder: radius, half length
    int mesh = -1;   // of hulls and triangles
    int field = -1;  // of heights
    double friction = 1, torsional_friction = 0, rolling_friction = 0;  // the latter two in m
    int dimensions =
        3;  // of contact, MJCF's condim: 4 with torsion, 6 with rolling too; of a pair the larger counts
    Softness softness;
    std::uint32_t category = 1, collide = 1;
    int priority = 0;  // MJCF: of two shapes that touch, the larger one's friction counts alone
    int still = 0;     // of the world's link: which of RobotModel::still it is part of, from 1 on; 0: none
    float color[4] = {0.7f, 0.7f, 0.7f, 1};
};

// Two shapes, by their names, that touch whatever their bits say, and of whose contact this alone says all (MJCF's <pair>).
struct ShapePair {
    std::string name, shape1, shape2;
    double friction = 1, torsional_friction = 0.005, rolling_friction = 0.0001;  // the latter two in m
    int dimensions = 3;
    Softness softness;
    int line = 0;
};

// What of a link a medium resists: a link of the file, as the box that has its inertia. Half sides, in m, along the axes
// of the pose, which stands in the link's frame.
struct FluidBox {
    Pose pose;
    double mass = 0;
    Vec moments, half;
};

// Still air or water, but for the wind.
struct Medium {
    double density = 0, viscosity = 0;  // kg/m^3, Pa s
    Vec wind;                           // m/s
    bool acts() const { return density > 0 || viscosity > 0; }
};

// What gravity does not pull, MJCF's gravcomp: a share of a mass at a point of a link.
struct Lift {
    Vec centre;
    double mass = 0, share = 0;
};

struct Link {
    std::string name;
    int parent = -1;
    Pose pose;
    std::vector<int> joints;      // none: fixed to the parent
    double mass = 0;              // kg
    Vec centre;                   // of mass
    Matrix inertia{};             // about the centre, in the link's axes
    Quat inertia_axes;            // that a file has given it in, for where moments are equal
    std::vector<FluidBox> boxes;  // none without a medium
    bool has_inertial = false;
    bool is_weightless = false;  // gravity does not pull it
    std::vector<Lift> lifts;     // else what of it is not pulled
    bool is_mocap = false;       // a child of the world, without joints, that the program puts where it wants
    std::vector<Shape> shapes;   // what touches
    std::vector<Shape> visuals;  // what is only looked at
    int line = 0;
};

enum class JointKind { kHinge, kSlide, kBall, kFree };
constexpr int coordinates(JointKind kind)
{
    return kind == JointKind::kFree ? 7 : kind == JointKind::kBall ? 4 : 1;
}
const char* name_of(JointKind kind);

struct Joint {
    std::string name;
    JointKind kind = JointKind::kHinge;
    int link = 0;
    Vec axis{0, 0, 1}, anchor;
    double reference = 0;
    bool limited = false;
    double low = -kInfinity, high = kInfinity;
    double max_force = kInfinity, max_velocity = kInfinity;
    double stiffness = 0, spring_reference = 0, damping = 0, armature = 0, friction = 0;
    Softness stop_softness;
    int position = 0;  // where its coordinates begin among all
    int line = 0;
    int coordinates() const { return robots::coordinates(kind); }
    bool is_scalar() const { return kind == JointKind::kHinge || kind == JointKind::kSlide; }
};

// sum of factor_i q_i = offset, the polynomial's higher terms apart.
struct Coupling {
    struct Term {
        int joint = -1;
        double factor = 0;
    };
    std::string name;
    std::vector<Term> terms;
    double offset = 0;
    std::vector<double> polynomial;  // of MJCF's joint equality beyond the linear term; empty: linear
    // Of MJCF's equality of tendons: these, and the factor of the second.
    std::array<int, 2> tendons{-1, -1};
    double ratio = 0;
    int line = 0;
};

// A loop: a point (connect) or a frame (weld) of one link stays on that of another.
struct Closure {
    std::string name;
    bool weld = false;
    int link1 = 0, link2 = 0;
    Pose pose1, pose2;
    int line = 0;
};

// An equality of two tendons of which one has a path, of the lengths L and K and what they are at the reference position, r and s:
//     L - r = c0 + c1 (K - s) + c2 (K - s)^2 + ...;    without a second tendon L - r = c0.
struct Tie {
    std::string name;
    int tendon1 = -1, tendon2 = -1;  // -1 of the second: none
    std::array<double, 5> curve{0, 1, 0, 0, 0};
    double rest1 = 0, rest2 = 0;
    int line = 0;
};

// A part of a spatial tendon's path: a site that it passes, a surface that it may go round between two sites, or a pulley, at which
// the path ends and begins again, what follows counting one divisor-th.
struct PathPart {
    enum class Kind { kSite, kSphere, kCylinder, kPulley };
    Kind kind = Kind::kSite;
    int link = 0;  // of site and surface, and where in it
    Pose pose;
    double radius = 0;
    int side_link = -1;  // of the point that says how it goes round (wrap.h); -1: none
    Vec side;
    double divisor = 1;
};

// For actuators, springs and limits: a weighted sum of coordinates, or the length of a path.
struct Tendon {
    std::string name;
    std::vector<Coupling::Term> terms;
    std::vector<PathPart> path;  // of a spatial one, which has no terms
    double low = -kInfinity, high = kInfinity;
    double stiffness = 0, damping = 0, friction = 0, armature = 0;
    bool has_rest = false;           // else its spring rests at the reference position
    double rest = 0, rest_high = 0;  // a spatial one's anywhere between the two, a sum's at the first
    int line = 0;
};

// What stands between control and force: act' = u (integrator), (u - act) / T (filters; the exact one solved over a step), or that
// of a muscle (robots/muscle.h).
struct Activation {
    enum class Kind { kNone, kIntegrator, kFilter, kExactFilter, kMuscle };
    Kind kind = Kind::kNone;
    double time = 1, low = -kInfinity, high = kInfinity;  // T, s; the range of act
    bool is_early = false;                                // the force is that of the act at a step's end
    double slower = 1, smooth = 0;  // of a muscle: the time of deactivation, s, and the width between the two
};

// MuJoCo's muscle (robots/muscle.h).
struct Muscle {
    bool acts = false;
    double low = 0.75, high = 1.05;  // of its lengths, in its own units, between the two below
    double force = -1, scale = 200;  // N at peak; below 0: so large that it gives its load `scale` m/s^2
    double shortest = 0.5, longest = 1.6, fastest = 1.5, passive = 1.3, eccentric = 1.2;
    double length_low = 0, length_high = 0;  // m or rad, of joint or tendon times the gear
};

// Of an actuator that pushes a site: the gear as a force and a torque (robots/wrench.h). Of a slider-crank: the site is that of the crank,
// the reference the slider, and the force's x the gear.
struct SiteWrench {
    int link = -1;  // -1: none
    Pose pose;      // of the site in its link
    int reference_link = -1;
    Pose reference;  // of the reference site in its
    Vec force, torque;
    double rod = -1;  // m, of a slider-crank; below 0: it is none
    bool is_crank() const { return rod >= 0; }
};

// gain = gain + gain_position gear q + gain_velocity gear w; of a damper the last alone.
// force = gear clamp(gain control + bias0 - bias_position gear q - bias_velocity gear w), clamped to the range of
// forces: a motor has gain alone, a position servo gain = bias_position, a velocity servo gain = bias_velocity.
struct Actuator {
    std::string name, kind;
    int joint = -1, tendon = -1;
    Vec direction;  // of a ball's: the gear along the link's axes
    SiteWrench wrench;
    int adhesive_link = -1;  // that it pulls towards what it touches
    double gear = 1, gain = 1, bias = 0, bias_position = 0, bias_velocity = 0;
    double low = -kInfinity, high = kInfinity;              // of the control
    double force_low = -kInfinity, force_high = kInfinity;  // of the force before the gear
    double gain_position = 0, gain_velocity = 0;
    Muscle muscle;
    Activation filter;
    std::vector<std::array<std::string, 2>> activation;  // as MJCF's attributes, to be written again
    int line = 0;
};

struct Sensor {
    std::string name, kind, object;
    int line = 0;
    std::string attribute, object_type;     // of MJCF: which one named the object; the type where it is said
    std::string reference, reference_type;  // of MJCF: relative to what a frame is read; empty: to the world
    double cutoff = 0;                      // of MJCF: largest absolute value that it reads; 0: any
    bool is_on_child = false;               // force and torque are those on the link, not on its parent
};

// A named frame: a merged link, a site.
struct Frame {
    std::string name;
    int link = 0;
    Pose pose;
    ShapeKind zone = ShapeKind::kSphere;  // of a site of MJCF, what its touch sensor feels (robots/zone.h)
    Vec size{};  // of the zone, as a shape's; 0: it has none, and feels its whole link
};

// It looks along the -z axis of its frame, x to the right, y up.
struct Camera {
    Frame frame;
    double field = 0.785398163397448;  // of view, from the lowest to the highest row, rad
};

struct Start {
    std::string name;
    std::vector<double> positions;  // as many as the model has coordinates
    std::vector<double> controls;
    std::vector<Pose>
        mocap;  // of the links that are moved by the program, in their order; empty: as in the file
};

enum class Note { kChanged, kApproximated, kIgnored, kError };
const char* name_of(Note note);

struct ReportLine {
    Note note = Note::kChanged;
    std::string file;
    int line = 0;
    std::string text;
};

struct RobotModel {
    std::string name, format, path;
    std::vector<Link> links;
    std::vector<Joint> joints;
    std::vector<Coupling> couplings;
    std::vector<Closure> closures;
    std::vector<Tie> ties;
    std::vector<Tendon> tendons;
    std::vector<Actuator> actuators;
    std::vector<Sensor> sensors;
    std::vector<Frame> frames;
    std::vector<Camera> cameras;
    std::vector<std::array<int, 2>> excluded;  // pairs of links that do not touch
    std::vector<ShapePair> pairs;
    // Bodies of the file that are fixed to the world and do not touch some link, and those pairs: link, and number from 1 on.
    std::vector<std::string> still;
    std::vector<std::array<int, 2>> excluded_still;
    std::vector<Start> starts;
    std::vector<Mesh> meshes;
    std::vector<HeightField> fields;
    std::vector<ReportLine> report;
    Vec gravity{0, 0, -9.81};
    double stepsize = 0;  // s, that the file asks for; 0: it does not say
    Medium medium;
    Vec magnetic{0, -0.5, 0};       // flux, that magnetometers read
    bool touches_itself = true;     // but what can never part; false: not what overlaps at the reference
    bool largest_friction = false;  // of a pair, as MuJoCo has it; else the geometric mean
    int coordinates = 0;
    bool decomposes_meshes = false;  // into several hulls each
    PartSettings parts;

    // Those that the program moves.
    std::vector<int> mocap_links() const;
    // -1 where there is none of that name. A frame counts with its link.
    int link_named(const std::string& wanted) const;
    // The frame of that name in its link, a link's own too; false where there is none.
    bool frame_named(const std::string& wanted, Frame& frame) const;
    // By MJCF's types: a site; a body, whose origin is its centre of mass; else as frame_named.
    bool object_named(const std::string& type, const std::string& wanted, Frame& frame) const;
    // A shape that touches or one that is only looked at, and its link; null: none.
    const Shape* any_shape_named(const std::string& wanted, int& link) const;
    int joint_named(const std::string& wanted) const;
    int tendon_named(const std::string& wanted) const;
    int actuator_named(const std::string& wanted) const;
    bool has_errors() const;
};

// Coordinates of all joints at the reference position; then, link by link, poses in the world.
std::vector<double> reference_positions(const RobotModel& model);
std::vector<Pose> forward_kinematics(const RobotModel& model, const std::vector<double>& positions);
// Where a joint takes its link from a pose.
Pose moved_by(const Joint& joint, const Pose& pose, const std::vector<double>& positions);
// Numbers the coordinates, after joints were added or removed.
void number_coordinates(RobotModel& model);

}  // namespace epode::robots
