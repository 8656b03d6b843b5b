// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See kinematics.h. A twist (w, v) has v at the world's origin; a velocity's direction is a twist S, of a hinge
// (a, p x a), of a slider (0, a). Down the tree
//     V = V_parent + S q',    A = A_parent + S q'' + V x (S q'),    (w, v) x (a, b) = (w x a, w x b + v x a),
// where a free joint's linear part does not turn and adds nothing to the last term. A link's centre c then has
// the acceleration  A_v + A_w x c + w x (v + w x c), and Newton's and Euler's laws give the wrench that goes up the tree.
// (Featherstone, Rigid Body Dynamics Algorithms, 2008, chapter 5.)
#include "robots/kinematics.h"

#include "robots/tendon_armature.h"

namespace epode::robots {

namespace {

struct Twist {
    Vec w, v;
};

Twist operator+(Twist a, Twist b) { return {a.w + b.w, a.v + b.v}; }
Twist operator*(double s, Twist a) { return {s * a.w, s * a.v}; }
Twist cross(Twist a, Twist b) { return {cross(a.w, b.w), cross(a.w, b.v) + cross(a.v, b.w)}; }

// About an axis through a point.
Twist about(Vec axis, Vec point) { return {axis, cross(point, axis)}; }

// Of every velocity the direction at these positions, joint by joint; and the links' poses.
struct Directions {
    std::vector<Pose> poses;
    std::vector<Twist> twists;
    std::vector<int> first;  // velocity of each joint
};

// A joint's axis stands where the joints up to it have taken it: their later ones at the reference.
Pose pose_after(const RobotModel& model, const Link& link, size_t joints, const std::vector<Pose>& poses,
                const std::vector<double>& positions)
{
    Pose pose = poses[size_t(link.parent)] * link.pose;
    for (size_t k = 0; k < joints; ++k)
        pose = moved_by(model.joints[size_t(link.joints[k])], pose, positions);
    return pose;
}

Directions directions(const RobotModel& model, const std::vector<double>& positions)
{
    Directions out;
    out.poses = forward_kinematics(model, positions);
    int count = 0;
    for (const Joint& joint : model.joints) {
        out.first.push_back(count);
        count += velocities_of(joint);
    }
    out.twists.resize(size_t(count));
    for (const Link& link : model.links)
        for (size_t k = 0; k < link.joints.size(); ++k) {
            const size_t number = size_t(link.joints[k]);
            const Joint& joint = model.joints[number];
            const Pose& whole = out.poses[size_t(joint.link)];
            const Pose here =
                joint.kind == JointKind::kFree ? whole : pose_after(model, link, k + 1, out.poses, positions);
            Twist* its = &out.twists[size_t(out.first[number])];
            if (joint.kind == JointKind::kHinge)
                *its = about(rotate(here.q, joint.axis), here * joint.anchor);
            if (joint.kind == JointKind::kSlide) *its = {{}, rotate(here.q, joint.axis)};
            if (joint.is_scalar()) continue;
            const bool is_free = joint.kind == JointKind::kFree;
            const Vec centre = is_free ? whole.p : here * joint.anchor;
            for (int i = 0; i < 3; ++i) {
                Vec e;
                e[i] = 1;
                if (is_free) its[i] = {{}, e};
                its[is_free ? 3 + i : i] = about(rotate(whole.q, e), centre);
            }
        }
    return out;
}

}  // namespace

int velocities_of(const Joint& joint)
{
    return joint.kind == JointKind::kFree ? 6 : joint.kind == JointKind::kBall ? 3 : 1;
}

int number_of_velocities(const RobotModel& model)
{
    int count = 0;
    for (const Joint& joint : model.joints) count += velocities_of(joint);
    return count;
}

std::vector<double> moved_positions(const RobotModel& model, const std::vector<double>& positions,
                                    const std::vector<double>& velocities)
{
    std::vector<double> out = positions;
    const double* its = velocities.data();
    for (const Joint& joint : model.joints) {
        double* q = &out[size_t(joint.position)];
        for (int i = 0; i < (joint.is_scalar() ? 1 : joint.kind == JointKind::kFree ? 3 : 0); ++i)
            *q++ += *its++;
        if (joint.is_scalar()) continue;
        const Vec w{its[0], its[1], its[2]};
        const Quat turned = normalised(normalised({q[0], q[1], q[2], q[3]}) * turn(w, length(w)));
        q[0] = turned.w, q[1] = turned.x, q[2] = turned.y, q[3] = turned.z, its += 3;
    }
    return out;
}

std::vector<double> difference(const RobotModel& model, const std::vector<double>& from,
                               const std::vector<double>& to)
{
    std::vector<double> out;
    for (const Joint& joint : model.joints) {
        const double *a = &from[size_t(joint.position)], *b = &to[size_t(joint.position)];
        const int lengths = joint.is_scalar() ? 1 : joint.kind == JointKind::kFree ? 3 : 0;
        for (int i = 0; i < lengths; ++i) out.push_back(*b++ - *a++);
        if (joint.is_scalar()) continue;
        const Quat e = conjugate(normalised({a[0], a[1], a[2], a[3]})) * normalised({b[0], b[1], b[2], b[3]});
        const double side = e.w < 0 ? -2 : 2;
        out.insert(out.end(), {side * e.x, side * e.y, side * e.z});
    }
    return out;
}

std::vector<LinkVelocity> link_velocities(const RobotModel& model, const std::vector<double>& positions,
                                          const std::vector<double>& velocities)
{
    const Directions all = directions(model, positions);
    std::vector<Twist> twists(model.links.size());
    std::vector<LinkVelocity> out(model.links.size());
    for (size_t i = 1; i < model.links.size(); ++i) {
        twists[i] = twists[size_t(model.links[i].parent)];
        for (int joint : model.links[i].joints)
            for (int k = 0; k < velocities_of(model.joints[size_t(joint)]); ++k) {
                const size_t d = size_t(all.first[size_t(joint)] + k);
                twists[i] = twists[i] + velocities[d] * all.twists[d];
            }
        out[i] = {twists[i].w, twists[i].v + cross(twists[i].w, all.poses[i].p)};
    }
    return out;
}

std::vector<double> jacobian(const RobotModel& model, const std::vector<double>& positions, int link,
                             Vec point)
{
    const Directions all = directions(model, positions);
    const size_t n = all.twists.size();
    std::vector<double> out(6 * n, 0);
    const Vec place = all.poses[size_t(link)] * point;
    for (; link > 0; link = model.links[size_t(link)].parent)
        for (int joint : model.links[size_t(link)].joints)
            for (int i = 0; i < velocities_of(model.joints[size_t(joint)]); ++i) {
                const size_t column = size_t(all.first[size_t(joint)] + i);
                const Twist& s = all.twists[column];
                const Vec linear = s.v + cross(s.w, place);
                for (int row = 0; row < 3; ++row) {
                    out[size_t(row) * n + column] = linear[row];
                    out[size_t(row + 3) * n + column] = s.w[row];
                }
            }
    return out;
}

std::vector<double> inverse_dynamics(const RobotModel& model, const std::vector<double>& positions,
                                     const std::vector<double>& velocities,
                                     const std::vector<double>& accelerations, Vec gravity)
{
    const Directions all = directions(model, positions);
    const size_t count = model.links.size();
    std::vector<Twist> velocity(count), acceleration(count),
        wrench(count);  // of a wrench: torque at the origin, force
    for (size_t i = 1; i < count; ++i) {
        const Link& link = model.links[i];
        Twist v = velocity[size_t(link.parent)], a = acceleration[size_t(link.parent)];
        for (int number : link.joints) {
            const Joint& joint = model.joints[size_t(number)];
            Twist turning;
            for (int k = 0; k < velocities_of(joint); ++k) {
                const size_t d = size_t(all.first[size_t(number)] + k);
                v = v + velocities[d] * all.twists[d];
                a = a + accelerations[d] * all.twists[d];
                if (joint.kind != JointKind::kFree || k >= 3)
                    turning = turning + velocities[d] * all.twists[d];
            }
            a = a + cross(v, turning);
        }
        velocity[i] = v, acceleration[i] = a;
        const Vec c = all.poses[i] * link.centre;
        const Vec of_centre =
            a.v + cross(a.w, c) + cross(v.w, v.v + cross(v.w, c)) - (link.is_weightless ? Vec{} : gravity);
        const Matrix tensor = rotated(link.inertia, all.poses[i].q);
        const Vec force = link.mass * of_centre;
        wrench[i] = {apply(tensor, a.w) + cross(v.w, apply(tensor, v.w)) + cross(c, force), force};
    }
    std::vector<double> out(all.twists.size(), 0);
    for (size_t i = count; i-- > 1;) {
        const Link& link = model.links[i];
        for (int number : link.joints)
            for (int k = 0; k < velocities_of(model.joints[size_t(number)]); ++k) {
                const size_t d = size_t(all.first[size_t(number)] + k);
                out[d] = dot(all.twists[d].w, wrench[i].w) + dot(all.twists[d].v, wrench[i].v) +
                         model.joints[size_t(number)].armature * accelerations[d];
            }
        wrench[size_t(link.parent)] = wrench[size_t(link.parent)] + wrench[i];
    }
    add_armature_forces(model, positions, velocities, accelerations, out);
    return out;
}

struct PointForces::Tree {
    const RobotModel& model;
    Directions all;
    std::vector<Twist> wrenches;  // on links: torque at the origin, force
};

PointForces::PointForces(const RobotModel& model, const std::vector<double>& positions)
    : tree_(new Tree{model, directions(model, positions), std::vector<Twist>(model.links.size())})
{}

PointForces::~PointForces() = default;

const std::vector<Pose>& PointForces::poses() const { return tree_->all.poses; }

void PointForces::clear() { tree_->wrenches.assign(tree_->wrenches.size(), {}); }

void PointForces::add(int link, Vec point, Vec force)
{
    Twist& its = tree_->wrenches[size_t(link)];
    its = its + Twist{cross(point, force), force};
}

void PointForces::add_torque(int link, Vec torque)
{
    Twist& its = tree_->wrenches[size_t(link)];
    its = its + Twist{torque, {}};
}

std::vector<double> PointForces::along_velocities() const
{
    const Directions& all = tree_->all;
    std::vector<Twist> wrenches = tree_->wrenches;
    std::vector<double> out(all.twists.size(), 0);
    for (size_t i = wrenches.size(); i-- > 1;) {
        const Link& link = tree_->model.links[i];
        for (int joint : link.joints)
            for (int k = 0; k < velocities_of(tree_->model.joints[size_t(joint)]); ++k) {
                const size_t d = size_t(all.first[size_t(joint)] + k);
                out[d] = dot(all.twists[d].w, wrenches[i].w) + dot(all.twists[d].v, wrenches[i].v);
            }
        wrenches[size_t(link.parent)] = wrenches[size_t(link.parent)] + wrenches[i];
    }
    return out;
}

namespace {

// What moves as one: mass, first moment and moment of inertia about the world's origin.
struct Composite {
    double mass = 0;
    Vec first;
    Matrix about_origin{};

