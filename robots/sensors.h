// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What sensors on a built robot's links read. A frame is a pose in a link's frame.
#pragma once

#include <ode/ext.h>

#include <map>

#include "robots/build.h"
#include "robots/shape_distances.h"

namespace epode::robots {

struct Touch {
    int points = 0;
    double normal_force = 0;
    Vec force, centre;
};

struct View {
    int width = 320, height = 240, threads = 1;
    double field = 0.8, max_distance = 100;
};

// Row by row from the top; each may be null.
struct Pixels {
    dReal* depth = nullptr;
    dGeomID* geoms = nullptr;
    unsigned char* color = nullptr;
};

class Sensors {
  public:
    Sensors(Robot& robot, dWorldID world);
    ~Sensors();
    Sensors(const Sensors&) = delete;
    Sensors& operator=(const Sensors&) = delete;

    // Forgets the joints: they have been or will be destroyed with their world.
    void release() { feedback_.clear(); }

    // The motion of all bodies now; what it was becomes the past. begin: there is no past.
    void begin();
    void update(double stepsize);  // notes all bodies' motion; the robot's clock goes on
    std::vector<double> drive_forces() const;
    // Specific force and angular velocity; false before the first update.
    bool imu(int link, const Pose& frame, Vec& specific_force, Vec& angular_velocity) const;
    // False for a link that no joint holds.
    bool watch_force(int link, bool on);
    // False for a link that is not watched.
    bool force_torque(int link, const Pose& frame, Vec& force, Vec& torque) const;
    // zone: of its frame, where that has one; else the whole link.
    Touch touch(int link, const Frame* zone = nullptr) const;
    int cast(int link, const Pose& frame, dSpaceID space, const std::vector<Vec>& directions,
             double max_distance, int threads, std::vector<dQueryHit>& hits) const;
    int take_picture(int link, const Pose& frame, dSpaceID space, const View& view,
                     const Pixels& pixels) const;
    // Empty and a problem where there is nothing to read.
    std::vector<double> read(int sensor, dSpaceID space, std::string& problem);

  private:
    struct Motion {
        Pose pose;            // of the centre
        Vec linear, angular;  // in the body's axes
    };
    struct Seen {  // a frame in the world
        Pose at;
        Vec linear, angular;
    };
    std::vector<Motion> motion_now() const;
    Seen seen(const Frame& frame) const;
    Pose link_pose(int link) const;
    bool is_of(dGeomID geom, int link) const;
    Vec gravity() const;
    std::vector<double> read_joint(const Sensor& sensor) const;
    std::vector<double> read_motion(const Sensor& sensor, const Frame& frame) const;
    std::vector<double> read_subtree(const Sensor& sensor, int root) const;
    std::vector<double> read_acceleration(const Sensor& sensor, const Frame& frame) const;
    std::vector<double> read_limit(const Sensor& sensor) const;
    std::vector<double> read_tendon(const Sensor& sensor) const;
    std::vector<double> read_distance(const Sensor& sensor);
    std::vector<double> read_inside(const Sensor& sensor, const Frame& frame) const;
    std::vector<double> read_uncut(const Sensor& sensor, dSpaceID space, std::string& problem);
    bool feels(const Frame& zone, Vec point, Vec outwards) const;

    Robot& robot_;
    dWorldID world_;
    std::vector<Motion> before_, now_;
    double stepsize_ = 0;  // 0: no past
    std::vector<std::unique_ptr<dJointFeedback>> feedback_;
    std::unique_ptr<ShapeDistances> distances_;  // made by the first sensor that wants one
};

}  // namespace epode::robots
