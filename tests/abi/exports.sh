#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# exports.sh LIBRARY INCLUDE_DIR [CC]
# The library exports exactly what the public headers declare: every dynamic symbol it defines is a
# C name of the interface (d and a capital), every function marked ODE_API is exported, and
# nothing is exported that no header declares.
set -eu
library=$1
include=$2
cc=${3:-cc}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

nm -D --defined-only "$library" | awk '{print $NF}' | sed 's/@.*//' | LC_ALL=C sort -u > "$work/exported"

# The preprocessor leaves a marker where ODE_API stood; the function's name is the first d... word after
# it that stands before a parenthesis.
printf '#include <ode/ode.h>\n#include <ode/ext.h>\n' |
    "$cc" -E -P -x c -DODE_API=EPODE_EXPORTED -I"$include" - | tr '\n' ' ' | tr ';' '\n' |
    sed -n 's/.*EPODE_EXPORTED//p' |
    awk 'match($0, /d[A-Z][A-Za-z0-9_]* *\(/) {
             name = substr($0, RSTART, RLENGTH); gsub(/[ (]/, "", name); print name }' |
    LC_ALL=C sort -u > "$work/declared"

wrong=0
complain() { # title, file with names
    [ -s "$2" ] || return 0
    echo "$1:"
    sed 's/^/  /' "$2"
    wrong=1
}
grep -v -E '^d[A-Z]' "$work/exported" > "$work/foreign" || true
LC_ALL=C comm -23 "$work/declared" "$work/exported" > "$work/missing"
LC_ALL=C comm -13 "$work/declared" "$work/exported" | grep -E '^d[A-Z]' > "$work/undeclared" || true
complain "exported, but not a C name of the interface" "$work/foreign"
complain "declared in a header, but not exported" "$work/missing"
complain "exported, but declared in no header" "$work/undeclared"

count=$(wc -l < "$work/declared")
if [ "$count" -lt 400 ]; then
    echo "only $count declarations found in $include: the headers were not read"
    exit 1
fi
echo "$(wc -l < "$work/exported") exported, $count declared"
exit $wrong
