# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Files of xacro: read by the package or the program of that name, and refused with a sentence that says so where neither is there."""
import os
import pickle
import stat
import sys

import numpy as np
import pytest

import epode

ARM = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="arm"><xacro:property name="m" value="1.5"/>
<xacro:include filename="$(find arm_parts)/link.xacro"/><link name="world"/><xacro:rod name="rod" mass="${2 * m}"/>
<joint name="pivot" type="continuous"><parent link="world"/><child link="rod"/><axis xyz="0 1 0"/></joint></robot>"""
LINK = """<robot xmlns:xacro="http://www.ros.org/wiki/xacro"><xacro:macro name="rod" params="name mass"><link name="${name}"><inertial>
<origin xyz="0 0 ${-1/4}"/><mass value="${mass}"/><inertia ixx=".1" iyy=".1" izz=".01" ixy="0" ixz="0" iyz="0"/></inertial></link></xacro:macro></robot>"""


@pytest.fixture
def arm(tmp_path):
    (tmp_path / "arm_parts").mkdir()
    (tmp_path / "robots").mkdir()
    (tmp_path / "arm_parts" / "link.xacro").write_text(LINK)
    path = tmp_path / "robots" / "arm.urdf.xacro"
    path.write_text(ARM)
    return path


def test_a_file_of_xacro_is_read_with_its_packages_found_by_name(arm):
    pytest.importorskip("xacro")
    model = epode.load(arm)
    assert model.joint_names == ["pivot"] and model.actuator_names == ["pivot"]
    assert np.isclose(model.mass_matrix([0])[0, 0], 0.1 + 3 * 0.0625)
    assert pickle.loads(pickle.dumps(model)) == model
    assert epode.robot.check(arm) == []
    arm.write_text(ARM.replace("arm_parts", "leg_parts"))
    with pytest.raises(epode.RefusedError, match="no package 'leg_parts'"):
        epode.load(arm)
    arm.write_text(ARM.replace("2 * m", "2 * n"))
    with pytest.raises(epode.RefusedError, match="xacro says"):
        epode.load(arm)


def test_without_the_package_its_program_is_called(arm, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "xacro", None)  # as if it were not installed
    monkeypatch.setenv("PATH", str(tmp_path))
    with pytest.raises(epode.RefusedError, match="pip install xacro, or Debian's package xacro"):
        epode.load(arm)
    program = tmp_path / "xacro"
    program.write_text("#!/bin/sh\necho \"<robot name='made'><link name='world'/></robot>\"\n")
    program.chmod(program.stat().st_mode | stat.S_IEXEC)
    assert epode.load(arm).name == "made"
    program.write_text("#!/bin/sh\necho nothing of it >&2\nexit 2\n")
    with pytest.raises(epode.RefusedError, match="xacro says: nothing of it"):
        epode.load(arm)
    with pytest.raises(epode.RefusedError, match="is no file"):
        epode.load(os.fspath(tmp_path / "none.xacro"))


def test_a_text_with_macros_is_refused_with_what_expands_it():
    with pytest.raises(epode.RefusedError, match="this is xacro, macros for URDF"):
        epode.robot.from_text(ARM)
    plain = "<robot xmlns:xacro='http://www.ros.org/wiki/xacro' name='r'><link name='world'/></robot>"  # what xacro leaves
    assert epode.robot.from_text(plain).name == "r"
