#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted_alone.sh COMPILER CHECK_ALONE...: the tool finds a source that lacks an include, which its folder's other file has, a warning,
# and a source whose header has lost an include; and it lets sources be that have not changed.
set -euo pipefail
compiler=$1
shift
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
judge() { "$@" --root "$work" > "$work/build/said"; }
finds() { # N WORDS: so many lines have these words
  [ "$(grep -cE "$2" "$work/build/said")" -eq "$1" ] || { echo "not $1 times '$2':"; cat "$work/build/said"; exit 1; }
}
git() { command git -C "$work" -c user.name=t -c user.email=t@t "$@"; }

# Two files compiled as one behind a precompiled header, and one that is not.
mkdir -p "$work/src" "$work/build/release/Unity"
printf '#include <vector>\nint size(std::vector<int>& v) { return int(v.size()); }\n' > "$work/src/one.cpp"
printf '#include <vector>\nint first(std::vector<int>& v) { return v[0]; }\n' > "$work/src/two.cpp"
printf '#pragma once\n#include <string>\n' > "$work/src/names.h"
printf '#include "names.h"\nstd::string name() { return "it"; }\n' > "$work/src/three.cpp"
unit="$work/build/release/Unity/unity_src.cxx"
printf '#include "%s"\n#include "%s"\n' "$work/src/one.cpp" "$work/src/two.cpp" > "$unit"
command="$compiler -Wall -Werror"
printf '[{"directory": "%s", "file": "%s", "command": "%s"}, {"directory": "%s", "file": "%s", "command": "%s"}]' \
  "$work/build" "$unit" "$command -Winvalid-pch -include $work/build/cmake_pch.hxx -o unit.o -c $unit" \
  "$work/build" "$work/src/three.cpp" "$command -o three.o -c $work/src/three.cpp" > "$work/build/release/compile_commands.json"
echo /build/ > "$work/.gitignore"
git init -q
git add . && git commit -q -m "Begin"

judge "$@" || { echo "good sources are refused:"; cat "$work/build/said"; exit 1; }
finds 1 '^check_alone: 3 sources \(all\), 0 do not'
sed -i 's/#include <vector>//' "$work/src/two.cpp"
printf '#pragma once\n' > "$work/src/names.h"
if judge "$@" --since HEAD; then echo "planted faults are not found"; exit 1; fi
finds 1 '^src/two.cpp does not compile alone'
finds 1 '^src/three.cpp does not compile alone'
finds 1 '^check_alone: 2 sources \(changed since [0-9a-f]+\), 2 do not'
printf '#include <vector>\nint first(std::vector<int>& v) { int last; return v[0]; }\n' > "$work/src/two.cpp"
git checkout -q src/names.h
if judge "$@" --since HEAD; then echo "a planted warning is not found"; exit 1; fi
finds 1 'unused-variable'
echo "three planted faults found, sources that have not changed let be"
