#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# standards.sh INCLUDE CC CXX
#
# All public headers compile in every standard of C and C++ that programs are written in, without a diagnostic that the
# standard requires; in the oldest ones in both precisions. That each stands alone is abi_headers_alone.
set -u
include=$1 cc=$2 cxx=$3 faults=0
cd "$include" || exit 1
# drawstuff.h includes doubles.h, for C++ alone.
headers="ode/ode.h drawstuff/drawstuff.h $(ls ode/*.h epode/*.h drawstuff/*.h | grep -v doubles)"

# compiler, standard, precision
compile()
{
    { printf '#include <%s>\n' $headers; echo 'typedef int whole;'; } |
        $1 -std="$2" -pedantic-errors -Wno-deprecated-declarations -DdIDE"$3" -I. -fsyntax-only - && return
    echo "FAULT: $2 in $3 precision"
    faults=$((faults + 1))
}

for standard in c89 c99 c11 c17; do compile "$cc -x c" $standard DOUBLE; done
for standard in c++98 c++11 c++14 c++17 c++20 c++23; do compile "$cxx -x c++" $standard DOUBLE; done
compile "$cc -x c" c89 SINGLE
compile "$cxx -x c++" c++98 SINGLE
echo "$(echo "$headers" | wc -w) headers, $faults faults"
[ $faults -eq 0 ]
