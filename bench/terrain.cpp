// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The terrain of scene S7: hills of several wavelengths over 256 x 256 cells of half a metre, 131,072
// triangles, or a height field of the same heights (other diagonals). Solids of about half a metre lie on it
// in random poses, sunk in by up to 5 cm, and for each dCollide is asked for eight contacts. Printed per
// class: the least time per pair over the rounds, how many pairs touch, and the mean number of contacts of
// these.
#include "bench/terrain.h"

#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <vector>

#include "scenes/extensions.h"

namespace epode::bench {

namespace {

constexpr double kCell = 0.5;

class Dice {
  public:
    double in(double lo, double hi)
    {
        state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
        return lo + (hi - lo) * double(state_ >> 11) * 0x1p-53;
    }

  private:
    std::uint64_t state_ = 12345;
};

double height(double x, double y)
{
    return 1.5 * std::sin(0.11 * x) * std::cos(0.13 * y) + 0.3 * std::sin(0.7 * x + 0.2) * std::sin(0.6 * y) +
           0.04 * std::sin(3.1 * x) * std::cos(2.7 * y);
}

class MeshGround {
  public:
    explicit MeshGround(int n)
    {
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i) {
                const double x = kCell * (i - 0.5 * n), y = kCell * (j - 0.5 * n);
                for (const double v : {x, y, height(x, y), 0.0}) vertices_.push_back(dReal(v));
            }
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const dTriIndex a = dTriIndex(i + j * (n + 1)), b = a + 1, c = a + dTriIndex(n) + 1,
                                d = c + 1;
                for (const dTriIndex corner : {a, b, d, a, d, c}) corners_.push_back(corner);
            }
        dGeomTriMeshDataBuildSimple(data_, vertices_.data(), int(vertices_.size() / 4), corners_.data(),
                                    int(corners_.size()));
        geom_ = dCreateTriMesh(nullptr, data_, nullptr, nullptr, nullptr);
    }
    MeshGround(const MeshGround&) = delete;
    MeshGround& operator=(const MeshGround&) = delete;
    ~MeshGround()
    {
        dGeomDestroy(geom_);
        dGeomTriMeshDataDestroy(data_);
    }
    dGeomID geom() const { return geom_; }

  private:
    std::vector<dReal> vertices_;
    std::vector<dTriIndex> corners_;
    dTriMeshDataID data_ = dGeomTriMeshDataCreate();
    dGeomID geom_ = nullptr;
};

// Its own y up is the world's z, its z against the world's y.
class FieldGround {
  public:
    explicit FieldGround(int n)
    {
        std::vector<double> heights;
        for (int j = 0; j <= n; ++j)
            for (int i = 0; i <= n; ++i)
                heights.push_back(height(kCell * (i - 0.5 * n), -kCell * (j - 0.5 * n)));
        dGeomHeightfieldDataBuildDouble(data_, heights.data(), 1, dReal(kCell * n), dReal(kCell * n), n + 1,
                                        n + 1, 1, 0, 1, 0);
        geom_ = dCreateHeightfield(nullptr, data_, 1);
        dMatrix3 up = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};
        dGeomSetRotation(geom_, up);
    }
    FieldGround(const FieldGround&) = delete;
    FieldGround& operator=(const FieldGround&) = delete;
    ~FieldGround()
    {
        dGeomDestroy(geom_);
        dGeomHeightfieldDataDestroy(data_);
    }
    dGeomID geom() const { return geom_; }

  private:
    dHeightfieldDataID data_ = dGeomHeightfieldDataCreate();
    dGeomID geom_ = nullptr;
};

dGeomID make(const char* name, Dice& dice)
{
    const double s = dice.in(0.2, 0.4);
    switch (name[0]) {
        case 's':
            return dCreateSphere(nullptr, dReal(s));
        case 'b':
            return dCreateBox(nullptr, dReal(2 * s), dReal(1.5 * s), dReal(s));
        default:
            return name[1] == 'a' ? dCreateCapsule(nullptr, dReal(0.6 * s), dReal(1.5 * s))
                                  : dCreateCylinder(nullptr, dReal(0.8 * s), dReal(1.5 * s));
    }
}

// On the ground by its box, then a little in.
void put(dGeomID solid, Dice& dice, double half)
{
    dQuaternion q;
    do {
        for (dReal& v : q) v = dReal(dice.in(-1, 1));
    } while (q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] < dReal(0.1));
    const dReal norm = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (dReal& v : q) v /= norm;
    dGeomSetQuaternion(solid, q);
    const double x = dice.in(-half, half), y = dice.in(-half, half);
    dGeomSetPosition(solid, dReal(x), dReal(y), 0);
    dReal box[6];
    dGeomGetAABB(solid, box);
    dGeomSetPosition(solid, dReal(x), dReal(y), dReal(height(x, y) - box[4] - dice.in(0, 0.05)));
}

void bench_class(const char* name, dGeomID terrain, const TerrainOptions& options)
{
    Dice dice;
    std::vector<dGeomID> all;
    for (int k = 0; k < options.solids; ++k) {
        all.push_back(make(name, dice));
        put(all.back(), dice, 0.45 * kCell * options.cells);
    }
    double least = 1e300;
    int touching = 0, contacts = 0;
    for (int round = 0; round < options.rounds; ++round) {
        touching = contacts = 0;
        const auto start = std::chrono::steady_clock::now();
        for (const dGeomID g : all) {
            dContactGeom found[8];
            const int n = dCollide(g, terrain, 8, found, sizeof(dContactGeom));
            touching += n > 0 ? 1 : 0, contacts += n;
        }
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count() / options.solids);
    }
    fmt::print("{:<9} {:>8.0f} ns   touching {:>5}   contacts {:.2f}\n", name, least, touching,
               touching ? double(contacts) / touching : 0.0);
    for (const dGeomID g : all) dGeomDestroy(g);
}

template <typename Ground>
void bench_ground(const TerrainOptions& options)
{
    const Ground ground(options.cells);
    for (const char* name : {"sphere", "box", "capsule", "cylinder"})
        if (options.only.empty() || options.only == name) bench_class(name, ground.geom(), options);
}

}  // namespace

int bench_terrain(const TerrainOptions& options)
{
    fmt::print("library {}\n", scenes::loaded_library());
    options.field ? bench_ground<FieldGround>(options) : bench_ground<MeshGround>(options);
    return 0;
}

}  // namespace epode::bench
