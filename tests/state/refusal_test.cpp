// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is no state of this world is refused in words that name the first thing wrong, and nothing changes.
#include <algorithm>
#include <cstring>

#include "../effort.h"
#include "checksum.h"
#include "scene.h"

namespace epode::states {
namespace {

void seal(Bytes& state)
{
    const std::uint64_t size = state.size(), sum = checksum(state.data() + 24, state.size() - 24);
    std::memcpy(&state[8], &size, 8), std::memcpy(&state[16], &sum, 8);
}

// Expects the refusal, in words that have `text` in them.
void expect_refused(const Scene& scene, const Bytes& state, const char* text)
{
    const Bytes before = scene.save();
    const int messages_before = Messages::count();
    EXPECT_FALSE(scene.load(state)) << text;
    EXPECT_EQ(Messages::count(), messages_before + 1);
    EXPECT_NE(Messages::last().find(text), std::string::npos) << Messages::last();
    EXPECT_TRUE(scene.save() == before) << text << ": something has changed";
}

TEST(StateRefusals, name_the_first_difference)
{
    const Messages messages;
    Scene scene({.piles = 2}), more({.piles = 3}), free({.joints = false, .piles = 2});
    scene.steps(3);
    const Bytes state = scene.save();
    expect_refused(scene, more.save(), "the state has 27 bodies and the world 24");
    expect_refused(scene, free.save(), "the state has 7 bodies and the world 24");
    Scene heavy({.piles = 2});
    dMass mass;
    dMassSetBox(&mass, 100, 1, 1, 1);
    dBodySetMass(heavy.bodies[5], &mass);
    expect_refused(heavy, state, "body 5 (of 24, in order of creation) had another mass");
    Scene wide({.piles = 2});
    dGeomBoxSetLengths(wide.grounds[1], 7, 7, 1);
    expect_refused(wide, state, "geom 1 (of 27, in order of creation) had another class, shape");
    Scene loose({.piles = 2});
    dJointAttach(loose.joints[3], loose.bodies[1], nullptr);
    expect_refused(loose, state, "joint 3 (of");
    Bytes other = state;
    other[4] = 9;
    expect_refused(scene, other, "a state of version 9; this library reads versions 3 to 8");
    other = state, other[6] = sizeof(dReal) == 8 ? 4 : 8;
    expect_refused(scene, other, sizeof(dReal) == 8 ? "single precision" : "double precision");
    other = state, other[0] ^= 1;
    expect_refused(scene, other, "no state of a world");
    other = state, other[other.size() / 2] ^= 16;
    expect_refused(scene, other, "checksum");
    other = state, other.resize(other.size() - 4);
    expect_refused(scene, other, "of which");
    other = state, other.resize(20);
    expect_refused(scene, other, "20 bytes are no state");
    other = state, other.resize(other.size() - 4), seal(other);
    expect_refused(scene, other, "ends too early");
    other = state, other.resize(other.size() + 4), seal(other);
    expect_refused(scene, other, "bytes too many");
    Bytes buffer(state.size() - 1, 7);
    EXPECT_EQ(dWorldGetState(scene.world, buffer.data(), buffer.size()), 0);
    EXPECT_EQ(buffer, Bytes(state.size() - 1, 7));
    other = state, other.resize(state.size() + 100, 3);
    EXPECT_TRUE(scene.load(other)) << "bytes behind the end do not matter";
}

// Found by tests/fuzz: such a quaternion, and a contact's normal of as wrong a length, were taken one by one and gave a normal that no
// step allows.
TEST(StateRefusals, an_orientation_that_is_nearly_of_unit_length)
{
    const Messages messages;
    Scene scene({.piles = 1});
    scene.step();
    dReal q[4];
    std::copy_n(dBodyGetQuaternion(scene.bodies[0]), 4, q);
    Bytes state = scene.save();
    const auto* const bytes = reinterpret_cast<const unsigned char*>(q);
    const auto at = std::search(state.begin(), state.end(), bytes, bytes + sizeof q);
    ASSERT_NE(at, state.end());
    for (dReal& part : q) part *= dReal(1.00025);
    std::copy_n(reinterpret_cast<const unsigned char*>(q), sizeof q, at);
    seal(state);
    expect_refused(scene, state, "no unit quaternion");
}

// Puts other numbers in the place of those.
void replace(Bytes& state, const std::vector<dReal>& numbers, const std::vector<dReal>& others)
{
    const auto* const bytes = reinterpret_cast<const unsigned char*>(numbers.data());
    const auto at = std::search(state.begin(), state.end(), bytes, bytes + numbers.size() * sizeof(dReal));
    ASSERT_NE(at, state.end());
    std::copy_n(reinterpret_cast<const unsigned char*>(others.data()), others.size() * sizeof(dReal), at);
    seal(state);
}

// Found by mutations of states: normals of length 3 and depths of 10 m, with the words that a setter of a rotation refuses.
TEST(StateRefusals, a_geom_that_is_turned_by_no_rotation)
{
    const Messages messages;
    const Scene scene({.piles = 1});
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 2, 3, dReal(0.7));
    dGeomSetRotation(scene.grounds[1], R);
    for (const dReal times : {dReal(1.4), dReal(-1)}) {  // longer; a reflection
        Bytes state = scene.save();
        replace(state, {R[0], R[1], R[2]}, {times * R[0], times * R[1], times * R[2]});
        expect_refused(scene, state, "turned by a matrix that is no rotation");
    }
}

// The height was judged before it was read; where it was read it was too late to refuse, and the rest of the state was lost.
TEST(StateRefusals, a_character_of_no_height)
{
    const Messages messages;
    const Scene scene({.piles = 1});
    dCharacterSettings settings;
    dCharacterSettingsInit(&settings, sizeof settings);
    settings.height = dReal(1.7345);
    dCharacterCreate(scene.space, &settings);
    for (const dReal height : {dReal(-1), dReal(0), dReal(1e9)}) {
        Bytes state = scene.save();
        replace(state, {settings.height}, {height});
        expect_refused(scene, state, "a state or a height that it cannot have");
    }
}

void try_in_step(dBodyID body)
{
    const dWorldID world = dBodyGetWorld(body);
    unsigned char buffer[64] = {};
    EXPECT_EQ(dWorldGetStateSize(world), 0u);
    EXPECT_EQ(dWorldGetState(world, buffer, sizeof buffer), 0);
    EXPECT_EQ(dWorldSetState(world, buffer, sizeof buffer), 0);
    EXPECT_EQ(dWorldGetStateDelta(world, buffer, sizeof buffer, nullptr, 0), 0u);
    EXPECT_EQ(dWorldSetStateDelta(world, buffer, sizeof buffer, buffer, sizeof buffer), 0);
    EXPECT_NE(Messages::last().find("during a step"), std::string::npos);
}

TEST(StateRefusals, during_a_step_and_in_a_locked_space)
{
    const Messages messages;
    Scene scene({.piles = 1});
    dBodySetMovedCallback(scene.bodies[0], try_in_step);
    scene.step();
    EXPECT_EQ(Messages::count(), 5);
    struct Locked {
        const Scene& scene;
        const Bytes state;
        bool loaded;
    } locked{scene, scene.save(), true};
    dSpaceCollide(scene.space, &locked, [](void* data, dGeomID, dGeomID) {
        auto& l = *static_cast<Locked*>(data);
        l.loaded = l.scene.load(l.state);
    });
    EXPECT_FALSE(locked.loaded);
    EXPECT_NE(Messages::last().find("locked space"), std::string::npos);
}

int mutations()
{
    const char* wanted = std::getenv("EPODE_STATE_MUTATIONS");
    return wanted ? std::atoi(wanted) : tests::effort(4000);
}

void mutate(Bytes& state, std::mt19937& random)
{
    const auto place = [&] { return 24 + random() % (state.size() - 24); };
    for (unsigned n = 1 + random() % 4; n-- > 0 && state.size() > 64;) switch (random() % 6) {
            case 0:
                state[place()] ^= static_cast<unsigned char>(1u << random() % 8);
                break;
            case 1:
                state[place()] = static_cast<unsigned char>(random());
                break;
            case 2: {
                const std::uint32_t words[] = {0,          ~0u,        1,          0x7fffffff,
                                               0x80000000, 0x7f800000, 0x7ff00000, std::uint32_t(random())};
                std::memcpy(&state[place() / 4 * 4 - 4], &words[random() % 8], 4);
                break;
            }
            case 3:
                state.resize(state.size() - 4 * (1 + random() % 8));
                break;
            case 4:
                state.insert(state.begin() + std::ptrdiff_t(place() / 4 * 4), 4, 0);
                break;
            default: {
                const std::size_t from = place() / 4 * 4, to = place() / 4 * 4;
                const std::size_t n4 = std::min(state.size() - std::max(from, to), std::size_t(16));
                std::memmove(&state[to], &state[from], n4);
            }
        }
}

// Changed bytes under a right checksum: somebody wants to do harm.
TEST(HostileStates, are_refused_or_taken_without_harm)
{
    const Messages messages;
    std::mt19937 random(5);
    int refused = 0, taken = 0;
    for (const bool world_contacts : {true, false}) {
        Scene scene({.stepper = Stepper::kSubsteps, .world_contacts = world_contacts, .piles = 3});
        scene.steps(40);
        const Bytes good = scene.save();
        scene.step();
        const Bytes next = scene.save();
        ASSERT_TRUE(scene.load(good));
        for (int i = 0; i < mutations() / 2; ++i) {
            Bytes state = good;
            mutate(state, random);
            seal(state);
            const Bytes before = scene.save();
            const int messages_before = Messages::count();
            if (scene.load(state)) {
                ++taken;
                (void)scene.save();
                for (int k = 0; k < 2; ++k) scene.step();
                std::vector<dWorldContact> contacts(64);
                (void)dWorldGetContacts(scene.world, contacts.data(), 64);
                ASSERT_TRUE(scene.load(good)) << Messages::last();
                scene.step();
                ASSERT_EQ(difference(scene.save(), next), "") << "after mutation " << i;
                ASSERT_TRUE(scene.load(good)) << Messages::last();
            } else {
                ++refused;
                ASSERT_EQ(Messages::count(), messages_before + 1);
                ASSERT_TRUE(scene.save() == before) << Messages::last() << " has changed something";
            }
        }
        ASSERT_TRUE(scene.load(good));
        scene.step();
        EXPECT_TRUE(scene.save() == next) << "a good state no longer gives its bits";
    }
    EXPECT_GT(refused, mutations() / 20);
    EXPECT_GT(taken, mutations() / 20);
}

TEST(HostileStates, as_differences_are_refused_or_taken_without_harm)
{
    const Messages messages;
    std::mt19937 random(6);
    Scene scene({.stepper = Stepper::kSubsteps, .piles = 3});
    scene.steps(40);
    const Bytes base = scene.save();
    scene.step();
    Bytes good(dWorldGetStateDelta(scene.world, base.data(), base.size(), nullptr, 0));
    ASSERT_EQ(dWorldGetStateDelta(scene.world, base.data(), base.size(), good.data(), good.size()),
              good.size());
    EXPECT_LT(good.size(), base.size());
    for (int i = 0; i < mutations() / 4; ++i) {
        Bytes delta = good;
        mutate(delta, random);
        if (random() % 4) seal(delta);
        (void)dWorldSetStateDelta(scene.world, base.data(), base.size(), delta.data(), delta.size());
    }
    EXPECT_EQ(dWorldSetStateDelta(scene.world, base.data(), base.size(), good.data(), good.size()), 1);
    Bytes other = base;
    other[30] ^= 1, seal(other);
    EXPECT_EQ(dWorldSetStateDelta(scene.world, other.data(), other.size(), good.data(), good.size()), 0);
    EXPECT_NE(Messages::last().find("another base"), std::string::npos) << Messages::last();
}

TEST(StateDelta, of_what_sleeps_costs_next_to_nothing)
{
    Scene scene({.stepper = Stepper::kSubsteps, .joints = false, .piles = 60});
    scene.steps(300);
    for (const dBodyID body : scene.bodies) dBodyDisable(body);
    scene.steps(3);
    const Bytes base = scene.save();
    dBodyEnable(scene.bodies[4]), dBodySetLinearVel(scene.bodies[4], 1, 0, 2);
    scene.steps(2);
    const std::size_t size = dWorldGetStateDelta(scene.world, base.data(), base.size(), nullptr, 0);
    EXPECT_LT(size, base.size() / 10) << base.size();
}

}  // namespace
}  // namespace epode::states
