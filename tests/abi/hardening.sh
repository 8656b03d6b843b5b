#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# hardening.sh LIBRARY REFERENCE: what protects a process from mistakes, its own and ours. LIBRARY has every protection
# that REFERENCE, Debian's library, has, and does nothing that spoils a host. 77, ctest's skip: there is no REFERENCE.
# hardening.sh LIBRARY parser: LIBRARY or program has what those who read the files of others have.
set -eu
export LC_ALL=C

protections() {
    readelf -lW "$1" | grep -q GNU_RELRO && echo "relocations are read-only (GNU_RELRO)"
    readelf -dW "$1" | grep -q 'Flags:.* NOW' && echo "all of them are bound at the start (BIND_NOW)"
    readelf -lW "$1" | grep -q 'GNU_STACK.* RW ' && echo "the stack holds no code"
    :
}

faults() {
    readelf -dW "$1" | grep -q TEXTREL && echo "code is written to (TEXTREL)"
    readelf -dW "$1" | grep -q 'RPATH\|RUNPATH' && echo "it has a path of its own to other libraries"
    readelf -dW "$1" | grep -q STATIC_TLS && echo "it wants room in the static TLS block (late_dlopen.c)"
    nm -D "$1" | grep -qw getenv && echo "it obeys the environment of a set-user-ID program (getenv, not secure_getenv)"
    :
}

guards() {
    readelf -lW "$1" | grep -q GNU_RELRO || echo "relocations are read-only (GNU_RELRO)"
    nm -D "$1" | grep -qw __stack_chk_fail || echo "returns are guarded (-fstack-protector-strong)"
    nm -D "$1" | grep -qE '__(memcpy|snprintf|vsnprintf|read|memset|strcpy|fprintf)_chk' || echo "sizes are checked (_FORTIFY_SOURCE)"
    # Of a program CLI11 contains one, for options that are given by the environment: it has none.
    case $1 in *.so*) nm -D "$1" | grep -qw getenv && echo "secure_getenv, not getenv" ;; esac
    :
}
if [ "$2" = parser ]; then
    lacking=$(guards "$1")
    [ -z "$lacking" ] || { echo "$1 LACKS:
$lacking"; exit 1; }
    exit 0
fi

[ -e "$2" ] || { echo "hardening: $2 is not installed (scripts/setup test)"; exit 77; }
own=$(protections "$1")
lacking=$(protections "$2" | grep -vxF "$own" || true)
spoilt=$(faults "$1")
echo "has:
$own"
[ -z "$lacking$spoilt" ] || { echo "LACKS:
$lacking
FAULTS:
$spoilt"; exit 1; }
