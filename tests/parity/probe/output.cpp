// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See output.h. A negative zero is printed as 0: the sign of a zero has no meaning for a client, and the
// two libraries may well sum in another order.
#include "output.h"

#include <cstdarg>
#include <cstdio>

namespace parity {
namespace {

int messages_in_block = 0;

void count_message(int, const char*, va_list) { ++messages_in_block; }

void print_real(double value) { std::printf(" %.17g", value == 0 ? 0.0 : value); }

}  // namespace

void count_library_messages() { dSetMessageHandler(&count_message); }

Output::Output(std::string case_name) : case_name_(std::move(case_name)) { messages_in_block = 0; }

Output::~Output() { close_block(); }

void Output::close_block()
{
    if (messages_in_block > 0) { put("messages", {static_cast<double>(messages_in_block)}); }
    messages_in_block = 0;
}

void Output::open_block(const std::string& block)
{
    close_block();
    block_ = block;
}

void Output::start_line(const std::string& key)
{
    std::printf("%s %s/%s", case_name_.c_str(), block_.empty() ? "-" : block_.c_str(), key.c_str());
}

void Output::put(const std::string& key, std::initializer_list<double> values)
{
    start_line(key);
    for (const double value : values) { print_real(value); }
    std::printf("\n");
}

void Output::put(const std::string& key, const dReal* values, int count)
{
    start_line(key);
    for (int i = 0; i < count; ++i) { print_real(values[i]); }
    std::printf("\n");
}

void Output::put_text(const std::string& key, const std::string& words)
{
    start_line(key);
    std::printf(" %s\n", words.c_str());
}

void Output::put_matrix3(const std::string& key, const dReal* rows_of_four)
{
    const dReal* r = rows_of_four;
    put(key, {r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10]});
}

void Output::put_body(const std::string& name, dBodyID body)
{
    put(name + ".pos", dBodyGetPosition(body), 3);
    put(name + ".quat", dBodyGetQuaternion(body), 4);
    put(name + ".lvel", dBodyGetLinearVel(body), 3);
    put(name + ".avel", dBodyGetAngularVel(body), 3);
}

}  // namespace parity
