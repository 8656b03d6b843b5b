// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// For the test of the C++ wrappers: two equal objects, one moved by a wrapper's member and one by the C
// function it stands for. After each pair of calls everything that the C interface can read of the two must
// be equal to the last bit, and a setter must have changed something. What was read is printed, so that the
// output of the same source built with the headers of Debian's libode-dev and run on its library can be
// compared with ours. C++98, as the wrappers are.
#ifndef TESTS_CPP_TWINS_H
#define TESTS_CPP_TWINS_H

#include <cstdio>
#include <cstring>
#include <vector>

#include <ode/ode.h>

/** Everything that can be read of an object, as numbers. */
typedef std::vector<double> Numbers;

/** How many checks were made, and how many failed. */
extern int g_checks, g_failures;

/** Append count reals to the numbers. */
inline void append(Numbers& to, const dReal* from, int count) { to.insert(to.end(), from, from + count); }

/** Note a check of this name; print it, with the values, and complain if it failed. */
void judge(const char* name, bool passed, const Numbers& values);

/** A setter: both objects must read the same afterwards, and not what they read before. */
void judge_set(const char* name, const Numbers& before, const Numbers& wrapped, const Numbers& plain);

/** A getter: one number, or several, from either interface. */
void judge_get(const char* name, double wrapped, double plain);
void judge_get(const char* name, const Numbers& wrapped, const Numbers& plain);

/** Calls a setter on both and compares: `read` gives the Numbers of an object. */
#define SET(name, read, a, b, wrapped_call, plain_call) \
    do {                                                \
        const Numbers before_set = read(a);             \
        wrapped_call;                                   \
        plain_call;                                     \
        judge_set(name, before_set, read(a), read(b));  \
    } while (0)

/** A getter that fills an array of count reals named `out` in both expressions. */
#define GET_ARRAY(name, count, wrapped_call, plain_call) \
    do {                                                 \
        Numbers read_wrapped, read_plain;                \
        {                                                \
            dReal out[16] = {0};                         \
            wrapped_call;                                \
            append(read_wrapped, out, count);            \
        }                                                \
        {                                                \
            dReal out[16] = {0};                         \
            plain_call;                                  \
            append(read_plain, out, count);              \
        }                                                \
        judge_get(name, read_wrapped, read_plain);       \
    } while (0)

/** The parts of the test; each lives in a file of its own. */
void test_world();
void test_body();
void test_joint_group_and_base();
void test_joint_types();
void test_geoms();
void test_spaces();
void test_mass();

#endif
