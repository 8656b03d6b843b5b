#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""unit_tests.py SOURCE_FOLDER [--together]: pyode's own test-suite, tests/test_xode.py, one line "name outcome" for each test.

All but one of its 111 tests are commented out in the file that pyode ships, for the original library does not survive them;
here the comment signs are taken away. Each test runs in a process of its own, so that a crash is an outcome ("signal 11")
and not the end; with --together all run in this one process, as unittest would.
"""

import os
import re
import sys
import types
import unittest

import falling


def load(folder):
    path = os.path.join(folder, "tests", "test_xode.py")
    with open(path) as file:
        head, body = file.read().split("import unittest\n", 1)
    body = re.sub(r"^# ?", "", body, flags=re.MULTILINE)
    module = types.ModuleType("test_xode")
    exec(compile("import unittest\n" + body, path, "exec"), module.__dict__)
    return list(flatten(unittest.defaultTestLoader.loadTestsFromModule(module)))


def flatten(suite):
    for test in suite:
        if isinstance(test, unittest.TestSuite):
            yield from flatten(test)
        else:
            yield test


def outcome_of(test):
    result = unittest.TestResult()
    test.run(result)
    return "error" if result.errors else "fail" if result.failures else "ok"


def outcome_alone(test):
    """The outcome in a forked process, which ends like a program: everything is destroyed before."""
    reading, writing = os.pipe()
    child = os.fork()
    if child == 0:
        os.close(reading)
        outcome = outcome_of(test)
        test.__dict__.clear()
        os.write(writing, outcome.encode())
        os._exit(0)
    os.close(writing)
    with os.fdopen(reading) as pipe:
        outcome = pipe.read()
    _, status = os.waitpid(child, 0)
    return "signal %d" % os.WTERMSIG(status) if os.WIFSIGNALED(status) else outcome


def main(folder, together=""):
    print("#library", *falling.library(), flush=True)
    for test in load(folder):
        print(test.id().split(".", 1)[1], outcome_of(test) if together else outcome_alone(test), flush=True)
    print("#end", flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:3])
