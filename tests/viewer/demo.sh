#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# demo.sh EPODE SAME_PICTURE ROOT: README's picture is what `epode run wall` makes, and not another moment of it.
# demo.sh EPODE SAME_PICTURE ROOT PICTURE TRACE: and so are these, which scripts/demo has made with a library without kernels for AVX that
# is optimised little: the picture to the pixel, the trace but for times (.ci/run).
set -euo pipefail
epode=$1 same=$2 readme=$3/docs/images/wall.png
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
without_times() { cut -d, -f1-6,8- "$1"; }

"$epode" run wall --quiet --picture "$work/wall.png" --trace "$work/wall.csv" > /dev/null
"$same" "$work/wall.png" "$readme" 0.02 || {
  echo "README shows another picture than the demo makes: scripts/demo && cp out/wall.png docs/images"
  exit 1
}
"$epode" run wall --quiet --steps 200 --picture "$work/earlier.png" > /dev/null
! "$same" "$work/earlier.png" "$readme" 0.02 || { echo "a picture of half the time passes"; exit 1; }
! "$same" "$readme" "$3/docs/images/camera.png" 1 || { echo "a picture of another size passes"; exit 1; }
if [ $# -eq 5 ]; then
  "$same" "$work/wall.png" "$4" 0
  cmp <(without_times "$work/wall.csv") <(without_times "$5")
fi
