#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# precision.sh LIBDIR INCLUDE_DIR CC CXX
# A program and a library of different precisions do not come together: the linker refuses, and its message says
# what to do; where the library is exchanged behind the linker's back, a program for float does not start. What
# fits together is linked and runs, programs built against other headers of ODE among it, and both libraries can
# be opened by dlopen.
set -eu
libdir=$1 include=$2 cc=$3 cxx=$4
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
export LC_ALL=C
for_single='undefined reference to .dSinglePrecisionProgram_LinkWith_ode_single'
for_double='libode_single.so.*: undefined reference to .dDoublePrecisionProgram_CompileWith_dIDESINGLE'

fail() {
    echo "precision: $*"
    [ ! -s message ] || cat message
    exit 1
}
refused() { # message wanted, what, compiler and arguments
    wanted=$1 what=$2
    shift 2
    if "$@" -o refused > message 2>&1; then fail "$what was linked"; fi
    grep -q "$wanted" message || fail "$what: not the message wanted ($wanted)"
    echo "refused, as it must be: $what: $(grep -m 1 -o "$wanted" message)"
}
runs() { # what, compiler and arguments
    what=$1
    shift
    "$@" -o good > message 2>&1 || fail "$what was not linked"
    LD_BIND_NOW=1 LD_LIBRARY_PATH=$libdir ./good || fail "$what does not run"
    echo "runs: $what"
}

both_directions() { # language, options, compiler and arguments
    language=$1 options=$2
    shift 2
    set -- "$@" -I"$include" -L"$libdir" $options -x "$language" "$here/precision_client.c" -x none
    runs "$language $options, double on libode" "$@" -DdIDEDOUBLE -lode
    runs "$language $options, float on libode_single" "$@" -DdIDESINGLE -lode_single
    refused "$for_single" "$language $options, float on libode" "$@" -DdIDESINGLE -lode
    refused "$for_double" "$language $options, double on libode_single" "$@" -lode_single
}
# The options by which a program sheds what it does not use must not shed the guard.
both_directions c -O0 "$cc"
both_directions c "-O2 -ffunction-sections -fdata-sections -Wl,--gc-sections" "$cc"
both_directions c++ -flto "$cxx"

# Other headers of ODE leave no trace in a program; they are for double.
set -- "$cc" -L"$libdir" "$here/precision_foreign.c"
runs "a program built against other headers, on libode" "$@" -lode
refused "$for_double" "a program built against other headers, on libode_single" "$@" -lode_single

# A program for float that finds the double library under the name of its own.
"$cc" -I"$include" -DdIDESINGLE "$here/precision_client.c" -o late -L"$libdir" -lode_single
mkdir wrong
cp "$libdir/libode.so.8" wrong/libode_single.so.8
if LD_LIBRARY_PATH=$work/wrong ./late > message 2>&1; then fail "a program for float started on the library for double"; fi
grep -q 'symbol lookup error.*dSinglePrecisionProgram_LinkWith_ode_single' message || fail "started, or failed otherwise"

# Programs in other languages, which know no headers.
"$cc" "$here/precision_dlopen.c" -o opens -ldl
for library in ode ode_single; do
    ./opens "$libdir/lib$library.so.8" || fail "lib$library.so.8 cannot be opened by dlopen"
done
