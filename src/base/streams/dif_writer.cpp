// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Uses std::to_chars, because printf writes a decimal comma in some locales. WebAssembly has no such locale, and std::to_chars brings
// 104 kB of tables there, which compress to 35: a twenty-seventh of the npm package's module.
#include "base/streams/dif_writer.h"

#include <charconv>

namespace epode {
namespace {

constexpr int kDigits = kSingle ? 9 : 15;

void write_digits(char (&digits)[40], Real value)
{
#ifdef __wasm__
    std::snprintf(digits, sizeof digits, "%.*g", kDigits, double(value));
#else
    *std::to_chars(digits, digits + sizeof digits - 1, value, std::chars_format::general, kDigits).ptr = 0;
#endif
}

}  // namespace

void DifWriter::indent()
{
    for (int i = 0; i < depth_; ++i) put("\t");
}

void DifWriter::begin(const char* name, int number)
{
    indent();
    put(name);
    if (number > 0) put_integer(number);
    put(" = ");
}

void DifWriter::put_integer(long long value)
{
    hash_ ? hash_->add(std::uint64_t(value)) : (void)std::fprintf(file_, "%lld", value);
}

void DifWriter::put_real(Real value)
{
    if (hash_) return hash_->add(value);
    char digits[40];
    write_digits(digits, value);
    put(digits);
}

void DifWriter::put_list(std::initializer_list<Real> values)
{
    const char* before = "{";
    for (Real value : values) {
        put(before);
        put_real(value);
        before = ",";
    }
    put("}");
}

void DifWriter::comment(const char* text)
{
    put("-- ");
    put(text);
    put("\n\n");
}

void DifWriter::collection(const char* name)
{
    put(prefix_);
    put(name);
    put(" = {}\n");
}

void DifWriter::begin_object(const char* name, int index, const char* type)
{
    put(prefix_);
    put(name);
    if (index >= 0) {
        put("[");
        put_integer(index);
        put("]");
    }
    put(" = dynamics.");
    put(type);
    put(" {\n");
    depth_ = 1;
}

void DifWriter::end_object()
{
    put("}\n");
    depth_ = 0;
}

void DifWriter::real(const char* name, Real value, int number)
{
    begin(name, number);
    put_real(value);
    put(",\n");
}

void DifWriter::integer(const char* name, long long value)
{
    begin(name, 0);
    put_integer(value);
    put(",\n");
}

void DifWriter::bits(const char* name, unsigned long value)
{
    begin(name, 0);
    hash_ ? hash_->add(std::uint64_t(value)) : (void)std::fprintf(file_, "%lu", value);
    put(",\n");
}

void DifWriter::text(const char* name, const char* value)
{
    begin(name, 0);
    put("\"");
    put(value);
    put("\",\n");
}

void DifWriter::list(const char* name, std::initializer_list<Real> values, int number)
{
    begin(name, number);
    put_list(values);
    put(",\n");
}

void DifWriter::rows(const char* name, std::initializer_list<std::initializer_list<Real>> rows)
{
    begin(name, 0);
    const char* before = "{";
    for (const auto& row : rows) {
        put(before);
        put_list(row);
        before = ",";
    }
    put("},\n");
}

void DifWriter::open(const char* name, int number)
{
    begin(name, number);
    put("{\n");
    ++depth_;
}

void DifWriter::open()
{
    indent();
    put("{\n");
    ++depth_;
}

void DifWriter::close()
{
    --depth_;
    indent();
    put("},\n");
}

void DifWriter::reference(const char* name, const char* object)
{
    begin(name, 0);
    put(prefix_);
    put(object);
    put(",\n");
}

void DifWriter::references(const char* name, const char* object, std::initializer_list<int> indices)
{
    begin(name, 0);
    put("{");
    const char* before = "";
    for (int index : indices) {
        put(before);
        put(prefix_);
        put(object);
        put("[");
        put_integer(index);
        put("]");
        before = ",";
    }
    put("},\n");
}

}  // namespace epode
