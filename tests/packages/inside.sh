#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# In the bare root (deb.sh): every line judges itself; the first that fails ends it.
set -euo pipefail
cd /try
export DEBIAN_FRONTEND=noninteractive
ok() { echo "ok     $*"; }
fail() { echo "FAILED $*" >&2; exit 1; }
installed() { dpkg-query -W -f='${Status}' "$1" 2>/dev/null | grep -q 'ok installed'; }
# Names of what pyode's program measured, without messages of the library. (tests/clients compares the values.)
figures() { sed -n 's/^\([a-z][^ ]*\) .*/\1/p' "$1"; }
quietly() { "$@" >log 2>&1 || { tail -n 40 log >&2; fail "$*"; }; }

if ! installed xmoto || ! installed libdart-dev; then
  quietly apt-get update
  quietly apt-get install -y --no-install-recommends xmoto python3-pyode xvfb xauth g++ pkgconf cmake make libdart-dev libdart-collision-ode-dev
fi
# As it was before us, should an earlier run have ended here.
quietly apt-get install -y --allow-downgrades libode8 libode-dev
installed libode8 || fail "no libode8 to take the place of"
quietly python3 falling.py
cp log pyode-before

quietly apt-get install -y --no-install-recommends ./*.deb
for package in libepode8 libepode-robots0 libepode-dev epode-tools python3-epode xmoto python3-pyode libdart-dev; do
  installed "$package" || fail "$package is not installed"
done
if installed libode8 || installed libode-dev; then fail "Debian's own is still there"; fi
quietly dpkg --audit
quietly apt-get check
ok "libepode8 has taken libode8's place, with all that depends on it"

library=$(readlink -f /usr/lib/*/libode.so.8)
dpkg -S "$library" | grep -q '^libepode8' || fail "$library is not ours"
quietly python3 falling.py
grep -q "^#library $library " log || fail "pyode runs on $(head -n 1 log)"
diff <(figures log) <(figures pyode-before) || fail "pyode: other figures than before"
[ "$(figures log | wc -l)" -gt 100 ] || fail "pyode: hardly a figure"
ok "python3-pyode: $(figures log | wc -l) figures, as on Debian's"

xvfb-run -a xmoto -l tut1 --nowww --nosound -win -res 800x600 >game 2>&1 &
seen=
for _ in $(seq 60); do
  sleep 1
  game=$(pgrep -x xmoto || true)
  if [ -n "$game" ] && grep -q "$library" "/proc/$game/maps"; then seen=$((${seen:-0} + 1)); fi
  [ "${seen:-0}" -lt 20 ] || break
done
[ "${seen:-0}" -ge 20 ] || { tail game >&2; fail "xmoto did not run for 20 s"; }
pkill -x xmoto || true
ok "xmoto runs on it"

quietly g++ -std=c++17 -O0 -isystem /usr/include/eigen3 contacts.cpp preamble.cpp -o contacts -ldart-collision-ode -ldart -lode
python3 -c 'import judge; judge.write_torus("/try/torus.obj")'
quietly ./contacts 500 /try/torus.obj
grep -q "^#library $library " log || fail "DART runs on $(head -n 1 log)"
[ "$(tail -n 1 log)" = "#end" ] || fail "DART's detector did not reach its end"
ok "DART's detector: $(awk '$1 == "pair" && $4 > 0' log | wc -l) of 500 pairs touch"

# shellcheck disable=SC2046
quietly gcc -Wall -Werror client.c -o client $(pkg-config --cflags --libs ode) -lepode_robots -lm
quietly ./client
ok "a program by pkg-config: $(cat log)"
# shellcheck disable=SC2046
quietly gcc -Wall -Werror client.c -o client-single -DNO_ROBOTS $(pkg-config --cflags --libs ode-single) -lm
quietly ./client-single
ok "in single precision: $(cat log)"

for name in ode ODE epode; do
  mkdir -p "by-$name"
  cat >"by-$name/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.18)
project(client C CXX)
find_package($name REQUIRED)
add_executable(client ../client.c)
target_compile_definitions(client PRIVATE NO_ROBOTS)
target_link_libraries(client PRIVATE ODE::ODE m)
END
  quietly cmake -S "by-$name" -B "by-$name/build"
  quietly cmake --build "by-$name/build"
  quietly "by-$name/build/client"
  ok "a program by CMake, find_package($name): $(cat log)"
done

quietly epode --version
quietly epode run wall --steps 60 --picture wall.png
[ "$(head -c 4 wall.png | tail -c 3)" = PNG ] || fail "epode makes no picture"
ok "epode run, with a picture"
quietly python3 pendulum.py
grep -q "^period " log || fail "the pendulum says $(cat log)"
ok "python3-epode: $(cat log)"

quietly apt-get install -y --allow-downgrades --allow-remove-essential libode8 libode-dev
installed libode8 || fail "Debian's own does not come back"
if installed libepode8; then fail "libepode8 stays next to libode8"; fi
installed xmoto || fail "xmoto is gone"
ok "and back to Debian's"
