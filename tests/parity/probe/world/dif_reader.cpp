// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Recursive descent over  value = { item ... } | number | word | "text",  item = name = value | value.
#include "dif_reader.h"

#include <cctype>
#include <cstdlib>
#include <vector>

namespace parity {
namespace {

class Reader {
  public:
    Reader(Output& out, const std::string& text) : out_(out), text_(text) {}

    void read_all()
    {
        if (text_.compare(0, 2, "--") == 0) {
            const std::size_t line = text_.find('\n');
            out_.put_text("heading", text_.substr(0, line));
            at_ = line;
        }
        while (!done()) {
            const std::string name = word();
            if (name.empty() || !take('=')) { return out_.put_text("unreadable", std::to_string(at_)); }
            if (peek() != '{') { out_.put_text(name + ".made-by", word()); }
            value(name);
        }
    }

  private:
    bool done() { return peek() == 0; }
    char peek()
    {
        while (at_ < text_.size() && std::isspace(static_cast<unsigned char>(text_[at_]))) { ++at_; }
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c)
    {
        if (peek() != c) { return false; }
        ++at_;
        return true;
    }
    static bool in_word(char c)
    {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '.' || c == '[' || c == ']';
    }
    std::string word()
    {
        peek();
        const std::size_t from = at_;
        while (at_ < text_.size() && in_word(text_[at_])) { ++at_; }
        return text_.substr(from, at_ - from);
    }
    bool number(double& value)
    {
        const char* from = text_.c_str() + at_;
        char* to = nullptr;
        value = std::strtod(from, &to);
        if (to == from || in_word(*to)) { return false; }
        at_ += static_cast<std::size_t>(to - from);
        return true;
    }

    // Numbers are collected; whatever has a name is written at once.
    void value(const std::string& path)
    {
        std::vector<double> numbers;
        std::string words;
        collect(path, numbers, words);
        if (!numbers.empty()) { out_.put(path, numbers.data(), static_cast<int>(numbers.size())); }
        if (!words.empty()) { out_.put_text(path, words); }
    }
    void collect(const std::string& path, std::vector<double>& numbers, std::string& words)
    {
        double x;
        if (take('{')) {
            table(path, numbers, words);
        } else if (take('"')) {
            const std::size_t end = text_.find('"', at_);
            words += " " + text_.substr(at_, end - at_);
            at_ = end + 1;
        } else if (peek(), number(x)) {
            numbers.push_back(x);
        } else {
            words += " " + word();
        }
    }
    void table(const std::string& path, std::vector<double>& numbers, std::string& words)
    {
        for (int index = 0; !take('}') && !done();) {
            if (take(',')) { continue; }
            const std::size_t from = at_;
            const std::string name = word();
            const bool named = !name.empty() && !std::isdigit(static_cast<unsigned char>(name[0]));
            if (named && take('=')) {
                value(path + "." + name);
            } else if (!(named && std::isalpha(static_cast<unsigned char>(peek())))) {
                at_ = from;  // not one of the bare words
                collect(path + "." + std::to_string(index), numbers, words);
                ++index;
            }
        }
    }

    Output& out_;
    const std::string& text_;
    std::size_t at_ = 0;
};

}  // namespace

std::string exported(dWorldID world, const char* prefix)
{
    FILE* file = std::tmpfile();
    if (!file) { return "no temporary file"; }
    dWorldExportDIF(world, file, prefix);
    std::rewind(file);
    std::string text;
    for (int c; (c = std::fgetc(file)) != EOF;) { text += static_cast<char>(c); }
    std::fclose(file);
    return text;
}

void put_dif(Output& out, const std::string& text) { Reader(out, text).read_all(); }

}  // namespace parity
