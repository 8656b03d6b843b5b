// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

namespace hostile {
namespace {

constexpr int kNumbers[] = {0,     1,     2,     3,     4,     5,     6,     7,     8,     9,
                            10,    11,    12,    13,    0x100, 0x101, 0x102, 0x105, 0x107, 0x108,
                            0x109, 0x10a, 0x200, 0x201, 0x202, 0x205, 0x207, 0x208, 0x209, 0x20a};
constexpr int kIndices[] = {0, 1, 2};
constexpr int kNone[] = {0};

// What readers write into: the reals of one argument, or of three arguments.
constexpr int kMaxReals = sizeof(dMass) / sizeof(dReal);
constexpr int kArguments = 6;
dReal g_reals[3][kMaxReals];
int g_integers[3];

void mix(std::uint64_t& hash, std::uint64_t word)
{
    hash = (hash ^ word) * 0x100000001b3u;
    hash ^= hash >> 29;
}

bool contains(const char* text, const char* part) { return std::strstr(text, part) != nullptr; }

// A name that ends as one of a body's or geom's readings of motion.
bool is_motion(const char* name)
{
    if (contains(name, "Joint") || contains(name, "Offset") || contains(name, "Damping")) return false;
    for (const char* part : {"GetPosition", "GetRotation", "GetQuaternion", "CopyPosition", "CopyRotation",
                             "CopyQuaternion", "GetLinearVel", "GetAngularVel", "GetForce", "GetTorque"})
        if (contains(name, part)) return true;
    return false;
}

// How many reals stand behind the pointer that a reader answers.
int reals_behind(const char* name)
{
    if (contains(name, "GetLastTransform")) return 16;
    if (!contains(name, "GetOffset") && !is_motion(name)) return 0;
    if (contains(name, "Copy")) return 0;
    return contains(name, "Rotation") ? 12 : contains(name, "Quaternion") ? 4 : 3;
}

// How many reals one of its arguments can hold.
int reals_of(Kind kind)
{
    switch (kind) {
        case Kind::kVector3:
            return 3;
        case Kind::kVector4:
        case Kind::kQuaternion:
            return 4;
        case Kind::kVector6:
            return 6;
        case Kind::kMatrix3:
            return 12;
        case Kind::kMass:
            return kMaxReals;
        case Kind::kRealPointer:
            return 1;
        default:
            return 0;
    }
}

std::span<const int> numbers_for(const Function& f)
{
    for (const Parameter& p : f.all()) {
        if (p.kind == Kind::kParameterNumber) return kNumbers;
        if (p.kind == Kind::kInt) return kIndices;
    }
    return kNone;
}

// Adds a real; false when it is not as it should be.
bool mix_real(std::uint64_t& hash, double x, bool finite)
{
    mix(hash, std::bit_cast<std::uint64_t>(x));
    return finite ? std::isfinite(x) : !std::isnan(x);
}

}  // namespace

void State::learn()
{
    readings_.clear();
    for (const Function& f : functions())
        if (f.flags & kReader) learn(f);
}

void State::learn(const Function& f)
{
    const std::size_t objects = f.count > 0 ? scene_.live[std::size_t(f.parameters[0].kind)].size() : 1;
    Reading r = {&f, 0, 0, reals_behind(f.name), 0, is_motion(f.name)};
    for (const Parameter& p : f.all()) r.written = std::max(r.written, reals_of(p.kind));
    bool first = true;
    for (r.object = 0; r.object < int(objects); ++r.object) {
        // All numbers of the first object that takes the function; a few of the others.
        const auto numbers = numbers_for(f);
        bool taken = false;
        for (int number : first ? numbers : numbers.first(std::min<std::size_t>(numbers.size(), 3))) {
            r.number = number;
            std::uint64_t hash = 0;
            bool healthy = true;
            if (take(r, hash, healthy)) {
                readings_.push_back(r);
                taken = true;
            }
        }
        first = first && !taken;
    }
}

// False when the reader refused.
bool State::take(const Reading& r, std::uint64_t& hash, bool& healthy) const
{
    Value arguments[kArguments];
    const auto parameters = r.function->all();
    for (auto& reals : g_reals) std::fill_n(reals, r.written, dReal(0));
    for (int& integer : g_integers) integer = 0;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const Kind kind = parameters[i].kind;
        if (is_handle(kind))
            arguments[i].pointer = scene_.live[std::size_t(kind)][std::size_t(r.object)];
        else if (kind == Kind::kInt || kind == Kind::kParameterNumber)
            arguments[i].integer = r.number;
        else if (kind == Kind::kIntPointer)
            arguments[i].pointer = &g_integers[i % 3];
        else
            arguments[i].pointer = g_reals[i % 3];
    }
    const int before = messages().refusals;
    const Result result = r.function->call(arguments);
    if (messages().refusals != before) return false;
    if (result.type == Result::Type::kReal)
        healthy = mix_real(hash, result.real, r.finite) && healthy;
    else
        mix(hash,
            std::uint64_t(result.integer) ^ std::uint64_t(reinterpret_cast<std::uintptr_t>(result.pointer)));
    const auto* values = static_cast<const dReal*>(result.pointer);
    for (int i = 0; values && i < r.reals; ++i) healthy = mix_real(hash, values[i], r.finite) && healthy;
    for (int i = 0; i < r.written; ++i)
        for (const auto& reals : g_reals) healthy = mix_real(hash, reals[i], r.finite) && healthy;
    for (int integer : g_integers) mix(hash, unsigned(integer));
    return true;
}

std::uint64_t State::hash(std::string* fault)
{
    const Messages kept = messages();
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const Reading& r : readings_) {
        bool healthy = true;
        if (!take(r, hash, healthy)) mix(hash, 0x5eed);
        if (!healthy && fault && fault->empty())
            *fault = std::string(r.function->name) + " of object " + std::to_string(r.object) + ", number " +
                     std::to_string(r.number);
    }
    messages() = kept;
    return hash;
}

}  // namespace hostile
