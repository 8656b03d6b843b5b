# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Long calls in portions, so that Ctrl-C ends them."""
from __future__ import annotations

import time
from collections.abc import Iterator

_SECONDS, _GROWTH = 0.05, 8


def portions(steps: int) -> Iterator[int]:
    """Numbers that add up to steps, each of what takes about a twentieth of a second: signals are heard between them."""
    size = 1
    while steps > 0:
        portion = min(size, steps)
        begin = time.perf_counter()
        yield portion
        steps -= portion
        share = _SECONDS / max(time.perf_counter() - begin, 1e-9)
        size = max(1, min(int(portion * share), _GROWTH * size))
