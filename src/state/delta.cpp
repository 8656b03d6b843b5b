// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/delta.h"

#include <algorithm>
#include <bit>
#include <climits>

#include "base/hash.h"
#include "base/streams/little_endian.h"
#include "state/state_header.h"

namespace epode {
namespace {

constexpr int kWindow = 8;  // words that must agree to find a place: few, and equal objects are confused
// Farther away in the base the same eight words may be those of another object, and what lies between is lost.
constexpr int kFar = 512, kFarWindow = 32;
constexpr int kPatience = 16;  // differing words before a place is searched for

// Follows the header.
struct Frame {
    std::uint64_t base_checksum;
    std::uint64_t words;  // of the state
};
constexpr int kFrameEnd = int(sizeof(StateHeader) + sizeof(Frame)) / 4;

class Words {
  public:
    explicit Words(std::span<const std::byte> bytes) : bytes_(bytes) {}
    int count() const { return int(bytes_.size() / 4); }
    std::uint32_t operator[](int i) const { return get_little<std::uint32_t>(bytes_.data(), std::size_t(i)); }
    bool has_window(int i) const { return i + kWindow <= count(); }
    std::size_t hash(int i) const
    {
        const auto pair = [&](int k) { return std::uint64_t((*this)[i + k]) << 32 | (*this)[i + k + 1]; };
        return hash_of(pair(0) ^ std::rotl(pair(4), 21), pair(2) ^ std::rotl(pair(6), 42));
    }

  private:
    std::span<const std::byte> bytes_;
};

// The number of equal words from here on.
int alike(const Words& a, int i, const Words& b, int j)
{
    int count = 0;
    while (i + count < a.count() && j + count < b.count() && a[i + count] == b[j + count]) ++count;
    return count;
}

// The first place of each window of the base; the table is built at the first search.
class Places {
  public:
    explicit Places(const Words& base) : base_(base) {}

    // -1: nowhere from `from` on, -2: out of memory.
    int find(const Words& in, int at, int from)
    {
        if (!in.has_window(at)) return -1;
        if (table_.empty() && !make()) return -2;
        for (std::size_t slot = in.hash(at) & mask(); table_.data()[slot] >= 0; slot = (slot + 1) & mask()) {
            const int place = table_.data()[slot];
            if (place >= from && alike(base_, place, in, at) >= (place - from < kFar ? kWindow : kFarWindow))
                return place;
            if (++tries_ % kTries == 0) return -1;
        }
        return -1;
    }

  private:
    static constexpr unsigned kTries = 16;

    std::size_t mask() const { return std::size_t(table_.size() - 1); }
    bool make()
    {
        if (!table_.resize(int(std::bit_ceil(unsigned(2 * base_.count() + 16))))) return false;
        std::fill(table_.begin(), table_.end(), -1);
        for (int i = 0; base_.has_window(i); ++i) {
            std::size_t slot = base_.hash(i) & mask();
            int tries = 0;
            while (table_.data()[slot] >= 0 && ++tries < int(kTries)) slot = (slot + 1) & mask();
            if (table_.data()[slot] < 0) table_.data()[slot] = i;
        }
        return true;
    }

    const Words& base_;
    Array<int> table_;
    unsigned tries_ = 0;
};

class Writer {
  public:
    Writer(std::span<const std::byte> base, std::span<const std::byte> state, Array<std::uint32_t>& out)
        : base_(base), state_(state), places_(base_), out_(out)
    {}

    bool run()
    {
        int at = 0, from = 0;  // both are encoded up to here
        while (at < state_.count()) {
            const int same = alike(base_, from, state_, at);
            if (!begin_run(from, same)) return false;
            at += same, from += same;
            const int own = at;
            if (!next_place(at, from)) return false;
            if (!end_run(own, at)) return false;
        }
        return true;
    }

