// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See calls.h.
#include "record/file/calls.h"

#include <cmath>

namespace epode::record {

namespace {

void put(ByteWriter& out, const Argument& argument)
{
    out.u8(std::uint8_t(argument.kind));
    switch (argument.kind) {
        case ArgumentKind::kWorld:
            break;
        case ArgumentKind::kBody:
        case ArgumentKind::kJoint:
        case ArgumentKind::kGroup:
            out.i32(argument.handle);
            break;
        case ArgumentKind::kNumber:
            out.f64(argument.number);
            break;
        case ArgumentKind::kInteger:
            out.i32(argument.integer);
            break;
        case ArgumentKind::kNumbers:
            out.u32(std::uint32_t(argument.numbers.size()));
            out.f64s(argument.numbers);
            break;
    }
}

Argument get(ByteReader& in)
{
    const ArgumentKind kind = ArgumentKind(in.u8());
    switch (kind) {
        case ArgumentKind::kNumber:
            return Argument::of(in.f64());
        case ArgumentKind::kInteger:
            return Argument::of(in.i32());
        case ArgumentKind::kNumbers: {
            std::vector<double> numbers(in.count(8));
            in.f64s(numbers);
            return Argument::of(std::move(numbers));
        }
        case ArgumentKind::kBody:
        case ArgumentKind::kJoint:
        case ArgumentKind::kGroup:
            return Argument::of(kind, in.i32());
        default:
            return Argument::of(kind, -1);
    }
}

// The members of a surface that a bit of the mode asks for.
struct Optional {
    int bit;
    dReal dSurfaceParameters::*member;
};
constexpr Optional kOptional[] = {
    {dContactMu2, &dSurfaceParameters::mu2},          {dContactRolling, &dSurfaceParameters::rho},
    {dContactRolling, &dSurfaceParameters::rho2},     {dContactRolling, &dSurfaceParameters::rhoN},
    {dContactBounce, &dSurfaceParameters::bounce},    {dContactBounce, &dSurfaceParameters::bounce_vel},
    {dContactSoftERP, &dSurfaceParameters::soft_erp}, {dContactSoftCFM, &dSurfaceParameters::soft_cfm},
    {dContactMotion1, &dSurfaceParameters::motion1},  {dContactMotion2, &dSurfaceParameters::motion2},
    {dContactMotionN, &dSurfaceParameters::motionN},  {dContactSlip1, &dSurfaceParameters::slip1},
    {dContactSlip2, &dSurfaceParameters::slip2},
};

}  // namespace

void CallTape::add(const char* name, const std::vector<Argument>& arguments)
{
    const auto [known, is_new] = names_.try_emplace(name, std::uint32_t(names_.size()));
    if (is_new) block_.new_names.push_back(name);
    bytes_.u32(known->second);
    bytes_.u8(std::uint8_t(arguments.size()));
    for (const Argument& argument : arguments) put(bytes_, argument);
    ++block_.count;
}

CallBlock CallTape::take()
{
    block_.bytes = bytes_.bytes();
    bytes_.clear();
    CallBlock taken;
    std::swap(taken, block_);
    return taken;
}

bool next_call(ByteReader& in, Call& call)
{
    if (in.finished()) return false;
    call.name = in.u32();
    call.arguments.clear();
    for (size_t left = in.u8(); left > 0 && !in.failed(); --left) {
        call.arguments.push_back(get(in));
        if (call.arguments.back().kind > ArgumentKind::kLast) in.fail();
    }
    return !in.failed();
}

bool sound(const CallBlock& block, std::uint32_t names)
{
    ByteReader in(block.bytes.data(), block.bytes.size());
    Call call;
    std::uint32_t count = 0;
    while (next_call(in, call)) {
        if (call.name >= names) return false;
        ++count;
    }
    return in.finished() && count == block.count;
}

std::vector<double> numbers_of(const dMass& mass)
{
    std::vector<double> numbers{double(mass.mass)};
    for (int i = 0; i < 3; ++i) numbers.push_back(double(mass.c[i]));
    for (dReal value : mass.I) numbers.push_back(double(value));
    return numbers;
}

bool from_numbers(const std::vector<double>& numbers, dMass& mass)
{
    if (numbers.size() != 16) return false;
    mass = {};
    mass.mass = dReal(numbers[0]);
    for (size_t i = 0; i < 3; ++i) mass.c[i] = dReal(numbers[1 + i]);
    for (size_t i = 0; i < 12; ++i) mass.I[i] = dReal(numbers[4 + i]);
    return true;
}

// mode, mu, position, normal, depth, what the mode asks for, and friction's direction if it does.
std::vector<double> numbers_of(const dContact& contact)
{
    const dSurfaceParameters& surface = contact.surface;
    std::vector<double> numbers{double(surface.mode), double(surface.mu)};
    for (int i = 0; i < 3; ++i) numbers.push_back(double(contact.geom.pos[i]));
    for (int i = 0; i < 3; ++i) numbers.push_back(double(contact.geom.normal[i]));
    numbers.push_back(double(contact.geom.depth));
    for (const Optional& optional : kOptional) {
        if (surface.mode & optional.bit) numbers.push_back(double(surface.*optional.member));
    }
    for (int i = 0; i < 3 && (surface.mode & dContactFDir1); ++i) numbers.push_back(double(contact.fdir1[i]));
    return numbers;
}

bool from_numbers(const std::vector<double>& numbers, dContact& contact)
{
    contact = {};
    if (numbers.size() < 9 || !(std::abs(numbers[0]) < 1e9)) return false;
    dSurfaceParameters& surface = contact.surface;
    surface.mode = int(numbers[0]);
    surface.mu = dReal(numbers[1]);
    for (size_t i = 0; i < 3; ++i) contact.geom.pos[i] = dReal(numbers[2 + i]);
    for (size_t i = 0; i < 3; ++i) contact.geom.normal[i] = dReal(numbers[5 + i]);
    contact.geom.depth = dReal(numbers[8]);
    contact.geom.side1 = contact.geom.side2 = -1;
    size_t at = 9;
    const auto next = [&] { return at < numbers.size() ? dReal(numbers[at]) : dReal(0); };
    for (const Optional& optional : kOptional) {
        if (surface.mode & optional.bit) surface.*optional.member = next(), ++at;
    }
    for (size_t i = 0; i < 3 && (surface.mode & dContactFDir1); ++i) contact.fdir1[i] = next(), ++at;
    return at == numbers.size();
}

}  // namespace epode::record
