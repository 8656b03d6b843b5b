#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# .glb files of scenes of every kind pass Khronos' gltf-validator without a word. 77: it is not installed.
set -euo pipefail
program=$1
root=$(cd "$(dirname "$0")/../.." && pwd)
export EPODE_NPM=$root/build/npm
[ -d "$EPODE_NPM/node_modules/gltf-validator" ] || { echo "skipped: no gltf-validator in build/npm (scripts/setup page)"; exit 77; }
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
for scene in wall pile buggy ragdolls chain; do
  "$program" run "$scene" --steps 60 --record "$work/$scene.glb" --quiet >/dev/null
done
node -e '
  const fs = require("fs"), {createRequire} = require("module");
  const validator = createRequire(process.env.EPODE_NPM + "/")("gltf-validator");
  (async () => {
    for (const file of process.argv.slice(1)) {
      const {issues, info} = await validator.validateBytes(new Uint8Array(fs.readFileSync(file)));
      const {numErrors, numWarnings, numInfos, numHints} = issues;
      console.log(`${file.split("/").pop()}: ${numErrors} errors, ${numWarnings} warnings, ${numInfos} infos, ${numHints} hints, ` +
                  `${info.totalTriangleCount} triangles`);
      if (numErrors + numWarnings + numInfos + numHints > 0 || info.animationCount !== 1) {
        console.log(JSON.stringify(issues.messages.slice(0, 5), null, 1));
        process.exitCode = 1;
      }
    }
  })();
' "$work"/*.glb
