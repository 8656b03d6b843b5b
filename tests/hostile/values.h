// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The values of each kind of parameter, sensible ones first. What pointers point to lies in blocks of exactly
// the size that the interface states, one per position in the argument list, so that a sanitizer sees every
// access beyond; blocks are filled again for each call and remember with what.
#pragma once

#include <map>
#include <memory>
#include <utility>

#include "scene.h"

namespace hostile {

class Values {
  public:
    explicit Values(const Scene& scene) : scene_(scene) {}

    int count(Kind kind);
    Value get(Kind kind, int index, int position);
    Trait trait(Kind kind, int index);

    // Whether the block that the value points to, if it is one of ours, is as it was filled.
    bool untouched(Kind kind, int position, const Value& value) const;

  private:
    struct Block {
        std::unique_ptr<char[]> data;
        std::size_t size = 0;
        std::unique_ptr<char[]> filled;
    };
    Value handle(Kind kind, int index) const;
    Value memory(Kind kind, int index, int position);
    void* fill(Kind kind, int position, const void* content, std::size_t size);

    const Scene& scene_;
    std::map<std::pair<int, int>, Block> blocks_;
};

// What a printed call calls the handles.
const char* name_of(Kind kind);

}  // namespace hostile
