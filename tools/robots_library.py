# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""epode/robots.h for the scripts that judge it: models through the C API, as any program would use it."""
import ctypes
import pathlib

import numpy as np

NOTES = ("changed", "approximated", "ignored", "error")


class Options(ctypes.Structure):
    _fields_ = [("struct_size", ctypes.c_uint)] + [(name, ctypes.c_int) for name in (
        "strict", "keep_fixed", "fixed_base", "repair", "inertia_from_shapes", "meshes_as_triangles")] + [
            ("missing_mass", ctypes.c_double), ("roots", ctypes.c_char_p), ("meshes_as_parts", ctypes.c_int), ("max_parts", ctypes.c_int),
            ("max_part_vertices", ctypes.c_int), ("part_tolerance", ctypes.c_double)]


class Line(ctypes.Structure):
    _fields_ = [("note", ctypes.c_int), ("line", ctypes.c_int), ("file", ctypes.c_char_p), ("text", ctypes.c_char_p)]


class Link(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("parent", ctypes.c_int), ("joints", ctypes.c_int), ("shapes", ctypes.c_int),
                ("mass", ctypes.c_double), ("centre", ctypes.c_double * 4), ("inertia", ctypes.c_double * 12)]


class Joint(ctypes.Structure):
    _fields_ = [("name", ctypes.c_char_p), ("kind", ctypes.c_int), ("link", ctypes.c_int), ("position", ctypes.c_int),
                ("anchor", ctypes.c_double * 4), ("axis", ctypes.c_double * 4), ("low", ctypes.c_double), ("high", ctypes.c_double),
                ("max_force", ctypes.c_double), ("max_velocity", ctypes.c_double)]


class Model:
    """A loaded model."""

    def __init__(self, library, path, root, **options):
        its = Options(roots=str(root).encode(), **options)
        its.struct_size = ctypes.sizeof(Options)
        self.library = library
        self.handle = library.dRobotModelLoad(str(path).encode(), ctypes.byref(its))
        self.report = [(NOTES[x.note], x.line, x.text.decode(errors="replace")) for x in self.array("Report", Line)]
        self.errors = [text for note, _, text in self.report if note == "error"]

    def array(self, what, kind):
        get = getattr(self.library, f"dRobotModelGet{what}")
        count = get(self.handle, None, 0)
        out = (kind * max(1, count))()
        get(self.handle, out, count)
        return out[:count]

    def links(self):
        return self.array("Links", Link)

    def joints(self):
        return self.array("Joints", Joint)

    def poses(self, q):
        count = self.library.dRobotModelGetLinks(self.handle, None, 0)
        out = np.zeros(7 * count)
        pointer = ctypes.POINTER(ctypes.c_double)
        q = np.ascontiguousarray(q, dtype=float)
        self.library.dRobotModelGetPoses(self.handle, q.ctypes.data_as(pointer), len(q), out.ctypes.data_as(pointer), count)
        return out.reshape(count, 7)

    def positions(self):
        return self.library.dRobotModelGetNumPositions(self.handle)

    def numbers(self, function, q, *more):
        """What a function writes to an array at its end."""
        pointer, its = ctypes.c_void_p, getattr(self.library, f"dRobotModelGet{function}")
        q = np.ascontiguousarray(q, dtype=float)
        arguments = [pointer(self.handle), pointer(q.ctypes.data)] + [
            pointer(one.ctypes.data) if isinstance(one, np.ndarray) else pointer(None) if one is None else ctypes.c_int(one) for one in more]
        out = np.zeros(its(*arguments, pointer(None), 0))
        its(*arguments, pointer(out.ctypes.data), len(out))
        return out

    def tendons(self, q):
        """Their lengths and the matrix of their moments."""
        pointer, its = ctypes.c_void_p, self.library.dRobotModelGetTendons
        q = np.ascontiguousarray(q, dtype=float)
        count = its(pointer(self.handle), pointer(q.ctypes.data), None, None, 0)
        lengths = np.zeros(count)
        moments = np.zeros((count, self.library.dRobotModelGetNumVelocities(pointer(self.handle))))
        its(pointer(self.handle), pointer(q.ctypes.data), pointer(lengths.ctypes.data), pointer(moments.ctypes.data), count)
        return lengths, moments

    def close(self):
        self.library.dRobotModelDestroy(self.handle)


def load_library(path):
    library = ctypes.CDLL(path)
    library.dRobotModelLoad.restype = ctypes.c_void_p
    pointer = ctypes.POINTER(ctypes.c_double)
    library.dRobotModelLoad.argtypes = [ctypes.c_char_p, ctypes.c_void_p]
    for what in ("Report", "Links", "Joints"):
        getattr(library, f"dRobotModelGet{what}").argtypes = [ctypes.c_void_p, ctypes.c_void_p, ctypes.c_int]
    library.dRobotModelGetNumPositions.argtypes = [ctypes.c_void_p]
    library.dRobotModelGetPoses.argtypes = [ctypes.c_void_p, pointer, ctypes.c_int, pointer, ctypes.c_int]
    library.dRobotModelDestroy.argtypes = [ctypes.c_void_p]
    return library


def silence(path):
    """Sends the messages of the library next to the file path nowhere, as long as the returned object lives."""
    handler = ctypes.CFUNCTYPE(None, ctypes.c_int, ctypes.c_char_p, ctypes.c_void_p)(lambda *_: None)
    ode = ctypes.CDLL(str(pathlib.Path(path).parent / "libode.so.8"))
    ode.dSetMessageHandler(handler)
    return ode, handler
