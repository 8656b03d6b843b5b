// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A convex solid for the reference: what it is and where, and its farthest point in any direction, in double
// precision whatever dReal is. Made together with the geom that stands for it in the library, whose pose it
// reads back. Nothing here is shared with src/.
#pragma once

#include <ode/ode.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace epode::reference {

using Point = std::array<double, 3>;

inline double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline Point sum(const Point& a, double t, const Point& b)
{
    return {a[0] + t * b[0], a[1] + t * b[1], a[2] + t * b[2]};
}
double norm(const Point& a);
Point unit(const Point& a);

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : state_(seed) {}
    double in(double lo, double hi)
    {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return lo + (hi - lo) * double(state_ >> 11) * 0x1p-53;
    }
    Point direction();

  private:
    std::uint64_t state_;
};

inline constexpr const char* kKinds[] = {"sphere", "box",       "capsule", "cylinder", "convex",
                                         "cone",   "ellipsoid", "tapered", "plane"};

class Solid {
  public:
    // Sizes of 0.1 to 1; a convex one is a prism, an antiprism, a pyramid or a ball of 3 to 60 points.
    Solid(const std::string& kind, Dice& dice);
    Solid(const Solid&) = delete;
    Solid& operator=(const Solid&) = delete;
    ~Solid() { dGeomDestroy(geom_); }

    dGeomID geom() const { return geom_; }
    bool is_plane() const { return shape_ == Shape::kPlane; }
    double reach() const { return reach_; }        // from the geom's position
    const Point& normal() const { return half_; }  // of a plane, and its distance
    double distance() const { return radius_; }

    void place(const Point& position, Dice& turn);
    void move(const Point& by);
    Point position() const { return position_; }
    // Of any direction, unit or not, but of a plane.
    Point support(const Point& direction) const;

  private:
    void make_hull(Dice& dice);
    void make_tapered();
    void read_pose();

    enum class Shape { kSphere, kBox, kCapsule, kCylinder, kConvex, kCone, kEllipsoid, kTapered, kPlane };
    Shape shape_;
    dGeomID geom_ = nullptr;
    double radius_ = 0, reach_ = 0;
    Point half_{}, position_{};
    double rotation_[3][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    double balls_[2][2] = {};  // of a tapered capsule: radius, height
    std::vector<Point> vertices_;
    std::vector<dReal> points_, planes_;
    std::vector<unsigned> polygons_;
};

}  // namespace epode::reference
