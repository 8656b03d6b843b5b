// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Counts what the library has to say while it lives: messages, errors and failed checks, each also shown on
// stderr the first few times. A sound library run on a sound scene says nothing, so the count belongs in
// every report.
#pragma once

namespace epode::scenes {

class MessageCounter {
  public:
    MessageCounter();
    ~MessageCounter();
    MessageCounter(const MessageCounter&) = delete;
    MessageCounter& operator=(const MessageCounter&) = delete;
    int count() const;
};

}  // namespace epode::scenes
