// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The solids of the reference: see solid.h. Polyhedra are given as points; the library finds their faces.
#include "solid.h"

#include <ode/ext.h>

#include <cmath>

namespace epode::reference {

double norm(const Point& a) { return std::sqrt(dot(a, a)); }
Point unit(const Point& a)
{
    const double n = norm(a);
    return {a[0] / n, a[1] / n, a[2] / n};
}

Point Dice::direction()
{
    for (;;) {
        const Point p = {in(-1, 1), in(-1, 1), in(-1, 1)};
        const double n = norm(p);
        if (n < 1 && n > 0.1) return unit(p);
    }
}

Solid::Solid(const std::string& kind, Dice& dice)
{
    shape_ = Shape::kPlane;
    for (std::size_t i = 0; i < std::size(kKinds); ++i)
        if (kind == kKinds[i]) shape_ = Shape(i);
    radius_ = double(dReal(dice.in(0.1, 1)));
    for (double& h : half_) h = double(dReal(dice.in(0.1, 1)));
    if (kind == "sphere") {
        geom_ = dCreateSphere(nullptr, dReal(radius_));
        reach_ = radius_;
    } else if (kind == "box") {
        geom_ = dCreateBox(nullptr, dReal(2 * half_[0]), dReal(2 * half_[1]), dReal(2 * half_[2]));
        reach_ = norm(half_);
    } else if (kind == "capsule") {
        geom_ = dCreateCapsule(nullptr, dReal(radius_), dReal(2 * half_[2]));
        reach_ = radius_ + half_[2];
    } else if (kind == "cylinder") {
        geom_ = dCreateCylinder(nullptr, dReal(radius_), dReal(2 * half_[2]));
        reach_ = std::hypot(radius_, half_[2]);
    } else if (kind == "convex") {
        make_hull(dice);
    } else if (kind == "cone") {
        geom_ = dCreateCone(nullptr, dReal(radius_), dReal(2 * half_[2]));
        reach_ = std::fmax(std::hypot(radius_, half_[2] / 2), 1.5 * half_[2]);
    } else if (kind == "ellipsoid") {
        geom_ = dCreateEllipsoid(nullptr, dReal(half_[0]), dReal(half_[1]), dReal(half_[2]));
        reach_ = std::fmax(half_[0], std::fmax(half_[1], half_[2]));
    } else if (kind == "tapered") {
        make_tapered();
    } else {
        half_ = dice.direction();
        geom_ = dCreatePlane(nullptr, dReal(half_[0]), dReal(half_[1]), dReal(half_[2]), dReal(radius_));
        dVector4 p;
        dGeomPlaneGetParams(geom_, p);
        half_ = {double(p[0]), double(p[1]), double(p[2])}, radius_ = double(p[3]);
    }
}

void Solid::make_hull(Dice& dice)
{
    const double kind = dice.in(0, 4), height = half_[2];
    const int sides = 3 + int(dice.in(0, 8));
    const auto add = [&](double x, double y, double z) {
        const Point p = {double(dReal(x)), double(dReal(y)), double(dReal(z))};
        vertices_.push_back(p);
        reach_ = std::fmax(reach_, norm(p));
    };
    if (kind < 3) {
        const double twist = kind < 1 ? 0 : 3.14159265358979323846 / sides;
        for (int i = 0; i < sides; ++i) {
            const double angle = 2 * 3.14159265358979323846 * i / sides;
            add(radius_ * std::cos(angle), radius_ * std::sin(angle), -height);
            if (kind < 2) add(half_[0] * std::cos(angle + twist), half_[0] * std::sin(angle + twist), height);
        }
        if (kind >= 2) add(0, 0, height);
    } else {
        for (int i = 0; i < 60; ++i) {
            const Point d = dice.direction();
            add(radius_ * d[0], half_[0] * d[1], height * d[2]);
        }
    }
    for (const Point& p : vertices_)
        for (const double x : p) points_.push_back(dReal(x));
    geom_ = dCreateConvexHull(nullptr, points_.data(), unsigned(vertices_.size()), 0);
}

// Where the balls are about the centre of mass, the geom's own depths tell.
void Solid::make_tapered()
{
    const double r1 = radius_, r2 = half_[0], length = double(dReal(2 * half_[2]));
    geom_ = dCreateTaperedCapsule(nullptr, dReal(r1), dReal(r2), dReal(length));
    double below = 0, above = 10;  // the lower end of the axis
    for (int i = 0; i < 200; ++i) {
        const double z = (below + above) / 2;
        (dGeomTaperedCapsulePointDepth(geom_, 0, 0, dReal(-z)) > 0 ? below : above) = z;
    }
    balls_[0][0] = r1, balls_[0][1] = r2 - r1 > length ? -below + r2 - length : -below + r1;
    balls_[1][0] = r2, balls_[1][1] = balls_[0][1] + length;
    reach_ = std::fmax(std::fabs(balls_[0][1]) + r1, std::fabs(balls_[1][1]) + r2);
}

void Solid::place(const Point& position, Dice& turn)
{
    if (is_plane()) return;
    dQuaternion q;
    double n;
    do {
        n = 0;
        for (dReal& v : q) v = dReal(turn.in(-1, 1)), n += double(v) * double(v);
    } while (n > 1 || n < 0.01);
    const double kind = turn.in(0, 1);
    if (kind < 0.2) q[1] = q[2] = q[3] = 0, q[0] = 1;
    if (kind >= 0.2 && kind < 0.4) q[1] = q[2] = 0;
    dNormalize4(q);
    dGeomSetQuaternion(geom_, q);
    dGeomSetPosition(geom_, dReal(position[0]), dReal(position[1]), dReal(position[2]));
    read_pose();
}

void Solid::move(const Point& by)
{
    const Point p = sum(position_, 1, by);
    dGeomSetPosition(geom_, dReal(p[0]), dReal(p[1]), dReal(p[2]));
    read_pose();
}

void Solid::read_pose()
{
    const dReal *p = dGeomGetPosition(geom_), *r = dGeomGetRotation(geom_);
    for (std::size_t i = 0; i < 3; ++i) {
        position_[i] = double(p[i]);
        for (std::size_t j = 0; j < 3; ++j) rotation_[i][j] = double(r[4 * i + j]);
    }
}

Point Solid::support(const Point& direction) const
{
    const auto& r = rotation_;
    const Point& g = direction;
    const Point d = {r[0][0] * g[0] + r[1][0] * g[1] + r[2][0] * g[2],
                     r[0][1] * g[0] + r[1][1] * g[1] + r[2][1] * g[2],
                     r[0][2] * g[0] + r[1][2] * g[1] + r[2][2] * g[2]};
    const auto side = [](double v, double h) { return v < 0 ? -h : h; };
    Point s{};
    switch (shape_) {
        case Shape::kSphere:
            s = sum({0, 0, 0}, radius_ / norm(d), d);
            break;
        case Shape::kBox:
            s = {side(d[0], half_[0]), side(d[1], half_[1]), side(d[2], half_[2])};
            break;
        case Shape::kCapsule:
            s = sum({0, 0, side(d[2], half_[2])}, radius_ / norm(d), d);
            break;
        case Shape::kCylinder: {
            const double across = std::sqrt(d[0] * d[0] + d[1] * d[1]);
            if (across > 0) s = {radius_ * d[0] / across, radius_ * d[1] / across, 0};
            s[2] = side(d[2], half_[2]);
            break;
        }
        case Shape::kCone: {
            const double across = std::sqrt(d[0] * d[0] + d[1] * d[1]), length = 2 * half_[2];
            if (length * d[2] > radius_ * across)
                s = {0, 0, 0.75 * length};
            else
                s = {across > 0 ? radius_ * d[0] / across : 0, across > 0 ? radius_ * d[1] / across : 0,
                     -0.25 * length};
            break;
        }
        case Shape::kEllipsoid: {
            const Point along = {half_[0] * d[0], half_[1] * d[1], half_[2] * d[2]};
            for (std::size_t i = 0; i < 3; ++i) s[i] = half_[i] * along[i] / norm(along);
            break;
        }
        case Shape::kTapered: {
            const bool first =
                balls_[0][1] * d[2] + balls_[0][0] * norm(d) > balls_[1][1] * d[2] + balls_[1][0] * norm(d);
            const double* ball = balls_[first ? 0 : 1];
            s = sum({0, 0, ball[1]}, ball[0] / norm(d), d);
            break;
        }
        default: {
            double extent = -1e300;
            for (const Point& v : vertices_) {
                const double along = dot(v, d);
                if (along > extent) extent = along, s = v;
            }
        }
    }
    return {position_[0] + r[0][0] * s[0] + r[0][1] * s[1] + r[0][2] * s[2],
            position_[1] + r[1][0] * s[0] + r[1][1] * s[1] + r[1][2] * s[2],
            position_[2] + r[2][0] * s[0] + r[2][1] * s[1] + r[2][2] * s[2]};
}

}  // namespace epode::reference
