# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Letters of 5 by 7 dots for panels in windows, which then need no font of the system: printable ASCII, column by column, the lowest bit
on top."""
from __future__ import annotations

import numpy as np
from numpy.typing import NDArray

Pixels = NDArray[np.uint8]
_COLUMNS = bytes.fromhex(
    "0000000000 00005f0000 0007000700 147f147f14 242a7f2a12 2313086462 3649562050 0008070300 001c224100 0041221c00 2a1c7f1c2a"
    "08083e0808 0080703000 0808080808 0000606000 2010080402 3e5149453e 00427f4000 7249494946 2141494d33 1814127f10 2745454539"
    "3c4a494931 4121110907 3649494936 464949291e 0000140000 0040340000 0008142241 1414141414 0041221408 0201590906 3e415d594e"
    "7c1211127c 7f49494936 3e41414122 7f4141413e 7f49494941 7f09090901 3e41415173 7f0808087f 00417f4100 2040413f01 7f08142241"
    "7f40404040 7f021c027f 7f0408107f 3e4141413e 7f09090906 3e4151215e 7f09192946 2649494932 03017f0103 3f4040403f 1f2040201f"
    "3f4038403f 6314081463 0304780403 6159494d43 007f414141 0204081020 004141417f 0402010204 4040404040 0003070800 2054547840"
    "7f28444438 3844444428 384444287f 3854545418 00087e0902 18a4a49c78 7f08040478 00447d4000 2040403d00 7f10284400 00417f4000"
    "7c04780478 7c08040478 3844444438 fc18242418 18242418fc 7c08040408 4854545424 04043f4424 3c4040207c 1c2040201c 3c4030403c"
    "4428102844 4c9090907c 4464544c44 0008364100 0000770000 0041360800 0201020402")
DOTS = np.unpackbits(np.frombuffer(_COLUMNS, np.uint8).reshape(-1, 5), axis=1, bitorder="little").reshape(-1, 5, 8).transpose(0, 2, 1)
WIDE, HIGH = 6, 8  # of a letter with its gap, in dots


def text_dots(text: str) -> NDArray[np.bool_]:
    """The dots of a text, 8 rows; "?" for what is no printable ASCII."""
    codes = [ord(one) - 32 if 32 <= ord(one) < 127 else ord("?") - 32 for one in text]
    out = np.zeros((HIGH, WIDE * len(codes)), bool)
    for i, code in enumerate(codes):
        out[:, WIDE * i:WIDE * i + 5] = DOTS[code]
    return out


def put_text(pixels: Pixels, text: str, x: int, y: int, color: tuple[int, int, int], scale: int = 1, right: int | None = None) -> int:
    """Write a text into pixels, from x, y on, or up to `right`; what does not fit is cut. Returns its width in pixels."""
    dots = np.kron(text_dots(text), np.ones((scale, scale), bool))
    if right is not None:
        x = max(x, right - dots.shape[1])
        dots = dots[:, :max(0, right - x)]
    dots = dots[:max(0, pixels.shape[0] - y), :max(0, pixels.shape[1] - x)]
    pixels[y:y + dots.shape[0], x:x + dots.shape[1]][dots] = color
    return int(dots.shape[1])
