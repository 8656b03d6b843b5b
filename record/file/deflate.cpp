// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// RFC 1951: bytes are replaced by what has been seen before (section 2.3), and what is left gets Huffman codes of its own in each block
// (3.2.7). Sequences are found by a hash of three bytes; of those with the same hash the newest are tried.
#include "record/file/deflate.h"

#include <algorithm>
#include <array>
#include <queue>

namespace epode::record {

namespace {

constexpr size_t kWindow = 32768, kLeast = 3, kMaxLength = 258, kTries = 24, kTokens = 1 << 16;
constexpr int kLiterals = 286, kDistances = 30, kEnd = 256, kLengthCodes = 19;

// The codes of lengths and distances, the first that each stands for and its further bits (3.2.5).
struct Steps {
    std::vector<int> first, bits;
};

Steps length_steps()
{
    Steps steps;
    for (int code = 0, at = int(kLeast); code < 28; ++code) {
        steps.first.push_back(at);
        steps.bits.push_back(code < 8 ? 0 : code / 4 - 1);
        at += 1 << steps.bits.back();
    }
    steps.first.push_back(int(kMaxLength));
    steps.bits.push_back(0);
    return steps;
}

Steps distance_steps()
{
    Steps steps;
    for (int code = 0, at = 1; code < kDistances; ++code) {
        steps.first.push_back(at);
        steps.bits.push_back(code < 4 ? 0 : code / 2 - 1);
        at += 1 << steps.bits.back();
    }
    return steps;
}

const Steps kLength = length_steps(), kDistance = distance_steps();

int code_of(const Steps& steps, int value)
{
    return int(std::upper_bound(steps.first.begin(), steps.first.end(), value) - steps.first.begin()) - 1;
}

// A literal (distance 0), or a length at a distance.
struct Token {
    std::uint16_t value, distance;
};

// The lengths of Huffman codes for these counts, none above a limit: counts are made alike until that holds.
std::vector<int> code_lengths(std::vector<std::uint32_t> counts, int limit)
{
    if (std::count_if(counts.begin(), counts.end(), [](auto n) { return n > 0; }) < 2) {
        for (size_t i = 0, wanted = 2; i < counts.size() && wanted > 0; ++i)
            if (counts[i] > 0 || i < 2) counts[i] = std::max(counts[i], 1u), --wanted;
    }
    for (;; std::ranges::for_each(counts, [](auto& n) { n = n > 0 ? (n + 1) / 2 : 0; })) {
        using Node = std::pair<std::uint64_t, int>;
        std::priority_queue<Node, std::vector<Node>, std::greater<>> nodes;
        std::vector<int> above(counts.size(), -1);
        for (size_t i = 0; i < counts.size(); ++i)
            if (counts[i] > 0) nodes.push({counts[i], int(i)});
        while (nodes.size() > 1) {
            const Node a = nodes.top();
            nodes.pop();
            const Node b = nodes.top();
            nodes.pop();
            const int both = int(above.size());
            above.push_back(-1);
            above[size_t(a.second)] = above[size_t(b.second)] = both;
            nodes.push({a.first + b.first, both});
        }
        std::vector<int> depth(above.size(), 0);
        for (size_t i = above.size(); i-- > 0;)
            if (above[i] >= 0) depth[i] = depth[size_t(above[i])] + 1;
        depth.resize(counts.size());
        if (*std::ranges::max_element(depth) <= limit) return depth;
    }
}

// The codes of given lengths (3.2.2), with their first bit lowest.
std::vector<std::uint32_t> codes_of(const std::vector<int>& lengths)
{
    std::array<std::uint32_t, 17> next{}, count{};
    for (int length : lengths) count[size_t(length)] += length > 0;
    for (size_t bits = 1; bits < next.size(); ++bits) next[bits] = (next[bits - 1] + count[bits - 1]) << 1;
    std::vector<std::uint32_t> codes(lengths.size(), 0);
    for (size_t i = 0; i < lengths.size(); ++i) {
        if (lengths[i] == 0) continue;
        std::uint32_t code = next[size_t(lengths[i])]++;
        for (int bit = 0; bit < lengths[i]; ++bit, code >>= 1) codes[i] = codes[i] << 1 | (code & 1);
    }
    return codes;
}

class Deflate {
  public:
    explicit Deflate(std::span<const std::uint8_t> bytes)
        : bytes_(bytes), head_(kWindow, -1), before_(kWindow, -1)
    {}

    std::vector<std::uint8_t> run()
    {
        size_t at = 0;
        do {
            std::vector<Token> tokens;
            while (at < bytes_.size() && tokens.size() < kTokens) at += take(at, tokens);
            block(tokens, at == bytes_.size());
        } while (at < bytes_.size());
        if (filled_ > 0) out_.push_back(std::uint8_t(pending_));
        return std::move(out_);
    }

  private:
    static size_t hash(const std::uint8_t* p)
    {
        return ((std::uint32_t(p[0]) << 16 | std::uint32_t(p[1]) << 8 | p[2]) * 2654435761u >> 8) % kWindow;
    }

