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
quietly() { "$@" >log 2>&1 || { tail -n 40 log >&2; fail "$*"; }; }

if ! installed xmoto || ! installed libdart-dev; then
  quietly apt-get update
  quietly apt-get install -y --no-install-recommends xmoto python3-pyode xvfb xauth g++ pkgconf libdart-dev libdart-collision-ode-dev
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
[ "$(wc -l <log)" = "$(wc -l <pyode-before)" ] || fail "pyode: other figures than before"
ok "python3-pyode: $(($(wc -l <log) - 1)) figures"

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
quietly ./contacts
ok "DART's detector: $(wc -l <log) lines of contacts"

# shellcheck disable=SC2046
quietly gcc -Wall -Werror client.c -o client $(pkg-config --cflags --libs ode) -lepode_robots -lm
quietly ./client
ok "a program by pkg-config: $(cat log)"
# shellcheck disable=SC2046
quietly gcc -Wall -Werror client.c -o client-single -DNO_ROBOTS $(pkg-config --cflags --libs ode-single) -lm
quietly ./client-single
ok "in single precision: $(cat log)"

quietly epode --version
quietly epode run wall --steps 60 --picture wall.png
[ "$(head -c 4 wall.png | tail -c 3)" = PNG ] || fail "epode makes no picture"
ok "epode run, with a picture"
quietly python3 -c '
import epode
world = epode.World()
body = epode.Body(world)
world.gravity = (0, 0, -10)
for _ in range(100): world.step(0.01)
assert abs(body.position[2] + 5) < 0.1, body.position
print(body.position)'
ok "python3-epode: $(cat log)"

quietly apt-get install -y --allow-downgrades --allow-remove-essential libode8 libode-dev
installed libode8 || fail "Debian's own does not come back"
if installed libepode8; then fail "libepode8 stays next to libode8"; fi
installed xmoto || fail "xmoto is gone"
ok "and back to Debian's"
