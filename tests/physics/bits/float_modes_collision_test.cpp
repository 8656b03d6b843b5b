// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Collision, queries, masses and matrices by several threads in every floating-point mode of a host: the same
// bits, and the host's registers as they were, flags included.
#include "float_modes.h"
#include "rig.h"

#include <cstring>
#include <limits>
#include <thread>

namespace epode::physics {
namespace {

#ifdef EPODE_HAS_FLOAT_MODES

// Whatever calls have written, by its bits.
class Results {
  public:
    template <typename Value>
    void add(const Value& value)
    {
        unsigned char bytes[sizeof(Value)];
        std::memcpy(bytes, &value, sizeof value);
        for (const unsigned char byte : bytes) hash_ = (hash_ ^ byte) * 1099511628211u;
    }
    void add(const dReal* values, int count)
    {
        for (int i = 0; i < count; ++i) add(values[i]);
    }
    std::uint64_t hash() const { return hash_; }

  private:
    std::uint64_t hash_ = 14695981039346656037u;
};

struct Field {
    Field()
    {
        for (int i = 0; i < 36; ++i) heights[i] = float((i * 7 + i * i * 3) % 11) / 16;
        id = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildSingle(id, heights, 0, 6, 6, 6, 6, 1, dReal(-0.3), 1, 0);
    }
    ~Field() { dGeomHeightfieldDataDestroy(id); }
    Field(const Field&) = delete;
    Field& operator=(const Field&) = delete;
    float heights[36];
    dHeightfieldDataID id;
};

struct Mesh {
    Mesh()
    {
        id = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSingle(id, corners, 3 * sizeof(float), 5, faces, 18, 3 * sizeof(dTriIndex));
    }
    ~Mesh() { dGeomTriMeshDataDestroy(id); }
    Mesh(const Mesh&) = delete;
    Mesh& operator=(const Mesh&) = delete;
    static constexpr float corners[15] = {-0.7f, -0.6f, 0,    0.8f, -0.7f, 0.1f, 0.6f, 0.9f,
                                          0,     -0.8f, 0.7f, 0.1f, 0.1f,  0,    0.9f};
    static constexpr dTriIndex faces[18] = {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4, 0, 2, 1, 0, 3, 2};
    dTriMeshDataID id;
};

// One geom of every kind about the origin; scale 1 or so small that squares are denormal.
struct Zoo {
    explicit Zoo(std::uint32_t seed)
    {
        Random random(seed);
        static const dReal points[15] = {1,          0, 0, -1,         dReal(0.5), 0,          0, -1,
                                         dReal(0.2), 0, 0, dReal(1.3), dReal(0.3), dReal(0.4), -1};
        geoms = {dCreateSphere(space, dReal(0.8)),
                 dCreateBox(space, 1, dReal(1.3), dReal(0.7)),
                 dCreateCapsule(space, dReal(0.4), dReal(0.9)),
                 dCreateCylinder(space, dReal(0.5), dReal(1.1)),
                 dCreateConvexHull(space, points, 5, 0),
                 dCreateTriMesh(space, mesh.id, nullptr, nullptr, nullptr),
                 dCreateHeightfield(space, field.id, 1),
                 dCreateRay(space, 3)};
        for (const dGeomID geom : geoms) {
            const V3 at = random.point(0.7);
            dQuaternion q;
            random.quaternion(q);
            dGeomSetPosition(geom, real(at.x), real(at.y), real(at.z));
            dGeomSetQuaternion(geom, q);
        }
        geoms.push_back(dCreatePlane(space, dReal(0.1), dReal(0.2), dReal(0.97), dReal(-0.2)));
    }
    ~Zoo() { dSpaceDestroy(space); }
    Zoo(const Zoo&) = delete;
    Zoo& operator=(const Zoo&) = delete;
    Field field;
    Mesh mesh;
    dSpaceID space = dHashSpaceCreate(nullptr);
    std::vector<dGeomID> geoms;
};

bool is_solid(dGeomID geom)
{
    return dGeomGetClass(geom) <= dConvexClass && dGeomGetClass(geom) != dPlaneClass &&
           dGeomGetClass(geom) != dRayClass;
}

// In a mode: contacts of all pairs, written where nobody computes before the mode is over.
std::uint64_t contacts_of(const Zoo& zoo, const FloatMode& mode, bool& kept)
{
    constexpr int kCapacity = 16;
    Results results;
    for (const dGeomID a : zoo.geoms)
        for (const dGeomID b : zoo.geoms) {
            dContactGeom contacts[kCapacity] = {};
            int count;
            {
                const HostMode host(mode, kept);
                count = dCollide(a, b, kCapacity, contacts, sizeof(dContactGeom));
            }
            for (int i = 0; i < count; ++i) {
                results.add(contacts[i].pos, 3);
                results.add(contacts[i].normal, 3);
                results.add(contacts[i].depth);
                results.add(contacts[i].side1);
            }
            results.add(count);
        }
    return results.hash();
}

struct Pairs {
    int count = 0;
    int order[200];
};

std::uint64_t pairs_of(const Zoo& zoo, const FloatMode& mode, bool& kept)
{
    for (std::size_t i = 0; i < zoo.geoms.size(); ++i) dGeomSetData(zoo.geoms[i], reinterpret_cast<void*>(i));
    Pairs pairs;
    const auto note = [](void* data, dGeomID a, dGeomID b) {
        Pairs& all = *static_cast<Pairs*>(data);
        all.order[all.count++] = int(reinterpret_cast<std::size_t>(dGeomGetData(a)) * 16 +
                                     reinterpret_cast<std::size_t>(dGeomGetData(b)));
    };
    {
        const HostMode host(mode, kept);
        dSpaceCollide(zoo.space, &pairs, note);
        dSpaceCollide2(zoo.geoms[1], reinterpret_cast<dGeomID>(zoo.space), &pairs, note);
    }
    Results results;
    for (int i = 0; i < pairs.count; ++i) results.add(pairs.order[i]);
    return results.hash();
}

void add(Results& results, const dQueryHit& hit)
{
    results.add(hit.pos, 3);
    results.add(hit.normal, 3);
    results.add(hit.distance);
    results.add(hit.side);
}

std::uint64_t rays_of(const Zoo& zoo, const FloatMode& mode, int threads, bool& kept)
{
    constexpr int kRays = 300;
    static dReal origins[3 * kRays], directions[3 * kRays], lengths[kRays];
    Random random(5);
    for (int i = 0; i < kRays; ++i) {
        const V3 from = random.point(3), way = random.point(1);
        const double at[] = {from.x, from.y, from.z}, to[] = {way.x, way.y, way.z};
        for (int k = 0; k < 3; ++k) origins[3 * i + k] = real(at[k]), directions[3 * i + k] = real(to[k]);
        lengths[i] = 4;
    }
    static dQueryHit hits[kRays], one, all[16];
    std::memset(hits, 0, sizeof hits);
    int met, several;
    {
        const HostMode host(mode, kept);
        met = dSpaceRayBatch(zoo.space, kRays, origins, directions, lengths, nullptr, hits, threads);
        dSpaceRayClosest(zoo.space, origins, directions + 3, 4, nullptr, &one);
        several = dSpaceRayAll(zoo.space, origins + 6, directions, 4, nullptr, all, 16);
    }
    Results results;
    results.add(met);
    results.add(several);
    for (const dQueryHit& hit : hits) add(results, hit);
    add(results, one);
    for (int i = 0; i < several; ++i) add(results, all[i]);
    return results.hash();
}

std::uint64_t queries_of(const Zoo& zoo, const FloatMode& mode, bool& kept)
{
    Results results;
    const dVector3 motion = {dReal(0.3), dReal(-2), dReal(1.1), 0};
    for (const dGeomID a : zoo.geoms)
        for (const dGeomID b : zoo.geoms) {
            if (a == b || !is_solid(a)) continue;
            dQueryDistance distance{};
            dQueryHit cast{}, first{};
            dGeomID near[16];
            int found[4];
            {
                const HostMode host(mode, kept);
                found[0] = dGeomGetDistance(a, b, dInfinity, &distance);
                found[1] = dGeomCast(a, motion, b, &cast);
                found[2] = dSpaceCast(zoo.space, a, motion, nullptr, &first);
                found[3] = dSpaceOverlap(zoo.space, b, nullptr, near, 16);
            }
            results.add(found);
            results.add(distance.distance);
            results.add(distance.normal, 3);
            add(results, cast);
            add(results, first);
        }
    return results.hash();
}

std::uint64_t numbers_of(const Zoo& zoo, const FloatMode& mode, bool& kept)
{
    dMass m[8] = {};
    dReal depth[4];
    dVector3 p, q;
    const dVector3 a = {0, 0, 0, 0}, b = {1, dReal(0.7), 0, 0}, c = {dReal(0.3), 1, 1, 0},
                   d = {dReal(0.1), -1, dReal(0.7), 0};
    const dMatrix3 turn = {dReal(0.36), dReal(0.48), dReal(-0.8), 0,           dReal(-0.8), dReal(0.6),
                           0,           0,           dReal(0.48), dReal(0.64), dReal(0.6),  0};
    {
        const HostMode host(mode, kept);
        dMassSetSphere(&m[0], dReal(0.7), dReal(0.3));
        dMassSetBox(&m[1], dReal(0.7), dReal(0.1), dReal(0.3), dReal(1.1));
        dMassSetCylinder(&m[2], dReal(0.7), 2, dReal(0.3), dReal(1.1));
        dMassSetCapsule(&m[3], dReal(0.7), 3, dReal(0.3), dReal(1.1));
        dMassSetTrimesh(&m[4], dReal(0.7), zoo.geoms[5]);
        dMassSetConvex(&m[5], dReal(0.7), zoo.geoms[4]);
        m[6] = m[1];
        dMassTranslate(&m[6], dReal(0.1), dReal(0.2), dReal(0.3));
        dMassRotate(&m[6], turn);
        dMassAdd(&m[6], &m[2]);
        m[7] = m[3];
        dMassAdjust(&m[7], dReal(0.77));
        depth[0] = dGeomSpherePointDepth(zoo.geoms[0], dReal(0.1), dReal(0.2), dReal(0.3));
        depth[1] = dGeomBoxPointDepth(zoo.geoms[1], dReal(0.1), dReal(0.2), dReal(0.3));
        depth[2] = dGeomCapsulePointDepth(zoo.geoms[2], dReal(0.1), dReal(0.2), dReal(0.3));
        depth[3] = dGeomPlanePointDepth(zoo.geoms[8], dReal(0.1), dReal(0.2), dReal(0.3));
        dClosestLineSegmentPoints(a, b, c, d, p, q);
    }
    Results results;
    for (const dMass& mass : m) {
        results.add(mass.mass);
        results.add(mass.c, 3);
        results.add(mass.I, 12);
    }
    results.add(depth, 4);
    results.add(p, 3);
    results.add(q, 3);
    return results.hash();
}

// Shapes are computed from what the program gives, once.
std::uint64_t shapes_made(const FloatMode& mode, bool& kept)
{
    Field field;
    Mesh mesh;
    Zoo other(3);
    {
        const HostMode host(mode, kept);
        static const dReal points[15] = {1,          0, 0, -1,         dReal(0.5), 0,          0, -1,
                                         dReal(0.2), 0, 0, dReal(1.3), dReal(0.3), dReal(0.4), -1};
        dGeomSetConvexHull(other.geoms[4], points, 5, 0);
        dGeomTriMeshDataUpdate(other.mesh.id);
        dGeomHeightfieldDataSetBounds(other.field.id, dReal(-0.1), dReal(0.7));
    }
    bool usual = true;
    return contacts_of(other, {"usual", kUsualControl}, usual);
}

TEST(FloatModes, collision_and_queries_have_the_same_bits_in_all_of_them)
{
    const FloatMode usual{"usual", kUsualControl};
    for (std::uint32_t seed = 1; seed <= 5; ++seed) {
        const auto all_of = [&](const FloatMode& mode, int threads) {
            Zoo zoo(seed);  // boxes and trees are built again in the mode
            bool kept = true;
            std::vector<std::uint64_t> all = {pairs_of(zoo, mode, kept),         contacts_of(zoo, mode, kept),
                                              rays_of(zoo, mode, threads, kept), queries_of(zoo, mode, kept),
                                              numbers_of(zoo, mode, kept),       shapes_made(mode, kept)};
            all.push_back(kept || mode.control == kUsualControl);
            return all;
        };
        const auto alone = all_of(usual, 1);
        EXPECT_EQ(all_of(kEverythingTraps, 1), alone);
        for (const FloatMode& mode : kFloatModes)
            for (int threads = 1; threads <= 3; ++threads)
                EXPECT_EQ(all_of(mode, threads), alone) << mode.name << ' ' << threads;
    }
}

// Denormals that matter: spheres whose distance, squared, is one.
TEST(FloatModes, tiny_shapes_touch_where_they_do)
{
    const dReal size = std::sqrt(std::numeric_limits<dReal>::min()) / 16;
    const dGeomID a = dCreateSphere(nullptr, size), b = dCreateSphere(nullptr, size);
    dGeomSetPosition(b, 0, size, size);
    for (const FloatMode& mode : kFloatModes) {
        dContactGeom contact{};
        bool kept = true;
        int count;
        {
            const HostMode host(mode, kept);
            count = dCollide(a, b, 1, &contact, sizeof contact);
        }
        ASSERT_EQ(count, 1) << mode.name;
        EXPECT_TRUE(kept) << mode.name;
        EXPECT_NEAR(double(contact.normal[1]), -std::sqrt(0.5), 1e-4) << mode.name;
        EXPECT_NEAR(double(contact.depth / size), 2 - std::sqrt(2.), 1e-4) << mode.name;
    }
    dGeomDestroy(a);
    dGeomDestroy(b);
}

// A factorisation that several threads share; the threads carry the mode that the program gave them.
TEST(FloatModes, threads_with_modes_of_their_own_factor_the_same)
{
    constexpr int kSize = 120;
    const auto factor = [](const FloatMode& mode, bool shared, bool& kept) {
        std::vector<dReal> A(kSize * kSize), d(kSize);
        Random random(9);
        for (int i = 0; i < kSize; ++i)
            for (int j = 0; j <= i; ++j)
                A[std::size_t(i * kSize + j)] = real(i == j ? kSize : random.uniform(-1, 1));
        const dThreadingImplementationID impl = dThreadingAllocateMultiThreadedImplementation();
        dThreadingThreadPoolID pool = nullptr;
        {
            bool any = true;
            const HostMode host(mode, any, Keeps::kModes);
            pool = dThreadingAllocateThreadPool(2, 0, dAllocateFlagBasicData, nullptr);
        }
        dThreadingThreadPoolServeMultiThreadedImplementation(pool, impl);
        const dCooperativeID crew = dCooperativeCreate(dThreadingImplementationGetFunctions(impl), impl);
        const dResourceRequirementsID needs = dResourceRequirementsCreate(crew);
        dEstimateCooperativelyFactorLDLTResourceRequirements(needs, 0, kSize);
        const dResourceContainerID container = dResourceContainerAcquire(needs);
        {
            const HostMode host(mode, kept);
            if (shared)
                dCooperativelyFactorLDLT(container, 0, A.data(), d.data(), kSize, kSize);
            else
                dFactorLDLT(A.data(), d.data(), kSize, kSize);
        }
        dResourceContainerDestroy(container);
        dResourceRequirementsDestroy(needs);
        dCooperativeDestroy(crew);
        dThreadingImplementationShutdownProcessing(impl);
        dThreadingFreeThreadPool(pool);
        dThreadingFreeImplementation(impl);
        return A;
    };
    bool kept = true;
    const auto alone = factor({"usual", kUsualControl}, false, kept);
    kept = true;
    for (const FloatMode& mode : kFloatModes)
        for (const bool shared : {false, true})
            EXPECT_EQ(factor(mode, shared, kept), alone) << mode.name << ' ' << shared;
    EXPECT_TRUE(kept);
}

#endif

}  // namespace
}  // namespace epode::physics
