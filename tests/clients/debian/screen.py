# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Pictures of an X screen: reads what xwd writes (X11/XWDFile.h: 25 big-endian words, names, colours, rows), compares, writes PNG."""

import struct
import zlib


class Picture:
    def __init__(self, path):
        with open(path, "rb") as file:
            data = file.read()
        header = struct.unpack(">25I", data[:100])
        self.width, self.height, self.bytes, self.stride, colours = header[4], header[5], header[11] // 8, header[12], header[19]
        if self.bytes not in (3, 4):
            raise ValueError("%s: %d bytes a pixel, wanted 3 or 4" % (path, self.bytes))
        self.pixels = data[header[0] + 12 * colours:]

    def rows(self):
        """Rows of bytes red, green, blue (least significant byte first in the file: blue)."""
        for y in range(self.height):
            row = self.pixels[y * self.stride:y * self.stride + self.bytes * self.width]
            line = bytearray(3 * self.width)
            line[0::3], line[1::3], line[2::3] = row[2::self.bytes], row[1::self.bytes], row[0::self.bytes]
            yield bytes(line)

    def colours(self):
        return len({row[i:i + 3] for row in self.rows() for i in range(0, len(row), 3)})

    def write_png(self, path):
        def chunk(kind, body):
            return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))

        raw = b"".join(b"\0" + row for row in self.rows())
        with open(path, "wb") as file:
            file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)))
            file.write(chunk(b"IDAT", zlib.compress(raw, 6)) + chunk(b"IEND", b""))


def differing_share(first, second, part=None):
    """The share of pixels, in all or a part (left, top, right, bottom), that differ by more than 16 of 255 in some colour."""
    if (first.width, first.height) != (second.width, second.height):
        return 1.0
    left, top, right, bottom = part or (0, 0, first.width, first.height)
    count = 0
    for y, (a, b) in enumerate(zip(first.rows(), second.rows())):
        if top <= y < bottom and a != b:
            count += sum(max(abs(a[i + k] - b[i + k]) for k in range(3)) > 16 for i in range(3 * left, 3 * right, 3))
    return count / ((right - left) * (bottom - top))
