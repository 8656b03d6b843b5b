// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every setter of a pose, with poses that are none and with the largest that are: what a setter takes is a rotation
// and a place, and a state, a delta, a history, a file and a clone carry it; what it refuses has changed nothing.
#include <cctype>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "scene.h"

namespace epode::states {
namespace {

// A geom of each kind of place.
struct Places {
    Places()
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.8));
        dWorldSetContactSpace(world, space);
        dCreatePlane(space, 0, 0, 1, 0);
        for (dBodyID& b : body) b = dBodyCreate(world);
        for (dGeomID g : {on_body, with_offset}) dGeomSetBody(g, g == on_body ? body[0] : body[1]);
        dBodySetPosition(body[0], 0, 0, dReal(0.19));
        dBodySetPosition(body[1], 2, 0, dReal(0.19));
        dGeomSetOffsetPosition(with_offset, dReal(0.01), 0, 0);
        dGeomSetPosition(free, 4, 0, 3);
        dWorldSetHistory(world, 8);
        step();
    }
    ~Places()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }
    void step() const { EXPECT_EQ(dWorldStepHybrid(world, dReal(0.01)), 1); }

    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dBodyID body[2];
    dGeomID on_body = box(), with_offset = box(), free = box(), ray = dCreateRay(space, 1);
    dGeomID box() const { return dCreateBox(space, dReal(0.4), dReal(0.4), dReal(0.4)); }
};

struct Given {
    dReal R[12], q[4], p[3];
};

struct Setter {
    const char* name;
    dGeomID (*geom)(const Places&);
    void (*set)(const Places&, dGeomID, const Given&);
};

dGeomID on_body(const Places& s) { return s.on_body; }
dGeomID with_offset(const Places& s) { return s.with_offset; }
dGeomID free_geom(const Places& s) { return s.free; }
dGeomID ray(const Places& s) { return s.ray; }

#define PLACED(geom, name)                                                                             \
    {                                                                                                  \
#name, geom, [](const Places&, dGeomID g, const Given& v) { name(g, v.p[0], v.p[1], v.p[2]); } \
    }
#define TURNED(geom, name)                                                          \
    {                                                                               \
#name, geom, [](const Places&, dGeomID g, const Given& v) { name(g, v.R); } \
    }
#define ORIENTED(geom, name)                                                        \
    {                                                                               \
#name, geom, [](const Places&, dGeomID g, const Given& v) { name(g, v.q); } \
    }
#define BODY(name, ...)                                                                                \
    {                                                                                                  \
#name, on_body, [](const Places& s, dGeomID, const Given& v) { name(s.body[0], __VA_ARGS__); } \
    }

const Setter kSetters[] = {
    BODY(dBodySetPosition, v.p[0], v.p[1], v.p[2]),
    BODY(dBodySetRotation, v.R),
    BODY(dBodySetQuaternion, v.q),
    {"dBodiesSetStates", on_body,
     [](const Places& s, dGeomID, const Given& v) { dBodiesSetStates(s.body, 1, dStatePosition, v.p, 0); }},
    {"dBodiesSetStates", on_body,
     [](const Places& s, dGeomID, const Given& v) { dBodiesSetStates(s.body, 1, dStateQuaternion, v.q, 0); }},
    PLACED(on_body, dGeomSetPosition),
    PLACED(with_offset, dGeomSetPosition),
    PLACED(free_geom, dGeomSetPosition),
    TURNED(on_body, dGeomSetRotation),
    TURNED(with_offset, dGeomSetRotation),
    TURNED(free_geom, dGeomSetRotation),
    ORIENTED(on_body, dGeomSetQuaternion),
    ORIENTED(with_offset, dGeomSetQuaternion),
    ORIENTED(free_geom, dGeomSetQuaternion),
    PLACED(on_body, dGeomSetOffsetPosition),
    PLACED(with_offset, dGeomSetOffsetWorldPosition),
    TURNED(on_body, dGeomSetOffsetRotation),
    TURNED(with_offset, dGeomSetOffsetRotation),
    TURNED(with_offset, dGeomSetOffsetWorldRotation),
    ORIENTED(with_offset, dGeomSetOffsetQuaternion),
    ORIENTED(on_body, dGeomSetOffsetWorldQuaternion),
    {"dGeomRaySet", ray,
     [](const Places&, dGeomID g, const Given& v) {
         dGeomRaySet(g, v.p[0], v.p[1], v.p[2], v.q[1], v.q[2], v.q[3]);
     }},
};

