#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# python.sh FOLDER [WAY...]: wheels and source distribution in FOLDER (scripts/wheel --all), away from the clone. WAY, all by default:
#   metadata   what PyPI shows and demands (twine); a wheel of the stable ABI uses no more than that (abi3audit); each wheel's platform
#              is the oldest that it runs on (auditwheel)
#   wheels     each CPython of scripts/pythons installs its wheel in a new environment: a pendulum, the command, a picture
#   sdist      `pip install epode-VERSION.tar.gz` in a new environment, which builds; then as a wheel
# The source distribution is built with -O1 and without kernels for better processors: how it is packed is judged.
set -euo pipefail
folder=$(realpath "$1")
shift
repository=$(cd "$(dirname "$0")/../.." && pwd)
pythons=$("$repository/scripts/pythons")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp "$repository/python/recipes/pendulum.py" "$work"
fail() { echo "FAILED $*" >&2; exit 1; }
quietly() { "$@" >"$work/log" 2>&1 || { tail -n 40 "$work/log" >&2; fail "$*"; }; }
ok() { echo "ok     $*"; }
wheels=("$folder"/epode-*.whl)
sdist=$(echo "$folder"/epode-*.tar.gz)
[ -f "${wheels[0]}" ] && [ -f "$sdist" ] || fail "no wheel, or no source distribution in $folder"

way_metadata() {
  local tools=$repository/build/python/release-tools wheel policy key
  [ -x "$tools/bin/abi3audit" ] || { python3 -m venv "$tools" && "$tools/bin/pip" install -q twine abi3audit auditwheel spdx-tools; }
  quietly "$tools/bin/twine" check --strict "${wheels[@]}" "$sdist"
  for wheel in "${wheels[@]}"; do
    [[ $wheel != *-abi3-* ]] || quietly "$tools/bin/abi3audit" --strict --report "$wheel"
    policy=$("$tools/bin/auditwheel" show "$wheel" | tr '\n' ' ' | sed -n 's/.*following platform tag: *"\([^"]*\)".*/\1/p')
    [[ $wheel == *"$policy"* ]] || fail "$(basename "$wheel") is of $policy"
    unzip -p "$wheel" '*.dist-info/METADATA' >"$work/metadata"
    for key in Summary Requires-Python License-Expression License-File Author Keywords 'Classifier: Typing' Description-Content-Type; do
      grep -q "^$key" "$work/metadata" || fail "$(basename "$wheel"): no $key"
    done
    ok "metadata: $(basename "$wheel"), $(stat -c %s "$wheel") bytes"
  done
}

# uses PYTHON NAME: what is installed in the environment, from a folder without the clone.
uses() {
  local bin=$work/$2/bin
  cd "$work"
  quietly "$bin/python" -c "import epode, os; assert os.path.realpath(epode.__file__).startswith('$work'), epode.__file__"
  quietly "$bin/python" pendulum.py
  local said; said=$(cat "$work/log")
  grep -q '^period ' "$work/log" || fail "$2: the pendulum says $said"
  quietly "$bin/epode" run wall --steps 30 --picture "$work/$2.png"
  [ "$(head -c 4 "$work/$2.png" | tail -c 3)" = PNG ] || fail "$2: no picture"
  ok "$2: $("$1" --version), $said, epode run with a picture"
}
environment() { "$1" -m venv "$work/$2" && "$work/$2/bin/pip" install -q numpy; }

way_wheels() {
  local python version
  for python in $pythons; do
    version=$("$python" -c 'import sys; print("%d.%d" % sys.version_info[:2])')
    environment "$python" "wheel-$version"
    # From this folder alone: pip itself takes the wheel that fits.
    quietly "$work/wheel-$version/bin/pip" install --no-index --only-binary :all: --find-links "$folder" --no-deps epode
    uses "$python" "wheel-$version"
  done
}

way_sdist() {
  local python; python=$(tail -n 1 <<<"$pythons")
  tar tzf "$sdist" | grep -q '/engine/CMakeLists.txt$' || fail "the source distribution is without the engine"
  environment "$python" sdist
  quietly env CXXFLAGS=-O1 CMAKE_BUILD_PARALLEL_LEVEL="${EPODE_JOBS:-$(nproc)}" "$work/sdist/bin/pip" install -v "$sdist" \
    --config-settings cmake.build-type=Demo --config-settings cmake.define.EPODE_BASELINE=ON
  uses "$python" sdist
}

ways=("$@")
[ $# -gt 0 ] || ways=(metadata wheels sdist)
for way in "${ways[@]}"; do
  [ "$(type -t "way_$way")" = function ] || fail "no way '$way'"
  "way_$way"
done
