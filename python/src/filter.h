// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a query finds, and structured arrays as numpy has them.
#pragma once

#include "calls.h"

// A dQueryFilter whose callback is a Python function.
struct Filter {
    Filter();
    dQueryFilter filter;
    nb::object callback;
};
const dQueryFilter* filter_of(const Filter* filter);

template <typename P>
struct HandleList {
    std::vector<P> v;
};
using BodyList = HandleList<dBodyID>;
using JointList = HandleList<dJointID>;
