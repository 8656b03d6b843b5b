// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The words of a text, one after the other: between them stand blanks and control characters.
#pragma once

#include <string_view>

#include "robots/files/number.h"
#include "robots/geometry.h"

namespace epode::robots {

class Words {
  public:
    explicit Words(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}
    bool next(std::string_view& word)
    {
        while (at_ != end_ && static_cast<unsigned char>(*at_) <= ' ') ++at_;
        const char* begin = at_;
        while (at_ != end_ && static_cast<unsigned char>(*at_) > ' ') ++at_;
        word = {begin, size_t(at_ - begin)};
        return begin != at_;
    }
    bool number(double& value)
    {
        std::string_view word;
        if (!next(word)) return false;
        if (word[0] == '+') word.remove_prefix(1);
        return read_number(word.data(), word.data() + word.size(), value) && std::isfinite(value);
    }
    bool vec(Vec& v) { return number(v.x) && number(v.y) && number(v.z); }
    // What is left of the line.
    std::string_view line()
    {
        const char* begin = at_;
        while (at_ != end_ && *at_ != '\n') ++at_;
        return {begin, size_t(at_ - begin)};
    }

  private:
    const char *at_, *end_;
};

}  // namespace epode::robots
