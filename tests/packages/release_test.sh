#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# release_test.sh: the judge of releases on a small one, made up here of this tree's port: good as it is, and not once damaged. vcpkg's
# manifest, and one that has faults. The parts that take long are scripts/nightly's (archive, wheels, packages). 77: no git here.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd)
cd "$here/../.."
git rev-parse HEAD >/dev/null 2>&1 || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
fail() { echo "release: $*" >&2; exit 1; }
version=$(sed -n 's/^project(epode VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
out=$work/release
mkdir -p "$out/vcpkg" "$out/python"
tar cz README.md >"$out/epode-$version.tar.gz"
tar cz LICENSE >"$out/python/epode-$version.tar.gz"
cp packaging/vcpkg/vcpkg.json "$out/vcpkg"
sum=$(sha512sum "$out/epode-$version.tar.gz")
sed "s|@URL@|epode-$version.tar.gz|; s|@SHA512@|${sum%% *}|" packaging/vcpkg/portfile.cmake >"$out/vcpkg/portfile.cmake"
tools/sbom.py "$version" 2026-11-30T00:00:00Z "$out" "$out"/*.tar.gz "$out"/python/*.tar.gz >"$work/bill"
mv "$work/bill" "$out/epode-$version.spdx.json"
tools/release_manifest.py "$out" "$version" >"$work/manifest"
mv "$work/manifest" "$out/manifest.json"
(cd "$out" && find . -type f -printf '%P\n' | sort | xargs sha256sum >"$work/sums" && mv "$work/sums" SHA256SUMS)
"$here/release.py" "$out" --planted
echo more >>"$out/README.md"
if "$here/release.py" "$out" 2>"$work/said"; then fail "a file more is not found"; fi
grep -q "SHA256SUMS: does not name README.md" "$work/said" || fail "$(cat "$work/said")"

"$here/vcpkg_manifest.py" packaging/vcpkg/vcpkg.json
sed 's/"name": "epode"/"name": "Epode"/; s/"license"/"licence"/' packaging/vcpkg/vcpkg.json >"$work/wrong.json"
if "$here/vcpkg_manifest.py" "$work/wrong.json" 2>"$work/said"; then fail "a wrong manifest is taken"; fi
[ "$(grep -c . "$work/said")" -eq 3 ] || fail "three faults, and this is said: $(cat "$work/said")"
