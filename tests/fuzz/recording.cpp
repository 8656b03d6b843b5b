// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The reader of recordings on any bytes, whose chunks get the right checksums.
#include "record/file/recording.h"

#include <malloc.h>

#include <new>

#include "../record/sample.h"
#include "meter.h"
#include "record/file/format.h"
#include "record/file/reader.h"
#include "seal.h"

void* operator new(std::size_t size)
{
    void* const block = std::malloc(size);
    if (!block) throw std::bad_alloc();
    epode::fuzz::Meter::took(malloc_usable_size(block));
    return block;
}
void operator delete(void* block) noexcept
{
    if (block) epode::fuzz::Meter::gave(malloc_usable_size(block));
    std::free(block);
}
void operator delete(void* block, std::size_t) noexcept { operator delete(block); }

namespace {

using namespace epode::fuzz;
using namespace epode::record;

void seal(Bytes& file)
{
    std::size_t at = kFileHead;
    while (file.size() >= at + kChunkHead + kChunkTail) {
        std::uint64_t length;
        std::memcpy(&length, &file[at + 4], 8);
        if (length > file.size() - at - kChunkHead - kChunkTail) return;
        put(file, at + kChunkHead - 4, crc32(&file[at], kChunkHead - 4));
        const std::size_t checked = kChunkHead + std::size_t(length);
        put(file, at + checked, crc32(&file[at], checked));
        at += checked + kChunkTail;
    }
}

bool make_seed()
{
    keep_seed("sample", 0, bytes_of(sample_recording()));
    return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const bool ready = make_seed();
    (void)ready;
    Bytes file(data, data + size);
    seal(file);
    Recording recording;
    const Meter meter(size);
    (void)read_bytes(file.data(), file.size(), recording);
    return 0;
}
