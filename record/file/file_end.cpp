// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See file_end.h. Only heads of chunks are read, and the first payload: a file that was written from front to
// back is whole up to the last chunk that fits.
#include "record/file/file_end.h"

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "record/file/bytes.h"
#include "record/file/format.h"
#include "record/file/reader.h"

namespace epode::record {

namespace {

using File = std::unique_ptr<std::FILE, int (*)(std::FILE*)>;
constexpr std::uint64_t kMostInfo = 1 << 20;  // bytes

bool fail(std::string& problem, const char* why = nullptr)
{
    problem = why ? why : std::strerror(errno);
    return false;
}

bool read_at(std::FILE* file, std::uint64_t at, std::uint8_t* bytes, size_t count)
{
    return fseeko(file, off_t(at), SEEK_SET) == 0 && std::fread(bytes, 1, count, file) == count;
}

void read_info(std::FILE* file, std::uint64_t at, std::uint64_t size, Info& about)
{
    std::vector<std::uint8_t> payload(size);
    if (size > kMostInfo || !read_at(file, at, payload.data(), size)) return;
    ByteReader in(payload.data(), payload.size());
    for (size_t left = in.count(8); left > 0; --left) {
        const std::string key = in.text();
        about[key] = in.text();
    }
}

// The chunk at end.size, if all of it is there.
bool next_chunk(std::FILE* file, std::uint64_t size, FileEnd& end)
{
    const std::uint64_t at = end.size, left = size - at;
    std::uint8_t bytes[kChunkHead];
    if (left < kChunkHead + kChunkTail || !read_at(file, at, bytes, kChunkHead)) return false;
    ByteReader head(bytes, kChunkHead);
    const std::uint32_t tag = head.u32();
    const std::uint64_t length = head.u64();
    if (head.u32() != crc32(bytes, kChunkHead - 4) || length > left - kChunkHead - kChunkTail) return false;
    if (tag == kInfoTag && length <= kMostInfo) read_info(file, at + kChunkHead, length, end.about);
    end.states += tag == kStepTag;
    end.complete = tag == kDoneTag;
    end.size += kChunkHead + length + kChunkTail;
    return !end.complete;
}

std::vector<std::uint8_t> done_chunk(std::uint64_t states)
{
    ByteWriter out;
    out.u32(kDoneTag);
    out.u64(8);
    out.u32(crc32(out.bytes().data(), out.bytes().size()));
    out.u64(states);
    out.u32(crc32(out.bytes().data(), out.bytes().size()));
    return out.bytes();
}

}  // namespace

bool find_end(const std::string& path, FileEnd& end, std::string& problem)
{
    const File file(std::fopen(path.c_str(), "rb"), std::fclose);
    struct stat status;
    if (!file || fstat(fileno(file.get()), &status) != 0) return fail(problem);
    std::uint8_t head[kFileHead];
    if (!read_at(file.get(), 0, head, kFileHead) || std::memcmp(head, kMark, sizeof kMark) != 0)
        return fail(problem, "this is not a recording of epode");
    end = {};
    end.size = kFileHead;
    while (next_chunk(file.get(), std::uint64_t(status.st_size), end)) {}
    return true;
}

bool complete_file(const std::string& path, const FileEnd& end, std::string& problem)
{
    if (truncate(path.c_str(), off_t(end.size)) != 0) return fail(problem);
    const File file(std::fopen(path.c_str(), "ab"), std::fclose);
    const auto bytes = done_chunk(end.states);
    const bool written = file && std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
    return (written && std::fflush(file.get()) == 0) || fail(problem);
}

}  // namespace epode::record
