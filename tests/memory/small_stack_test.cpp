// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A thread with a stack of 64 KiB steps islands of 5,000 rows and more with each stepper and collides every
// pair of classes. The stack is our own memory, painted before and read after, so that the deepest use is
// known and printed; below it lies a page that must not be touched. glibc puts the thread's descriptor and
// its thread-local variables at the top of that memory (some 4 KiB here): they count as used. A sanitizer's
// frames are several times larger: there the stack has 1 MiB.
#include <pthread.h>
#include <sys/mman.h>

#include <cstdio>
#include <cstring>
#include <functional>

#include "heap.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define MEMORY_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
#define MEMORY_SANITIZED 1
#endif
#endif

namespace epode::memory {
namespace {

#if defined(MEMORY_SANITIZED)
constexpr std::size_t kStack = 1024 * 1024;
constexpr bool kSanitized = true;
#else
constexpr std::size_t kStack = 64 * 1024;
constexpr bool kSanitized = false;
#endif
constexpr std::size_t kGuard = 4096;
constexpr unsigned char kPaint = 0xa5;

void* call(void* work)
{
    (*static_cast<std::function<void()>*>(work))();
    return nullptr;
}

// Runs the work on such a thread; the bytes of stack that it has used.
std::size_t on_small_stack(std::function<void()> work)
{
    void* memory = mmap(nullptr, kGuard + kStack, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    EXPECT_NE(memory, MAP_FAILED);
    EXPECT_EQ(mprotect(memory, kGuard, PROT_NONE), 0);
    unsigned char* bottom = static_cast<unsigned char*>(memory) + kGuard;
    std::memset(bottom, kPaint, kStack);
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    EXPECT_EQ(pthread_attr_setstack(&attributes, bottom, kStack), 0);
    pthread_t thread;
    EXPECT_EQ(pthread_create(&thread, &attributes, &call, &work), 0);
    pthread_join(thread, nullptr);
    pthread_attr_destroy(&attributes);
    std::size_t untouched = 0;
    while (untouched < kStack && bottom[untouched] == kPaint) ++untouched;
    munmap(memory, kGuard + kStack);
    return kStack - untouched;
}

void expect_small(const char* what, std::size_t used)
{
    std::printf("%s: %zu bytes of stack\n", what, used);
    EXPECT_LT(used, kStack - 8 * 1024) << what << ": room for the program itself must remain";
}

const char* const kNames[] = {"dWorldStep", "dWorldQuickStep", "dWorldStepFast1"};

int rows_of(dWorldID world)
{
    dWorldStepReport report;
    report.struct_size = sizeof report;
    return dWorldGetStepReport(world, &report) ? report.rows : 0;
}

// Balls in a square, tied to their neighbours and lying on the ground: equalities and inequalities.
struct Mat {
    dWorldID world = dWorldCreate();
    std::vector<dBodyID> bodies;
    explicit Mat(int side)
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetStepReportMode(world, 1);
        for (int i = 0; i < side * side; ++i) {
            bodies.push_back(dBodyCreate(world));
            dBodySetPosition(bodies.back(), dReal(i % side), dReal(i / side), 0);
        }
        for (int i = 0; i < side * side; ++i) {
            if (i % side + 1 < side) tie(i, i + 1);
            if (i + side < side * side) tie(i, i + side);
        }
        for (int i = 0; i < side * side; i += 3) lay(bodies[std::size_t(i)]);
    }
    ~Mat() { dWorldDestroy(world); }

    void tie(int a, int b)
    {
        dJointID joint = dJointCreateBall(world, nullptr);
        dJointAttach(joint, bodies[std::size_t(a)], bodies[std::size_t(b)]);
        const dReal *p = dBodyGetPosition(bodies[std::size_t(a)]),
                    *q = dBodyGetPosition(bodies[std::size_t(b)]);
        dJointSetBallAnchor(joint, (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, 0);
    }
    void lay(dBodyID body)
    {
        dContact contact{};
        contact.geom.normal[2] = 1;
        for (int i = 0; i < 3; ++i) contact.geom.pos[i] = dBodyGetPosition(body)[i];
        contact.surface.mu = dReal(0.5);
        dJointAttach(dJointCreateContact(world, nullptr, &contact), body, nullptr);
    }
};

TEST(SmallStack, islands_of_5000_rows_are_stepped)
{
    for (Stepper stepper : kSteppers) {
        const Library library;
        Mat mat(kSanitized ? 12 : 30);
        int done = 0;
        const std::size_t used = on_small_stack([&] {
            for (int i = 0; i < 2; ++i) done += step(mat.world, stepper, dReal(0.01));
        });
        EXPECT_EQ(done, 2);
        EXPECT_GE(rows_of(mat.world), kSanitized ? 800 : 5000);
        for (dBodyID b : mat.bodies) EXPECT_TRUE(finite(b));
        expect_small(kNames[int(stepper)], used);
    }
}

// The options of the exact stepper, and small islands, which have code of their own.
TEST(SmallStack, options_and_small_islands)
{
    for (Stepper stepper : kSteppers) {
        const Library library;
        for (int side : {2, 3, 5, 8, 12}) {
            Mat mat(side);
            dWorldSetExactSubsteps(mat.world, 3);
            dWorldSetStepProjection(mat.world, 5);
            dWorldSetExactRotation(mat.world, 1);
            for (dBodyID b : mat.bodies) dBodySetAngularVel(b, 1, 2, 3);
            int done = 0;
            const std::size_t used = on_small_stack([&] { done = step(mat.world, stepper, dReal(0.01)); });
            EXPECT_EQ(done, 1);
            expect_small(kNames[int(stepper)], used);
        }
    }
}

void count_pair(void* n, dGeomID a, dGeomID b)
{
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) return dSpaceCollide2(a, b, n, &count_pair);
    dContactGeom contact[8];
    *static_cast<int*>(n) += dCollide(a, b, 8, contact, sizeof contact[0]);
}

// A waved sheet of 338 triangles; its corners make a hull too.
struct Wavy {
    static constexpr int kSide = 14, kCorners = kSide * kSide, kTriangles = 2 * (kSide - 1) * (kSide - 1);
    dReal corners[3 * kCorners];
    dTriIndex triangles[3 * kTriangles];
    dTriMeshDataID data = dGeomTriMeshDataCreate();

