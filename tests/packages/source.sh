#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# source.sh FOLDER [WAY...]: the source archive in FOLDER (scripts/release source) as projects use it, without git. Each way builds the
# library and runs a program of C on it. WAY, all by default:
#   same          another clone, in another time zone and with another umask, makes the same bytes
#   subdirectory  below a project, by add_subdirectory
#   fetched       by FetchContent
#   shared        installed: find_package(ode), (ODE) and (epode), pkg-config
#   static        the same of the static library
#   conan         `conan create`, which runs packaging/conan/test_package, of a shared and of a static library
#   vcpkg         the port in FOLDER/vcpkg, its functions replaced by those of vcpkg.cmake
# How the library is packed is judged, not how fast it is: it is compiled with -O1, and without kernels for better processors.
set -euo pipefail
release=$(realpath "$1")
shift
here=$(cd "$(dirname "$0")" && pwd)
repository=$(cd "$here/../.." && pwd)
archive=$(echo "$release"/epode-*.tar.gz)
version=$(basename "$archive" .tar.gz)
version=${version#epode-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
# The ways compile the same text in folders of different names.
export CCACHE_BASEDIR=$work CCACHE_NOHASHDIR=1
fail() { echo "FAILED $*" >&2; exit 1; }
quietly() { "$@" >"$work/log" 2>&1 || { tail -n 40 "$work/log" >&2; fail "$*"; }; }
ok() { echo "ok     $*"; }
jobs=(-j"${EPODE_JOBS:-$(nproc)}")
fast=(-G Ninja -DCMAKE_BUILD_TYPE=Demo "-DCMAKE_C_FLAGS_DEMO=-O1" "-DCMAKE_CXX_FLAGS_DEMO=-O1 -DNDEBUG" -DEPODE_BASELINE=ON)
source=$work/epode-$version
tar xzf "$archive" -C "$work"
[ ! -e "$source/.git" ] || fail "the archive has .git"
grep -q "^project(epode VERSION $version " "$source/CMakeLists.txt" || fail "the archive is of another version than its name"

way_same() {
  local commit; commit=$(set +o pipefail && gzip -dc "$archive" | git get-tar-commit-id)  # which reads the beginning alone
  git clone -q --no-hardlinks "$repository" "$work/clone"
  git -C "$work/clone" checkout -q "$commit"
  (umask 077 && TZ=Asia/Kolkata LC_ALL=C "$work/clone/scripts/release" source) >"$work/log" 2>&1 || { cat "$work/log" >&2; fail "same: no archive"; }
  cmp "$archive" "$work/clone/out/release/epode-$version.tar.gz" || fail "another clone makes other bytes"
  rm -rf "$work/clone"
  ok "same: $(stat -c %s "$archive") bytes, twice, of commit ${commit:0:8}"
}

# Below another project there is one way to be built.
below() {
  quietly cmake -S "$here/consumers/$1" -B "$work/$1" "${fast[@]}" -DSOURCE="$source" -DARCHIVE="file://$archive" -DCLIENT="$here/client.c"
  quietly cmake --build "$work/$1" --target client "${jobs[@]}"
  quietly "$work/$1/client"
  ok "$1: $(cat "$work/log")"
}
way_subdirectory() { below subdirectory; }
way_fetched() { below fetched; }

# uses WAY PREFIX PACKAGE...: projects that find it under PREFIX.
uses() {
  local way=$1 prefix=$2 package
  for package in "${@:3}"; do
    quietly cmake -S "$here/consumers/installed" -B "$work/$way-$package" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" -DPACKAGE="$package" -DCLIENT="$here/client.c"
    quietly cmake --build "$work/$way-$package"
    quietly "$work/$way-$package/client"
    ok "$way, find_package($package): $(cat "$work/log")"
  done
  # shellcheck disable=SC2046
  quietly cc -DNO_ROBOTS "$here/client.c" -o "$work/client" $(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs ode) -lm
  quietly env LD_LIBRARY_PATH="$prefix/lib" "$work/client"
  ok "$way, pkg-config: $(cat "$work/log")"
}
installs() {
  quietly cmake -S "$source" -B "$work/$1" "${fast[@]}" -DBUILD_SHARED_LIBS="$2" -DEPODE_TESTS=OFF -DEPODE_TOOLS=OFF -DEPODE_PRECISIONS=double -DCMAKE_INSTALL_LIBDIR=lib
  quietly cmake --build "$work/$1" "${jobs[@]}"
  quietly cmake --install "$work/$1" --prefix "$work/$1-prefix"
  uses "$1" "$work/$1-prefix" ode ODE epode
}
way_shared() { installs shared ON; }
way_static() { installs static OFF; }

way_conan() {
  local tools=$repository/build/python/conan shared
  [ -x "$tools/bin/conan" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install -q conan; }
  export CONAN_HOME=$work/conan
  quietly "$tools/bin/conan" profile detect
  for shared in True False; do
    quietly "$tools/bin/conan" create "$source/packaging/conan" -s compiler.cppstd=20 -s build_type=Debug -o "epode/*:shared=$shared" \
      -c tools.cmake.cmaketoolchain:generator=Ninja -c tools.build:jobs="${jobs[0]#-j}" -c 'tools.build:cxxflags=["-O1", "-g0"]' \
      -c 'tools.cmake.cmaketoolchain:extra_variables={"EPODE_BASELINE": "ON"}'
    grep -q 'ball at 0[.]5' "$work/log" || fail "conan ran no test of the package"
    ok "conan create, shared=$shared: $(sed -n 's/^\(ODE .* m\)$/\1/p' "$work/log" | head -n 1)"
  done
}

way_vcpkg() {
  quietly "$here/vcpkg_manifest.py" "$release/vcpkg/vcpkg.json"
  quietly cmake -DPORT="$release/vcpkg" -DFROM="$archive" -DTO="$work/vcpkg" -DALL="$(IFS=';' && echo "${fast[*]:2}")" -DJOBS="${jobs[0]#-j}" -P "$here/vcpkg.cmake"
  uses vcpkg "$work/vcpkg/packages" ode epode
}

ways=("$@")
[ $# -gt 0 ] || ways=(same subdirectory fetched shared static conan vcpkg)
for way in "${ways[@]}"; do
  [ "$(type -t "way_$way")" = function ] || fail "no way '$way'"
  "way_$way"
done
