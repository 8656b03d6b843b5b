# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""One program on two libraries in turn: what bench/exact and bench/accuracy share."""
import argparse
import os
import platform
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def parser(description):
    """Options that say which program runs on which libraries."""
    made = argparse.ArgumentParser(description=description)
    made.add_argument('--bench', default=ROOT + '/build/release/bin/epode_bench')
    made.add_argument('--ours', default=ROOT + '/build/release/lib')
    made.add_argument('--other', default=f'/usr/lib/{platform.machine()}-linux-gnu')
    return made


def parse(made):
    options = made.parse_args()
    for path in (options.bench, options.ours + '/libode.so.8', options.other + '/libode.so.8'):
        if not os.path.exists(path):
            made.error(f'there is no {path}')
    libraries = [library(options, folder) for folder in (options.ours, options.other)]
    if libraries[0] == libraries[1]:
        made.error(f'both runs use {libraries[0]}; the program does not follow LD_LIBRARY_PATH')
    print(f'ours   {libraries[0]}\nother  {libraries[1]}')
    return options


def library(options, folder):
    return run(options, folder, ['library']).stdout.strip()


def run(options, folder, arguments, given=None):
    environment = dict(os.environ, LD_LIBRARY_PATH=folder)
    return subprocess.run([options.bench] + arguments, env=environment, input=given, capture_output=True, text=True, check=False)


def median(values):
    values = sorted(values)
    middle = len(values) // 2
    return values[middle] if len(values) % 2 else (values[middle - 1] + values[middle]) / 2
