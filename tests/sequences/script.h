// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Calls that are made and written down at once: script.call("dBodyEnable", dBodyEnable, &body) calls
// dBodyEnable(body.id) and writes `dBodyEnable(b[3]);`, so the program that a failed sequence leaves behind
// cannot differ from what was done. What happens inside callbacks is written into the body of the callback,
// which counts its calls.
#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>
#include <type_traits>
#include <vector>

#include "model.h"

namespace epode::sequences {

// A function or number that has a name in the program.
template <typename T>
struct Named {
    const char* text;
    T value;
};
template <typename T>
Named(const char*, T) -> Named<T>;

struct Four {
    dReal v[12];  // room for a rotation
    int count = 4;
};

// A space argument where the model has a geom.
struct AsSpace {
    const Geom* geom;
};

class Script {
  public:
    std::FILE* record = nullptr;  // unbuffered: what a crash interrupts has been written down
    int refusals = 0;             // counted by the debug handler

    // ---- arguments: what is passed, and how it is written ----
    template <typename T>
    static typename T::Id pass(T* object)
    {
        return object ? object->id : nullptr;
    }
    static dSpaceID pass(AsSpace s) { return reinterpret_cast<dSpaceID>(s.geom ? s.geom->id : nullptr); }
    template <typename T>
    static T pass(Named<T> named)
    {
        return named.value;
    }
    static const dReal* pass(const Four& four) { return four.v; }
    static dReal pass(double x) { return dReal(x); }
    static int pass(int x) { return x; }
    static unsigned pass(unsigned x) { return x; }
    static unsigned long pass(unsigned long x) { return x; }

    template <typename T>
    static std::string text(T* object)
    {
        if (!object) return "0";
        return std::string(T::kLetter) + "[" + std::to_string(object->number) + "]";
    }
    static std::string text(AsSpace s) { return s.geom ? "(dSpaceID)" + text(s.geom) : "0"; }
    template <typename T>
    static std::string text(Named<T> named)
    {
        return named.text;
    }
    static std::string text(double x);
    static std::string text(const Four& four);
    static std::string text(int x) { return std::to_string(x); }
    static std::string text(unsigned x) { return std::to_string(x) + "u"; }
    static std::string text(unsigned long x) { return std::to_string(x) + "ul"; }

    template <typename F, typename... Arguments>
    auto call(const char* name, F function, const Arguments&... arguments)
    {
        if (record) write(std::string(name) + "(" + list(arguments...) + ");");
        return function(pass(arguments)...);
    }

    // The same with a result that becomes object `number` of the letter.
    template <typename F, typename... Arguments>
    auto make(const char* letter, int number, const char* cast, const char* name, F function,
              const Arguments&... arguments)
    {
        if (record)
            write(std::string(letter) + "[" + std::to_string(number) + "] = " + cast + name + "(" +
                  list(arguments...) + ");");
        return function(pass(arguments)...);
    }

    void write(const std::string& line);
    void enter_callback(bool near);
    void leave_callback() { open_.pop_back(); }

    // A C program from a record, with the toolbox in front.
    static std::string program(const std::string& toolbox, const std::string& comment,
                               const std::string& record);

  private:
    template <typename... Arguments>
    static std::string list(const Arguments&... arguments)
    {
        std::string all;
        ((all += (all.empty() ? "" : ", ") + text(arguments)), ...);
        return all;
    }

    // Whose body is written: "main", or "near 12": the twelfth call of that callback.
    std::vector<std::string> open_{"main"};
    int near_calls_ = 0, moved_calls_ = 0;
};

#define CALL(function, ...) script.call(#function, function __VA_OPT__(, ) __VA_ARGS__)

}  // namespace epode::sequences
