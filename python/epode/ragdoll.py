# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Ragdolls: figures of bones, motors that hold a pose, and animations that they follow."""
from __future__ import annotations

import dataclasses
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any, Self

import numpy as np
from numpy.typing import ArrayLike

from . import c
from ._assembly import Assembly, adopt_bodies, adopt_joints
from ._handle import FloatArray, describe_fields, three
from .body import Body
from .enums import BoneJoint
from .shapes import Box, Capsule, Sphere

if TYPE_CHECKING:
    from .geom import Geom
    from .joint import Joint
    from .world import World

# Of the bones that dBonesMakeHuman writes, in their order.
_HUMAN = ["pelvis", "abdomen", "thorax", "head", *(f"{side} {part}" for parts in (("upper arm", "forearm", "hand"), ("thigh", "shank", "foot"))
                                                   for side in ("left", "right") for part in parts)]
_SHAPES = {c.dBoneCapsule: (Capsule, 2), c.dBoneBox: (Box, 3), c.dBoneSphere: (Sphere, 1)}
_SAME = ("parent", "mass", "density", "position", "anchor", "axis", "swing", "low", "high", "stiffness", "damping", "strength", "friction")


@dataclasses.dataclass(eq=False)
class Bone:
    """A bone of a ragdoll, and the joint with its parent. Places and directions are in one frame of the whole figure, in any pose within
    the limits, in which all angles are zero.

    shape: a Capsule along the bone's z, a Box or a Sphere. parent: number of an earlier bone; -1 for bone 0. name: for the program.
    position: of the centre, m; quaternion: of the shape. mass: kg; 0: as density says, kg/m^3; 0: 1000. joint: what connects it with
    its parent, at anchor, m. axis: a hinge's, or that of the twist, along the bone. swing: of a universal or ball joint, the first
    swing's, fixed in the parent; the second is swing x axis. low, high: rad, of twist, second and first swing (a hinge has the first alone); where
    low is not below high there is no limit. stiffness, N m/rad, damping, N m s/rad, and strength, N m (0: no limit), are the motors'
    that hold a pose; friction is dry, of each axis, N m."""
    shape: Capsule | Box | Sphere
    parent: int = -1
    name: str = ""
    position: ArrayLike = (0.0, 0.0, 0.0)
    quaternion: ArrayLike = (1.0, 0.0, 0.0, 0.0)
    mass: float = 0.0
    density: float = 0.0
    joint: BoneJoint = BoneJoint.BALL
    anchor: ArrayLike = (0.0, 0.0, 0.0)
    axis: ArrayLike = (0.0, 0.0, 1.0)
    swing: ArrayLike = (1.0, 0.0, 0.0)
    low: ArrayLike = (0.0, 0.0, 0.0)
    high: ArrayLike = (0.0, 0.0, 0.0)
    stiffness: float = 0.0
    damping: float = 0.0
    strength: float = 0.0
    friction: float = 0.0

    def _to_c(self) -> c.dBone:
        found = next((kind for kind, (shape, _) in _SHAPES.items() if type(self.shape) is shape), None)
        if found is None:
            raise TypeError(f"shape: a Capsule, a Box or a Sphere is expected, not {self.shape!r}")
        bone = c.dBone()
        sizes = [float(size) for size in dataclasses.astuple(self.shape)]
        bone.shape, bone.joint, bone.size, bone.orientation = found, int(self.joint), [*sizes, 0.0, 0.0][:3], self.quaternion
        for name in _SAME:
            setattr(bone, name, getattr(self, name))
        return bone

    @classmethod
    def _from_c(cls, bone: c.dBone, name: str) -> Bone:
        kind, sizes = _SHAPES[bone.shape]
        quaternion = bone.orientation if np.any(bone.orientation) else (1.0, 0.0, 0.0, 0.0)
        values = {field: getattr(bone, field) for field in _SAME}
        return cls(kind(*map(float, bone.size[:sizes])), name=name, quaternion=quaternion, joint=BoneJoint(bone.joint), **values)


def human(height: float = 1.8, mass: float = 75.0) -> list[Bone]:
    """The 16 bones of a human of a height, m, and a mass, kg, that stands, facing x, left y, up z, the soles at z = 0: pelvis, abdomen, thorax,
    head, left upper arm, left forearm, left hand, the right ones, left thigh, left shank, left foot, the right ones."""
    return [Bone._from_c(bone, name) for bone, name in zip(c.dBonesMakeHuman(height, mass), _HUMAN, strict=True)]


def _product(a: FloatArray, b: FloatArray) -> FloatArray:
    vector = a[0] * b[1:] + b[0] * a[1:] + np.cross(a[1:], b[1:])
    return np.array([a[0] * b[0] - a[1:] @ b[1:], *vector])


def _conjugate(q: FloatArray) -> FloatArray:
    return q * (1.0, -1.0, -1.0, -1.0)


def _about(axis: FloatArray, angle: float) -> FloatArray:
    return np.array([np.cos(angle / 2), *(np.sin(angle / 2) * axis)])


def _unit(v: ArrayLike) -> FloatArray:
    array = np.asarray(v, dtype=float)
    unit: FloatArray = array / np.linalg.norm(array)
    return unit


