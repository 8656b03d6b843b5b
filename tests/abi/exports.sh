#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# exports.sh LIBRARY INCLUDE_DIR CC [-DdIDESINGLE]
# The library exports exactly what the public headers declare: every dynamic symbol it defines is a C name of
# the interface (d and a capital) without a version, every declared one is exported, and nothing else is. Of the
# functions of Debian's library (debian_functions.txt) exactly those of missing_functions.txt are absent.
set -eu
library=$1
include=$2
cc=$3
shift 3
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
export LC_ALL=C

nm -D --defined-only "$library" | awk '{print $NF}' | sort -u > "$work/exported"
"$here/../../packaging/exports.sh" --names "$include" "$cc" "$@" > "$work/declared"
cut -f 1 "$here/debian_functions.txt" | sort -u > "$work/debian"
grep -v '^#' "$here/missing_functions.txt" | sort -u > "$work/listed"

wrong=0
complain() { # title, file with names
    [ -s "$2" ] || return 0
    echo "$1:"
    sed 's/^/  /' "$2"
    wrong=1
}
grep -v -E '^d[A-Z][A-Za-z0-9_]*$' "$work/exported" > "$work/foreign" || true
comm -23 "$work/declared" "$work/exported" > "$work/missing"
comm -13 "$work/declared" "$work/exported" | grep -E '^d[A-Z]' > "$work/undeclared" || true
comm -23 "$work/debian" "$work/exported" > "$work/absent"
comm -23 "$work/absent" "$work/listed" > "$work/lost"
comm -13 "$work/absent" "$work/listed" > "$work/done"
complain "exported, but not a C name of the interface" "$work/foreign"
complain "declared in a header, but not exported" "$work/missing"
complain "exported, but declared in no header" "$work/undeclared"
complain "in Debian's library, but neither exported nor in missing_functions.txt" "$work/lost"
complain "in missing_functions.txt, but exported (or not Debian's): take it out" "$work/done"

total=$(wc -l < "$work/debian")
ours=$(comm -13 "$work/debian" "$work/exported" | wc -l)
echo "$(($(comm -12 "$work/debian" "$work/exported" | wc -l))) of $total functions of Debian's library, $ours of our own"
exit $wrong
