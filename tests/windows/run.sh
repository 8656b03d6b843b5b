#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# The libraries for 64-bit Windows: Debian's MinGW-w64 builds them by the preset `windows`, Wine runs their tests, golden hashes
# among them, and a program that is built against what `cmake --install` leaves.
#   tests/windows/run.sh [--golden]      (needs what `scripts/setup windows` installs; --golden: the hashes alone, in minutes)
# It shows that the code works and has the same bits; of speed, and of Microsoft's own system, it shows nothing.
set -euo pipefail
cd "$(dirname "$0")/../.."
export WINEDEBUG=-all WINEPREFIX="$PWD/build/wine"
build=build/windows
cmake --preset windows >/dev/null
programs=(golden_tests)
[ "${1:-}" = --golden ] || programs+=(unit_tests contract_tests physics_tests state_tests)
cmake --build --preset windows --target ode ode_single "${programs[@]}"

# It exports what the headers declare, and no more.
for library in ode ode_single; do
  x86_64-w64-mingw32-objdump -p $build/bin/lib$library.dll |
    sed -n '/^\[Ordinal\/Name Pointer\] Table/,/^$/s/^\t\[ *[0-9]*\] //p' | LC_ALL=C sort > $build/$library.exported
  tail -n +2 $build/$library.def | diff - $build/$library.exported || { echo "windows: lib$library.dll exports something else"; exit 1; }
done

begin=$SECONDS
for program in "${programs[@]}"; do
  echo "$program"
  wine $build/bin/$program.exe --gtest_brief=1 | tr -d '\r' | grep -E '^\[ *(=|PASSED|FAILED)' || exit 1
done

for kernels in baseline avx2 avx512; do
  [ $kernels = baseline ] || grep -q "$kernels" /proc/cpuinfo || continue
  EPODE_KERNELS=$kernels wine $build/bin/golden_tests.exe --gtest_brief=1 | tr -d '\r' | grep -E '^\[ *(PASSED|FAILED)' | sed "s/$/ ($kernels)/" || exit 1
done

rm -rf $build/installed
cmake --install $build --prefix $build/installed >/dev/null
for library in ode ode_single; do
  x86_64-w64-mingw32-gcc-posix $([ $library = ode ] || echo -DdIDESINGLE) -I$build/installed/include tests/windows/fall.c -o $build/fall.exe -L$build/installed/lib -l$library
  cp $build/installed/bin/lib$library.dll $build/
  [ "$(wine $build/fall.exe | tr -d '\r')" = "-4.95405" ] || { echo "windows: a program with lib$library says something else"; exit 1; }
done
echo "windows: $((SECONDS - begin)) s under Wine"
