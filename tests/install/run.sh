#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh BUILD CMAKE CC CXX PRECISION...
# Installs the build into a prefix, moves the prefix, and uses it as its users do: pkg-config from C, ode-config
# from C, find_package from C++ in both spellings; drawstuff by pkg-config and CMake. Every program judges itself.
set -euo pipefail
build=$1 cmake=$2 cc=$3 cxx=$4
shift 4
clients=$(cd "$(dirname "$0")/clients" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LC_ALL=C
fail() { echo "install: $*" >&2; exit 1; }

first=$work/first prefix=$work/second
"$cmake" --install "$build" --prefix "$first" > "$work/log" || { cat "$work/log"; fail "cmake --install"; }
libdir=$(dirname "$(find "$first" -name pkgconfig)")
libdir=${libdir#"$first/"}

name_of() { [ "$1" = single ] && echo ode_single || echo ode; }
package_of() { [ "$1" = single ] && echo ode-single || echo ode; }
flags() { PKG_CONFIG_PATH=$1/$libdir/pkgconfig pkg-config --cflags --libs "$(package_of "$2")"; }
run() { echo "-- $*"; LD_LIBRARY_PATH=$prefix/$libdir "$@" || fail "$* said no"; }

# A program built before the move says that a moved tree is not merely one that was never used.
for precision in "$@"; do
    # shellcheck disable=SC2046
    "$cc" "$clients/fall.c" -o "$work/before_$precision" $(flags "$first" "$precision") -lm
    LD_LIBRARY_PATH=$first/$libdir "$work/before_$precision"
done
mv "$first" "$prefix"
cd "$work"

# What lies there.
for header in "$clients"/../../../include/ode/*.h; do
    cmp "$header" "$prefix/include/ode/$(basename "$header")" || fail "header"
done
for precision in "$@"; do
    lib=$prefix/$libdir/lib$(name_of "$precision").so
    [ "$(readlink "$lib")" = "$(basename "$lib").8" ] || fail "$lib is no link to .so.8"
    [ "$(readlink "$lib.8")" = "$(basename "$lib").8.0.2" ] || fail "$lib.8 is no link to .so.8.0.2"
    [ -f "$lib.8.0.2" ] || fail "$lib.8.0.2 is missing"
done
if grep -r -l -I -F -e "$first" -e "$build" "$prefix"; then fail "a text names the folder it came from"; fi
if readelf -d "$prefix"/bin/epode "$prefix/$libdir"/*.so.8 | grep -E 'R(UN)?PATH' | grep -v -F '[$ORIGIN/../'; then
    fail "a binary names a folder of the build"
fi

config=$prefix/bin/ode-config
[ "$("$config" --version)" = 0.16.2 ] || fail "ode-config --version"
[ "$("$config" --prefix --exec-prefix)" = "$prefix"$'\n'"$prefix" ] || fail "ode-config --prefix"
[ "$("$config" --prefix=/a --cflags --exec-prefix=/b --libs --prefix)" = "-I/a/include"$'\n'"-L/b/$libdir -lode"$'\n'"/a" ] ||
    [ "$*" = single ] || fail "ode-config does not read from left to right"
for wrong in "" "--nonsense"; do
    # shellcheck disable=SC2086
    if "$config" $wrong 2> usage; then fail "ode-config '$wrong' was accepted"; fi
    grep -q '^Usage: ode-config' usage || fail "ode-config '$wrong' does not tell its usage"
done
PKG_CONFIG_PATH=$prefix/$libdir/pkgconfig pkg-config --exists "$(package_of "$1") >= 0.11" || fail "version of $1"

for precision in "$@"; do
    PKG_CONFIG_PATH=$prefix/$libdir/pkgconfig pkg-config --variable=precision "$(package_of "$precision")" |
        grep -qix "d$precision" || fail "precision of $(package_of "$precision").pc"
    # shellcheck disable=SC2046
    "$cc" -Wall -Wextra -Werror "$clients/fall.c" -o "fall_$precision" $(flags "$prefix" "$precision") -lm
    run "./fall_$precision"
    # shellcheck disable=SC2046
    "$cc" -Wall -Wno-deprecated-declarations "$clients/guide.c" -o "guide_$precision" \
        $("$config" "--$precision" --cflags --libs) -lm
    run "./guide_$precision"
done

precisions=$(IFS=';'; echo "$*")
for project in upper lower; do
    "$cmake" -G Ninja -S "$clients/$project" -B "$project" -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_CXX_COMPILER="$cxx" \
        -DPRECISIONS="$precisions" > log 2>&1 && "$cmake" --build "$project" > log 2>&1 || { cat log; fail "$project"; }
done
for program in $(printf 'upper/pendulum_%s lower/lower_%s ' $(for p in "$@"; do echo "$p $p"; done)) lower/variables; do
    echo "-- $program"
    "./$program" || fail "$program said no"
done

# By Epode's own name, with its library of robots.
"$cmake" -G Ninja -S "$clients/epode" -B named -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$cc" \
    -DCLIENT="$clients/../../packages/client.c" > log 2>&1 && "$cmake" --build named > log 2>&1 || { cat log; fail "named"; }
run named/named

# drawstuff, where it was built: a C program and a C++ one, by pkg-config and by CMake.
if [ -f "$prefix/$libdir/libdrawstuff.a" ]; then
    board=$clients/../../drawstuff
    draw_flags() { PKG_CONFIG_PATH=$prefix/$libdir/pkgconfig pkg-config --cflags --libs drawstuff; }
    # shellcheck disable=SC2046
    "$cc" -std=c99 -Wall -Wextra -Werror "$board/every.c" -o every_c $(draw_flags)
    # shellcheck disable=SC2046
    "$cxx" -std=c++11 -Wall -Wextra -Werror "$board/every.cpp" -o every_cpp $(draw_flags)
    "$cmake" -G Ninja -S "$clients/draws" -B draws -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_C_COMPILER="$cc" \
        -DCMAKE_CXX_COMPILER="$cxx" -DBOARD="$(realpath "$board")" > log 2>&1 && "$cmake" --build draws > log 2>&1 ||
        { cat log; fail "draws"; }
    for program in every_c every_cpp draws/draws_c draws/draws_cpp; do
        EPODE_GL=egl EPODE_FRAMES='' run "./$program" stop 7 2> log | tail -1 | grep -q '^frames 7 ' || fail "$program: $(cat log)"
    done
fi

env -u LD_LIBRARY_PATH "$prefix/bin/epode" list > list || fail "epode list"
grep -q wall list || fail "epode knows no scene"
echo "install: good, $*"