  private:
    // On from where the two differ to where they go on alike. Where something has come, that is nearer to the
    // base's beginning than if it had been put in its place: all that has not been copied is looked at.
    bool next_place(int& at, int& from)
    {
        const int first = from;
        for (int differ = 0; at < state_.count(); ++differ) {
            if (alike_enough(from, at)) return true;
            const int place = differ >= kPatience ? places_.find(state_, at, first) : -1;
            if (place == -2) return false;
            if (place >= 0) {
                from = place;
                return true;
            }
            ++at;
            if (from < base_.count()) ++from;
        }
        return true;
    }
    bool alike_enough(int from, int at) const
    {
        for (int i = 0; i < kWindow; ++i)
            if (from + i >= base_.count() || at + i >= state_.count() || base_[from + i] != state_[at + i])
                return false;
        return true;
    }
    bool begin_run(int from, int same)
    {
        length_at_ = out_.size() + 2;
        return out_.push(little(std::uint32_t(from))) && out_.push(little(std::uint32_t(same))) &&
               out_.push(0);
    }
    bool end_run(int first, int last)
    {
        out_[length_at_] = little(std::uint32_t(last - first));
        for (int i = first; i < last; ++i)
            if (!out_.push(little(state_[i]))) return false;
        return true;
    }

    Words base_, state_;
    Places places_;
    Array<std::uint32_t>& out_;
    int length_at_ = 0;
};

StateHeader header_of(std::span<const std::byte> state)
{
    StateHeader header;
    std::memcpy(&header, state.data(), sizeof header);
    return little(header);
}

// False: it is not a valid difference.
bool join(const Words& base, const Words& delta, Array<std::uint32_t>& out)
{
    const auto size = std::uint32_t(out.size());
    std::uint32_t at = 0, from = 0;
    int next = kFrameEnd;
    while (next + 3 <= delta.count()) {
        const std::uint32_t begin = delta[next], same = delta[next + 1], own = delta[next + 2];
        next += 3;
        if (begin < from || begin > std::uint32_t(base.count()) || same > std::uint32_t(base.count()) - begin)
            return false;
        if (own > std::uint32_t(delta.count() - next) || same > size - at || own > size - at - same)
            return false;
        for (std::uint32_t i = 0; i < same; ++i) out[int(at++)] = little(base[int(begin + i)]);
        for (std::uint32_t i = 0; i < own; ++i) out[int(at++)] = little(delta[next++]);
        from = begin + same;
    }
    return next == delta.count() && at == size;
}

}  // namespace

bool write_delta(std::span<const std::byte> base, std::span<const std::byte> state, Array<std::uint32_t>& out)
{
    base = base.first(std::size_t(header_of(base).size));
    if (!out.resize(kFrameEnd) || !Writer(base, state, out).run()) return false;
    const Frame frame{little(header_of(base).checksum), little(std::uint64_t(state.size() / 4))};
    std::memcpy(out.data() + sizeof(StateHeader) / 4, &frame, sizeof frame);
    seal(out.data(), 4 * std::size_t(out.size()), StateHeader::kDelta);
    return true;
}

const char* read_delta(std::span<const std::byte> base, std::span<const std::byte> delta,
                       Array<std::uint32_t>& out, char* text, std::size_t text_size)
{
    StateHeader of_base, of_delta;
    if (const char* wrong =
            read_header(base.data(), base.size(), StateHeader::kWhole, of_base, text, text_size))
        return wrong;
    if (const char* wrong =
            read_header(delta.data(), delta.size(), StateHeader::kDelta, of_delta, text, text_size))
        return wrong;
    base = base.first(std::size_t(of_base.size)), delta = delta.first(std::size_t(of_delta.size));
    if (delta.size() < 4 * std::size_t(kFrameEnd)) return "the difference ends too early";
    Frame frame;
    std::memcpy(&frame, delta.data() + sizeof of_delta, sizeof frame);
    frame = {little(frame.base_checksum), little(frame.words)};
    if (frame.base_checksum != of_base.checksum) return "the difference was made from another base";
    if (frame.words > (base.size() + delta.size()) / 4 || frame.words > INT_MAX / 4)
        return "the difference makes up more than it can have";
    if (!out.resize(int(frame.words))) return kOutOfMemory;
    return join(Words(base), Words(delta), out) ? nullptr : "the difference does not fit its base";
}

}  // namespace epode
