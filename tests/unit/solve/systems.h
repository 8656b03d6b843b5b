// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Row systems made without joints or worlds: what a solver is asked, in the form in which it is asked.
#pragma once

#include <cmath>
#include <vector>

#include "base/random.h"
#include "math/mat.h"
#include "rows/policy.h"
#include "rows/row_system.h"

namespace epode_test {

using namespace epode;

struct Problem {
    Real h = Real(0.01);
    std::vector<SolverBody> bodies;
    std::vector<Vec3> places;  // of the bodies
    std::vector<Row> rows;
    std::vector<RowNumbers> numbers;
    std::vector<RowBlock> blocks;

    // A solid box, or a body that nothing moves when `mass` is 0.
    int body(Vec3 place, Real mass, Vec3 sides = {1, 1, 1})
    {
        SolverBody b;
        if (mass > 0) {
            const Vec3 s = scale(sides, sides);
            b.mass = mass, b.inv_mass = 1 / mass;
            b.inertia = {mass / 12 * (s.y + s.z), mass / 12 * (s.x + s.z), mass / 12 * (s.x + s.y), 0, 0, 0};
            b.inv_inertia = {1 / b.inertia.xx, 1 / b.inertia.yy, 1 / b.inertia.zz, 0, 0, 0};
        }
        bodies.push_back(b);
        places.push_back(place);
        return int(bodies.size()) - 1;
    }

    // The arms of a contact's rows (one, or three orthonormal directions): a = r x d.
    static ContactArms arms_of(const std::vector<Row>& of)
    {
        ContactArms arms;
        const Real share = of.size() == 1 ? Real(1) : Real(0.5);
        for (std::size_t k = 0; k < of.size() && k < 3; ++k) {
            arms.r1 += share * cross(of[k].lin1, of[k].ang1);
            arms.r2 += share * cross(of[k].lin1, -of[k].ang2);
        }
        return arms;
    }

    void block(int body1, int body2, bool contact, const std::vector<Row>& of)
    {
        blocks.push_back({int(rows.size()), int(of.size()), body1, body2, contact, arms_of(of)});
        const int first = int(rows.size());
        for (const Row& row : of) {
            rows.push_back(row);
            numbers.push_back(ode_baumgarte(row, h, first));
        }
    }

    // Row that moves point `at` of the bodies apart along d.
    Row point_row(int body1, int body2, Vec3 at, Vec3 d, Real erp, Real cfm) const
    {
        Row r;
        r.erp = erp, r.cfm = cfm;
        r.lin1 = d, r.ang1 = cross(at - places[std::size_t(body1)], d);
        if (body2 >= 0) r.lin2 = -d, r.ang2 = -cross(at - places[std::size_t(body2)], d);
        return r;
    }

    void ball(int body1, int body2, Vec3 at, Real cfm, Vec3 error = {}, Real erp = Real(0.2))
    {
        std::vector<Row> of;
        const Vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        for (const Vec3& d : axes) {
            of.push_back(point_row(body1, body2, at, d, erp, cfm));
            of.back().error = dot(error, d);
        }
        block(body1, body2, false, of);
    }

    // mu < 0: no friction rows at all.
    void contact(int body1, int body2, Vec3 at, Vec3 n, Real depth, Real mu, Real cfm,
                 bool proportional = true)
    {
        std::vector<Row> of{point_row(body1, body2, at, n, Real(0.2), cfm)};
        of[0].kind = RowKind::kNormal;
        of[0].error = depth;
        of[0].lo = 0;
        Vec3 t[2];
        plane_space(n, t[0], t[1]);
        for (int k = 0; k < 2 && mu >= 0; ++k) {
            of.push_back(point_row(body1, body2, at, t[k], Real(0.2), cfm));
            of.back().kind = RowKind::kFriction;
            of.back().hi = mu, of.back().lo = -mu;
            of.back().parent = proportional ? 0 : -1;
        }
        block(body1, body2, true, of);
    }

    void pull(Vec3 gravity)
    {
        for (SolverBody& b : bodies)
            if (b.inv_mass > 0) b.v += h * gravity;
    }

    RowSystem system()
    {
        RowSystem s;
        s.h = h, s.bodies = bodies, s.rows = rows, s.numbers = numbers, s.blocks = blocks;
        return s;
    }
};

class Dice {
  public:
    explicit Dice(std::uint64_t seed) : random_(seed) {}
    Real real(Real lo, Real hi) { return lo + (hi - lo) * Real(double(random_.next() >> 11) * 0x1p-53); }
    Vec3 vec(Real size) { return {real(-size, size), real(-size, size), real(-size, size)}; }
    Vec3 direction()
    {
        Vec3 d = vec(1);
        return normalize(d) ? d : Vec3{0, 0, 1};
    }
    int below(int n) { return random_.below(n); }

