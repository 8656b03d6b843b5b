// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/state_header.h"

#include <cstdio>
#include <cstring>

#include "base/streams/checksum.h"
#include "base/streams/little_endian.h"

namespace epode {
namespace {

std::uint64_t sum_of(const void* state, std::size_t size, int version)
{
    const void* const content = static_cast<const char*>(state) + sizeof(StateHeader);
    const std::size_t length = size - sizeof(StateHeader);
    return version < 4 ? checksum_3(content, length) : checksum(content, length);
}

StateHeader header_of(std::size_t size, StateHeader::Kind kind)
{
    StateHeader header;
    header.kind = kind, header.size = size;
    return header;
}

const char* precision(int real_size) { return real_size == sizeof(double) ? "double" : "single"; }

}  // namespace

StateHeader little(StateHeader h)
{
    return {little(h.magic), little(h.version), h.real_size, h.kind, little(h.size), little(h.checksum)};
}

void seal(void* state, std::size_t size, StateHeader::Kind kind, Seal with)
{
    StateHeader header = header_of(size, kind);
    if (with == Seal::kSealed) header.checksum = sum_of(state, size, header.version);
    header = little(header);
    std::memcpy(state, &header, sizeof header);
}

void copy_sealed(void* to, std::span<const std::byte> state)
{
    StateHeader header = header_of(state.size(), StateHeader::kWhole);
    const std::span<const std::byte> content = state.subspan(sizeof header);
    header.checksum =
        copy_and_sum(static_cast<std::byte*>(to) + sizeof header, content.data(), content.size());
    header = little(header);
    std::memcpy(to, &header, sizeof header);
}

const char* read_header(const void* state, std::size_t size, StateHeader::Kind kind, StateHeader& header,
                        char* text, std::size_t text_size, Seal with)
{
    const auto wrong = [&](auto... parts) {
        std::snprintf(text, text_size, parts...);
        return static_cast<const char*>(text);
    };
    if (size < sizeof header)
        return wrong("%zu bytes are no state: even its header has %zu", size, sizeof header);
    std::memcpy(&header, state, sizeof header);
    header = little(header);
    if (header.magic != StateHeader::kMagic) return "these bytes are no state of a world";
    if (header.version < StateHeader::kOldest || header.version > StateHeader::kVersion)
        return wrong("a state of version %d; this library reads versions %d to %d", int(header.version),
                     int(StateHeader::kOldest), int(StateHeader::kVersion));
    if (header.real_size != sizeof(Real))
        return wrong("a state of %s precision; this library has %s", precision(header.real_size),
                     precision(sizeof(Real)));
    if (header.kind != kind)
        return kind == StateHeader::kWhole ? "a difference between states, where a whole one is wanted"
                                           : "a whole state, where a difference is wanted";
    if (header.size > size || header.size < sizeof header || header.size % 4 != 0)
        return wrong("a state of %llu bytes, of which %zu are given",
                     static_cast<unsigned long long>(header.size), size);
    if (with == Seal::kSealed && header.checksum != sum_of(state, std::size_t(header.size), header.version))
        return "the checksum of the state is wrong: its bytes have changed";
    return nullptr;
}

}  // namespace epode
