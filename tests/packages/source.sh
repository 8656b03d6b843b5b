#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# source.sh ARCHIVE: the source archive as projects use it, without git: below a project (add_subdirectory), fetched by it
# (FetchContent), by Conan's recipe, and vcpkg's port as far as CMake reads it. Each builds the library and runs a client of it.
set -euo pipefail
archive=$(realpath "$1")
here=$(cd "$(dirname "$0")" && pwd)
repository=$(cd "$here/../.." && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "FAILED $*" >&2; exit 1; }
quietly() { "$@" >"$work/log" 2>&1 || { tail -n 40 "$work/log" >&2; fail "$*"; }; }
mkdir "$work/source"
tar xzf "$archive" -C "$work/source" --strip-components 1
[ ! -e "$work/source/.git" ] || fail "the archive has .git"

# Below another project there is one way to be built; what makes it fast is asked for here.
for kind in subdirectory fetched; do
  quietly cmake -S "$here/consumers/$kind" -B "$work/$kind" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_C_FLAGS=-O1 -DCMAKE_CXX_FLAGS=-O1 \
    -DEPODE_BASELINE=ON -DSOURCE="$work/source" -DARCHIVE="file://$archive" -DCLIENT="$here/client.c"
  quietly cmake --build "$work/$kind" --target client
  quietly "$work/$kind/client"
  echo "ok     $kind: $(cat "$work/log")"
done

tools=$repository/build/python/conan
[ -x "$tools/bin/conan" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install -q conan; }
export CONAN_HOME=$work/conan
quietly "$tools/bin/conan" profile detect
quietly "$tools/bin/conan" create "$work/source/packaging/conan" -s compiler.cppstd=20 -s build_type=Release -o 'epode/*:shared=True' \
  -c tools.cmake.cmaketoolchain:generator=Ninja
grep -q "Full package reference: epode/" "$work/log" || fail "conan made no package"
echo "ok     conan create: $(sed -n 's/.*Full package reference: \(epode[^#]*\).*/\1/p' "$work/log" | head -n 1)"

python3 -m json.tool "$work/source/packaging/vcpkg/vcpkg.json" >/dev/null
# Its functions are vcpkg's: names that do nothing let CMake read the port to its end.
{
  for name in download_distfile extract_source_archive cmake_configure cmake_install cmake_config_fixup fixup_pkgconfig install_copyright; do
    echo "function(vcpkg_$name)"
    echo "endfunction()"
  done
  echo "set(CURRENT_PACKAGES_DIR $work/none)"
  cat "$work/source/packaging/vcpkg/portfile.cmake"
} >"$work/port.cmake"
quietly cmake -P "$work/port.cmake"
echo "ok     vcpkg: port and manifest are read"
