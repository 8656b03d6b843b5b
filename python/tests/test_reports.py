# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What steps tell of themselves: reports, the energy ledger, causes, and kinds with names."""
import enum
import inspect
import re

import numpy as np
import pytest

import epode
from epode import c


def test_kinds_are_those_of_the_headers():
    """Each class has a name for every number of the C enumeration that its text names."""
    numbers = {name: value for name, value in vars(c).items() if type(value) is int and re.match(r"d[A-Z]", name)}
    classes = [one for _, one in inspect.getmembers(epode, inspect.isclass) if issubclass(one, enum.IntEnum | enum.IntFlag)]
    assert len(classes) == 15
    prefixes = {"EventKind": r"dEvent(?!Gone)", "EventGone": "dEventGone", "ContactEventKind": "dContact(?=Begin|Persist|End)",
                "CombineRule": "dCombine", "CauseKind": "dDiagnosis", "Severity": "dSeverity", "IslandMethod": "dIslandMethod",
                "Behaviour": "dBehaviour", "Falloff": "dFalloff", "CharacterState": "dCharacter(?=InAir|OnSteep|OnGround)",
                "VehicleKind": "dVehicle(?=Car|Bike|Tracked)", "WheelCast": "dWheel(?=Ray|Sphere|Cylinder)", "Differential": "dDifferential",
                "BoneJoint": "dBone(?=Hinge|Universal|Ball|Fixed)", "RopeEnds": "dRope(?=Loose|From|To|Both)"}
    for one in classes:
        wanted = {value for name, value in numbers.items() if re.match(prefixes[one.__name__], name)}
        if one.__name__ == "CharacterState":
            wanted.add(0)  # has not moved yet: no enumerator of C
        assert {int(member) for member in one.__members__.values()} == wanted and wanted, one
        assert re.search(r"``c\.(d\w+)``", one.__doc__)


def test_ledgers_and_reports_name_every_island():
    world = epode.World()
    world.plane()
    ball = world.body(mass=2, position=(0, 0, 1), shape=epode.Sphere(0.2), material=epode.Material(bounce=0.5))
    far = world.body(mass=1, position=(9, 0, 50))
    assert world.ledger() is None and world.report() is None and world.island_reports() == [] and world.island_ledgers() == []
    world.keeps_ledger = world.reports = True
    sums = dict.fromkeys(("gravity", "impacts", "correction", "integration"), 0.0)
    for _ in range(100):
        world.step(0.005)
        ledger = world.ledger()
        shares = sum(getattr(ledger, name) for name in ("gravity", "forces", "drives", "friction", "impacts", "joints", "damping",
                                                         "correction", "integration"))
        assert ledger.kinetic_after - ledger.kinetic_before == pytest.approx(shares, abs=1e-9)
        for name in sums:
            sums[name] += getattr(ledger, name)
    assert sums["impacts"] < -1 and sums["gravity"] == pytest.approx(
        9.81 * (2 * (1 - ball.position[2]) + 50 - far.position[2]), rel=1e-9)
    islands, ledgers = world.island_reports(), world.island_ledgers()
    assert len(islands) == len(ledgers) == world.report().islands == 2
    assert {island.bodies for island in islands} == {1} and {i.body for i in islands} == {ball._handle, far._handle}
    assert all(isinstance(epode.IslandMethod(island.method), epode.IslandMethod) for island in islands)
    assert sum(one.kinetic_after for one in ledgers) == pytest.approx(ledger.kinetic_after)


def test_causes_name_objects_of_python():
    world = epode.World()
    world.diagnosing = True
    thrown = world.body(mass=1)
    world.step(0.01)
    thrown.velocity = (1e9, 0, 0)
    world.step(0.01)
    cause = world.diagnose()[0]
    assert cause.kind is epode.CauseKind.INPUT and cause.body is thrown and cause.geom is None and cause.text
    assert isinstance(cause.severity, epode.Severity) and cause.figure > cause.threshold
    thrown.destroy()
    assert world.diagnose()[0].body is None


def test_events_and_broken_joints_have_names():
    world = epode.World()
    floor = world.plane()
    world.list_events()
    ball = world.body(mass=1, position=(0, 0, 0.21), shape=epode.Sphere(0.2))
    hung = world.body(mass=5, position=(3, 0, 5))
    rope = world.joint("ball", hung, anchor=(3, 0, 5))
    rope.break_limits = (20, float("inf"))
    kinds = []
    for _ in range(20):
        world.step(0.01)
        kinds += [epode.EventKind(kind) for kind in world.events["kind"]]
        if world.broken_joints():
            assert world.broken_joints() == [rope] and rope.broken
    assert kinds[0] is epode.EventKind.JOINT_BREAK and epode.EventKind.CONTACT_BEGIN in kinds
    first = epode.ContactEventKind(world.contact_events["kind"][0])
    assert first is epode.ContactEventKind.PERSIST and {floor, ball.geoms[0]} == {world.geom_of(world.contact_events[key][0]) for key in ("g1", "g2")}


def test_behaviour_is_a_name():
    world = epode.World()
    assert world.behaviour is epode.Behaviour.EPODE_1
    world.behaviour = epode.Behaviour.ODE_016
    assert world.behaviour is epode.Behaviour.ODE_016
    with pytest.raises(epode.RefusedError):
        world.behaviour = 7


def test_feedback_is_what_a_joint_bears():
    world = epode.World()
    bob = world.body(mass=3, position=(0, 0, -1))
    joint = world.joint("fixed", bob)
    joint.feedback
    world.step(0.01, steps=2)
    np.testing.assert_allclose(joint.feedback.f1, (0, 0, 3 * 9.81), atol=1e-9)
