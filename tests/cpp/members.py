#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""members.py LEAST PROGRAM HEADER...: every public member function of the wrapper classes in the headers, at least
so many, has a check of its own in the output of PROGRAM (class::member, perhaps with more words)."""
import re
import subprocess
import sys


def members(path):
    """(class, member) pairs of the public functions, without constructors, destructors and operators."""
    text = re.sub(r"/\*.*?\*/|//[^\n]*", "", open(path, encoding="utf-8").read(), flags=re.S)
    text = re.sub(r"\n\s+(?=: public )|(?<=,)\n\s+", " ", text)
    name, public = None, False
    for line in text.splitlines():
        head = re.match(r"(?:template <.*> )?(?:class|struct) (?:ODE_API_DEPRECATED )?(d\w+)(?: :.*)? ?{", line)
        if head:
            name, public = head.group(1), "struct" in line
        elif line.startswith("};"):
            name = None
        elif line.strip() in ("public:", "protected:", "private:"):
            public = line.strip() == "public:"
        elif name and public:
            found = re.match(r"    (?:virtual )?(?:const )?[\w:]+(?: long)?\*? (\w+)\(", line)
            if found and found.group(1) != name and "operator" not in line:
                yield name, found.group(1)


def main():
    output = subprocess.run([sys.argv[2]], capture_output=True, text=True, check=False).stdout
    checks = {line.split()[0] for line in output.splitlines()}
    wanted = {pair for path in sys.argv[3:] for pair in members(path)}
    # What makes joints is one template; its member is checked once for each type of joint.
    missing = [f"{c}::{m}" for c, m in sorted(wanted)
               if c != "dMadeJointTemplate" and "Container" not in c and f"{c}::{m}" not in checks]
    print(f"{len(wanted)} members of {len({c for c, _ in wanted})} classes, {len(missing)} without a check")
    print("\n".join(missing), file=sys.stderr)
    return bool(missing) or len(wanted) < int(sys.argv[1])


if __name__ == "__main__":
    sys.exit(main())
