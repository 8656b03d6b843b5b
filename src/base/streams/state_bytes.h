// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A block of bytes that grows, over the library's memory hooks. Plain data, so that arrays may hold blocks:
// whoever has one releases it.
#pragma once

#include <cstddef>
#include <span>

namespace epode {

struct StateBytes {
    std::byte* data = nullptr;
    std::size_t size = 0, capacity = 0;

    // Keeps the content. False when memory is exhausted or the size would exceed what lists can count; the
    // block is then unchanged.
    [[nodiscard]] bool reserve(std::size_t wanted);
    void release();
    std::span<const std::byte> span() const { return {data, size}; }
};

}  // namespace epode