    void remember(size_t at)
    {
        if (at + kLeast > bytes_.size()) return;
        const size_t place = hash(&bytes_[at]);
        before_[at % kWindow] = head_[place];
        head_[place] = std::int64_t(at);
    }

    // A token for what begins here. Returns how many bytes it stands for.
    size_t take(size_t at, std::vector<Token>& tokens)
    {
        size_t length = 0, distance = 0;
        if (at + kLeast <= bytes_.size()) {
            std::int64_t from = head_[hash(&bytes_[at])];
            for (size_t i = 0; i < kTries && from >= 0 && at - size_t(from) < kWindow && length < kMaxLength;
                 ++i) {
                const size_t same = alike(size_t(from), at);
                if (same > length) length = same, distance = at - size_t(from);
                from = before_[size_t(from) % kWindow];
            }
        }
        if (length < kLeast) length = 1, distance = 0;
        tokens.push_back({std::uint16_t(distance ? length : bytes_[at]), std::uint16_t(distance)});
        for (size_t i = 0; i < length; ++i) remember(at + i);
        return length;
    }

    size_t alike(size_t a, size_t b) const
    {
        const size_t limit = std::min(kMaxLength, bytes_.size() - b);
        size_t count = 0;
        while (count < limit && bytes_[a + count] == bytes_[b + count]) ++count;
        return count;
    }

    void block(const std::vector<Token>& tokens, bool last)
    {
        std::vector<std::uint32_t> literal(kLiterals, 0), distance(kDistances, 0);
        literal[kEnd] = 1;
        for (const Token& token : tokens) {
            ++literal[size_t(token.distance ? 257 + code_of(kLength, token.value) : token.value)];
            if (token.distance) ++distance[size_t(code_of(kDistance, token.distance))];
        }
        const std::vector<int> literal_bits = code_lengths(literal, 15),
                               distance_bits = code_lengths(distance, 15);
        put(last, 1);
        put(2, 2);
        lengths(literal_bits, distance_bits);
        const auto literals = codes_of(literal_bits), distances = codes_of(distance_bits);
        const auto literal_code = [&](int i) { put(literals[size_t(i)], literal_bits[size_t(i)]); };
        for (const Token& token : tokens) {
            if (!token.distance) {
                literal_code(token.value);
                continue;
            }
            const int length = code_of(kLength, token.value), far = code_of(kDistance, token.distance);
            literal_code(257 + length);
            put(std::uint32_t(token.value - kLength.first[size_t(length)]), kLength.bits[size_t(length)]);
            put(distances[size_t(far)], distance_bits[size_t(far)]);
            put(std::uint32_t(token.distance - kDistance.first[size_t(far)]), kDistance.bits[size_t(far)]);
        }
        literal_code(kEnd);
    }

    // The lengths of both codes, with a code of their own; zeros in a row by one number (3.2.7).
    void lengths(const std::vector<int>& literal, const std::vector<int>& distance)
    {
        std::vector<int> all = literal;
        all.insert(all.end(), distance.begin(), distance.end());
        std::vector<std::array<int, 3>> said;  // code, further bits, their number
        for (size_t i = 0; i < all.size();) {
            size_t zeros = 0;
            while (i + zeros < all.size() && all[i + zeros] == 0 && zeros < 138) ++zeros;
            if (zeros >= 11) {
                said.push_back({18, int(zeros) - 11, 7});
            } else if (zeros >= 3) {
                said.push_back({17, int(zeros) - 3, 3});
            } else {
                said.push_back({all[i], 0, 0});
                zeros = 1;
            }
            i += zeros;
        }
        std::vector<std::uint32_t> count(kLengthCodes, 0);
        for (const auto& one : said) ++count[size_t(one[0])];
        const std::vector<int> bits = code_lengths(count, 7);
        const auto codes = codes_of(bits);
        static constexpr std::array<int, kLengthCodes> kOrder{16, 17, 18, 0, 8,  7, 9,  6, 10, 5,
                                                              11, 4,  12, 3, 13, 2, 14, 1, 15};
        put(kLiterals - 257, 5);
        put(kDistances - 1, 5);
        put(kLengthCodes - 4, 4);
        for (int code : kOrder) put(std::uint32_t(bits[size_t(code)]), 3);
        for (const auto& [code, more, more_bits] : said) {
            put(codes[size_t(code)], bits[size_t(code)]);
            put(std::uint32_t(more), more_bits);
        }
    }

    void put(std::uint32_t value, int bits)
    {
        pending_ |= std::uint64_t(value) << filled_;
        for (filled_ += bits; filled_ >= 8; filled_ -= 8, pending_ >>= 8)
            out_.push_back(std::uint8_t(pending_));
    }

    std::span<const std::uint8_t> bytes_;
    std::vector<std::int64_t> head_, before_;
    std::vector<std::uint8_t> out_;
    std::uint64_t pending_ = 0;
    int filled_ = 0;
};

}  // namespace

std::vector<std::uint8_t> deflated(std::span<const std::uint8_t> bytes) { return Deflate(bytes).run(); }

}  // namespace epode::record