def _turn(bone: Bone, angles: FloatArray) -> FloatArray:
    """How the bone has turned, in the list's frame: by the twist, then by the second swing, then by the first."""
    twist = _unit(bone.axis)
    if bone.joint == BoneJoint.HINGE:
        return _about(twist, angles[0])
    swing = np.asarray(bone.swing, dtype=float)
    swing = _unit(swing - (swing @ twist) * twist)
    return _product(_about(swing, angles[2]), _product(_about(np.cross(swing, twist), angles[1]), _about(twist, angles[0])))


class Ragdoll(Assembly):
    """A figure of bones, made by ``World.ragdoll``: bodies, geoms and joints like any others. It is limp until ``hold``. ``figure["left hand"]``
    or ``figure[6]`` is a body of it.

    A pose is an array with a quaternion for each bone: its orientation against its parent, of bone 0 in the world."""

    __slots__ = ("_bones", "_raw", "_list")

    def __init__(self, world: World, bones: Sequence[Bone], bodies: Sequence[Body | None], joints: Sequence[Joint | None] = (),
                 geoms: Sequence[Geom | None] = ()) -> None:
        """As ``World.ragdoll`` does: in the world, of bones, whose bodies and joints have been made; geoms: none of its own."""
        super().__init__(world, bodies, joints, geoms)
        self._bones, self._raw = tuple(bones), [bone._to_c() for bone in bones]
        self._list: tuple[tuple[c.dBodyID, ...], c.BodyList] | None = None

    def __repr__(self) -> str:
        return f"<epode.Ragdoll of {len(self._bones)} bones{'' if self.alive else ', destroyed'}>"

    @classmethod
    def _new(cls, world: World, bones: Sequence[Bone], position: ArrayLike | None, quaternion: ArrayLike | None) -> Ragdoll:
        handles = c.dRagdollCreate(world._handle, world._space, [bone._to_c() for bone in bones], position, quaternion)
        bodies = adopt_bodies(world, handles, lambda i: bones[i].shape)
        return cls(world, bones, bodies, adopt_joints(world, bodies))

    def _settings(self) -> tuple[Any, ...]:
        return (self._bones,)

    @classmethod
    def _again(cls, world: World, settings: tuple[Any, ...], bodies: list[Body | None], joints: list[Joint | None],
               geoms: list[Geom | None]) -> Self:
        return cls(world, settings[0], bodies, joints)

    @property
    def _handles(self) -> c.BodyList:
        """The handles of its bodies, which a roll back over their destruction changes."""
        self._must_live()
        now = tuple(body._handle for body in self.bodies)
        if self._list is None or self._list[0] != now:
            self._list = now, c.BodyList(now)
        return self._list[1]

    # ---- what it is ----

    @property
    def bones(self) -> tuple[Bone, ...]:
        """What it was built from. To change a bone afterwards has no effect."""
        return self._bones

    def number(self, bone: int | str) -> int:
        """The number of a bone, by its name or number."""
        names = [one.name for one in self._bones]
        if isinstance(bone, str):
            if bone not in names:
                raise KeyError(f"no bone is called {bone!r}: {', '.join(name for name in names if name)}")
            return names.index(bone)
        if not 0 <= bone < len(names):
            raise IndexError(f"bone {bone}: there are {len(names)}")
        return bone

    def __getitem__(self, bone: int | str) -> Body:
        return self.bodies[self.number(bone)]

    @property
    def gap(self) -> float:
        """The largest gap of a joint, m: how far the two sides of an anchor are apart."""
        return c.dRagdollGetGap(self._raw, self._handles)

    # ---- poses ----

    @property
    def pose(self) -> FloatArray:
        """The present pose, an array of (bones, 4)."""
        return c.dRagdollGetPose(self._raw, self._handles)

    def pose_of(self, angles: Mapping[int | str, ArrayLike] | None = None) -> FloatArray:
        """The pose of the list with some bones turned, by name or number: a hinge by an angle, others by (twist, second swing, first
        swing), rad, as their limits have them. Bone 0 is as in the list."""
        pose = np.empty((len(self._bones), 4))
        turned = {self.number(bone): np.asarray(values, dtype=float).ravel() for bone, values in (angles or {}).items()}
        seen = [_unit(bone.quaternion) for bone in self._bones]
        for i, bone in enumerate(self._bones):
            turn = turned.get(i)
            wanted = 0 if i == 0 or bone.joint == BoneJoint.FIXED else 1 if bone.joint == BoneJoint.HINGE else 3
            if turn is not None and (turn.size != wanted or not np.isfinite(turn).all()):
                raise ValueError(f"angles of bone {bone.name or i}: {wanted} finite numbers are expected, not {turn.tolist()}")
            own = seen[i] if turn is None else _product(_turn(bone, turn), seen[i])
            pose[i] = own if i == 0 else _product(_conjugate(seen[bone.parent]), own)
        return pose

    def hold(self, pose: ArrayLike | None = None, strength: float = 1.0) -> int:
        """Let motors pull it to a pose (None: to the present one), where they can with the stiffness, damping and strength of the bones, times
        strength each; 0: it is limp. They do not balance. Returns how many joints have motors."""
        return c.dRagdollSetPose(self._raw, self._handles, self.pose if pose is None else pose, strength)

    def follow(self, position: ArrayLike, pose: ArrayLike, h: float, *, weight: float = 1.0) -> int:
        """Follow an animation: give the bodies velocities that bring them in the coming step of h seconds to a pose with bone 0 at
        position, m. weight: the share of these velocities, the rest is what they have. Call it before each step. Returns how many
        bodies follow."""
        return c.dRagdollFollow(self._raw, self._handles, three(position, "position"), pose, weight, h)


describe_fields(Bone)
