# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Time to load the largest files of the packages, alongside MuJoCo's compiler and Pinocchio: a file's own text alone and with its meshes.
MuJoCo makes hulls and trees of meshes when it compiles, so ours has them too: a first robot in a world. Pinocchio's model has no geometry,
its geometry model reads the meshes by assimp. Processor time (of all threads) of the fastest of several runs in one process, files in the cache."""
import ctypes
import pathlib
import re
import site
import time

from robots_library import Model, load_library, silence

RUNS = 7


def fastest_ms(action):
    times = []
    for _ in range(RUNS):
        start = time.process_time()
        action()
        times.append(time.process_time() - start)
    return 1e3 * min(times)


class Ours:
    def __init__(self, path):
        self.library, (self.ode, self.handler) = load_library(path), silence(path)
        self.ode.dWorldCreate.restype = self.library.dRobotCreate.restype = ctypes.c_void_p
        self.ode.dSimpleSpaceCreate.restype = ctypes.c_void_p
        self.library.dRobotCreate.argtypes = [ctypes.c_void_p] * 5
        for function in (self.library.dRobotDestroy, self.ode.dWorldDestroy, self.ode.dSpaceDestroy, self.ode.dSimpleSpaceCreate):
            function.argtypes = [ctypes.c_void_p]

    def load(self, path, root):
        model = Model(self.library, path, root, repair=1, missing_mass=1e-3)
        assert not model.errors, model.errors[0]
        return model

    def model(self, path, root):
        self.load(path, root).close()

    def built(self, path, root):
        model = self.load(path, root)
        world, space = self.ode.dWorldCreate(), self.ode.dSimpleSpaceCreate(None)
        robot = self.library.dRobotCreate(world, space, model.handle, None, None)
        self.library.dRobotDestroy(robot)
        self.ode.dSpaceDestroy(space)
        self.ode.dWorldDestroy(world)
        model.close()

    def second(self, path, root):
        """us for a robot of a model that has been built before, and its end."""
        model = self.load(path, root)
        world, space = self.ode.dWorldCreate(), self.ode.dSimpleSpaceCreate(None)
        make = lambda: self.library.dRobotDestroy(self.library.dRobotCreate(world, space, model.handle, None, None))
        make()
        return 1e3 * fastest_ms(make)


def without_meshes(path):
    """A copy next to the file in which no mesh is named: its text alone is read."""
    text = re.sub(r"<(collision|visual)\b.*?</\1>", "", path.read_text(errors="replace"), flags=re.S)
    copy = path.with_name("epode_without_meshes.urdf")
    copy.write_text(text)
    return copy


def largest(packages, suffix, mark, count):
    files = [path for path in packages.rglob("*" + suffix) if mark in path.read_text(errors="replace")]
    return sorted(files, key=lambda path: -path.stat().st_size)[:count]


def table(library):
    import mujoco
    import pinocchio
    packages, ours = pathlib.Path(site.getsitepackages()[0]), Ours(library)
    data = packages / "cmeel.prefix/share/example-robot-data"
    print("| file | size, kB | ours, model | ours, with a robot | theirs | theirs, with meshes |\n|---|---|---|---|---|---|")
    for path in largest(data, ".urdf", "<robot", 3):
        text = without_meshes(path)
        alone = fastest_ms(lambda: ours.model(text, packages))
        theirs = fastest_ms(lambda: pinocchio.buildModelFromUrdf(str(text)))
        text.unlink()
        built = fastest_ms(lambda: ours.built(path, packages))
        model = pinocchio.buildModelFromUrdf(str(path))
        try:
            geometry = fastest_ms(lambda: pinocchio.buildGeomFromUrdf(model, str(path), pinocchio.GeometryType.COLLISION, package_dirs=[str(data.parent)]))
            geometry = f"{theirs + geometry:.1f} ms"
        except ValueError as problem:
            geometry = str(problem).splitlines()[0][:40]
        print(f"| {path.name} | {path.stat().st_size / 1e3:.0f} | {alone:.2f} ms (text) | {built:.1f} ms | Pinocchio {theirs:.2f} ms (text) | {geometry} |", flush=True)
    for path in [*largest(packages / "dm_control", ".xml", "<worldbody", 2), packages / "gymnasium/envs/mujoco/assets/humanoid.xml",
                 packages / "gymnasium/envs/mujoco/assets/ant.xml"]:
        mine, built = fastest_ms(lambda: ours.model(path, packages)), fastest_ms(lambda: ours.built(path, packages))
        theirs = fastest_ms(lambda: mujoco.MjModel.from_xml_path(str(path)))
        second = ours.second(path, packages)
        print(f"| {path.name} | {path.stat().st_size / 1e3:.0f} | {mine:.2f} ms | {built:.1f} ms, the next {second:.0f} us | MuJoCo | {theirs:.2f} ms |", flush=True)
    return 0
