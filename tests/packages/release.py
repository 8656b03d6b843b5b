#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""release.py FOLDER: is a release (scripts/release) whole, and as its checksums, manifest, bill of materials and port say?

With --planted, damaged copies of it are judged, too: each damage has to be found. Where spdx-tools are installed (scripts/nightly
packages), they judge the bill's form.
"""

import hashlib
import json
import re
import shutil
import sys
import tempfile
from pathlib import Path

OWN = {"SHA256SUMS", "manifest.json"}


def digest(path, kind="sha256"):
    return hashlib.new(kind, path.read_bytes()).hexdigest()


def differences(what, said, there):
    yield from (f"{what}: names {name}, which is not there" for name in said.keys() - there.keys())
    yield from (f"{what}: does not name {name}" for name in there.keys() - said.keys())
    yield from (f"{what}: {name} has other contents" for name in said.keys() & there.keys() if said[name] != there[name])


def faults_of_port(folder, archives):
    port = (folder / "vcpkg/portfile.cmake").read_text(encoding="utf-8")
    if re.search(r"@[A-Z0-9]+@", port):
        yield "port: something is not filled in"
    if not archives or f"SHA512 {digest(archives[0], 'sha512')}" not in port:
        yield "port: not of this source archive"


def faults_of_bill(path, packed):
    try:
        from spdx_tools.spdx.parser.parse_anything import parse_file
        from spdx_tools.spdx.validation.document_validator import validate_full_spdx_document
        yield from (f"bill: {message.validation_message}" for message in validate_full_spdx_document(parse_file(str(path))))
    except ImportError:
        print("release: without spdx-tools, which judge the bill's form", file=sys.stderr)
    bill = json.loads(path.read_text(encoding="utf-8"))
    said = {each["packageFileName"]: each["checksums"][0]["checksumValue"] for each in bill["packages"] if "packageFileName" in each}
    yield from differences("bill of materials", said, packed)
    names = [each["SPDXID"] for each in bill["packages"]]
    if len(names) != len(set(names)):
        yield "bill of materials: two packages of one name"


def faults(folder):
    there = {str(path.relative_to(folder)): digest(path) for path in sorted(folder.rglob("*")) if path.is_file()}
    sums = dict(reversed(line.split("  ", 1)) for line in (folder / "SHA256SUMS").read_text(encoding="utf-8").splitlines())
    yield from differences("SHA256SUMS", sums, {name: sum for name, sum in there.items() if name != "SHA256SUMS"})
    manifest = json.loads((folder / "manifest.json").read_text(encoding="utf-8"))
    said = {each["file"]: each["sha256"] for each in manifest["files"]}
    yield from differences("manifest", said, {name: sum for name, sum in there.items() if name not in OWN})
    bill = folder / f"epode-{manifest['version']}.spdx.json"
    packed = {name: sum for name, sum in there.items() if name.endswith((".gz", ".whl", ".deb"))}
    if not packed:
        yield "nothing is released"
    yield from faults_of_bill(bill, packed) if bill.exists() else ["no bill of materials"]
    if (folder / "vcpkg").is_dir():
        yield from faults_of_port(folder, list(folder.glob("epode-*.tar.gz")))


def turn_byte(path):
    data = bytearray(path.read_bytes())
    data[len(data) // 2] ^= 1
    path.write_bytes(data)


def judge_planted(folder):
    damages = {f"a bit of {path.relative_to(folder)} turned": lambda copy, name=path.relative_to(folder): turn_byte(copy / name)
               for path in folder.rglob("*") if path.name.endswith((".gz", ".whl", ".deb"))}
    damages |= {"a file more": lambda copy: (copy / "more.whl").write_bytes(b"more"),
                "a port of another archive": lambda copy: turn_byte(copy / "vcpkg/portfile.cmake") if (copy / "vcpkg").is_dir() else turn_byte(copy / "SHA256SUMS"),
                "a file less": lambda copy: next(copy.glob("*.spdx.json")).unlink()}
    for name, damage in damages.items():
        with tempfile.TemporaryDirectory() as work:
            copy = Path(work) / "release"
            shutil.copytree(folder, copy)
            damage(copy)
            if not list(faults(copy)):
                yield f"planted: {name} is not found"
    print(f"ok     {len(damages)} damages planted")


if __name__ == "__main__":
    options, names = {word for word in sys.argv[1:] if word.startswith("--")}, [word for word in sys.argv[1:] if not word.startswith("--")]
    if len(names) != 1 or options - {"--planted"} or not (Path(names[0]) / "SHA256SUMS").is_file():
        sys.exit(__doc__)
    where = Path(names[0])
    found = list(faults(where)) + (list(judge_planted(where)) if "--planted" in options else [])
    if found:
        sys.exit("\n".join(f"release: {fault}" for fault in found))
    print(f"ok     {where}: {sum(path.is_file() for path in where.rglob('*'))} files, as they are said to be")