  private:
    CounterRandom random_;
};

struct RandomKind {
    int bodies = 8, joints = 6, contacts = 6;
    Real mu = Real(0.5), cfm = Real(1e-6), heaviest = 10;
    bool kinematic = false;  // the first body is moved by nothing
};

// Each draw is a statement of its own: compilers differ in the order in which arguments are evaluated.
inline Problem random_problem(std::uint64_t seed, const RandomKind& kind)
{
    Dice dice(seed);
    Problem p;
    for (int i = 0; i < kind.bodies; ++i) {
        const bool fixed = kind.kinematic && i == 0;
        const Real mass = fixed ? 0 : std::pow(kind.heaviest, dice.real(0, 1));
        const Vec3 inertia{dice.real(Real(.5), 2), dice.real(Real(.5), 2), dice.real(Real(.5), 2)};
        const int b = p.body(dice.vec(3), mass, inertia);
        p.bodies[std::size_t(b)].v = dice.vec(1);
        p.bodies[std::size_t(b)].w = dice.vec(1);
    }
    const auto pair = [&](int& a, int& b) {
        a = dice.below(kind.bodies);
        b = dice.below(kind.bodies + 1) - 1;
        if (kind.kinematic && a == 0) a = kind.bodies - 1;
        if (a == b) b = -1;
    };
    for (int i = 0; i < kind.joints; ++i) {
        int a, b;
        pair(a, b);
        const Vec3 error = dice.vec(Real(0.01));
        p.ball(a, b, p.places[std::size_t(a)] + dice.vec(1), kind.cfm, error);
    }
    for (int i = 0; i < kind.contacts; ++i) {
        int a, b;
        pair(a, b);
        const Real depth = dice.real(0, Real(0.01));
        const Vec3 n = dice.direction();
        p.contact(a, b, p.places[std::size_t(a)] + dice.vec(1), n, depth, kind.mu, kind.cfm);
    }
    return p;
}

// nx x ny x nz unit boxes on a floor, each face to face with four contacts, neighbours sideways too if
// `walls`.
inline Problem box_grid(int nx, int ny, int nz, Real mu, bool sideways, Real cfm = Real(1e-8))
{
    Problem p;
    const auto index = [&](int x, int y, int z) { return (z * ny + y) * nx + x; };
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) p.body({Real(x), Real(y), z + Real(0.5)}, 1);
    const Real s[2] = {Real(-0.5), Real(0.5)};
    const auto face = [&](int a, int b, Vec3 centre, Vec3 n, Vec3 e, Vec3 f) {
        for (const Real i : s)
            for (const Real j : s) p.contact(a, b, centre + i * e + j * f, n, Real(0.001), mu, cfm);
    };
    for (int z = 0; z < nz; ++z)
        for (int y = 0; y < ny; ++y)
            for (int x = 0; x < nx; ++x) {
                const int a = index(x, y, z);
                const Vec3 c = p.places[std::size_t(a)];
                face(a, z > 0 ? index(x, y, z - 1) : -1, c - Vec3{0, 0, Real(.5)}, {0, 0, 1}, {1, 0, 0},
                     {0, 1, 0});
                if (sideways && x > 0)
                    face(a, index(x - 1, y, z), c - Vec3{Real(.5), 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1});
                if (sideways && y > 0)
                    face(a, index(x, y - 1, z), c - Vec3{0, Real(.5), 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1});
            }
    p.pull({0, 0, Real(-9.81)});
    return p;
}

// Boxes in a pyramid of `rows` rows, each standing on two, in one plane.
inline Problem pyramid(int rows, Real mu, Real cfm = Real(1e-8))
{
    Problem p;
    int below = -1;
    for (int r = 0; r < rows; ++r) {
        const int first = int(p.bodies.size());
        for (int i = 0; i < rows - r; ++i) p.body({i + Real(0.5) * r, 0, r + Real(0.5)}, 1);
        for (int i = 0; i < rows - r; ++i)
            for (int side = 0; side < 2; ++side)
                for (int corner = 0; corner < 4; ++corner) {
                    const Real from = side ? Real(0) : Real(-.5);
                    const Vec3 at =
                        p.places[std::size_t(first + i)] +
                        Vec3{from + Real(.5) * (corner & 1), (corner & 2) ? Real(.5) : Real(-.5), Real(-.5)};
                    p.contact(first + i, r ? below + i + side : -1, at, {0, 0, 1}, 0, mu, cfm);
                }
        below = first;
    }
    p.pull({0, 0, Real(-9.81)});
    return p;
}

// Links hanging from the world by ball joints, lying along x; the last one `heavier` times as heavy.
inline Problem chain(int links, Real heavier, Real cfm = Real(1e-10))
{
    Problem p;
    for (int i = 0; i < links; ++i) {
        p.body({i + Real(.5), 0, 0}, i == links - 1 ? heavier : 1, {1, Real(.2), Real(.2)});
        p.ball(i, i - 1, {Real(i), 0, 0}, cfm);
    }
    p.pull({0, 0, Real(-9.81)});
    return p;
}

}  // namespace epode_test
