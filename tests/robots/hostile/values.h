// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Values of each role, mostly sensible ones. What pointers point to lies in blocks of exactly the size that the interface states, so
// that a sanitizer sees every access beyond.
#pragma once

#include <cstdint>
#include <memory>

#include "scene.h"
#include "table.h"

namespace hostile {

class Values {
  public:
    Values(const Scene& scene, std::uint64_t seed) : scene_(scene), seed_(seed) {}

    // Fills the arguments of a call. One in `often` is hostile.
    void choose(const RobotFunction& function, Value* arguments, int often);
    // The argument for whose value the call must be refused, or -1.
    int must_refuse(const RobotFunction& function, const Value* arguments) const;
    // Whether an output is as it was given.
    bool is_untouched(int argument) const;
    // Whether no real that was written to it is NaN.
    bool is_number(int argument) const;
    std::uint64_t random();
    int below(int n) { return int(random() % std::uint64_t(n)); }

  private:
    struct Block {
        std::unique_ptr<char[]> data;
        std::size_t size = 0;
    };
    Value choose(const RobotFunction& function, int argument, bool hostile);
    Value handle(const std::vector<void*>& live, void* dead, bool hostile);
    Value integer(long long good, std::initializer_list<std::pair<long long, Trait>> bad, bool hostile);
    Value real(std::initializer_list<std::pair<double, Trait>> bad, bool hostile);
    Value reals(int argument, int count, bool hostile);
    Value frame(int argument, int first_of_turn, int count, bool hostile);
    Value text(int argument, std::initializer_list<std::string> all, bool hostile);
    Value options(int argument, bool hostile);
    Value targets(int argument, bool hostile);
    Value inverse_options(int argument, bool hostile);
    Value camera(int argument, bool hostile);
    Value triangles(int argument, bool hostile);
    Value decomposition(int argument, bool hostile);
    Value batch_options(int argument, bool hostile);
    Value copy_values(int argument, bool hostile);
    Value sized(int argument, unsigned struct_size, std::size_t size, bool hostile);
    Value output(int argument, std::size_t size, bool hostile);
    Value block(int argument, const void* content, std::size_t size);
    template <typename Type>
    Value structure(int argument, const Type& content, Trait trait)
    {
        Value v = block(argument, &content, sizeof content);
        v.trait = trait;
        return v;
    }
    void measure(const RobotFunction& function, const Value& first);

    const Scene& scene_;
    std::uint64_t seed_;
    Block blocks_[kMaxArguments], inner_[2];
    int positions_ = 0, velocities_ = 0;  // of the object that the call is about
    std::size_t text_size_ = 0;
};

}  // namespace hostile
