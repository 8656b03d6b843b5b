# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Batches of a build, through the C functions, for benchmarks."""
import ctypes
import sys

import numpy as np

POSITIONS, VELOCITIES, CONTROLS, RESIDUAL, SWEEPS = 0, 1, 2, 6, 7
DIFFERENCES, EXACT = 0, 1


class Options(ctypes.Structure):
    _fields_ = [(name, ctypes.c_uint if name == "struct_size" else ctypes.c_int)
                for name in ("struct_size", "doubles", "threads", "max_sweeps")]
    _fields_ += [(name, ctypes.c_double) for name in ("stepsize", "erp", "max_correction", "reach", "tolerance")] + [("pinned", ctypes.c_int)]


def load(build):
    ctypes.CDLL(str(build / "lib/libode.so"), mode=ctypes.RTLD_GLOBAL).dInitODE2(0)
    library = ctypes.CDLL(str(build / "lib/libepode_robots.so"))
    p, i, d = ctypes.c_void_p, ctypes.c_int, ctypes.c_double
    for name, result, arguments in (("dRobotModelLoad", p, [ctypes.c_char_p, p]), ("dBatchCreate", p, [p, i, p]),
                                    ("dBatchGetSize", i, [p, i]), ("dBatchStep", i, [p, i]), ("dBatchCountBad", i, [p]),
                                    ("dBatchRead", i, [p, i, i, i, p]), ("dBatchWrite", i, [p, i, i, i, p]), ("dBatchDestroy", None, [p]),
                                    ("dBatchGetTangentSize", i, [p]), ("dBatchLinearise", i, [p, i, d, i, i, p, p])):
        getattr(library, name).restype, getattr(library, name).argtypes = result, arguments
    return library


class Batch:
    def __init__(self, library, path, copies, doubles, stepsize):
        options = Options()
        library.dBatchOptionsInit(ctypes.byref(options), ctypes.sizeof(options))
        options.doubles, options.threads, options.stepsize = int(doubles), 1, stepsize
        model = library.dRobotModelLoad(str(path).encode(), None)
        self.id = library.dBatchCreate(model, copies, ctypes.byref(options))
        if not self.id:
            sys.exit(f"{path}: refused")
        self.library, self.copies, self.type = library, copies, np.float64 if doubles else np.float32

    def read(self, quantity):
        out = np.empty((self.copies, self.library.dBatchGetSize(self.id, quantity)), self.type)
        self.library.dBatchRead(self.id, quantity, 0, self.copies, out.ctypes.data)
        return out

    def run(self, controls):
        for k in range(0, controls.shape[1], 5):
            now = np.ascontiguousarray(controls[:, k], self.type)
            self.library.dBatchWrite(self.id, CONTROLS, 0, self.copies, now.ctypes.data)
            self.library.dBatchStep(self.id, 5)

    def write(self, quantity, values):
        values = np.ascontiguousarray(values, self.type)
        if not self.library.dBatchWrite(self.id, quantity, 0, self.copies, values.ctypes.data):
            sys.exit("refused")

    def linearise(self, method, distance=0):
        n, controls = self.library.dBatchGetTangentSize(self.id), self.library.dBatchGetSize(self.id, CONTROLS)
        a, b = np.empty((self.copies, n, n), self.type), np.empty((self.copies, n, controls), self.type)
        self.library.dBatchLinearise(self.id, method, distance, 0, self.copies, a.ctypes.data, b.ctypes.data)
        return a, b
