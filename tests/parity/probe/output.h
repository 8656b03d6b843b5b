// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Records of the parity probe: one line each, "case block/key value...", on standard output.
//
// Reals are printed with 17 significant digits, so that reading a line back gives the very bits. A block is
// one trial (one state, one step); the comparison takes the scale of a quantity from its block. Messages the
// library emits meanwhile are counted per block (dSetMessageHandler): a reference run whose LCP solver
// reported a failure there is not a reference.
#pragma once

#include <ode/ode.h>

#include <initializer_list>
#include <string>

namespace parity {

class Output {
  public:
    explicit Output(std::string case_name);
    ~Output();

    void open_block(const std::string& block);
    void put(const std::string& key, std::initializer_list<double> values);
    void put(const std::string& key, const dReal* values, int count);
    void put_text(const std::string& key, const std::string& words);
    void put_matrix3(const std::string& key, const dReal* rows_of_four);
    void put_body(const std::string& name, dBodyID body);

  private:
    void start_line(const std::string& key);
    void close_block();

    std::string case_name_;
    std::string block_;
};

void count_library_messages();

}  // namespace parity
