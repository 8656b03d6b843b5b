// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See sensors.h. An accelerometer at r from a body's centre, in the body's axes: with the velocity u = R^T v + w x r of
// its point before (0) and after (1) a step h, transport to turning axes gives the acceleration
//     a = (u1 - u0) / h + (w0 + w1) / 2 x (u0 + u1) / 2,
// exact for steady turning, and it reads a - (R0^T g + R1^T g) / 2. A joint bears the force f and torque t about the
// link's centre c; about o the link exerts -f and -(t + (c - o) x f) on its parent.
#include "robots/sensors.h"

#include <algorithm>

#include "robots/body_poses.h"
#include "robots/kinematics.h"
#include "robots/zone.h"

namespace epode::robots {

namespace {

// Sky, light from above and from behind the eye, and a colour for each class of what is no robot.
struct Shade {
    unsigned char rgb[3];
};

Shade shade(const float* color, Vec normal, Vec towards_eye)
{
    const Vec sun{-0.35, -0.3, 0.89};
    const double light =
        0.35 + 0.45 * std::max(0.0, dot(normal, sun)) + 0.2 * std::max(0.0, dot(normal, towards_eye));
    Shade out{};
    for (int i = 0; i < 3; ++i)
        out.rgb[i] = static_cast<unsigned char>(255 * std::clamp(double(color[i]) * light, 0.0, 1.0));
    return out;
}

// Squares of 1 m on planes, so that a floor shows how far it reaches.
const float* color_of_other_geom(const dQueryHit& hit)
{
    static constexpr float light[] = {0.80f, 0.79f, 0.76f}, dark[] = {0.66f, 0.66f, 0.64f},
                           body[] = {0.80f, 0.52f, 0.28f};
    if (dGeomGetBody(hit.geom)) return body;
    if (dGeomGetClass(hit.geom) != dPlaneClass) return dark;
    const double squares = std::floor(double(hit.pos[0])) + std::floor(double(hit.pos[1]));
    return std::fmod(squares, 2) == 0 ? light : dark;  // of any size
}

void write_pixel(size_t place, const dQueryHit& hit, double stretch, Vec towards_eye,
                 const std::map<dGeomID, const float*>& colors, const Pixels& pixels)
{
    if (pixels.depth) pixels.depth[place] = hit.geom ? dReal(double(hit.distance) / stretch) : dInfinity;
    if (pixels.geoms) pixels.geoms[place] = hit.geom;
    if (!pixels.color) return;
    Shade shown{{206, 220, 236}};
    const auto own = colors.find(hit.geom);
    if (hit.geom)
        shown = shade(own == colors.end() ? color_of_other_geom(hit) : own->second, vec_of(hit.normal),
                      towards_eye);
    std::copy_n(shown.rgb, 3, pixels.color + 3 * place);
}

}  // namespace

Sensors::Sensors(Robot& robot, dWorldID world)
    : robot_(robot), world_(world), feedback_(robot.model().links.size())
{
    begin();
    for (const Sensor& sensor : robot_.model().sensors) {
        Frame frame;
        const bool bears = sensor.kind == "force" || sensor.kind == "torque";
        if (bears && robot_.model().frame_named(sensor.object, frame)) watch_force(frame.link, true);
    }
}

Sensors::~Sensors()
{
    for (size_t i = 0; i < feedback_.size(); ++i) watch_force(int(i), false);
}

Vec Sensors::gravity() const
{
    dVector3 g = {0, 0, 0, 0};
    dWorldGetGravity(world_, g);
    return vec_of(g);
}

Pose Sensors::link_pose(int link) const
{
    const dBodyID body = robot_.body(link);
    if (!body) return robot_.placement();
    const Pose centre = pose_of(body);
    return centre * Pose{-robot_.model().links[size_t(link)].centre, {}};
}

std::vector<Sensors::Motion> Sensors::motion_now() const
{
    std::vector<Motion> out(robot_.model().links.size());
    for (size_t i = 0; i < out.size(); ++i) {
        const dBodyID body = robot_.body(int(i));
        out[i].pose = link_pose(int(i)) * Pose{robot_.model().links[i].centre, {}};
        if (!body) continue;
        const Quat back = conjugate(out[i].pose.q);
        out[i].linear = rotate(back, vec_of(dBodyGetLinearVel(body)));
        out[i].angular = rotate(back, vec_of(dBodyGetAngularVel(body)));
    }
    return out;
}

void Sensors::begin()
{
    before_ = now_ = motion_now();
    stepsize_ = 0;
}

void Sensors::update(double stepsize)
{
    before_ = std::move(now_);
    now_ = motion_now();
    stepsize_ = stepsize;
    robot_.pass(stepsize);
}

std::vector<double> Sensors::drive_forces() const
{
    std::vector<double> out;
    const auto& joints = robot_.model().joints;
    for (size_t i = 0; i < joints.size(); ++i) {
        const dJointID its = robot_.joint(int(i));
        const bool has_drive = joints[i].is_scalar() && its;
        out.resize(out.size() + size_t(velocities_of(joints[i])), 0);
        if (has_drive) out.back() = double(dJointGetDriveForce(its, 0));
        if (const dJointID turn = robot_.turn(int(i)))
            for (int axis = 0; axis < 3; ++axis)
                out[out.size() - 3 + size_t(axis)] = double(dJointGetDriveForce(turn, axis));
    }
    return out;
}

bool Sensors::imu(int link, const Pose& frame, Vec& specific_force, Vec& angular_velocity) const
{
    if (!(stepsize_ > 0)) return false;
    const Motion &a = before_[size_t(link)], &b = now_[size_t(link)];
    const Vec r = frame.p - robot_.model().links[size_t(link)].centre;
    const Vec u0 = a.linear + cross(a.angular, r), u1 = b.linear + cross(b.angular, r);
    const Vec turning = 0.25 * cross(a.angular + b.angular, u0 + u1);
    const Vec g = gravity();
    const Vec pull = 0.5 * (rotate(conjugate(a.pose.q), g) + rotate(conjugate(b.pose.q), g));
    specific_force = rotate(conjugate(frame.q), (1 / stepsize_) * (u1 - u0) + turning - pull);
    angular_velocity = rotate(conjugate(frame.q), b.angular);
    return true;
}

bool Sensors::watch_force(int link, bool on)
{
    const dJointID joint = robot_.holder(link);
    auto& its = feedback_[size_t(link)];
    if (!joint) return false;
    if (on == bool(its)) return true;
    its = on ? std::make_unique<dJointFeedback>() : nullptr;
    dJointSetFeedback(joint, its.get());
    return true;
}

bool Sensors::force_torque(int link, const Pose& frame, Vec& force, Vec& torque) const
{
    const auto& its = feedback_[size_t(link)];
    if (!its) return false;
    const Pose at = link_pose(link), sensor = at * frame;
    const Vec f = vec_of(its->f1), arm = at * robot_.model().links[size_t(link)].centre - sensor.p;
    force = -rotate(conjugate(sensor.q), f);
    torque = -rotate(conjugate(sensor.q), vec_of(its->t1) + cross(arm, f));
    return true;
}

bool Sensors::is_of(dGeomID geom, int link) const
{
    if (!geom) return false;
    const dBodyID body = robot_.body(link);
    if (body) return dGeomGetBody(geom) == body;
    const auto& all = robot_.geoms();
    return link == 0 && !dGeomGetBody(geom) && std::find(all.begin(), all.end(), geom) != all.end();
}

bool Sensors::feels(const Frame& zone, Vec point, Vec outwards) const
{
    const Pose at = link_pose(zone.link) * zone.pose;
    return ray_meets_zone(zone.zone, zone.size, inverse(at) * point, rotate(conjugate(at.q), outwards));
}

Touch Sensors::touch(int link, const Frame* zone) const
{
    std::vector<dWorldContact> contacts(size_t(std::max(0, dWorldGetContacts(world_, nullptr, 0))));
    dWorldGetContacts(world_, contacts.data(), int(contacts.size()));
    Touch out;
    Vec weighted;
    for (const dWorldContact& contact : contacts) {
        const double side = is_of(contact.g1, link) ? 1 : is_of(contact.g2, link) ? -1 : 0;
        const double normal = double(contact.normal_force);
        const Vec force = normal * vec_of(contact.normal) + vec_of(contact.friction_force);
        if (side == 0 || !(normal > 0)) continue;
        if (zone && !feels(*zone, vec_of(contact.pos), -side * vec_of(contact.normal))) continue;
        ++out.points;
        out.normal_force += normal;
        out.force = out.force + side * force;
        weighted = weighted + normal * vec_of(contact.pos);
    }
    if (out.normal_force > 0) out.centre = (1 / out.normal_force) * weighted;
    return out;
}

int Sensors::cast(int link, const Pose& frame, dSpaceID space, const std::vector<Vec>& directions,
                  double max_distance, int threads, std::vector<dQueryHit>& hits) const
{
    const Pose sensor = link_pose(link) * frame;
    const size_t count = directions.size();
    std::vector<dReal> origins, ways, lengths(count, dReal(max_distance));
    for (const Vec& direction : directions) {
        const Vec way = rotate(sensor.q, direction);
        origins.insert(origins.end(), {dReal(sensor.p.x), dReal(sensor.p.y), dReal(sensor.p.z)});
        ways.insert(ways.end(), {dReal(way.x), dReal(way.y), dReal(way.z)});
    }
    dQueryFilter filter;
    dQueryFilterInit(&filter, sizeof filter);
    filter.skip_body = robot_.body(link);
    hits.assign(count, dQueryHit{});
    return dSpaceRayBatch(space, int(count), origins.data(), ways.data(), lengths.data(), &filter,
                          hits.data(), threads);
}

// Block by block of rows, so that large pictures take no memory of their own.
int Sensors::take_picture(int link, const Pose& frame, dSpaceID space, const View& view,
                          const Pixels& pixels) const
{
    constexpr int kBlock = 1 << 16;
    std::map<dGeomID, const float*> colors;
    for (size_t i = 0; i < robot_.geoms().size(); ++i) colors[robot_.geoms()[i]] = robot_.color(i);
    const Vec edge = rotate(turn({1, 0, 0}, view.field / 2), {0, 0, -1});
    const double pixel = 2 * edge.y / -edge.z / view.height;
    const Quat back = (link_pose(link) * frame).q;
    const int rows = std::max(1, kBlock / view.width);
    std::vector<Vec> directions;
    std::vector<dQueryHit> hits;
    int seen = 0;
    for (int row = 0; row < view.height; ++row) {
        for (int column = 0; column < view.width; ++column)
            directions.push_back(
                {(column + 0.5 - 0.5 * view.width) * pixel, (0.5 * view.height - row - 0.5) * pixel, -1});
        if ((row + 1) % rows != 0 && row + 1 < view.height) continue;
        const size_t first = size_t(row + 1) * size_t(view.width) - directions.size();
        seen += cast(link, frame, space, directions, view.max_distance, view.threads, hits);
        for (size_t i = 0; i < hits.size(); ++i) {
            const double stretch = length(directions[i]);
            const Vec towards_eye = rotate(back, (-1 / stretch) * directions[i]);
            write_pixel(first + i, hits[i], stretch, towards_eye, colors, pixels);
        }
        directions.clear();
    }
    return seen;
}

}  // namespace epode::robots
