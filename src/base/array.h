// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A growable array of trivially copyable elements over the library's memory hooks. Growing reports failure by
// its return value, which std::vector can do only by an exception.
#pragma once

#include <cstring>
#include <span>
#include <type_traits>
#include <utility>

#include "base/check.h"
#include "base/memory.h"

namespace epode {

template <typename T>
class Array {
    static_assert(std::is_trivially_copyable_v<T>);

  public:
    Array() = default;
    Array(const Array&) = delete;
    Array& operator=(const Array&) = delete;
    Array(Array&& other) noexcept { swap(other); }
    Array& operator=(Array&& other) noexcept
    {
        swap(other);
        return *this;
    }
    ~Array() { reset(); }

    int size() const { return size_; }
    int capacity() const { return capacity_; }
    bool empty() const { return size_ == 0; }
    T* data() { return data_; }
    const T* data() const { return data_; }
    T* begin() { return data_; }
    T* end() { return data_ + size_; }
    const T* begin() const { return data_; }
    const T* end() const { return data_ + size_; }
    T& operator[](int i)
    {
        EPODE_ASSERT(i >= 0 && i < size_);
        return data_[i];
    }
    const T& operator[](int i) const
    {
        EPODE_ASSERT(i >= 0 && i < size_);
        return data_[i];
    }
    T& back() { return (*this)[size_ - 1]; }
    std::span<T> span() { return {data_, std::size_t(size_)}; }
    std::span<const T> span() const { return {data_, std::size_t(size_)}; }

    // False when memory is exhausted; the array is then unchanged.
    [[nodiscard]] bool reserve(int capacity)
    {
        if (capacity <= capacity_) return true;
        T* grown = static_cast<T*>(allocate(sizeof(T) * std::size_t(capacity)));
        if (!grown) return false;
        if (size_) std::memcpy(static_cast<void*>(grown), data_, sizeof(T) * std::size_t(size_));
        release(data_, sizeof(T) * std::size_t(capacity_));
        data_ = grown;
        capacity_ = capacity;
        return true;
    }

    // New elements are zero bytes.
    [[nodiscard]] bool resize(int size)
    {
        if (!reserve(size)) return false;
        if (size > size_)
            std::memset(static_cast<void*>(data_ + size_), 0, sizeof(T) * std::size_t(size - size_));
        size_ = size;
        return true;
    }

    [[nodiscard]] bool push(const T& value)
    {
        if (size_ == capacity_) {
            const T copy = value;  // `value` may live in the block that is about to move
            if (!reserve(capacity_ < 8 ? 8 : capacity_ + capacity_ / 2)) return false;
            data_[size_++] = copy;
            return true;
        }
        data_[size_++] = value;
        return true;
    }

    // Appends `more` uninitialised elements.
    [[nodiscard]] bool extend(int more)
    {
        if (size_ + more > capacity_ && !reserve(size_ + more + capacity_ / 2)) return false;
        size_ += more;
        return true;
    }

    void pop() { --size_; }
    void clear() { size_ = 0; }
    void truncate(int size) { size_ = size; }
    void remove_swap(int i)
    {
        data_[i] = data_[size_ - 1];
        --size_;
    }
    void reset()
    {
        release(data_, sizeof(T) * std::size_t(capacity_));
        data_ = nullptr;
        size_ = capacity_ = 0;
    }
    void swap(Array& other) noexcept
    {
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
        std::swap(capacity_, other.capacity_);
    }

  private:
    T* data_ = nullptr;
    int size_ = 0;
    int capacity_ = 0;
};

}  // namespace epode
