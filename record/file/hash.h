// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The hash of a state. Let w_1 ... w_n be the 64-bit patterns (IEEE 754 double) of position x y z, quaternion
// w x y z, linear velocity x y z, angular velocity x y z of every living body, bodies in order of number; a
// state in floats is widened first. Then
//     h_0 = 14695981039346656037,   h_i = m(h_(i-1) xor w_i),   m(x) = y xor (y >> 32),  y = 1099511628211 x
//     mod 2^64.
// It is FNV-1a (Fowler, Noll, Vo) over words instead of bytes, with the upper half folded down so that the
// high bits of a double reach every bit. Two states of one hash that differ are not a concern of chance: each
// step of m is a bijection, so a single changed word always changes the hash.
#pragma once

#include <cstdint>
#include <vector>

#include "record/file/recording.h"

namespace epode::record {

std::uint64_t hash_states(const std::vector<BodyState>& bodies);
// 16 hexadecimal digits.
std::string as_text(std::uint64_t hash);

}  // namespace epode::record
