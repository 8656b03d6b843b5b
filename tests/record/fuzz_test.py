#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Damaged recordings and every verb that reads one: cut off anywhere, with bits turned over, and with bits turned over behind
# checksums that fit, which is what a reader must survive by looking at counts and numbers alone. Every run ends by itself with 0, 1
# or 2, within limits on time and memory that a file of this size has no reason to come near.
#     fuzz_test.py EPODE CLIENT [MUTANTS [SEED]]
import os
import random
import resource
import struct
import subprocess
import sys
import tempfile
import zlib

EPODE, CLIENT = sys.argv[1:3]
MUTANTS = int(sys.argv[3]) if len(sys.argv) > 3 else 40
SEED = int(sys.argv[4]) if len(sys.argv) > 4 else 1
SECONDS = 20  # of processor time for one run; whole files take 0.1
BYTES = 512 << 20  # of address space; libraries are 150 MiB of it, files 100 KiB
HEAD, CHUNK_HEAD = 12, 16


def limited():
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_AS, (BYTES, BYTES))
    resource.setrlimit(resource.RLIMIT_FSIZE, (64 << 20, 64 << 20))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def chunks(data):
    at = HEAD
    while at < len(data):
        size = struct.unpack_from("<Q", data, at + 4)[0]
        yield at, size
        at += CHUNK_HEAD + size + 4


def sign(data, at, size):
    """Checksums that fit what is there."""
    struct.pack_into("<I", data, at + 12, zlib.crc32(data[at : at + 12]))
    end = at + CHUNK_HEAD + size
    struct.pack_into("<I", data, end, zlib.crc32(data[at:end]))


def flip(data, at, rng):
    data[at] ^= 1 << rng.randrange(8)


def mutant(original, rng):
    data = bytearray(original)
    kind = rng.randrange(5)
    if kind == 0:
        return "cut", data[: rng.randrange(len(data))]
    if kind == 1:
        for _ in range(rng.randrange(1, 10)):
            flip(data, rng.randrange(len(data)), rng)
        return "flipped", data
    # Small chunks are as likely as large ones: they have the counts.
    places = rng.sample(list(chunks(original)), k=rng.randrange(1, 4))
    for at, size in places:
        if kind == 2:  # mostly the beginning, where counts are
            for _ in range(rng.randrange(1, 4)):
                flip(data, at + CHUNK_HEAD + rng.randrange(min(size, 64) if rng.random() < 0.7 else size), rng)
        elif kind == 3:  # all ones, or the sign and what is near it
            where = at + CHUNK_HEAD + rng.randrange(max(1, size - 4))
            struct.pack_into("<I", data, where, rng.choice([0xFFFFFFFF, 0x7FFFFFFF, 0x80000000, 1 << 24, 0x7FF00000]))
            if where + 4 > at + CHUNK_HEAD + size:
                continue
        else:  # the length itself
            struct.pack_into("<Q", data, at + 4, size ^ (1 << rng.randrange(64)))
            struct.pack_into("<I", data, at + 12, zlib.crc32(data[at : at + 12]))
            continue
        sign(data, at, size)
    return "signed", data


def main():
    rng = random.Random(SEED)
    worst = 0.0
    kinds, codes = {}, {}
    with tempfile.TemporaryDirectory() as folder:
        path = lambda name: os.path.join(folder, name)
        with open(path("page"), "w") as page:
            page.write("EPODE_TITLE EPODE_HEAD EPODE_DATA")
        os.environ["EPODE_PAGE"] = path("page")
        quiet = {"stdout": subprocess.DEVNULL, "stderr": subprocess.DEVNULL, "check": True}
        subprocess.run([EPODE, "record", "fourbar", "-o", path("a.epr"), "--steps", "30", "--quiet"], **quiet)
        subprocess.run([EPODE, "record", "ragdolls", "-o", path("b.epr"), "--steps", "4", "--quiet"], **quiet)
        subprocess.run([EPODE, "capture", "-o", path("c.epr"), "--", CLIENT], **quiet)
        originals = [open(path(name), "rb").read() for name in ("a.epr", "b.epr", "c.epr")]
        bad, good = path("bad.epr"), path("c.epr")
        runs = [
            ["inspect", bad],
            ["inspect", bad, "--hashes", "--partial"],
            ["diff", bad, good, "--partial"],
            ["convert", bad, path("x.csv"), "--partial"],
            ["convert", bad, path("x.glb"), "--partial"],
            ["convert", bad, path("x.html"), "--partial"],
            ["convert", bad, path("x.epr"), "--partial"],
            ["replay", bad, "--partial", "--quiet"],
            ["replay", bad, "--partial", "--quiet", "--stepper", "fast"],
        ]
        for number in range(MUTANTS):
            kind, data = mutant(originals[number % len(originals)], rng)
            kinds[kind] = kinds.get(kind, 0) + 1
            with open(bad, "wb") as out:
                out.write(data)
            for words in runs:
                before = resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime
                code = subprocess.run([EPODE, *words], preexec_fn=limited, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
                worst = max(worst, resource.getrusage(resource.RUSAGE_CHILDREN).ru_utime - before)
                codes[code.returncode] = codes.get(code.returncode, 0) + 1
                short = code.stderr.decode(errors="replace")
                if code.returncode not in (0, 1, 2) or "enough memory" in short or "bad_alloc" in short:
                    keep = f"/tmp/epode-fuzz-{SEED}-{number}.epr"
                    with open(keep, "wb") as out:
                        out.write(data)
                    sys.exit(f"FAILED: {kind} mutant {number} of seed {SEED}, {' '.join(words[:1] + words[2:])}: "
                             f"{code.returncode} {short[:300]}; kept as {keep}")
    memory = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
    print(f"{MUTANTS} mutants {kinds}, exit codes {codes}, longest {worst:.1f} s, most memory {memory:.0f} MiB")


main()
