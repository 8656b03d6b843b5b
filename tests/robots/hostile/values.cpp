// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "values.h"

#include <climits>
#include <cmath>
#include <cstring>
#include <limits>

namespace hostile {
namespace {

constexpr dReal kNotANumber = std::numeric_limits<dReal>::quiet_NaN(),
                kInf = std::numeric_limits<dReal>::infinity();
constexpr dReal kHuge = std::numeric_limits<dReal>::max(), kTiny = std::numeric_limits<dReal>::denorm_min();
constexpr int kLastQuantity = dBatchSensors, kLastParameter = dBatchRollingFrictions;
// What robots' functions take at most.
constexpr dReal kLimit = sizeof(dReal) == 8 ? dReal(1e30) : dReal(1e9);
constexpr std::size_t kOutputSize = 1 << 16;
constexpr int kRays = 16, kSide = 16, kTargets = 2, kMaxPositions = 64;

template <typename Type>
std::vector<void*> pointers(const std::vector<Type>& from)
{
    return {from.begin(), from.end()};
}

Value pointer(void* p, Trait trait, const char* text)
{
    Value v;
    v.pointer = p, v.trait = trait, v.text = text;
    return v;
}

Value none() { return pointer(nullptr, Trait::kNull, "null"); }

bool is(Role role, std::initializer_list<Role> any)
{
    for (const Role r : any)
        if (r == role) return true;
    return false;
}

}  // namespace

std::uint64_t Values::random()
{
    std::uint64_t z = (seed_ += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

Value Values::block(int argument, const void* content, std::size_t size)
{
    Block& its = blocks_[argument];
    its.data = std::make_unique<char[]>(size), its.size = size;
    if (content) std::memcpy(its.data.get(), content, size);
    return pointer(its.data.get(), Trait::kFine, "block");
}

bool Values::is_untouched(int argument) const
{
    const Block& its = blocks_[argument];
    for (std::size_t i = 0; i < its.size; ++i)
        if (its.data[i] != 0) return false;
    return true;
}

bool Values::is_number(int argument) const
{
    const Block& its = blocks_[argument];
    for (std::size_t i = 0; i + sizeof(dReal) <= its.size; i += sizeof(dReal)) {
        dReal value;
        std::memcpy(&value, &its.data[i], sizeof value);
        if (std::isnan(value)) return false;
    }
    return true;
}

Value Values::handle(const std::vector<void*>& live, void* dead, bool hostile)
{
    if (!hostile) return pointer(live[std::size_t(below(int(live.size())))], Trait::kFine, "live");
    alignas(64) static char zeros[256], letters[256] = "letters";
    const auto bits = [](std::uintptr_t value) { return reinterpret_cast<void*>(value); };
    void* const wrong[] = {nullptr,
                           dead,
                           scene_.world,
                           scene_.space,
                           scene_.models[0],
                           scene_.robots[0],
                           scene_.batches[0],
                           zeros,
                           letters,
                           bits(reinterpret_cast<std::uintptr_t>(live[0]) + 1),
                           bits(1),
                           bits(64),
                           bits(~std::uintptr_t(0))};
    void* const its = wrong[below(int(std::size(wrong)))];
    for (void* good : live)
        if (good == its) return pointer(its, Trait::kFine, "live");
    return pointer(its, its ? Trait::kBad : Trait::kNull, its ? "wrong handle" : "null");
}

Value Values::integer(long long good, std::initializer_list<std::pair<long long, Trait>> bad, bool hostile)
{
    Value v;
    v.integer = good, v.text = "count";
    if (!hostile) return v;
    const auto& chosen = bad.begin()[below(int(bad.size()))];
    v.integer = chosen.first, v.trait = chosen.second, v.text = "odd integer";
    if (v.integer == good) v.trait = Trait::kFine;
    return v;
}

Value Values::real(std::initializer_list<std::pair<double, Trait>> bad, bool hostile)
{
    Value v;
    v.real = dReal(0.01) * dReal(1 + below(100)), v.text = "real";
    if (!hostile) return v;
    const auto& chosen = bad.begin()[below(int(bad.size()))];
    v.real = dReal(chosen.first), v.trait = chosen.second, v.text = "odd real";
    return v;
}

Value Values::reals(int argument, int count, bool hostile)
{
    static constexpr dReal kOdd[] = {0, kTiny, -kTiny, kLimit, -kLimit, kHuge, -kHuge, kInf, kNotANumber};
    if (hostile && below(5) == 0) return none();
    Value v = block(argument, nullptr, std::size_t(count) * sizeof(dReal));
    auto* const values = static_cast<dReal*>(v.pointer);
    for (int i = 0; i < count; ++i) values[i] = dReal(below(2001) - 1000) / 700;
    if (!hostile || count == 0) return v;
    const dReal odd = kOdd[below(int(std::size(kOdd)))];
    if (below(2) && !std::isnan(odd))
        for (int i = 0; i < count; ++i) values[i] = odd;
    values[below(count)] = odd;
    v.trait = std::fabs(odd) <= kLimit ? Trait::kStrange : Trait::kNaN, v.text = "odd reals";
    return v;
}

// Reals of which the last four are a quaternion, which must not be 0.
Value Values::frame(int argument, int first, int count, bool hostile)
{
    if (below(3) == 0) return none();
    Value v = reals(argument, count, hostile);
    auto* const values = static_cast<dReal*>(v.pointer);
    if (!values || v.trait == Trait::kNaN) return v;
    dReal square = 0;
    for (int i = first; i < count; ++i) square += values[i] * values[i];
    if (!(square > 0)) v.trait = Trait::kBad, v.text = "no quaternion";
    return v;
}

Value Values::text(int argument, std::initializer_list<std::string> all, bool hostile)
{
    static const std::string odd[] = {"",          std::string(5000, 'x'), "\xff\xfe", "/",
                                      "/dev/null", "/nowhere/at/all.urdf", "%s%n"};
    if (hostile && below(4) == 0) return none();
    const std::string& chosen =
        hostile ? odd[below(int(std::size(odd)))] : all.begin()[below(int(all.size()))];
    Value v = block(argument, chosen.c_str(), chosen.size() + 1);
    v.trait = hostile ? Trait::kStrange : Trait::kFine, v.text = hostile ? "odd text" : "text";
    return v;
}

Value Values::options(int argument, bool hostile)
{
    if (below(3) == 0) return none();
    dRobotOptions o{};
    o.struct_size = sizeof o;
    o.keep_fixed = below(2), o.fixed_base = below(2), o.repair = below(2), o.meshes_as_triangles = below(2);
    o.inertia_from_shapes = below(2), o.strict = below(2);
    if (!hostile) return structure(argument, o, Trait::kFine);
    const int which = below(6);
    if (which == 0) o.struct_size = 0;
    if (which == 1) o.struct_size = UINT_MAX;
    if (which == 2) o.missing_mass = kNotANumber;
    if (which == 3) o.missing_mass = kInf;
    if (which == 4) o.missing_mass = -1;
    if (which == 5) o.roots = ":::/nowhere:", o.missing_mass = kLimit, o.strict = INT_MIN;
    return structure(argument, o, which == 5 ? Trait::kStrange : Trait::kBad);
}

Value Values::targets(int argument, bool hostile)
{
    if (hostile && below(5) == 0) return none();
    dRobotTarget all[kTargets];
    for (dRobotTarget& target : all) {
        dRobotTargetInit(&target, below(2));
        for (int i = 0; i < 3; ++i) target.position[i] = dReal(below(200) - 100) / 100;
    }
    Value v = block(argument, nullptr, sizeof all);
    dRobotTarget& first = all[0];
    const int which = hostile ? below(10) : -1;
    if (which == 0) first.link = -1;
    if (which == 1) first.link = INT_MAX;
    if (which == 2) first.position[1] = kNotANumber;
    if (which == 3) first.point[2] = kInf;
    if (which == 4) first.q[0] = 0;
    if (which == 5) first.position_weight = -1;
    if (which == 6) first.orientation_weight = kNotANumber;
    if (which == 7) first.position[0] = kHuge, first.point[0] = -kHuge;
    if (which == 8) first.q[1] = kHuge, first.position_weight = kHuge, first.orientation_weight = kTiny;
    if (which == 9)
        first.position[0] = kLimit, first.position_weight = kLimit, first.orientation_weight = kTiny;
    std::memcpy(v.pointer, all, sizeof all);
    v.trait = which < 0 ? Trait::kFine : which < 9 ? Trait::kBad : Trait::kStrange, v.text = "targets";
    return v;
}

Value Values::inverse_options(int argument, bool hostile)
{
    if (hostile && below(5) == 0) return none();
    dRobotInverseOptions o;
    dRobotInverseOptionsInit(&o, sizeof o);
    o.max_iterations = 1 + below(4), o.max_starts = 1 + below(2);
    if (!hostile) return structure(argument, o, Trait::kFine);
    const int which = below(10);
    Block& weights = inner_[0];
    weights.data = std::make_unique<char[]>(std::size_t(velocities_) * sizeof(dReal));
    auto* const its = reinterpret_cast<dReal*>(weights.data.get());
    for (int i = 0; i < velocities_; ++i) its[i] = 1;
    if (which == 0) o.struct_size = 8;
    if (which == 1) o.max_iterations = 0;
    if (which == 2) o.max_iterations = 1001;
    if (which == 3) o.max_starts = INT_MIN;
    if (which == 4) o.tolerance = kNotANumber;
    if (which == 5) o.tolerance = -1;
    if (which == 6 && velocities_ > 0) o.weights = its, its[below(velocities_)] = kNotANumber;
    if (which == 7 && velocities_ > 0) o.weights = its, its[below(velocities_)] = -1;
    if (which == 8) o.weights = its;
    if (which == 9) o.tolerance = kTiny;
    const bool odd = which >= 8 || (which >= 6 && velocities_ == 0);
    return structure(argument, o, odd ? Trait::kStrange : Trait::kBad);
}

Value Values::camera(int argument, bool hostile)
{
    if (hostile && below(8) == 0) return none();
    dRobotCamera c;
    dRobotCameraInit(&c, sizeof c);
    c.width = 1 + below(kSide), c.height = 1 + below(kSide);
    if (!hostile) return structure(argument, c, Trait::kFine);
    const int which = below(14);
    if (which == 0) c.struct_size = 0;
    if (which == 1) c.width = 0;
    if (which == 2) c.height = -1;
    if (which == 3) c.width = 8193;
    if (which == 4) c.height = INT_MAX;
    if (which == 5) c.field = kNotANumber;
    if (which == 6) c.field = 0;
    if (which == 7) c.field = 4;
    if (which == 8) c.max_distance = kNotANumber;
    if (which == 9) c.max_distance = 0;
    if (which == 10) c.threads = -1;
    if (which == 11) c.threads = 2, c.field = kTiny;
    if (which == 12) c.max_distance = kInf;
    if (which == 13) c.max_distance = kLimit, c.field = dReal(3.1415);
    return structure(argument, c, which <= 10 ? Trait::kBad : Trait::kStrange);
}

// Those of a tetrahedron. The wrong index is in the first three, which an odd count (3) takes.
Value Values::triangles(int argument, bool hostile)
{
    if (hostile && below(3) == 0) return none();
    static constexpr unsigned kFaces[12] = {0, 1, 2, 0, 3, 1, 0, 2, 3, 1, 3, 2},
                              kWrong[] = {4, 1u << 31, UINT_MAX};
    Value v = block(argument, kFaces, sizeof kFaces);
    if (!hostile) return v;
    static_cast<unsigned*>(v.pointer)[below(9)] = kWrong[below(3)];
    v.trait = Trait::kBad, v.text = "index beyond the vertices";
    return v;
}

Value Values::decomposition(int argument, bool hostile)
{
    if (below(3) == 0) return none();
    dDecompositionOptions o;
    dDecompositionOptionsInit(&o, sizeof o);
    o.tolerance = dReal(below(3)) / 10;
    if (!hostile) return structure(argument, o, Trait::kFine);
    const int which = below(5);
    if (which == 0) o.struct_size = 4;
    if (which == 1) o.max_vertices = 3;
    if (which == 2) o.max_vertices = INT_MIN;
    if (which == 3) o.tolerance = kNotANumber;
    if (which == 4) o.tolerance = -1;
    return structure(argument, o, which == 3 ? Trait::kNaN : Trait::kBad);
}

Value Values::batch_options(int argument, bool hostile)
{
    if (below(3) == 0) return none();
    dBatchOptions o;
    dBatchOptionsInit(&o, sizeof o);
    o.doubles = below(2), o.threads = 1 + below(2), o.max_sweeps = 1 + below(50);
    if (!hostile) return structure(argument, o, Trait::kFine);
    const int which = below(10);
    if (which == 0) o.struct_size = 4;
    o.pinned = below(2);
    if (which == 1) o.doubles = 2;
    if (which == 2) o.threads = -1;
    if (which == 3) o.max_sweeps = 0;
    if (which == 4) o.stepsize = kNotANumber;
    if (which == 5) o.stepsize = 0;
    if (which == 6) o.erp = -1;
    if (which == 7) o.max_correction = kInf;
    if (which == 8) o.reach = kNotANumber;
    if (which == 9) o.tolerance = -1;
    return structure(argument, o, Trait::kBad);
}

// Floats or doubles, whatever the batch has: halves and zeros of both; or what is no number in both.
Value Values::copy_values(int argument, bool hostile)
{
    if (hostile && below(3) == 0) return none();
    std::vector<double> values(std::size_t(64 * Scene::kCopies), 0.5);
    constexpr std::uint64_t kNone = 0x7ff800007ff80000u;
    if (hostile) std::memcpy(values.data(), &kNone, sizeof kNone);
    Value v = block(argument, values.data(), values.size() * sizeof(double));
    v.trait = hostile ? Trait::kNaN : Trait::kFine, v.text = hostile ? "NaN" : "values";
    return v;
}

Value Values::sized(int argument, unsigned struct_size, std::size_t size, bool hostile)
{
    if (hostile && below(3) == 0) return none();
    static constexpr unsigned kWrong[] = {0, 4, 9, UINT_MAX};
    Value v = block(argument, nullptr, size);
    const unsigned its = hostile ? kWrong[below(4)] : struct_size;
    std::memcpy(v.pointer, &its, sizeof its);
    v.trait = hostile ? Trait::kBad : Trait::kFine, v.text = "structure";
    return v;
}

Value Values::output(int argument, std::size_t size, bool hostile)
{
    if (hostile && below(2)) return none();
    return block(argument, nullptr, size);
}

// How many coordinates and velocities arrays of this call have.
void Values::measure(const RobotFunction& function, const Value& first)
{
    positions_ = velocities_ = kMaxPositions;
    if (first.trait != Trait::kFine && first.trait != Trait::kStrange) return;
    if (function.roles[0] == Role::kModel) {
        positions_ = dRobotModelGetNumPositions(static_cast<dRobotModelID>(first.pointer));
        velocities_ = dRobotModelGetNumVelocities(static_cast<dRobotModelID>(first.pointer));
    } else if (function.roles[0] == Role::kRobot) {
        positions_ = dRobotGetPositions(static_cast<dRobotID>(first.pointer), nullptr, 0);
        velocities_ = dRobotGetVelocities(static_cast<dRobotID>(first.pointer), nullptr, 0);
    }
    messages().clear();
}

Value Values::choose(const RobotFunction& function, int argument, bool hostile)
{
    using enum Trait;
    const auto counted = [&](int good) {
        return integer(good, {{good + 1, kBad}, {-1, kBad}, {0, kBad}, {INT_MAX, kBad}, {INT_MIN, kBad}},
                       hostile);
    };
    switch (function.roles[std::size_t(argument)]) {
        case Role::kModel: {
            Value v = handle(pointers(scene_.models), scene_.dead_model, hostile);
            if (hostile && below(6) == 0) v = pointer(scene_.faulty_model, kStrange, "faulty model");
            return v;
        }
        case Role::kRobot:
            return handle(pointers(scene_.robots), scene_.dead_robot, hostile);
        case Role::kWorld:
            return handle({scene_.world, scene_.other_world}, scene_.dead_world, hostile);
        case Role::kSpace:
        case Role::kSpaceOrNone:
            return handle({scene_.space}, scene_.dead_space, hostile);
        case Role::kNumber:
            return integer(below(3),
                           {{-1, kBad}, {INT_MIN, kBad}, {INT_MAX, kBad}, {1000, kBad}, {8, kStrange}},
                           hostile);
        case Role::kAnyNumber:
            return integer(1, {{-1, kStrange}, {INT_MAX, kStrange}}, hostile);
        case Role::kMode:
            return integer(below(2), {{-1, kBad}, {2, kBad}, {INT_MAX, kBad}}, hostile);
        case Role::kPositionCount:
            return counted(positions_);
        case Role::kVelocityCount:
            return counted(velocities_);
        case Role::kCapacity:
            return integer(200, {{-1, kBad}, {INT_MIN, kBad}, {0, kFine}, {1, kFine}, {INT_MAX, kStrange}},
                           hostile);
        case Role::kRayCount:
            return integer(kRays, {{-1, kBad}, {INT_MIN, kBad}, {0, kFine}}, hostile);
        case Role::kTargetCount:
            return integer(1 + below(kTargets), {{-1, kBad}, {INT_MIN, kBad}, {0, kFine}}, hostile);
        case Role::kStructSize:
            return integer(function.struct_size, {{0, kBad}, {4, kBad}, {UINT_MAX, kBad}}, hostile);
        case Role::kReal:
            return real({{0, kFine},
                         {double(kLimit), kStrange},
                         {-double(kHuge), kBad},
                         {double(kInf), kNaN},
                         {double(kNotANumber), kNaN}},
                        hostile);
        case Role::kPositive:
            return real({{0, kBad},
                         {-1, kBad},
                         {double(kTiny), kBad},
                         {double(kHuge), kBad},
                         {double(kInf), kNaN},
                         {double(kNotANumber), kNaN}},
                        hostile);
        case Role::kNotNegative:
            return real({{0, kFine},
                         {-1, kBad},
                         {double(kLimit), kStrange},
                         {double(kHuge), kBad},
                         {double(kInf), kNaN},
                         {double(kNotANumber), kNaN}},
                        hostile);
        case Role::kDistance:
            return real({{0, kFine},
                         {-1, kBad},
                         {double(kHuge), kBad},
                         {double(kLimit), kStrange},
                         {double(kInf), kStrange},
                         {double(kNotANumber), kNaN}},
                        hostile);
        case Role::kPositions:
            return reals(argument, positions_, hostile);
        case Role::kPositionInOut:
            return reals(argument, positions_, hostile);
        case Role::kVelocities:
            return reals(argument, velocities_, hostile);
        case Role::kVelocitiesOrNone:
            return below(3) ? reals(argument, velocities_, hostile) : none();
        case Role::kPointOrNone:
            return below(3) ? reals(argument, 3, hostile) : none();
        case Role::kTurnOrNone:
            return below(3) ? reals(argument, 4, hostile) : none();
        case Role::kFrameOrNone:
            return frame(argument, 3, 7, hostile);
        case Role::kDirections: {
            Value v = reals(argument, 3 * kRays, hostile);
            const auto* const values = static_cast<const dReal*>(v.pointer);
            for (int i = 0; values && v.trait != kNaN && i < kRays; ++i)
                if (values[3 * i] == 0 && values[3 * i + 1] == 0 && values[3 * i + 2] == 0) v.trait = kBad;
            return v;
        }
        case Role::kOriginsOrNone:
            return below(3) ? reals(argument, 3 * kRays, hostile) : none();
        case Role::kName:
            return text(argument, {"wrist", "torso", "hip", "eye", "knee", "base"}, hostile);
        case Role::kLoadPath:
            return text(argument, {scene_.paths[0], scene_.paths[1], scene_.paths[2]}, hostile);
        case Role::kSavePath:
            return text(argument, {"hostile_saved.urdf", "hostile_saved.xml", "hostile_saved.mjcf"}, hostile);
        case Role::kText: {
            if (hostile && below(4) == 0) return none();
            std::string text = scene_.text;
            if (hostile) text.resize(std::size_t(below(int(text.size()))));
            for (int i = 0; hostile && !text.empty() && i < below(20); ++i)
                text[std::size_t(below(int(text.size())))] = char(below(256));
            text_size_ = text.size();
            Value v = block(argument, text.data(), text.size());
            v.trait = hostile ? kStrange : kFine, v.text = "text";
            return v;
        }
        case Role::kTextSize:
            return integer(static_cast<long long>(text_size_),
                           {{0, kStrange}, {static_cast<long long>(text_size_ / 2), kStrange}}, hostile);
        case Role::kOptions:
            return options(argument, hostile);
        case Role::kTargets:
            return targets(argument, hostile);
        case Role::kInverseOptions:
            return inverse_options(argument, hostile);
        case Role::kResult:
            return below(4)
                       ? sized(argument, sizeof(dRobotInverseResult), sizeof(dRobotInverseResult), hostile)
                       : none();
        case Role::kCamera:
            return camera(argument, hostile);
        case Role::kTouch:
            return sized(argument, sizeof(dRobotTouch), sizeof(dRobotTouch), hostile);
        case Role::kCorners:
            return reals(argument, 12, hostile);
        case Role::kCornerCount:
            return integer(4, {{-1, kBad}, {0, kBad}, {3, kBad}, {INT_MIN, kBad}}, hostile);
        case Role::kTriangles:
            return triangles(argument, hostile);
        case Role::kTriangleCount:
            return integer(4, {{-1, kBad}, {0, kBad}, {3, kStrange}, {INT_MIN, kBad}}, hostile);
        case Role::kDecomposition:
            return decomposition(argument, hostile);
        case Role::kGeomCapacity:
            return integer(8, {{-1, kBad}, {0, kBad}, {257, kBad}, {INT_MIN, kBad}, {1, kStrange}}, hostile);
        case Role::kDecompositionReport:
            return below(3)
                       ? sized(argument, sizeof(dDecompositionReport), sizeof(dDecompositionReport), hostile)
                       : none();
        case Role::kBatch:
            return handle(pointers(scene_.batches), scene_.dead_batch, hostile);
        case Role::kBatchSize:
            return integer(1 + below(20), {{0, kBad}, {-1, kBad}, {INT_MIN, kBad}}, hostile);
        case Role::kBatchOptions:
            return batch_options(argument, hostile);
        case Role::kQuantity:
            return integer(below(kLastQuantity + 1), {{-1, kBad}, {kLastQuantity + 1, kBad}, {INT_MAX, kBad}},
                           hostile);
        case Role::kParameter:
            return integer(below(kLastParameter + 1),
                           {{-1, kBad}, {kLastParameter + 1, kBad}, {INT_MAX, kBad}}, hostile);
        case Role::kFirstCopy:
            return integer(below(2),
                           {{-1, kBad}, {INT_MIN, kBad}, {INT_MAX, kBad}, {Scene::kCopies + 1, kBad}},
                           hostile);
        case Role::kCopyCount:
            return integer(1 + below(Scene::kCopies - 1),
                           {{-1, kBad}, {INT_MIN, kBad}, {INT_MAX, kBad}, {0, kFine}}, hostile);
        case Role::kMethod:
            return integer(below(dBatchExact + 1), {{-1, kBad}, {dBatchExact + 1, kBad}, {INT_MAX, kBad}},
                           hostile);
        case Role::kHalf: {
            Value v =
                real({{-1, kBad}, {1, kBad}, {double(kNotANumber), kBad}, {double(kInf), kBad}}, hostile);
            if (!hostile) v.real /= 2;
            return v;
        }
        case Role::kBatchLink:
            return integer(1, {{-1, kBad}, {INT_MIN, kBad}, {INT_MAX, kBad}, {0, kFine}}, hostile);
        case Role::kStepCount:
            return integer(below(3), {{-1, kBad}, {INT_MIN, kBad}}, hostile);
        case Role::kCopyValues:
            return copy_values(argument, hostile);
        case Role::kBound:
            return below(2) ? none() : pointer(scene_.bound.data(), kFine, "bound");
        case Role::kRayAxes:
            return integer(below(3), {{-1, kBad}, {3, kBad}, {INT_MAX, kBad}}, hostile);
        case Role::kMask:
            return below(3) ? output(argument, std::size_t(Scene::kCopies), false) : none();
        case Role::kOutput:
            return output(argument, kOutputSize, hostile);
        case Role::kFewOutput:
            return output(argument, sizeof(dRobotTarget), hostile);
        case Role::kRangeOutput:
            return output(argument, kRays * sizeof(dReal), hostile);
        case Role::kOutputOrNone:
            return below(3) ? output(argument, kSide * kSide * sizeof(void*), hostile) : none();
    }
    return none();
}

void Values::choose(const RobotFunction& function, Value* arguments, int often)
{
    for (int i = 0; i < int(function.roles.size()); ++i) {
        blocks_[i] = {};
        arguments[i] = choose(function, i, below(often) == 0);
        if (i == 0) measure(function, arguments[0]);
    }
}

int Values::must_refuse(const RobotFunction& function, const Value* arguments) const
{
    const auto value_of = [&](Role role) {
        for (std::size_t i = 0; i < function.roles.size(); ++i)
            if (function.roles[i] == role) return arguments[i].integer;
        return 1LL;
    };
    for (int i = 0; i < int(function.roles.size()); ++i) {
        const Role role = function.roles[std::size_t(i)];
        const Trait trait = arguments[i].trait;
        const bool of_rays = is(role, {Role::kDirections, Role::kOriginsOrNone, Role::kRangeOutput}) &&
                             value_of(Role::kRayCount) == 0;
        const bool of_targets = role == Role::kTargets && value_of(Role::kTargetCount) == 0;
        const bool of_copies =
            is(role, {Role::kOutput, Role::kCopyValues}) && value_of(Role::kCopyCount) == 0;
        if (role == Role::kOutput && value_of(Role::kRayCount) == 0) continue;
        if (of_rays || of_targets || of_copies) continue;
        if (trait == Trait::kBad || trait == Trait::kNaN) return i;
        if (trait != Trait::kNull) continue;
        if (is(role, {Role::kSpaceOrNone, Role::kVelocitiesOrNone, Role::kPointOrNone, Role::kTurnOrNone,
                      Role::kFrameOrNone, Role::kOptions, Role::kInverseOptions, Role::kDecomposition,
                      Role::kDecompositionReport, Role::kResult, Role::kOutputOrNone, Role::kBatchOptions,
                      Role::kBound, Role::kMask, Role::kOriginsOrNone}))
            continue;
        if (is(role, {Role::kPositions, Role::kPositionInOut}) && positions_ == 0) continue;
        if (role == Role::kOutput && value_of(Role::kCapacity) == 0) continue;
        return i;
    }
    return -1;
}

}  // namespace hostile
