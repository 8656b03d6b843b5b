// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// File: comments (#), then lines "body side_x side_y side_z x y z qw qx qy qz vx vy vz wx wy wz" and lines
// "contact body1 body2 x y z nx ny nz depth", body2 -1 being the ground. Lengths are written to 1e-9 m and
// numbers are read with the C library's rounding, so every library gets the same bits.
#include "bench/problems/pile.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>
#include <string>

namespace epode::bench {

namespace {

using namespace scenes;

constexpr double kDensity = 1000;
constexpr double kDropDt = 0.005;
constexpr double kDropPitch = 0.8;
constexpr int kDropSteps = 2000;

std::istream& operator>>(std::istream& in, Vec& v) { return in >> v.x >> v.y >> v.z; }
std::istream& operator>>(std::istream& in, Turn& q) { return in >> q.w >> q.x >> q.y >> q.z; }

bool read_line(Problem& problem, const std::string& line)
{
    std::istringstream in(line);
    std::string kind;
    in >> kind;
    if (kind == "body") {
        Vec size, pos, linear, angular;
        Turn q;
        if (!(in >> size >> pos >> q >> linear >> angular)) return false;
        dMass mass;
        dMassSetBox(&mass, dReal(kDensity), dReal(size.x), dReal(size.y), dReal(size.z));
        problem.add_body(mass, pos, q, linear, angular);
        return true;
    }
    BatchPoint c;
    const int count = int(problem.bodies().size());
    if (kind != "contact" || !(in >> c.body1 >> c.body2 >> c.pos >> c.normal >> c.depth)) return false;
    if (c.body1 < 0 || c.body1 >= count || c.body2 < kStatic || c.body2 >= count) return false;
    problem.add_contact(c);
    return true;
}

// Boxes in layers of a loose grid, turned anyhow, over a pit.
void drop_boxes(Scene& scene, int count, double side)
{
    const int across = std::max(1, int(side / kDropPitch));
    Lcg random(scene.seed());
    add_ground(scene);
    add_pit(scene, side / 2, side / 2, 2 * side);
    for (int i = 0; i < count; ++i) {
        const auto place = [&](int cell) {
            return kDropPitch * (cell - 0.5 * (across - 1) + random.uniform(-0.1, 0.1));
        };
        const Vec size{random.uniform(0.3, 0.6), random.uniform(0.3, 0.6), random.uniform(0.3, 0.6)};
        const double x = place(i % across), y = place(i / across % across);
        add_box(scene, size, kDensity, {x, y, 0.5 + kDropPitch * (i / (across * across))}, random.any_turn());
    }
    scene.contacts_per_pair = 8;
}

std::string text(const dReal* values, int count)
{
    std::string line;
    for (int i = 0; i < count; ++i) line += fmt::format(" {:.9f}", double(values[i]));
    return line;
}

void print_state(const Scene& scene, const std::vector<std::string>& before,
                 const std::vector<ContactRecord>& contacts)
{
    for (const std::string& line : before) fmt::print("{}\n", line);
    std::map<dBodyID, int> number;
    for (dBodyID body : scene.bodies()) number.emplace(body, int(number.size()));
    const auto index = [&](dGeomID geom) {
        dBodyID body = dGeomGetBody(geom);
        return body ? number[body] : kStatic;
    };
    for (const ContactRecord& c : contacts) {
        // The ground is always second: the solver's problem is the same, and the file simpler.
        const bool swapped = index(c.geom1) == kStatic;
        const double s = swapped ? -1 : 1;
        fmt::print("contact {} {} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f} {:.9f}\n",
                   index(swapped ? c.geom2 : c.geom1), index(swapped ? c.geom1 : c.geom2), c.pos[0], c.pos[1],
                   c.pos[2], s * c.normal[0], s * c.normal[1], s * c.normal[2], c.depth);
    }
}

std::vector<std::string> describe_bodies(const Scene& scene)
{
    std::vector<std::string> lines;
    for (dBodyID body : scene.bodies()) {
        dVector3 size;
        dGeomBoxGetLengths(dBodyGetFirstGeom(body), size);
        lines.push_back("body" + text(size, 3) + text(dBodyGetPosition(body), 3) +
                        text(dBodyGetQuaternion(body), 4) + text(dBodyGetLinearVel(body), 3) +
                        text(dBodyGetAngularVel(body), 3));
    }
    return lines;
}

}  // namespace

bool load_pile(Problem& problem, int count)
{
    const std::string path = fmt::format("{}/pile_{}.txt", EPODE_BENCH_DATA, count);
    std::ifstream file(path);
    if (!file) {
        fmt::print(stderr, "epode_bench: cannot read {}\n", path);
        return false;
    }
    for (std::string line; std::getline(file, line);) {
        if (line.empty() || line[0] == '#') continue;
        if (!read_line(problem, line)) {
            fmt::print(stderr, "epode_bench: {} has a line that means nothing: {}\n", path, line);
            return false;
        }
    }
    return true;
}

int print_pile(int count, double side, int rows, std::uint32_t seed)
{
    constexpr Recipe kDrop = {"drop", "boxes let fall", kDropDt, 10, Stepper::kQuick, [](Scene&) {}};
    Scene scene(kDrop, seed);
    drop_boxes(scene, count, side);
    for (int i = 0; i < kDropSteps; ++i) {
        const std::vector<std::string> before = describe_bodies(scene);
        scene.step(Stepper::kQuick, kDropDt);
        if (3 * int(scene.contacts().size()) < rows) continue;
        fmt::print("# {} boxes over {} m, seed {}, after {:.3f} s\n", count, side, seed, kDropDt * i);
        print_state(scene, before, scene.contacts());
        return 0;
    }
    fmt::print(stderr, "epode_bench: these boxes never have {} rows\n", rows);
    return 1;
}

}  // namespace epode::bench
