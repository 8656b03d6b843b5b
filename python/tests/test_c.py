# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The C API in Python: all of it, with its texts, and no call that ends the process."""
import ast
import inspect
import os
import random
from importlib import resources

import numpy as np
import pytest

import epode
from epode import c


def test_every_public_function_is_reached_or_has_a_reason():
    coverage = c.coverage()
    assert len(coverage) > 700
    for name, how in coverage.items():
        if how in ("generated", "written"):
            assert callable(getattr(c, name, None)), f"{name} is {how}, but not there"
        else:
            assert how.startswith("left out: ") and len(how) > 20, f"{name}: {how}"
    assert sum(how.startswith("left out") for how in coverage.values()) <= 138


def test_functions_have_the_texts_of_the_headers():
    assert "exact solver" in c.dWorldStep.__doc__


def test_what_is_written_is_returned():
    world = c.dWorldCreate()
    c.dWorldSetGravity(world, 1, 2, 3)
    np.testing.assert_array_equal(c.dWorldGetGravity(world), (1, 2, 3))
    np.testing.assert_array_equal(c.dRFromAxisAndAngle(0, 0, 1, 0), np.eye(3))
    hinge = c.dJointCreateHinge(world, None)
    assert c.dJointGetBreakLimits(hinge) == (0, float("inf"), float("inf"))
    c.dWorldDestroy(world)
    with pytest.raises(epode.RefusedError):
        c.dWorldGetGravity(world)


def test_handles_have_types():
    body = c.dBodyCreate(c.dWorldCreate())
    with pytest.raises(TypeError):
        c.dWorldStep(body, 0.1)
    space = c.dHashSpaceCreate(None)
    assert isinstance(space, c.dGeomID) and c.dGeomIsSpace(space)
    assert isinstance(c.dCreateSphere(space, 1), c.dGeomID)


# Not called at random: they are about the process, or print.
SPARED = {"dRandSetSeed", "dTestDataStructures"}
NUMBERS = (0, 1, 1, -1, 2, 0.5, 3, 0.1, 1e300, float("nan"), float("inf"))


def parameter_types():
    """{function: what _c.pyi says of each parameter}."""
    tree = ast.parse(resources.files("epode").joinpath("_c.pyi").read_text())
    return {f.name: [ast.unparse(a.annotation) for a in f.args.args] for f in tree.body if isinstance(f, ast.FunctionDef)}


def value(rng, kind, handles):
    """Mostly what a parameter of a type takes, bad or good; now and then anything."""
    kind = kind.split(" | ")[0] if rng.random() < 0.95 else "anything"
    if kind == "float":
        return rng.choice(NUMBERS)
    if kind in ("int", "bool"):
        return rng.choice((0, 0, 1, 1, 2, 3, 7, -1))
    same = [h for h in handles if type(h).__name__ == kind or kind == "dGeomID" and isinstance(h, c.dGeomID)]
    if same:
        return rng.choice(same) if rng.random() < 0.97 else None
    if kind == "bytes":
        return rng.choice((b"", b"bytes", b"x" * 1000))
    if kind == "str":
        return rng.choice(("", "ODE"))
    if kind.startswith("Callable"):
        return rng.choice((lambda *a: 1, lambda *a: 1 / 0, lambda *a: None))
    if kind.startswith("Sequence"):
        return [value(rng, kind[9:-1], handles) for _ in range(rng.randrange(4))]
    if kind == "ArrayLike":
        shapes = (3, 3, 4, 12, 0, (3, 3), (4, 3))
        number = (lambda: rng.uniform(-2, 2)) if rng.random() < 0.8 else (lambda: rng.choice(NUMBERS))
        size = rng.choice(shapes)
        array = np.array([number() for _ in range(int(np.prod(size)))]).reshape(size)
        return rng.choice((array, array, array, array.tolist(), array.astype(int, casting="unsafe") if np.isfinite(array).all() else None))
    return rng.choice((None, "text", b"bytes", [], [1, 2, 3], {}, 1, np.zeros((0, 3)), rng.choice(handles)))


def test_random_calls_never_crash():
    rng = random.Random(int(os.environ.get("EPODE_HOSTILE_SEED", 29)))
    names = [n for n, how in c.coverage().items() if not how.startswith("left out") and n not in SPARED]
    structures = [getattr(c, n) for n in dir(c) if inspect.isclass(getattr(c, n)) and n.startswith("d") and not n.endswith("ID")]
    types = parameter_types()
    handles, answered, refused = [], set(), 0
    calls = int(os.environ.get("EPODE_HOSTILE_CALLS", 100_000))  # scripts/nightly wants a million, and 10,000 under the address sanitizer

    def refill():
        handles.clear()
        world, space = c.dWorldCreate(), c.dHashSpaceCreate(None)
        bodies = [c.dBodyCreate(world) for _ in range(3)]
        joints = [getattr(c, n)(world, None) for n in names if n.startswith("dJointCreate") and n != "dJointCreateContact"]
        geoms = [c.dCreateSphere(space, 1), c.dCreateBox(space, 1, 1, 1), c.dCreatePlane(space, 0, 0, 1, 0)]
        data = [c.dGeomTriMeshDataCreate(), c.dGeomHeightfieldDataCreate(), c.dJointGroupCreate(0)]
        handles.extend([world, space, *bodies, *joints[:8], *geoms, *data, *(s() for s in structures),
                        c.dWorldGetBodies(world), c.dWorldGetJoints(world)])
    import warnings
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        for i in range(calls):
            if i % 500 == 0:
                refill()
            name = rng.choice(names)
            try:
                result = getattr(c, name)(*[value(rng, kind, handles) for kind in types[name]])
                answered.add(name)
            except epode.RefusedError:
                refused += 1
                continue
            except Exception:
                continue
            if type(result).__name__.endswith("ID") and len(handles) < 200:
                handles.append(result)
    assert refused > calls / 10 and (calls < 100_000 or len(answered) > 0.8 * len(names))


def test_handles_are_compared_with_anything():
    with epode.World() as world:
        body = world.body(mass=1)
        same, other = epode.c.dWorldGetBodies(world._handle)[0], world.body(mass=1)._handle
        assert body._handle == same and not body._handle == other and body._handle != other
        assert not body._handle == None and body._handle != None and body._handle != 3 and body._handle not in [None, "x"]  # noqa: E711
