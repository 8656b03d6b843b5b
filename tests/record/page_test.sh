#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# The replay page of a scene in Debian's chromium (page_test.mjs). 77: npm's packages or the browser are not installed. With a folder as
# second argument the screenshots stay there; EPODE_MEASURE=1 counts frames a second of a page of 1,000 bodies over 10 s as well.
set -euo pipefail
program=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
export EPODE_NPM=$root/build/npm EPODE_PAGE=$root/build/page/replay.html
for needed in "$EPODE_NPM/node_modules/playwright-core" "$EPODE_PAGE" /usr/bin/chromium; do
  [ -e "$needed" ] || { echo "skipped: no $needed (scripts/setup page)"; exit 77; }
done
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
pictures=${2:-$work}
mkdir -p "$pictures"
"$program" run wall --html "$work/wall.html" --quiet >/dev/null
node "$root/tests/record/page_test.mjs" "$work/wall.html" "$pictures"
# A car, which drives out of any picture that stands still.
"$program" run buggy --html "$work/buggy.html" --quiet >/dev/null
node "$root/tests/record/page_test.mjs" "$work/buggy.html" "$work"
# A bike that goes far between posts that stay: alone it would be a dot in a view of all.
"$program" run motorbike --html "$work/motorbike.html" --quiet >/dev/null
node "$root/tests/record/page_test.mjs" "$work/motorbike.html" "$work" --follows
[ "${EPODE_MEASURE:-0}" = 1 ] || exit 0
"$program" run boxes-1000 --seconds 10 --html "$work/boxes.html" --quiet >/dev/null
echo "page of 1,000 bodies over 10 s: $(wc -c < "$work/boxes.html") bytes, $(gzip -9c "$work/boxes.html" | wc -c) by gzip"
node "$root/tests/record/page_test.mjs" "$work/boxes.html" "$pictures" --measure
