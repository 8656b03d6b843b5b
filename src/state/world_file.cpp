// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/world_file.h"

#include <cstdio>
#include <cstring>

#include "base/streams/checksum.h"
#include "base/streams/little_endian.h"

namespace epode {
namespace {

std::uint64_t sum_of(std::span<const std::byte> file, int version)
{
    const std::span<const std::byte> content = file.subspan(sizeof(WorldFileHeader));
    return version < 2 ? checksum_3(content.data(), content.size())
                       : checksum(content.data(), content.size());
}

// The header whose bytes in memory are those of a file, and the other way round.
WorldFileHeader little(const WorldFileHeader& h)
{
    using epode::little;
    return {little(h.magic),          little(h.version),    little(h.real_size),
            little(h.structure_size), little(h.state_size), little(h.checksum)};
}

}  // namespace

void seal_file(std::span<std::byte> file, std::size_t structure_end)
{
    WorldFileHeader header;
    header.structure_size = structure_end - sizeof header;
    header.state_size = file.size() - structure_end;
    header.checksum = sum_of(file, header.version);
    header = little(header);
    std::memcpy(file.data(), &header, sizeof header);
}

const char* read_file_header(std::span<const std::byte> file, WorldFileHeader& header, char* text,
                             std::size_t text_size)
{
    const auto wrong = [&](auto... parts) {
        std::snprintf(text, text_size, parts...);
        return static_cast<const char*>(text);
    };
    if (file.size() < sizeof header)
        return wrong("%zu bytes are no world: even its header has %zu", file.size(), sizeof header);
    std::memcpy(&header, file.data(), sizeof header);
    header = little(header);
    if (header.magic != WorldFileHeader::kMagic) return "these bytes are no world";
    if (header.version < 1 || header.version > WorldFileHeader::kVersion)
        return wrong("a world of version %d; this library reads versions up to %d", int(header.version),
                     int(WorldFileHeader::kVersion));
    if (header.real_size != sizeof(Real))
        return wrong("a world with numbers of %d bytes; those of this library have %zu",
                     int(header.real_size), sizeof(Real));
    const std::uint64_t content = file.size() - sizeof header;
    if (header.structure_size > content || header.state_size > content - header.structure_size)
        return wrong("a world of %llu and %llu bytes, of which %llu are given",
                     static_cast<unsigned long long>(header.structure_size),
                     static_cast<unsigned long long>(header.state_size),
                     static_cast<unsigned long long>(content));
    const std::size_t size = sizeof header + header.structure_size + header.state_size;
    if (header.checksum != sum_of(file.first(size), header.version))
        return "the checksum of the world is wrong: its bytes have changed";
    return nullptr;
}

}  // namespace epode