    Wavy()
    {
        dTriIndex* t = triangles;
        for (int i = 0; i < kCorners; ++i) {
            const int x = i % kSide, y = i / kSide;
            dReal* const at = corners + 3 * i;
            at[0] = dReal(0.2) * dReal(x - kSide / 2), at[1] = dReal(0.2) * dReal(y - kSide / 2);
            at[2] = dReal(0.3) * std::sin(3 * at[0]) * std::cos(2 * at[1]);
            if (x + 1 == kSide || y + 1 == kSide) continue;
            for (int corner : {i, i + 1, i + kSide, i + 1, i + kSide + 1, i + kSide})
                *t++ = dTriIndex(corner);
        }
        const auto build = sizeof(dReal) == 8 ? dGeomTriMeshDataBuildDouble : dGeomTriMeshDataBuildSingle;
        build(data, corners, 3 * sizeof(dReal), kCorners, triangles, 3 * kTriangles, 3 * sizeof(dTriIndex));
    }
    ~Wavy() { dGeomTriMeshDataDestroy(data); }
    Wavy(const Wavy&) = delete;
    Wavy& operator=(const Wavy&) = delete;
};

TEST(SmallStack, every_pair_is_collided)
{
    const Library library;
    static const double heights[16] = {0, 0.3, 0.1, 0, 0.2, 0.5, 0.4, 0.1, 0, 0.6, 0.2, 0.3, 0.1, 0, 0.2, 0};
    dHeightfieldDataID field = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(field, heights, 0, 4, 4, 4, 4, 1, 0, 1, 0);
    const Wavy wavy;
    std::vector<dSpaceID> nest{dHashSpaceCreate(nullptr)};
    for (int i = 0; i < 8; ++i) nest.push_back(dSimpleSpaceCreate(nest.back()));
    std::vector<dGeomID> geoms;
    for (int copy = 0; copy < 2; ++copy) {
        dSpaceID space = nest[copy ? 8 : 0];
        dGeomID held = dCreateBox(nullptr, 1, 1, 1), transform = dCreateGeomTransform(space);
        dGeomTransformSetCleanup(transform, 1);
        dGeomTransformSetGeom(transform, held);
        for (dGeomID g : {dCreateSphere(space, dReal(0.6)), dCreateBox(space, 1, 1, 1),
                          dCreateCapsule(space, dReal(0.4), 1), dCreateCylinder(space, dReal(0.5), 1),
                          dCreatePlane(space, 0, 0, 1, dReal(0.1)), dCreateRay(space, 3),
                          dCreateHeightfield(space, field, 1), transform,
                          dCreateConvexHull(space, wavy.corners, Wavy::kCorners, 0),
                          dCreateTriMesh(space, wavy.data, nullptr, nullptr, nullptr)})
            geoms.push_back(g);
    }
    static dContactGeom contacts[64];
    int met = 0, near = 0;
    const std::size_t used = on_small_stack([&] {
        for (int turn = 0; turn < 20; ++turn) {
            for (std::size_t i = 0; i < geoms.size(); ++i) {
                if (dGeomGetClass(geoms[i]) == dPlaneClass) continue;
                const dReal x = dReal(0.37 * turn + double(i));
                const dQuaternion q = {1, dReal(0.2) * x, std::sin(x), std::cos(x)};
                dGeomSetQuaternion(geoms[i], q);
                dGeomSetPosition(geoms[i], dReal(0.3) * std::sin(x), dReal(0.3) * std::cos(2 * x),
                                 dReal(0.2));
            }
            for (dGeomID a : geoms)
                for (dGeomID b : geoms) met += dCollide(a, b, 64, contacts, sizeof contacts[0]);
        }
    });
    const std::size_t used_by_spaces = on_small_stack([&] { dSpaceCollide(nest[0], &near, &count_pair); });
    EXPECT_GT(met, 1000);
    EXPECT_GT(near, 50);
    expect_small("dCollide", used);
    expect_small("dSpaceCollide, nine spaces deep", used_by_spaces);
    dSpaceDestroy(nest[0]);
    dGeomHeightfieldDataDestroy(field);
}

}  // namespace
}  // namespace epode::memory