    void add(const Composite& other)
    {
        mass += other.mass, first = first + other.first;
        for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j) about_origin[i][j] += other.about_origin[i][j];
    }
    // The wrench (torque at the origin, force) that gives it the acceleration a, at rest.
    Twist wrench(const Twist& a) const
    {
        return {apply(about_origin, a.w) + cross(first, a.v), mass * a.v + cross(a.w, first)};
    }
};

Composite composite_of(const Link& link, const Pose& pose)
{
    const Vec c = pose * link.centre;
    Composite out{link.mass, link.mass * c, rotated(link.inertia, pose.q)};
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
            out.about_origin[size_t(i)][size_t(j)] += link.mass * ((i == j ? dot(c, c) : 0) - c[i] * c[j]);
    return out;
}

// Of each link with all that it carries.
std::vector<Composite> composites(const RobotModel& model, const std::vector<Pose>& poses)
{
    std::vector<Composite> out(model.links.size());
    for (size_t i = out.size(); i-- > 1;) {
        out[i].add(composite_of(model.links[i], poses[i]));
        out[size_t(model.links[i].parent)].add(out[i]);
    }
    return out;
}

}  // namespace

// M_ij = S_i . (I S_j), where I is all that the joint of j carries, and i acts on j's link: on the way to the root or itself.
// (Featherstone, chapter 6: the composite-rigid-body algorithm.)
std::vector<double> mass_matrix(const RobotModel& model, const std::vector<double>& positions)
{
    const Directions all = directions(model, positions);
    const std::vector<Composite> carried = composites(model, all.poses);
    const size_t n = all.twists.size();
    std::vector<double> out(n * n, 0);
    const auto fill = [&](size_t j, const Twist& wrench, int joint) {
        for (int k = 0; k < velocities_of(model.joints[size_t(joint)]); ++k) {
            const size_t i = size_t(all.first[size_t(joint)] + k);
            out[i * n + j] = out[j * n + i] = dot(all.twists[i].w, wrench.w) + dot(all.twists[i].v, wrench.v);
        }
    };
    for (const Joint& joint : model.joints)
        for (int k = 0; k < velocities_of(joint); ++k) {
            const size_t j = size_t(all.first[size_t(&joint - model.joints.data())] + k);
            const Twist wrench = carried[size_t(joint.link)].wrench(all.twists[j]);
            for (int link = joint.link; link > 0; link = model.links[size_t(link)].parent)
                for (int other : model.links[size_t(link)].joints) fill(j, wrench, other);
            out[j * n + j] += joint.armature;
        }
    add_armatures(model, positions, out);
    return out;
}

}  // namespace epode::robots
