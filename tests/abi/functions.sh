#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# functions.sh MISSING FUNCTIONS: a C++ text that compiles only if our headers declare every function of Debian's
# library, except the missing ones, with the same type. FUNCTIONS holds lines "name TAB type", as the compiler
# printed them of Debian's headers; dReal where the two precisions differ.
set -eu
cat <<'END'
#include <cstdarg>

#include <ode/ode.h>

template <class T>
constexpr bool is(T*)
{
    return true;
}
END
awk -F '\t' 'FNR == NR { missing[$1]; next }
             !($1 in missing) { print "static_assert(is<" $2 ">(" $1 "));" }' "$1" "$2"
