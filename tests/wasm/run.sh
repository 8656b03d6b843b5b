#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# The library for WebAssembly: Debian's clang builds it by the preset `wasm`, Node runs its tests, golden hashes among them, the module
# through epode.mjs, the scenes of the playground, and a C program that is built against what `cmake --install` leaves.
# The playground in a browser is browser_test.mjs's, the live scenes of the site pages_test.mjs's.
#   tests/wasm/run.sh [--golden]      (needs what `scripts/setup wasm` installs and Node 20; --golden: the hashes alone, in minutes)
# tests/wasm/skipped lists the tests that need threads or processes.
set -euo pipefail
cd "$(dirname "$0")/../.."
build=$PWD/build/wasm
cmake --preset wasm >/dev/null
programs=(golden_tests)
[ "${1:-}" = --golden ] || programs+=(unit_tests contract_tests physics_tests state_tests)
cmake --build --preset wasm --target ode epode_module epode_npm epode_robots_module "${programs[@]}"
wasi() { node --no-warnings tests/wasm/wasi.mjs "$@"; }

begin=$SECONDS
skipped=$(grep -v '^#' tests/wasm/skipped)
: > $build/listed
for program in "${programs[@]}"; do
  echo "$program"
  wasi $build/bin/$program.wasm --gtest_list_tests | awk '/^[^ ]/ { suite = $1; next } { print suite $1 }' >> $build/listed
  wasi $build/bin/$program.wasm --gtest_brief=1 "--gtest_filter=-$(paste -sd: <<<"$skipped")" > $build/$program.log 2>&1 ||
    { cat $build/$program.log; exit 1; }
  grep -E '^\[ *(=|PASSED|SKIPPED)' $build/$program.log
done
if [ ${#programs[@]} -gt 1 ]; then
  grep -vxFf $build/listed <<<"$skipped" && { echo "wasm: tests/wasm/skipped names tests that are not there"; exit 1; }
  echo "wasm: $(wc -l <<<"$skipped") tests that need threads or processes left out"
fi

# The module exports what the headers declare, and says how to call it. (Node's V8 needs no options here.)
packaging/exports.sh --names include clang-19 --target=wasm32-wasi | diff - <(node -e '
  const module = new WebAssembly.Module(require("fs").readFileSync(process.argv[1]));
  console.log(WebAssembly.Module.exports(module).map(e => e.name).filter(name => /^d[A-Z]/.test(name)).sort().join("\n"));
' $build/web/epode.wasm) || { echo "wasm: epode.wasm exports something else"; exit 1; }
for part in module playground; do
  EPODE_WEB=$build/web EPODE_PACKAGE=$build/npm node --test tests/wasm/${part}_test.mjs > $build/$part.log || { cat $build/$part.log; exit 1; }
  echo "$part: $(grep -E '^# pass' $build/$part.log)"
done

rm -rf $build/installed
cmake --install $build --prefix $build/installed >/dev/null
clang-19 --target=wasm32-wasi -I$build/installed/include tests/windows/fall.c -o $build/fall.wasm -L$build/installed/lib -lode -lc++ -lc++abi
[ "$(wasi $build/fall.wasm)" = "-4.95405" ] || { echo "wasm: a program with libode.a says something else"; exit 1; }
echo "wasm: $(gzip -9 -c $build/web/epode.wasm | wc -c) bytes of module, compressed; $((SECONDS - begin)) s under Node $(node --version)"
