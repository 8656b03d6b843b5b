#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted_words.sh CHECK_WORDS...: the tool finds words of the house in a file's name, an identifier, a comment and a phrase over two lines, a long
# entry and a long commit subject; and lets ordinary English, names of ODE and headers of ODE's own be.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_NOSYSTEM=1
mkdir -p "$work/src/math" "$work/include/ode"
cp "$(dirname "$0")/../../CONTRIBUTING.md" "$work"
judge() { "${tool[@]}" --root "$work" > "$work/said"; }
finds() { # N WORDS: so many lines have these words
  [ "$(grep -cE "$2" "$work/said")" -eq "$1" ] || { echo "not $1 times '$2':"; cat "$work/said"; exit 1; }
}
tool=("$@")
printf '// At most of the room in the house is used.\nint vertices;\nvoid dGeomSetBody(int);\n' > "$work/src/math/good.h"
judge || { echo "ordinary English is refused:"; cat "$work/said"; exit 1; }
finds 1 '^words: ok'

printf '// A harvest.\n' > "$work/src/math/foresight.h"
printf 'int f(int most, int kRoom);\n// In small\n// steps.\n' > "$work/src/math/bad.h"
printf '%s\n' '/* @chapter bodies Bodies' 'Refused: nothing.' '*/' '/** One' two three four five six seven eight 'nine lines. [ours] */' \
  'ODE_API void dLong(void);' '/** A harvest of ODE itself. [guide] */' 'ODE_API void dOld(void);' > "$work/include/ode/long.h"
if judge; then echo "planted words are not found"; exit 1; fi
finds 1 'foresight.h:0: foresight.h: .*foresight'
finds 1 'foresight.h:1: harvest'
finds 1 'bad.h:1: most:'
finds 1 'bad.h:1: kRoom:'
finds 1 'bad.h:2: small steps:'
finds 1 'long.h:13: dLong: its entry has 9 lines'
finds 6 .

git -C "$work" init -q
commit() { git -C "$work" -c user.name=t -c user.email=t@t commit -q --allow-empty -m "$1"; }
commit "Begin"
commit "A subject that is so long that nobody who reads a log ever comes to the end of it"
if "${tool[@]}" --root "$work" --after HEAD~1 > "$work/said"; then echo "a long subject is not found"; exit 1; fi
finds 1 'the subject has 81 characters'
echo "seven planted faults found, ordinary English let be"
