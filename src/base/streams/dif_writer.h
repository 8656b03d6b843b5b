// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Writes the text of dWorldExportDIF: tables in the syntax of Lua, one field per line, one tab per level, a
// comma after every field. (Lua allows a comma after the last field; ODE forgets some.) Numbers have 15
// significant digits in double precision and 9 in single, enough to read a float back, and a decimal point in
// any locale; infinity is `inf`. Joints and geoms describe themselves through this class, so that a new type
// stays one file. What describes an object can also tell it from others: then a fingerprint is made instead
// of a text, of all that would be in it, with the numbers to the last bit.
#pragma once

#include <cstdio>
#include <initializer_list>

#include "base/config.h"
#include "base/streams/content_hash.h"

namespace epode {

class DifWriter {
  public:
    // `prefix` goes in front of every global name.
    DifWriter(std::FILE* file, const char* prefix) : file_(file), prefix_(prefix) {}
    explicit DifWriter(ContentHash& hash) : hash_(&hash) {}

    void comment(const char* text);
    // <prefix><collection> = {}
    void collection(const char* name);
    // <prefix><name>[index] = dynamics.<type> { ... }, without an index if it is negative.
    void begin_object(const char* name, int index, const char* type);
    void end_object();

    // Fields. A `number` above zero is put behind the name: limit2.
    void real(const char* name, Real value, int number = 0);
    void integer(const char* name, long long value);
    void bits(const char* name, unsigned long value);
    void text(const char* name, const char* value);
    void list(const char* name, std::initializer_list<Real> values, int number = 0);
    void rows(const char* name, std::initializer_list<std::initializer_list<Real>> rows);
    void open(const char* name, int number = 0);
    void open();  // a table without a name
    void close();
    // name = <prefix><object>,   and   name = {<prefix><object>[index],...},
    void reference(const char* name, const char* object);
    void references(const char* name, const char* object, std::initializer_list<int> indices);

  private:
    void indent();
    void begin(const char* name, int number);
    void put(const char* text) { hash_ ? hash_->add(text) : (void)std::fputs(text, file_); }
    void put_integer(long long value);
    void put_real(Real value);
    void put_list(std::initializer_list<Real> values);

    std::FILE* file_ = nullptr;
    ContentHash* hash_ = nullptr;  // null: a text is written
    const char* prefix_ = "";
    int depth_ = 0;
};

}  // namespace epode
