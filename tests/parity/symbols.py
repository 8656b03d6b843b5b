# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Which functions the original exports, which ours has, which the cases call: names read with nm. The C functions
# of the interface are those that begin with d and a capital; the original exports a few private ones as well.
import re
import subprocess
from pathlib import Path

INTERFACE_NAME = re.compile(r"d[A-Z]\w*$")


def names(file, *flags):
    lines = subprocess.run(["nm", *flags, str(file)], check=True, capture_output=True, text=True).stdout.splitlines()
    found = {line.split()[-1].split("@")[0] for line in lines if line.strip()}
    return {name for name in found if INTERFACE_NAME.match(name)}


def exported(library):
    return names(library, "-D", "--defined-only")


def called(program):
    return names(program, "-D", "--undefined-only")


def called_by_object(objects):
    """Case file (stem) to the functions its object calls."""
    return {Path(o).name.split(".")[0]: names(o, "--undefined-only") for o in objects}
