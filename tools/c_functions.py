# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The public headers as a C compiler sees them, for what is generated from them: the hostile calls (tests/hostile) and
the Python package (python/tools). Exported functions begin with the word EPODE_EXPORTED."""
import glob
import os
import re
import subprocess


# Headers that others include for their programs, and those of C++, which export nothing.
INCLUDED_BY_OTHERS = r"(collision_trimesh|odemath_legacy|odecpp\w*)\.h$"


def preprocessed(include, cc):
    """All headers, in one line."""
    headers = sorted(glob.glob(os.path.join(include, "ode", "*.h")))
    text = "".join(f'#include "{h}"\n' for h in headers if not re.search(INCLUDED_BY_OTHERS, h))
    command = [cc, "-E", "-P", "-x", "c", "-DODE_API=EPODE_EXPORTED", "-I" + include, "-"]
    out = subprocess.run(command, input=text, capture_output=True, text=True, check=True).stdout
    return " ".join(re.sub(r"__attribute__\s*\(\(.*?\)\)", "", out).split())


def split(parameters):
    """The parameters of a function; commas inside a callback's own list do not count."""
    parts, depth, part = [], 0, ""
    for c in parameters + ",":
        if c == "," and depth == 0:
            parts.append(part.strip())
            part = ""
            continue
        depth += (c == "(") - (c == ")")
        part += c
    return [p for p in parts if p not in ("", "void", "...")]
