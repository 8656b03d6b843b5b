// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// By zlib, without its header. A build without zlib1g-dev keeps the bytes as they are, in stored blocks of the same format (section 3.2.4).
#include "record/file/deflate.h"

#include <algorithm>
#include <new>

#ifdef EPODE_HAVE_ZLIB
#include <zlib.h>
#endif

namespace epode::record {

#ifdef EPODE_HAVE_ZLIB

namespace {

constexpr int kRawWindow = -15;  // 2^15 bytes, negative: no header
constexpr int kMemory = 9;
constexpr std::size_t kMargin = 64;                   // bytes, more than the marks of a flush take
constexpr std::size_t kPiece = std::size_t(1) << 30;  // zlib counts in unsigned int

// False: no memory.
bool deflate_all(z_stream& stream, std::span<const std::uint8_t> bytes, std::vector<std::uint8_t>& out)
{
    for (bool ended = false; !ended;) {
        const std::size_t piece = std::min(kPiece, bytes.size());
        stream.next_in = const_cast<std::uint8_t*>(bytes.data());
        stream.avail_in = uInt(piece);
        bytes = bytes.subspan(piece);
        const std::size_t end = out.size();
        out.resize(end + deflateBound(&stream, uLong(piece)) + kMargin);
        stream.next_out = out.data() + end, stream.avail_out = uInt(out.size() - end);
        const int result = deflate(&stream, bytes.empty() ? Z_FINISH : Z_FULL_FLUSH);
        out.erase(out.end() - std::ptrdiff_t(stream.avail_out), out.end());
        if (result != Z_OK && result != Z_STREAM_END) return false;
        ended = result == Z_STREAM_END;
    }
    return true;
}

}  // namespace

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes)
{
    z_stream stream{};
    std::vector<std::uint8_t> out;
    if (deflateInit2(&stream, Z_BEST_COMPRESSION, Z_DEFLATED, kRawWindow, kMemory, Z_DEFAULT_STRATEGY) !=
        Z_OK)
        throw std::bad_alloc();
    const bool good = deflate_all(stream, bytes, out);
    deflateEnd(&stream);
    if (!good) throw std::bad_alloc();
    return out;
}

#else

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes)
{
    constexpr std::size_t kBlock = 0xffff;
    std::vector<std::uint8_t> out;
    do {
        const std::size_t size = std::min(kBlock, bytes.size());
        const auto low = std::uint8_t(size & 0xff), high = std::uint8_t(size >> 8);
        const bool last = size == bytes.size();
        for (const int byte : {int(last), int(low), int(high), 0xff - low, 0xff - high})
            out.push_back(std::uint8_t(byte));
        out.insert(out.end(), bytes.begin(), bytes.begin() + std::ptrdiff_t(size));
        bytes = bytes.subspan(size);
    } while (!bytes.empty());
    return out;
}

#endif

}  // namespace epode::record
