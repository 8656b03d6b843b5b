#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# The npm package: built, packed, installed from its tarball in an empty folder, and there its tests, its types, its examples, random
# hostile calls, and a world that goes to a native program and back.
#   tests/wasm/npm.sh [CALLS]      (of the hostile test; 1,000,000. Needs what `scripts/setup wasm` installs, npm, and the preset release)
set -euo pipefail
cd "$(dirname "$0")/../.."
root=$PWD
native=${EPODE_NATIVE:-$root/build/release/lib}
wasm/npm/build
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
tarball=$(ls "$root"/build/wasm/epode-*.tgz)
cp tests/wasm/npm/*.mjs tests/wasm/npm/types.ts "$folder/"
cd "$folder"
echo '{"name": "clean", "private": true, "type": "module"}' > package.json
npm install --no-audit --no-fund --loglevel=error "$tarball" >/dev/null
[ "$(ls node_modules)" = epode ] || { echo "npm: the package brings others: $(ls node_modules)"; exit 1; }

gcc -O1 -I"$root/include" "$root/tests/wasm/npm/native_robot.c" -o native_robot -L"$native" -lepode_robots -lode -Wl,-rpath,"$native"
EPODE_ROOT=$root EPODE_NATIVE_ROBOT=$folder/native_robot node --test package_test.mjs robots_test.mjs > tests.log || { cat tests.log; exit 1; }
echo "npm: tests: $(grep -E '^# pass' tests.log)"
"$root/build/wasm/npm/node_modules/.bin/tsc" --noEmit --strict --target es2022 --module nodenext --skipLibCheck false types.ts
for example in node_modules/epode/examples/*.mjs; do
  node "$example" > example.log || { cat example.log; exit 1; }
  echo "npm: $(basename "$example"): $(tail -1 example.log)"
done
gcc -O1 -I"$root/include" "$root/tests/wasm/npm/native.c" -o native -L"$native" -lode -Wl,-rpath,"$native"
node native_test.mjs ./native
node hostile_test.mjs "${1:-1000000}" "${EPODE_SEED:-1}"
size=$(gzip -9 -c node_modules/epode/lib/epode.wasm | wc -c)
by_brotli() { node -e 'process.stdout.write(String(require("zlib").brotliCompressSync(require("fs").readFileSync(process.argv[1])).length))' "$1"; }
brotli=$(by_brotli node_modules/epode/lib/epode.wasm)
echo "npm: module with robots of $(by_brotli node_modules/epode/lib/epode_robots.wasm) bytes by brotli"
echo "npm: module of $size bytes by gzip, $brotli by brotli"
# It was 896,902 on 2026-12-01. wasm-ld's -Map says what a module is made of.
[ "$brotli" -le 900000 ] || { echo "npm: the module is larger than 900 kB"; exit 1; }
