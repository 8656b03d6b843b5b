#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""sbom.py VERSION DATE FOLDER FILE...: what a release consists of, FILEs below FOLDER, as SPDX 2.3 (JSON), on stdout.

The core library has no dependencies; the rest names what it is built with, as Debian's packages of it say. DATE is that of the
commit (ISO 8601), so that the same commit gives the same text.
"""

import hashlib
import json
import re
import subprocess
import sys
from pathlib import Path

# Part of a release, Debian's package, its licence: what runs in the process of a user.
USED = [
    ("libepode_robots", "libpugixml-dev", "MIT"),
    ("libepode_robots", "nlohmann-json3-dev", "MIT"),
    ("libepode_robots", "libsdformat-dev", "Apache-2.0"),
    ("libepode_robots", "libstb-dev", "MIT"),
    ("epode", "libcli11-dev", "BSD-3-Clause"),
    ("epode", "libfmt-dev", "MIT"),
    ("epode", "zlib1g-dev", "Zlib"),
    ("epode", "libepoxy-dev", "MIT"),
    ("epode", "libglfw3-dev", "Zlib"),
    ("epode", "libimgui-dev", "MIT"),
    ("epode (Python)", "nanobind", "BSD-3-Clause"),
    ("nanobind", "robin-map", "MIT"),
]
ROOT = Path(__file__).resolve().parent.parent


# Debian's version, or that of PyPI's package that the wheels were built with.
def installed(package):
    found = sorted(ROOT.glob(f"build/python/tools-*/lib/*/site-packages/{package}-*.dist-info"))
    if found:
        return found[-1].name.removesuffix(".dist-info").removeprefix(f"{package}-")
    done = subprocess.run(["dpkg-query", "-W", "-f=${Version}", package], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 and done.stdout else "NOASSERTION"


def identifier(text):
    return "SPDXRef-" + re.sub(r"[^A-Za-z0-9.-]", "-", text)


def package(name, version, licence, **more):
    return {"SPDXID": identifier(name), "name": name, "versionInfo": version, "licenseConcluded": licence, "licenseDeclared": licence,
            "copyrightText": "NOASSERTION", "downloadLocation": "NOASSERTION", "filesAnalyzed": False} | more


# By its way from the folder: the source archive and Python's source distribution have one name.
def released(path, folder):
    checksum = hashlib.sha256(path.read_bytes()).hexdigest()
    return package(str(path.relative_to(folder)), VERSION, "BSD-3-Clause", packageFileName=str(path.relative_to(folder)),
                   copyrightText="Copyright (c) 2026 The Epode authors",
                   checksums=[{"algorithm": "SHA256", "checksumValue": checksum}])


def relation(one, kind, other):
    return {"spdxElementId": one, "relationshipType": kind, "relatedSpdxElement": other}


def document(date, folder, files):
    engine = package("epode", VERSION, "BSD-3-Clause", copyrightText="Copyright (c) 2026 The Epode authors")
    its = [released(Path(name), folder) for name in files]
    used = [package(name, installed(name), licence, comment=f"built into {part}") for part, name, licence in USED]
    return {
        "spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"epode-{VERSION}",
        "documentNamespace": f"https://spdx.org/spdxdocs/epode-{VERSION}-{hashlib.sha256(date.encode()).hexdigest()[:16]}",
        "creationInfo": {"created": date, "creators": ["Organization: The Epode authors", "Tool: tools/sbom.py"]},
        "packages": [engine, *its, *used],
        "relationships": [relation("SPDXRef-DOCUMENT", "DESCRIBES", engine["SPDXID"]),
                          *(relation(each["SPDXID"], "GENERATED_FROM", engine["SPDXID"]) for each in its),
                          *(relation(engine["SPDXID"], "DEPENDS_ON", each["SPDXID"]) for each in used)],
    }


if __name__ == "__main__":
    if len(sys.argv) < 4:
        sys.exit(__doc__)
    VERSION = sys.argv[1]
    json.dump(document(sys.argv[2], Path(sys.argv[3]), sys.argv[4:]), sys.stdout, indent=1)
    print()
