// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Little-endian bytes, written and read value by value, so that a file is the same whatever the machine. The
// reader never leaves its range: past the end it yields zeros and remembers that it failed, and a count is
// believed only if the bytes that it promises are there, so that a broken count cannot ask for memory.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace epode::record {

class ByteWriter {
  public:
    void u8(std::uint8_t value) { bytes_.push_back(value); }
    void u32(std::uint32_t value) { put(value, 4); }
    void u64(std::uint64_t value) { put(value, 8); }
    void i32(std::int32_t value) { u32(std::uint32_t(value)); }
    void f32(float value) { u32(std::bit_cast<std::uint32_t>(value)); }
    void f64(double value) { u64(std::bit_cast<std::uint64_t>(value)); }
    void text(const std::string& value)
    {
        u32(std::uint32_t(value.size()));
        bytes_.insert(bytes_.end(), value.begin(), value.end());
    }
    template <class Values>
    void f64s(const Values& values)
    {
        for (double value : values) f64(value);
    }
    void append(const std::vector<std::uint8_t>& more)
    {
        bytes_.insert(bytes_.end(), more.begin(), more.end());
    }
    const std::vector<std::uint8_t>& bytes() const { return bytes_; }
    void clear() { bytes_.clear(); }

  private:
    void put(std::uint64_t value, int count)
    {
        const size_t at = bytes_.size();
        bytes_.resize(at + size_t(count));
        for (int i = 0; i < count; ++i) bytes_[at + size_t(i)] = std::uint8_t(value >> (8 * i));
    }
    std::vector<std::uint8_t> bytes_;
};

class ByteReader {
  public:
    ByteReader(const std::uint8_t* bytes, size_t size) : at_(bytes), left_(size) {}

    std::uint8_t u8() { return std::uint8_t(get(1)); }
    std::uint32_t u32() { return std::uint32_t(get(4)); }
    std::uint64_t u64() { return get(8); }
    std::int32_t i32() { return std::int32_t(u32()); }
    float f32() { return std::bit_cast<float>(u32()); }
    double f64() { return std::bit_cast<double>(u64()); }
    std::string text()
    {
        const size_t size = count(1);
        std::string value(reinterpret_cast<const char*>(at_), size);
        at_ += size;
        left_ -= size;
        return value;
    }
    template <class Values>
    void f64s(Values& values)
    {
        for (double& value : values) value = f64();
    }
    // How many elements of at least `bytes_each` bytes follow; 0 and failed where so many cannot.
    size_t count(size_t bytes_each)
    {
        const std::uint32_t said = u32();
        if (failed_ || said > left_ / bytes_each) {
            failed_ = true;
            return 0;
        }
        return said;
    }
    // All that is left.
    std::vector<std::uint8_t> rest()
    {
        std::vector<std::uint8_t> bytes(at_, at_ + left_);
        at_ += left_;
        left_ = 0;
        return bytes;
    }
    // What was read makes no sense.
    void fail() { failed_ = true; }
    bool failed() const { return failed_; }
    // Everything was read and nothing is left over.
    bool finished() const { return !failed_ && left_ == 0; }

  private:
    std::uint64_t get(size_t count)
    {
        if (left_ < count) {
            failed_ = true;
            left_ = 0;
            return 0;
        }
        std::uint64_t value = 0;
        for (size_t i = 0; i < count; ++i) value |= std::uint64_t(at_[i]) << (8 * i);
        at_ += count;
        left_ -= count;
        return value;
    }
    const std::uint8_t* at_;
    size_t left_;
    bool failed_ = false;
};

}  // namespace epode::record
