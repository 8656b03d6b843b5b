// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Reading of the probe's record files: "case block/key value...", and "#library PATH" at the top.
//
// A value is kept as text and, where all of them are numbers, as reals. Files are read as a stream, block
// by block (a block is one trial), so that memory does not grow with the number of trials.
#pragma once

#include <fstream>
#include <string>
#include <vector>

namespace parity {

struct Record {
    std::string case_name;
    std::string block;
    std::string key;
    std::string text;
    std::vector<double> values;
    bool numeric = false;
};

struct Block {
    std::string case_name;
    std::string name;
    std::vector<Record> records;
};

class RecordFile {
  public:
    explicit RecordFile(const std::string& path);

    bool is_open() const { return input_.is_open(); }
    const std::string& library() const { return library_; }
    bool next(Block& block);  // false at the end

  private:
    bool read_record();

    std::ifstream input_;
    std::string library_;
    Record ahead_;
    bool has_ahead_ = false;
};

}  // namespace parity
