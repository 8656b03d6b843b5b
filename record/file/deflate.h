// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bytes in fewer bytes, as every browser and zlib read them: the format of RFC 1951, without a header.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace epode::record {

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes);

}  // namespace epode::record
