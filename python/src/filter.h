// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a query finds, and structured arrays as numpy has them.
#pragma once

#include <algorithm>
#include <tuple>
#include <vector>

#include "calls.h"

// A dQueryFilter whose callback is a Python function.
struct Filter {
    Filter();
    dQueryFilter filter;
    nb::object callback;
};
const dQueryFilter* filter_of(const Filter* filter);

// All that ask(out, capacity) has to tell; it returns how many there are.
template <typename T, typename F>
std::vector<T> listed(F ask)
{
    std::vector<T> result(size_t(std::max(ask(static_cast<T*>(nullptr), 0), 0)));
    if (!result.empty()) ask(result.data(), int(result.size()));
    return result;
}

template <typename P>
struct HandleList {
    std::vector<P> v;
};
using BodyList = HandleList<dBodyID>;
using JointList = HandleList<dJointID>;

// A dtype of numpy: (name, format, offset) of each field.
nb::object dtype_of(const std::vector<std::tuple<const char*, const char*, size_t>>& fields, size_t size);
#define FIELD(struct_, name, format)           \
    {                                          \
#name, format, offsetof(struct_, name) \
    }
