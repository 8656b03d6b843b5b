// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Writes a recording to a file while it happens. After a failure (a full disk) nothing more is written and
// problem() says why; close() makes the file whole.
#pragma once

#include <cstdio>

#include "record/file/bytes.h"
#include "record/file/recording.h"

namespace epode::record {

class FileWriter : public Sink {
  public:
    FileWriter() = default;
    ~FileWriter() override;
    FileWriter(const FileWriter&) = delete;
    FileWriter& operator=(const FileWriter&) = delete;

    bool open(const std::string& path);
    // False when anything could not be written. A file that was not closed so is read as one that broke off.
    bool close();
    const std::string& problem() const { return problem_; }

    void info(const Info& info) override;
    void shape(const Shape& shape) override;
    void body(const Body& body) override;
    void geom(const Geom& geom) override;
    void joint(const Joint& joint) override;
    void gone(ObjectKind kind, std::uint32_t number) override;
    void moved(std::uint32_t geom, std::int32_t body, const Pose& pose) override;
    void calls(const CallBlock& block) override;
    void step(const Step& step) override;

  private:
    void chunk(std::uint32_t tag);
    void put(const std::vector<std::uint8_t>& bytes);
    void limits(const std::vector<Limit>& limits);
    std::FILE* file_ = nullptr;
    std::string problem_;
    ByteWriter payload_, frame_;
    std::vector<Stop> stops_;  // as told last
    std::uint64_t steps_ = 0;
};

// A recording that is whole already.
bool write_file(const Recording& recording, const std::string& path, std::string& problem);
// Sends a sink all that a recording holds, in its order.
void send_all(const Recording& recording, Sink& sink);

}  // namespace epode::record