constexpr dReal kHuge = sizeof(dReal) == 4 ? dReal(1e18) : dReal(1e100),
                kNan = std::numeric_limits<dReal>::quiet_NaN();

const Given kGiven[] = {
    {{2, 0, 0, 0, 0, 2, 0, 0, 0, 0, 2, 0}, {2, 0, 0, 0}, {1, 2, 3}},
    {{dReal(1.01), 0, 0, 0, 0, dReal(1.01), 0, 0, 0, 0, dReal(1.01), 0},
     {dReal(1.01), 0, 0, 0},
     {1e6, -1e6, 1e6}},
    {{1, dReal(0.2), 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, {1, 1, 1, 1}, {kHuge, 0, 0}},
    {{dReal(1.9), dReal(0.03), kHuge, 0, dReal(0.1), 1, 0, 0, 0, dReal(0.5), 1, 0},
     {kHuge, kHuge, 0, 0},
     {-kHuge, kHuge, kHuge}},
    {{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}, {0, 0, 0, 0}, {2 * kHuge, 0, 0}},
    {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, 0}, {-1, 0, 0, 0}, {0, 0, 0}},
    {{1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0}, {0, 0, 0, 1}, {0, -kHuge, 0}},
    {{1, dReal(3e-6), 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, {1, dReal(3e-6), 0, 0}, {1e-30, 0, 0}},
    {{1, dReal(3e-5), 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
     {1, dReal(3e-5), 0, 0},
     {1e30 > kHuge ? 1e15 : 1e30, 0, 0}},
    {{dReal(1e-3), 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, {dReal(1e-30), 0, 0, 0}, {0, 0, 0}},
    {{kNan, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, {kNan, 0, 0, 0}, {0, kNan, 0}},
    {{kHuge, 0, 0, 0, 0, kHuge, 0, 0, 0, 0, kHuge, 0}, {kHuge, 0, 0, kHuge}, {kHuge, kHuge, kHuge}},
};

struct Seen {
    dReal R[12], p[3];
    bool operator==(const Seen& other) const { return std::memcmp(this, &other, sizeof *this) == 0; }
};
Seen seen(dGeomID g)
{
    Seen s{};
    std::memcpy(s.p, dGeomGetPosition(g), sizeof s.p);
    for (int row = 0; row < 3; ++row)
        std::memcpy(s.R + 4 * row, dGeomGetRotation(g) + 4 * row, 3 * sizeof(dReal));
    return s;
}

// How far the rows are from orthonormal.
double fault(const Seen& s)
{
    double worst = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            double dot = 0;
            for (int k = 0; k < 3; ++k) dot += double(s.R[4 * i + k]) * double(s.R[4 * j + k]);
            worst = std::max(worst, std::fabs(dot - (i == j)));
        }
    const auto* r = s.R;
    const double det = double(r[0]) * (r[5] * r[10] - r[6] * r[9]) -
                       double(r[1]) * (r[4] * r[10] - r[6] * r[8]) +
                       double(r[2]) * (r[4] * r[9] - r[5] * r[8]);
    return std::max(worst, std::fabs(det - 1));
}

Seen of_number(dSpaceID space, int i) { return seen(dSpaceGetGeom(space, i)); }

void expect_copy(dWorldID copy, dSpaceID in, const Places& s, const char* what)
{
    ASSERT_NE(copy, nullptr) << what << ": " << Messages::last();
    for (int i = 0; i < dSpaceGetNumGeoms(in); ++i) {
        if (dGeomGetClass(dSpaceGetGeom(in, i)) == dPlaneClass) continue;
        EXPECT_TRUE(of_number(in, i) == of_number(s.space, i)) << what << ", geom " << i;
    }
    EXPECT_EQ(dWorldStepHybrid(copy, dReal(0.01)), 1);
    dWorldDestroy(copy);
    dSpaceDestroy(in);
}

void expect_carried(const Places& s)
{
    Bytes state(dWorldGetStateSize(s.world));
    ASSERT_EQ(dWorldGetState(s.world, state.data(), state.size()), 1);
    EXPECT_EQ(dWorldSetState(s.world, state.data(), state.size()), 1) << Messages::last();
    Bytes delta(dWorldGetStateDelta(s.world, state.data(), state.size(), nullptr, 0));
    dWorldGetStateDelta(s.world, state.data(), state.size(), delta.data(), delta.size());
    EXPECT_EQ(dWorldSetStateDelta(s.world, state.data(), state.size(), delta.data(), delta.size()), 1);
    Bytes file(dWorldSaveToBuffer(s.world, s.space, nullptr, 0));
    dWorldSaveToBuffer(s.world, s.space, file.data(), file.size());
    dSpaceID in = nullptr;
    const dWorldID loaded = dWorldLoadFromBuffer(file.data(), file.size(), &in);
    expect_copy(loaded, in, s, "a file");
    in = s.space;
    const dWorldID clone = dWorldClone(s.world, &in, nullptr, 0);
    expect_copy(clone, in, s, "a clone");
}

void expect_unit_normals(dWorldID world)
{
    dWorldContact contacts[32];
    const int count = std::min(dWorldGetContacts(world, contacts, 32), 32);
    for (int i = 0; i < count; ++i) {
        const dReal* n = contacts[i].normal;
        EXPECT_NEAR(n[0] * n[0] + n[1] * n[1] + n[2] * n[2], 1, 1e-4);
        EXPECT_TRUE(std::isfinite(contacts[i].depth));
    }
}

TEST(PoseSetters, take_what_states_files_and_clones_carry)
{
    const Messages messages;
    int taken = 0, refused = 0;
    for (const Setter& setter : kSetters)
        for (const Given& given : kGiven) {
            const Places s;
            SCOPED_TRACE(std::string(setter.name) + ", value " + std::to_string(&given - kGiven));
            const dGeomID geom = setter.geom(s);
            const Seen before = seen(geom);
            const int messages_before = Messages::count();
            setter.set(s, geom, given);
            const bool taken_now = Messages::count() == messages_before;
            ++(taken_now ? taken : refused);
            EXPECT_TRUE(taken_now || seen(geom) == before) << "refused, but changed";
            EXPECT_LT(fault(seen(geom)), 1e-5);
            expect_carried(s);
            for (int i = 0; i < 3; ++i) s.step();
            expect_unit_normals(s.world);
            expect_carried(s);
            EXPECT_EQ(dWorldRollBack(s.world, 2), 1) << Messages::last();
            EXPECT_EQ(Messages::count(), messages_before + !taken_now) << Messages::last();
            if (::testing::Test::HasFailure()) return;
        }
    EXPECT_GT(taken, 100);
    EXPECT_GT(refused, 20);
}

// Proper rotations keep their bits: programs read back what they have set.
TEST(PoseSetters, leave_rotations_as_they_are)
{
    const Places s;
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 2, 3, dReal(0.7));
    dGeomSetRotation(s.free, R);
    dGeomSetOffsetRotation(s.with_offset, R);
    for (int i = 0; i < 12; ++i) {
        if (i % 4 == 3) continue;
        EXPECT_EQ(dGeomGetRotation(s.free)[i], R[i]);
        EXPECT_EQ(dGeomGetOffsetRotation(s.with_offset)[i], R[i]);
    }
}

bool is_pose_setter(const std::string& name)
{
    if (name == "dGeomRaySet") return true;
    if (name.size() < 4 || name[0] != 'd' || !std::isupper(name[1]) || name.find("Set") == std::string::npos)
        return false;
    for (const char* end : {"Position", "Rotation", "Quaternion", "Pose", "States", "Transform"})
        if (name.ends_with(end)) return true;
    return false;
}

// The headers have no other setter of a pose.
TEST(PoseSetters, are_all_tried)
{
    // A memory of the program's own, a switch, targets of motors, and what tests/physics/characters judges.
    std::set<std::string> tried = {"dGeomTriMeshSetLastTransform", "dWorldSetExactRotation",
                                   "dRagdollSetPose", "dCharacterSetPosition"};
    for (const Setter& setter : kSetters) tried.insert(setter.name);
    int found = 0;
    for (const auto& header : std::filesystem::directory_iterator(EPODE_HEADERS)) {
        if (header.path().extension() != ".h") continue;
        std::ifstream in(header.path());
        std::string name;
        for (int c = in.get();; c = in.get()) {
            if (c != EOF && (std::isalnum(c) || c == '_')) {
                name += char(c);
                continue;
            }
            if (is_pose_setter(name)) {
                ++found;
                EXPECT_TRUE(tried.count(name)) << name << " is not tried here";
            }
            name.clear();
            if (c == EOF) break;
        }
    }
    EXPECT_GT(found, 14);
}

}  // namespace
}  // namespace epode::states
