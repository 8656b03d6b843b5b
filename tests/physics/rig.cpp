// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See rig.h. Energy is 1/2 m v.v + 1/2 w.(R I R^T w) - m g.x; masses are read back from the library, so a
// test compares the library with mechanics and not with numbers of its own.
#include "rig.h"

#include <algorithm>
#include <bit>
#include <cstdarg>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <mutex>

namespace epode::physics {
namespace {

class Library : public testing::Environment {
  public:
    void SetUp() override { ASSERT_NE(dInitODE2(0), 0); }
    void TearDown() override { dCloseODE(); }
};
[[maybe_unused]] testing::Environment* const kLibrary = testing::AddGlobalTestEnvironment(new Library);

struct Received {
    std::mutex lock;
    int count = 0;
    char last[256] = "";
};
Received received;

void receive(int number, const char* format, va_list arguments)
{
    const std::lock_guard guard(received.lock);
    ++received.count;
    const int used = std::snprintf(received.last, sizeof received.last, "%d: ", number);
    std::vsnprintf(received.last + used, sizeof received.last - std::size_t(used), format, arguments);
}

dMass mass_of(dBodyID body)
{
    dMass m;
    dBodyGetMass(body, &m);
    return m;
}

}  // namespace

double Random::uniform(double low, double high)
{
    state_ = state_ * 1664525u + 1013904223u;
    return low + (high - low) * (state_ >> 8) / 16777216.0;
}

V3 Random::point(double size)
{
    const double x = uniform(-size, size), y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
}

void Random::quaternion(dQuaternion q)
{
    for (int i = 0; i < 4; ++i) q[i] = real(uniform(-1, 1));
    q[0] += 2;
}

const char* name_of(Stepper stepper)
{
    return stepper == Stepper::kExact ? "exact" : stepper == Stepper::kQuick ? "quick" : "fast";
}

Sim::Sim(Stepper s)
    : stepper(s), world(dWorldCreate()), space(dHashSpaceCreate(nullptr)), contacts(dJointGroupCreate(0))
{
    surface.mode = dContactApprox1;
    surface.mu = real(0.5);
}

Sim::~Sim()
{
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(world);
}

dBodyID Sim::body(V3 at, double mass, double inertia)
{
    dMass m;
    dMassSetSphereTotal(&m, real(mass), 1);
    if (inertia > 0) {
        const dReal i = real(inertia);
        dMassSetParameters(&m, real(mass), 0, 0, 0, i, i, i, 0, 0, 0);
    }
    return shaped(at, nullptr, m);
}

dBodyID Sim::shaped(V3 at, dGeomID geom, const dMass& mass)
{
    dBodyID b = dBodyCreate(world);
    dBodySetMass(b, &mass);
    if (geom) dGeomSetBody(geom, b);
    place(b, at);
    bodies.push_back(b);
    return b;
}

dBodyID Sim::box(V3 at, V3 size, double mass)
{
    dMass m;
    dMassSetBoxTotal(&m, real(mass), real(size.x), real(size.y), real(size.z));
    return shaped(at, dCreateBox(space, real(size.x), real(size.y), real(size.z)), m);
}

dBodyID Sim::sphere(V3 at, double radius, double mass)
{
    dMass m;
    dMassSetSphereTotal(&m, real(mass), real(radius));
    return shaped(at, dCreateSphere(space, real(radius)), m);
}

dBodyID Sim::capsule(V3 at, double radius, double length, double mass)
{
    dMass m;
    dMassSetCapsuleTotal(&m, real(mass), 3, real(radius), real(length));
    return shaped(at, dCreateCapsule(space, real(radius), real(length)), m);
}

dBodyID Sim::cylinder(V3 at, double radius, double length, double mass)
{
    dMass m;
    dMassSetCylinderTotal(&m, real(mass), 3, real(radius), real(length));
    return shaped(at, dCreateCylinder(space, real(radius), real(length)), m);
}

dGeomID Sim::ground(double height) { return dCreatePlane(space, 0, 0, 1, real(height)); }

int Sim::advance(double h)
{
    switch (stepper) {
        case Stepper::kExact:
            return dWorldStep(world, real(h));
        case Stepper::kQuick:
            return dWorldQuickStep(world, real(h));
        case Stepper::kFast:
            return dWorldStepFast1(world, real(h), substeps);
    }
    return 0;
}

void Sim::near(void* self, dGeomID a, dGeomID b)
{
    constexpr int kCapacity = 8;
    Sim& sim = *static_cast<Sim*>(self);
    dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    if (!first && !second) return;
    if (first && second && dAreConnectedExcluding(first, second, dJointTypeContact)) return;
    dContact contact[kCapacity];
    const int count = dCollide(a, b, kCapacity, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contact[i].surface = sim.surface;
        dJointAttach(dJointCreateContact(sim.world, sim.contacts, &contact[i]), first, second);
    }
    sim.contact_count += count;
}

void Sim::collide()
{
    dJointGroupEmpty(contacts);
    contact_count = 0;
    dSpaceCollide(space, this, &Sim::near);
}

int Sim::step(double h)
{
    collide();
    return advance(h);
}

void Sim::steps(int count, double h)
{
    for (int i = 0; i < count; ++i) step(h);
}

dWorldStepReport Sim::report() const
{
    dWorldStepReport r{};
    r.struct_size = sizeof r;
    EXPECT_EQ(dWorldGetStepReport(world, &r), 1);
    return r;
}

void place(dBodyID body, V3 at) { dBodySetPosition(body, real(at.x), real(at.y), real(at.z)); }

void velocity(dBodyID body, V3 linear, V3 angular)
{
    dBodySetLinearVel(body, real(linear.x), real(linear.y), real(linear.z));
    dBodySetAngularVel(body, real(angular.x), real(angular.y), real(angular.z));
}

V3 spin_momentum(dBodyID body)
{
    const dMass m = mass_of(body);
    const dReal* R = dBodyGetRotation(body);
    const V3 w = spin(body);
    const V3 column[3] = {{R[0], R[4], R[8]}, {R[1], R[5], R[9]}, {R[2], R[6], R[10]}};
    const double local[3] = {dot(column[0], w), dot(column[1], w), dot(column[2], w)};
    V3 out;
    for (int i = 0; i < 3; ++i) {
        double row = 0;
        for (int j = 0; j < 3; ++j) row += double(m.I[4 * i + j]) * local[j];
        out = out + row * column[i];
    }
    return out;
}

double kinetic_energy(dBodyID body)
{
    const V3 v = velocity(body);
    return 0.5 * double(mass_of(body).mass) * dot(v, v) + 0.5 * dot(spin(body), spin_momentum(body));
}

V3 momentum(const Sim& sim)
{
    V3 sum;
    for (dBodyID b : sim.bodies) sum = sum + double(mass_of(b).mass) * velocity(b);
    return sum;
}

V3 angular_momentum(const Sim& sim)
{
    V3 sum;
    for (dBodyID b : sim.bodies)
        sum = sum + double(mass_of(b).mass) * cross(position(b), velocity(b)) + spin_momentum(b);
    return sum;
}

double energy(const Sim& sim)
{
    dVector3 g;
    dWorldGetGravity(sim.world, g);
    double sum = 0;
    for (dBodyID b : sim.bodies)
        sum += kinetic_energy(b) - double(mass_of(b).mass) * dot(vec(g), position(b));
    return sum;
}

dContact make_contact(V3 at, V3 n, double depth)
{
    dContact c{};
    c.surface.mode = dContactApprox1;
    c.geom.pos[0] = real(at.x), c.geom.pos[1] = real(at.y), c.geom.pos[2] = real(at.z);
    c.geom.normal[0] = real(n.x), c.geom.normal[1] = real(n.y), c.geom.normal[2] = real(n.z);
    c.geom.depth = real(depth);
    return c;
}

std::uint64_t hash_reals(const dReal* values, int count, std::uint64_t seed)
{
    for (int i = 0; i < count; ++i) {
        unsigned char bytes[sizeof(dReal)];
        std::memcpy(bytes, &values[i], sizeof bytes);
        if (std::endian::native == std::endian::big) std::reverse(std::begin(bytes), std::end(bytes));
        for (unsigned char byte : bytes) seed = (seed ^ byte) * 0x100000001b3u;
    }
    return seed;
}

std::uint64_t hash_state(const Sim& sim)
{
    std::uint64_t h = 0xcbf29ce484222325u;
    for (dBodyID b : sim.bodies) {
        h = hash_reals(dBodyGetPosition(b), 3, h);
        h = hash_reals(dBodyGetQuaternion(b), 4, h);
        h = hash_reals(dBodyGetLinearVel(b), 3, h);
        h = hash_reals(dBodyGetAngularVel(b), 3, h);
    }
    return h;
}

bool finite_state(const Sim& sim)
{
    for (dBodyID b : sim.bodies) {
        const V3 v = position(b) + velocity(b) + spin(b);
        const dReal* q = dBodyGetQuaternion(b);
        if (!std::isfinite(v.x + v.y + v.z + double(q[0] + q[1] + q[2] + q[3]))) return false;
    }
    return true;
}

Messages::Messages()
{
    clear();
    dSetMessageHandler(&receive);
    dSetDebugHandler(&receive);
    dSetErrorHandler(&receive);
}

Messages::~Messages()
{
    dSetMessageHandler(nullptr);
    dSetDebugHandler(nullptr);
    dSetErrorHandler(nullptr);
}

int Messages::count() const
{
    const std::lock_guard guard(received.lock);
    return received.count;
}

std::string Messages::last() const
{
    const std::lock_guard guard(received.lock);
    return received.last;
}

void Messages::clear()
{
    const std::lock_guard guard(received.lock);
    received.count = 0;
    received.last[0] = 0;
}

}  // namespace epode::physics
