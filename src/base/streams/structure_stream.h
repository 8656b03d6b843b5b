// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Writes what a world is made of to bytes, and builds it from them again: the structure of clones and files
// (state/world_structure). Each part visits its own numbers in one function for both directions, as for
// states (base/streams/state_stream.h). Sizes are not known before: what is saved goes to an array that grows. What is
// loaded becomes objects that nobody uses yet, and is stored while it is read. The first fault is kept, in
// words, and nothing is read after it.
// A clone shares what is of the process (meshes, functions, user data): its bytes hold pointers and never
// leave the process. Numbers are little endian (base/streams/little_endian.h).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>

#include "base/array.h"
#include "base/streams/first_fault.h"
#include "base/streams/little_endian.h"

namespace epode {

class StructureStream : public FirstFault {
  public:
    enum class Use { kFile, kClone };

    StructureStream(Array<std::byte>& to, Use use) : to_(&to), use_(use) {}
    StructureStream(std::span<const std::byte> from, Use use) : from_(from), use_(use) {}

    bool saves() const { return to_ != nullptr; }
    bool loads() const { return !saves(); }
    bool is_clone() const { return use_ == Use::kClone; }
    // Of the file that is loaded (state/world_file.h).
    bool is_older_than(int version) const { return version_ < version; }
    void set_version(int version) { version_ = version; }

    // Bytes that are left to be loaded.
    std::size_t left() const { return from_.size(); }

    // Whole numbers and single bytes of any value.
    template <typename T>
    void number(T& value)
    {
        numbers(&value, 1);
    }
    // At least `low` and less than `end`.
    template <typename T>
    void number(T& value, T low, T end, const char* text)
    {
        numbers(&value, 1);
        if (loads() && !(value >= low && value < end)) fail("%s", text), value = low;
    }
    // A count of what follows, each at least `size` bytes long.
    int count(int value, std::size_t size, const char* text);
    void flag(bool& value)
    {
        std::uint8_t byte = value;
        number(byte, std::uint8_t(0), std::uint8_t(2), "a switch in it is neither on nor off");
        value = byte != 0;
    }
    // Each at least `low`: finite, or with kInfinite any but NaN.
    enum Range { kFinite, kInfinite };
    void reals(Real* values, int count, Range range = kFinite, Real low = -kInf);
    void real(Real& value, Range range = kFinite, Real low = -kInf) { reals(&value, 1, range, low); }
    template <typename Vector>  // Vec3
    void vector(Vector& v)
    {
        reals(&v.x, 3);
    }
    template <typename Quaternion>  // Quat
    void quaternion(Quaternion& q)
    {
        reals(&q.w, 4);
    }
    // What a program has given and the interface limits to usable numbers, which may not be negative.
    void sizes(Real* values, int count);

    // A pointer of the process, in clones alone: in files it is null.
    template <typename T>
    void pointer(T*& p)
    {
        if (is_clone())
            bytes(&p, sizeof p);
        else if (loads())
            p = nullptr;
    }

    // As many numbers, whatever they are.
    template <typename T>
    void numbers(T* values, std::size_t count)
    {
        static_assert(std::is_arithmetic_v<T> || std::is_enum_v<T>);
        if constexpr (std::endian::native == std::endian::little) return bytes(values, sizeof(T) * count);
        for (std::size_t i = 0; i < count; ++i) {
            T value = saves() ? little(values[i]) : T{};
            bytes(&value, sizeof value);
            if (loads()) values[i] = little(value);
        }
    }

    // As many bytes, whatever they are.
    void bytes(void* values, std::size_t size)
    {
        if (size == 0) return;  // `values` may be null
        if (saves()) return write(values, size);
        if (from_.size() < size || failed()) [[unlikely]] {
            fail("it ends too early");
            std::memset(values, 0, size);
            return;
        }
        std::memcpy(values, from_.data(), size);
        from_ = from_.subspan(size);
    }

  private:
    void write(const void* values, std::size_t size)
    {
        const std::size_t end = std::size_t(to_->size()) + size;
        if (end > std::size_t(to_->capacity()) && !grow(end)) return;
        std::memcpy(to_->data() + to_->size(), values, size);
        (void)to_->extend(int(size));
    }
    bool grow(std::size_t size);

    Array<std::byte>* to_ = nullptr;
    std::span<const std::byte> from_;
    Use use_;
    int version_ = std::numeric_limits<int>::max();  // what this library writes
};

}  // namespace epode
