// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Listens on ODE's debug and message channels while a test runs and keeps what was said, so that a test can
// ask for "exactly one refusal, in these words".
#pragma once

#include <ode/ode.h>

#include <cstdarg>
#include <cstdio>
#include <string>
#include <vector>

class MessageRecorder {
  public:
    MessageRecorder()
    {
        texts().clear();
        dSetDebugHandler(&receive);
        dSetMessageHandler(&receive);
    }
    MessageRecorder(const MessageRecorder&) = delete;
    MessageRecorder& operator=(const MessageRecorder&) = delete;
    ~MessageRecorder()
    {
        dSetDebugHandler(nullptr);
        dSetMessageHandler(nullptr);
    }

    // What was said since the last call, joined by "|": empty for silence.
    std::string take()
    {
        std::string all;
        for (const std::string& text : texts()) all += (all.empty() ? "" : "|") + text;
        texts().clear();
        return all;
    }

  private:
    static std::vector<std::string>& texts()
    {
        static std::vector<std::string> all;
        return all;
    }

    static void receive(int number, const char* format, va_list arguments)
    {
        char text[512];
        std::vsnprintf(text, sizeof text, format, arguments);
        texts().push_back(std::to_string(number) + ": " + text);
    }
};
