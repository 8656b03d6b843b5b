// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Calls of ODE's interface as a recording keeps them, so that a world can be built and stepped again
// (rerun.h): the name, and every argument with its kind. Handles are numbers, each kind's own, counted in the
// order in which the calls made them (groups: in which they were first named), -1 for none. Arrays (vectors,
// a dMass, a dContact) are their numbers one after the other. A block has the calls between two states; a
// name is spelled once and numbered from then on.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "record/file/bytes.h"

namespace epode::record {

// Substeps of dWorldStepFast1 where a program that calls another stepper is to use this one.
constexpr int kFastSteps = 4;

enum class ArgumentKind : std::uint8_t {
    kWorld,
    kBody,
    kJoint,
    kGroup,
    kNumber,
    kInteger,
    kNumbers,
    kLast = kNumbers
};

struct Argument {
    ArgumentKind kind = ArgumentKind::kWorld;
    std::int32_t handle = -1;
    double number = 0;
    std::int32_t integer = 0;
    std::vector<double> numbers;  // empty: a null pointer

    static Argument world() { return {}; }
    static Argument of(ArgumentKind kind, std::int32_t handle) { return {kind, handle, 0, 0, {}}; }
    static Argument of(double number) { return {ArgumentKind::kNumber, -1, number, 0, {}}; }
    static Argument of(std::int32_t integer) { return {ArgumentKind::kInteger, -1, 0, integer, {}}; }
    static Argument of(std::vector<double> n) { return {ArgumentKind::kNumbers, -1, 0, 0, std::move(n)}; }
};

struct Call {
    std::uint32_t name = 0;
    std::vector<Argument> arguments;
};

struct CallBlock {
    std::vector<std::string> new_names;  // numbered on from those of the blocks before
    std::uint32_t count = 0;
    std::vector<std::uint8_t> bytes;
};

// Collects calls until a block of them is taken.
class CallTape {
  public:
    void add(const char* name, const std::vector<Argument>& arguments);
    bool empty() const { return block_.count == 0; }
    CallBlock take();

  private:
    std::map<std::string, std::uint32_t> names_;
    ByteWriter bytes_;
    CallBlock block_;
};

// The next call of a block; false at its end, and where the bytes are none (in.failed()).
bool next_call(ByteReader& in, Call& call);
// The bytes are as many calls as the block says, of names below `names`.
bool sound(const CallBlock& block, std::uint32_t names);

// What counts of a dMass and of a dContact, whose unused members may be anything.
std::vector<double> numbers_of(const dMass& mass);
std::vector<double> numbers_of(const dContact& contact);
// False where they are not such a thing.
bool from_numbers(const std::vector<double>& numbers, dMass& mass);
bool from_numbers(const std::vector<double>& numbers, dContact& contact);

}  // namespace epode::record
