// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The reader of recordings on any bytes, whose chunks get the right checksums.
#include "record/file/recording.h"

#include <sanitizer/allocator_interface.h>

#include "../record/sample.h"
#include "meter.h"
#include "record/file/format.h"
#include "record/file/reader.h"
#include "seal.h"

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

// All memory of the process passes the meter from now on.
void meter_process()
{
    __sanitizer_install_malloc_and_free_hooks(
        [](const volatile void*, std::size_t size) { Meter::took(size); },
        [](const volatile void* block) {
            if (block) Meter::gave(__sanitizer_get_allocated_size(block));
        });
}

bool make_seed()
{
    meter_process();
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
