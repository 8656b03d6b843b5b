#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""same_page.py A B: whether two replay pages hold the same, but for the time by the clock of each step.

The numbers are compressed (RFC 1951), so that pages which differ in times alone differ in length as well."""
import base64
import json
import re
import sys
import zlib


def content(path: str) -> tuple[str, bytes]:
    """The page with its data put aside, and the data without times by the clock."""
    text = open(path, encoding="utf-8").read()
    head = json.loads(re.search(r'<script id="head">(.*?)</script>', text, re.S)[1])
    packed = re.search(r'(?<=id="data">)[^<]*', text)
    data = bytearray(zlib.decompress(base64.b64decode(packed[0]), wbits=-15))
    offset, values = head["series"]["ms"]
    data[offset:offset + 4 * values] = bytes(4 * values)
    return text[:packed.start()] + text[packed.end():], bytes(data)


first, second = content(sys.argv[1]), content(sys.argv[2])
sys.exit(0 if first == second and first[1] else 1)
