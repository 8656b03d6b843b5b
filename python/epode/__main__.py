# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""``python -m epode``, and ``epode`` where the package is installed: the command, with the same words and exit codes, and ``epode sweep``."""
import sys

from . import _c
from .recording import _use_page


def main() -> int:
    """Run the command with the words of sys.argv; returns its exit code."""
    if sys.argv[1:2] == ["sweep"]:
        from .sweep.command import main as sweep
        return sweep(sys.argv[2:])
    if not hasattr(_c, "run_command"):
        print("epode: this build has no command: libcli11-dev and libfmt-dev were not there when it was built", file=sys.stderr)
        return 1
    _use_page()
    return _c.run_command(["epode", *sys.argv[1:]])


if __name__ == "__main__":
    sys.exit(main())
