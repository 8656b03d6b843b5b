#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted_faults.sh DOC_SAMPLES...: the tool finds a sample that does not compile; one that prints something else than it
# says, one that says nothing of what it prints, one that ends badly, and one whose call is refused; and lets good ones be.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
sample() { printf '```%s\n%s\n```\n' "$1" "$2"; }
finds() { # N WORDS PAGE
  if "${tool[@]}" "$work/$3" > "$work/said"; then echo "all is taken for good:"; cat "$work/$3"; exit 1; fi
  [ "$(grep -cE "$2" "$work/said")" -eq "$1" ] || { echo "not $1 times '$2':"; cat "$work/said"; exit 1; }
}
tool=("$@")
sample c 'dBodySetPosition(body, 0, 0);' > "$work/syntax.md"
{
  sample c 'printf("%.2f\n", (double)dBodyGetPosition(body)[2]); /* prints: 2.00 */'
  sample cpp 'dQuaternion q; dQSetIdentity(q); printf("%g", (double)q[0]); // prints: 1'
  sample c 'printf("%.2f\n", (double)dBodyGetPosition(body)[2]); /* prints: 3.00 */'
  sample c 'printf("said by nobody\n");'
  sample c 'int main(void) { return 1; }'
  sample c 'dBodySetPosition(body, 0, 0, dNaN);'
} > "$work/run.md"
finds 1 'does not compile' syntax.md
finds 2 'prints .*, and says' run.md
finds 1 'ends with 1' run.md
finds 1 'writes to stderr' run.md
finds 1 '^6 samples .* 4 faults$' run.md
echo "five planted faults found, two good samples let be"
