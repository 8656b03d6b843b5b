// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the wheels of a vehicle stand on. With u the vehicle's up, p the hub of a wheel that hangs free, and d
// the way down of the hub from where it is compressed by `kAbove` radii beyond the travel,
//   x = travel + kAbove R - d     compression of the suspension
// For a ray the wheel is a disc in the plane across its axle a, and what it hits a plane with the normal n
// there: the hub is R |n - (n . a) a| / (n . u) above the hit, along u. A wheel whose shape meets something
// steep takes the ray instead, so that a wall at its side does not hide what is under it.
#pragma once

#include "base/array.h"
#include "collide/space.h"
#include "dynamics/forces/vehicle.h"

namespace epode {

inline constexpr Real kAbove = Real(0.5);  // of the radius: how far above the stop of the suspension it looks
inline constexpr Real kLeastSlope = Real(0.3);  // n . u of what a wheel stands on

struct WheelContact {
    Geom* geom = nullptr;  // null: none
    int side = -1;
    Vec3 pos, normal;
    Real compression = 0;
};

// Axes of a vehicle and of its wheels, in the world.
struct VehicleFrame {
    Vec3 forward, left, up;
    Vec3 axle_of(Real steer) const;  // to the left
};
VehicleFrame frame_of(const Body& body);

class WheelCaster {
  public:
    WheelCaster(Body& body, Space& space) : body_(body), space_(space), frame_(frame_of(body)) {}

    // Finds what may be under any wheel. False: out of memory.
    [[nodiscard]] bool collect();
    WheelContact under(const VehicleWheel& wheel);
    const Array<Geom*>& candidates() const { return near_; }
    Space& space() { return space_; }

  private:
    Vec3 start_of(const dVehicleWheel& wheel) const;
    WheelContact by_ray(const VehicleWheel& wheel);
    WheelContact by_shape(const VehicleWheel& wheel);

    Body& body_;
    Space& space_;
    VehicleFrame frame_;
    Array<Geom*> near_;
};

// Where the wheels look; null: nowhere.
Space* space_of_wheels(const Body& body);

}  // namespace epode
