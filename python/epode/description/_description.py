# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A robot that can be edited: see ``epode.description``."""
from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from .._handle import FloatArray, Value
from .._robot_data import Options
from ..errors import RefusedError
from . import _attach, _mirror, _scale
from ._geoms import Geom, MeshAsset
from ._kinds import make
from ._links import Joint, Link, Site
from ._part import Part
from ._acting import Actuator, Coupling, Exclusion, Loop, Sensor, Tendon
from ._check import problems_of
from ._starts import Start, key_of, read_starts
from ._tree import Element, Top, Word, hint, read, written
from ._values import Elements, Path, name_of, put_words

if TYPE_CHECKING:
    from ..robot import Model

# In this order, as readers of MJCF want what is named before it is used.
ORDER = ["compiler", "option", "custom", "asset", "worldbody", "equality", "tendon", "actuator", "contact", "sensor", "keyframe"]
MASSES = ("repair", "inertia_from_shapes", "missing_mass")  # what is done about masses when links have been merged
KEPT = ("strict", "keep_fixed", "meshes_as_triangles", "meshes_as_parts", "roots", *MASSES)
LIMITED = {"limited": "range", "ctrllimited": "ctrlrange", "forcelimited": "forcerange", "actlimited": "actrange",
           "actuatorfrclimited": "actuatorfrcrange"}


class Description:
    """A robot that can be edited. ``Model.edit`` makes one of a model, ``Description(name)`` an empty one; ``model()`` compiles it.
    Descriptions can be compared, copied and pickled."""

    lost: list[str]
    starts: dict[str, Start]

    def __init__(self, name: str = "robot", *, folder: Path = ".") -> None:
        self._fill(f"<mujoco model='{''}'><compiler angle='radian'/><option gravity='0 0 -9.81'/><worldbody/></mujoco>", {}, os.fspath(folder), [])
        self.name = name

    def _fill(self, text: str, options: Mapping[str, Any], folder: str, lost: Sequence[str]) -> None:
        self._top: Top = read(text, lambda above, tag, words: Top(tag, words) if above is None else make(above, tag, words))  # type: ignore[assignment]
        object.__setattr__(self._top, "owner", self)
        self._options = dict(options)
        self.folder, self.lost = os.path.abspath(folder), list(lost)
        self.starts = read_starts(self)

    @classmethod
    def _restored(cls, *parts: Any) -> Description:
        self = cls.__new__(cls)
        self._fill(*parts)
        return self

    @classmethod
    def _of_model(cls, model: Model) -> Description:
        from ..robot import _read
        path, text, options = model._source
        folder = os.path.dirname(os.path.abspath(path))
        as_written: Options = {**{key: value for key, value in options.items() if key not in MASSES}, "keep_fixed": True}  # type: ignore[typeddict-item]
        written_text, lost = _read(path, text, as_written).text(False, folder)
        self = cls._restored(written_text, {key: options[key] for key in KEPT if key in options}, folder, lost)  # type: ignore[literal-required]
        self._simplify()
        return self

    def _simplify(self) -> None:
        """What a writer states of everything, for edits: limits that are there act, and links without a mass have geoms without."""
        compiler = self._section("compiler")
        compiler.words = {"angle": "radian"}
        for one in self._top.walk():
            for flag, word in LIMITED.items():
                if one[flag] == ("true" if one[word] is not None else "false"):
                    one[flag] = None
            if one.tag in ("mesh", "hfield") and one["file"] is not None:
                one["file"] = os.path.normpath(os.path.join(self.folder, one.words["file"]))
        for link in self.links:
            if link.child("inertial") is None:
                for geom in link.geoms:
                    geom["mass"] = 0
        for number, actuator in enumerate(self.actuators):
            if actuator["name"] is None:
                actuator.words["name"] = self._free_name("actuator", f"actuator{number}")

    # ---- what it is ----

    def __repr__(self) -> str:
        return f"<epode.robot.Description {self.name!r}: {len(self.links)} links, {len(self.joints)} joints>"

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Description):
            return NotImplemented
        return self.text() == other.text() and self._options == other._options

    __hash__ = None  # type: ignore[assignment]

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self)._restored, (self.text(), self._options, self.folder, self.lost)

    def copy(self) -> Description:
        """Another one that is the same."""
        return type(self)._restored(*self.__reduce__()[1])

    name: Value[str, str] = Value(lambda self: self._top.words.get("model", ""), lambda self, value: self._top.__setitem__("model", value),
                                  doc="Of the robot.")
    gravity: Value[FloatArray, ArrayLike] = Value(lambda self: self.option.numbers("gravity", (0, 0, -9.81)),
                                                  lambda self, value: self.option.put_numbers("gravity", value, 3), doc="m/s^2.")

    @property
    def option(self) -> Element:
        """MJCF's element of that name: density, viscosity and wind of a medium, and what other programs read there."""
        return self._section("option")

    @property
    def world(self) -> Link:
        """What does not move; first links hang on it."""
        return self._section("worldbody")  # type: ignore[return-value]

    def _all(self, kind: type[Any], what: str) -> Elements[Any]:
        return Elements(lambda: (one for one in self._top.walk() if isinstance(one, kind)), what)

    @property
    def links(self) -> Elements[Link]:
        """All but the world."""
        return Elements(lambda: (one for one in self._top.walk() if isinstance(one, Link) and one.tag == "body"), "link")

    @property
    def joints(self) -> Elements[Joint]:
        """Of all links, in the order of their coordinates."""
        return self._all(Joint, "joint")

    @property
    def geoms(self) -> Elements[Geom]:
        """Of all links."""
        return self._all(Geom, "geom")

    @property
    def sites(self) -> Elements[Site]:
        """Of all links."""
        return self._all(Site, "site")

    @property
    def actuators(self) -> Elements[Actuator]:
        """In the order of controls."""
        return self._all(Actuator, "actuator")

    @property
    def sensors(self) -> Elements[Sensor]:
        """All sensors."""
        return self._all(Sensor, "sensor")

    @property
    def tendons(self) -> Elements[Tendon]:
        """Fixed and spatial ones."""
        return self._all(Tendon, "tendon")

    @property
    def couplings(self) -> Elements[Coupling]:
        """Of joints and of tendons."""
        return self._all(Coupling, "coupling")

    @property
    def loops(self) -> Elements[Loop]:
        """Links that are held together."""
        return self._all(Loop, "loop")

    @property
    def exclusions(self) -> Elements[Exclusion]:
        """Pairs of links that do not touch."""
        return self._all(Exclusion, "exclusion")

    @property
    def meshes(self) -> Elements[MeshAsset]:
        """That geoms show."""
        return self._all(MeshAsset, "mesh")

    # ---- what is added ----

    def add_link(self, name: str, **words: Any) -> Link:
        """A link that hangs on the world: ``Link.add_link`` of it."""
        return self.world.add_link(name, **words)

    def _append(self, section: str, part: Element, name: str | None, words: dict[str, Any]) -> Any:
        object.__setattr__(part, "_above", self._section(section))
        if name is not None:
            self._check_name(part.space, name, part)
            part.words["name"] = name
        put_words(part, words)
        return self._section(section).add(part)

    def add_actuator(self, name: str, kind: str = "motor", *, joint: Joint | str | None = None, tendon: Tendon | str | None = None,
                     **words: Word | Element | None) -> Actuator:
        """An actuator of a joint, tendon or site. kind: motor, position (kp, kv), velocity (kv), general (gainprm, biasprm) and the
        others of MJCF. words: properties of ``Actuator`` and attributes of MJCF."""
        return self._append("actuator", Actuator(kind), name, {"joint": joint, "tendon": tendon, **words})  # type: ignore[no-any-return]

    def add_sensor(self, name: str, kind: str, on: Part | str | None = None, **words: Word | Part | None) -> Sensor:
        """A sensor of one of MJCF's kinds on an element of the description; on: it, or its name where the kind says what it is (jointpos: a
        joint, accelerometer: a site and so on); None: of the whole robot (clock, e_kinetic), or the words say it (distance: geom1 or body1, geom2
        or body2)."""
        sensor = Sensor(kind)
        if on is None:
            return self._append("sensor", sensor, name, dict(words))  # type: ignore[no-any-return]
        its = name_of(on)
        if kind.startswith("frame"):
            space = on.space if isinstance(on, Part) else "site" if its in self.sites.names else "body"
            words = {"objtype": "xbody" if space == "body" else space, "objname": its, **words}
        else:
            known = {"joint": "joint", "ball": "joint", "tendon": "tendon", "actuator": "actuator", "subtree": "body"}
            word = next((word for begin, word in known.items() if kind.startswith(begin)), "site")
            words = {word: its, **words}
        return self._append("sensor", sensor, name, dict(words))  # type: ignore[no-any-return]

    def add_tendon(self, name: str, *, joints: Mapping[Any, float] | None = None, path: Sequence[Any] | None = None,
                   **words: Word | None) -> Tendon:
        """A tendon: a sum of joints with their factors, or a string along a path of sites and round geoms (``Tendon.path``)."""
        if (joints is None) == (path is None):
            raise ValueError(f"tendon {name!r} has either joints or a path")
        tendon: Tendon = self._append("tendon", Tendon("spatial" if joints is None else "fixed"), name, dict(words))
        if joints is not None:
            tendon.joints = joints
        else:
            tendon.path = path  # type: ignore[assignment]
        return tendon

    def add_coupling(self, joint: Joint | str, leader: Joint | str | None = None, factor: float = 1.0, offset: float = 0.0, *,
                     name: str | None = None, coefficients: ArrayLike | None = None) -> Coupling:
        """Let a joint follow another one: offset plus factor times its coordinate, both from their references; coefficients: of a
        polynomial, in their place. Without a leader it is held at the offset."""
        its = (offset, factor if leader is not None else 0, 0, 0, 0) if coefficients is None else coefficients
        return self._append("equality", Coupling("joint"), name,  # type: ignore[no-any-return]
                            {"joint1": joint, "joint2": leader, "coefficients": np.concatenate([np.asarray(its, float), np.zeros(5)])[:5]})

    def add_loop(self, link1: Link | str, link2: Link | str | None = None, *, anchor: ArrayLike = (0, 0, 0), weld: bool = False,
                 name: str | None = None) -> Loop:
        """Hold two links together in the described pose, at a point of the first one, m, or altogether (weld)."""
        ends: dict[str, Any] = {"link1": link1, "link2": None if link2 is None or name_of(link2) == "world" else link2}
        return self._append("equality", Loop("weld" if weld else "connect"), name,  # type: ignore[no-any-return]
                            ends if weld else {**ends, "anchor": anchor})

    def exclude(self, link1: Link | str, link2: Link | str) -> Exclusion:
        """Let two links not touch."""
        return self._append("contact", Exclusion("exclude"), None, {"link1": link1, "link2": link2})  # type: ignore[no-any-return]

    def add_mesh(self, file: Path | None = None, *, scale: ArrayLike = (1, 1, 1), vertices: ArrayLike | None = None,
                 triangles: ArrayLike | None = None) -> MeshAsset:
        """A mesh for geoms: a file (its path counts from ``folder``), or vertices with or without triangles."""
        mesh = MeshAsset("mesh", {"inertia": "legacy" if triangles is not None else "convex"})
        if (file is None) == (vertices is None):
            raise ValueError("a mesh has either a file or vertices")
        stem = "mesh"
        if file is not None:
            mesh["file"] = os.path.normpath(os.path.join(self.folder, os.fspath(file)))
            stem = os.path.splitext(os.path.basename(os.fspath(file)))[0]
        else:
            mesh["vertex"] = np.asarray(vertices, float)
            mesh["face"] = None if triangles is None else np.asarray(triangles, float)
        if np.any(np.asarray(scale, float) != 1):
            mesh.put_numbers("scale", np.broadcast_to(np.asarray(scale, float), 3), 3)
        for known in self.meshes:
            if {**known.words, "name": ""} == {**mesh.words, "name": ""}:
                return known
        return self._append("asset", mesh, self._free_name("mesh", stem), {})  # type: ignore[no-any-return]

    # ---- edits of all of it ----

    def attach(self, other: Description, to: Link | Site | str | None = None, *, prefix: str = "", position: ArrayLike = (0, 0, 0),
               quaternion: ArrayLike = (1, 0, 0, 0)) -> list[Link]:
        """Put a copy of another description on a link or site (its name; None: the world), at a pose in its frame; prefix: in front of all
        its names. What its world holds comes along, but for planes and height fields, and so does all that acts on its links; start
        poses of one name become one. On another link than the world its free joints are left out: its roots are fixed there.
        Returns the links that hang on ``to`` now."""
        return _attach.attach(self, other, self._place(to), prefix, position, quaternion)

    def extract(self, link: Link | str) -> Description:
        """A description of a link, what hangs on it, and all that refers to these alone; the link stands in it as it does in its parent."""
        return _attach.extract(self, self.links[link] if isinstance(link, str) else link)

    def scale(self, factor: float, *, forces: bool = True) -> Description:
        """Make all of it larger: lengths by the factor, masses by its third, inertias by its fifth power. forces: springs, dampers, friction and
        actuators, too, so that the robot moves under the same gravity as before, its times longer by the root of the factor (torques
        by the fourth power); False: they stay as they are. Returns itself."""
        _scale.scale(self, factor, forces)
        return self

    def mirror(self, axis: str = "y", *, rename: Mapping[str, str] | Callable[[str], str] | None = None) -> Description:
        """Mirror all of it in the plane through the world's origin whose normal is the axis, x, y or z: it then moves as its mirror image at the
        same coordinates of hinges and slides. rename: texts in names and what takes their place ({"left": "right"}), or a function.
        Returns itself."""
        if axis not in ("x", "y", "z"):
            raise ValueError(f"no axis is called {axis!r}: x, y, z")
        _mirror.mirror(self, "xyz".index(axis))
        if rename is not None:
            self.rename(rename)
        return self

    def rename(self, rename: Mapping[str, str] | Callable[[str], str]) -> Description:
        """Change all names: texts in them and what takes their place, or a function from old names to new ones. Returns itself."""
        def changed(name: str) -> str:
            if callable(rename):
                return rename(name)
            for old, new in rename.items():
                name = name.replace(old, new)
            return name
        _attach.rename_all(self, changed)
        return self

    def _place(self, to: Link | Site | str | None) -> Link | Site:
        if to is None or to == "world":
            return self.world
        if not isinstance(to, str):
            return to
        groups: list[Link | Site] = [*self.links, *self.sites]
        found = next((one for one in groups if one["name"] == to), None)
        if found is None:
            raise KeyError(f"no link or site is called {to!r}{hint(to, [*self.links.names, *self.sites.names])}")
        return found

    # ---- names ----

    def _section(self, name: str) -> Element:
        found = self._top.child(name)
        if found is None:
            found = self._top.add(make(self._top, name, {}))
            self._top.children.sort(key=lambda one: ORDER.index(one.tag) if one.tag in ORDER else len(ORDER))
        return found

    def _in_space(self, space: str) -> Iterator[Element]:
        return (one for one in self._top.walk() if one["name"] is not None and one.space == space)

    def _check_name(self, space: str, name: str, part: Element) -> None:
        if not isinstance(name, str) or not name:
            raise ValueError(f"{part.title}: a name is a text that is not empty: {name!r}")
        if (space == "body" and name == "world") or any(one is not part and one["name"] == name for one in self._in_space(space)):
            what = "link" if space == "body" else space
            raise ValueError(f"there is a {what} {name!r} already")

    def _free_name(self, space: str, wanted: str) -> str:
        taken = {one["name"] for one in self._in_space(space)}
        names = [wanted, *(f"{wanted}_{i}" for i in range(2, len(taken) + 3))]
        return next(name for name in names if name not in taken)

    def _renamed(self, space: str, old: str, new: str) -> None:
        for one in self._top.walk():
            for word, its, name in list(one.references()):
                if its == space and name == old:
                    one.words[word] = new
        for start in self.starts.values():
            table: dict[str, Any] = {"joint": start.positions, "actuator": start.controls, "body": start.mocap}.get(space, {})
            if old in table:
                table[new] = table.pop(old)

    def _remove(self, part: Element) -> list[str]:
        return _attach.remove(self, part)

    # ---- out of it ----

    def _written(self, folder: str | None = None) -> tuple[str, list[Element | None]]:
        top = Element(self._top.tag, self._top.words)
        top.children = [_without_empty(one) for one in self._top.children if one.children or one.words or one.tag == "worldbody"]
        if folder is not None:
            top.children = [self._relative(one, folder) if one.tag == "asset" else one for one in top.children]
        if self.starts:
            keys = Element("keyframe")
            keys.children = [key_of(self, name, start) for name, start in self.starts.items()]
            top.children = [*top.children, keys]
        return written(top)

    def _relative(self, assets: Element, folder: str) -> Element:
        out = Element(assets.tag)
        for one in assets.children:
            out.children.append(Element(one.tag, dict(one.words)))
            if one["file"] is not None:
                out.children[-1].words["file"] = os.path.relpath(one.words["file"], folder)
        return out

    def text(self, folder: Path | None = None) -> str:
        """MJCF. folder: where the text is to stand, from which paths of meshes count then; None: they are whole."""
        problems = problems_of(self, starts_only=True)
        if problems:
            raise RefusedError(problems[0])
        return self._written(None if folder is None else os.path.abspath(folder))[0]

    def problems(self) -> list[str]:
        """What is wrong with it, a sentence each; none: ``model()`` compiles it."""
        return self._compiled()[1]

    def _compiled(self) -> tuple[Any, list[str]]:
        from ..robot import _read
        problems = problems_of(self)
        if problems:
            return None, problems
        text, owners = self._written()
        files = [os.path.dirname(one.words["file"]) for one in self._top.walk() if one.tag in ("mesh", "hfield") and "file" in one.words]
        options: Options = {**self._options, "roots": list(dict.fromkeys([*map(os.fspath, self._options.get("roots", ())), *files]))}  # type: ignore[typeddict-item]
        path = os.path.join(self.folder, (self.name or "robot") + ".xml")
        model = _read(path, text, options)
        for kind, _, line, words in model.report:
            owner = owners[line] if 0 < line < len(owners) else None
            if kind == "error":
                words = words.replace("give it an <inertial>, or load with the inertia from its shapes or with a mass for such links",
                                      "give it geoms that weigh something, or set_inertial(mass, inertia)").replace("correct it, or load with repair", "correct it")
                problems.append(words if owner is None or owner["name"] and repr(owner["name"])[1:-1] in words else f"{owner.title}: {words}")
        return (model, (path, text, options)), problems

    def model(self) -> Model:
        """Compile it. What is wrong raises RefusedError with the first of ``problems()``."""
        from ..robot import Model
        compiled, problems = self._compiled()
        if problems:
            more = f" (and {len(problems) - 1} more: Description.problems)" if len(problems) > 1 else ""
            raise RefusedError(problems[0] + more)
        return Model(*compiled)

    def save(self, path: Path) -> list[str]:
        """Write it to a file: URDF if it ends in .urdf, MJCF if in .xml or .mjcf; it must compile. Returns a sentence for each thing
        that the format cannot say."""
        model, ending = self.model(), os.path.splitext(os.fspath(path))[1].lower()
        if ending not in (".xml", ".mjcf") or any(self._options.get(option) for option in MASSES):
            return model.save(path)  # with the masses that were mended
        folder = os.path.dirname(os.path.abspath(path))
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.text(folder))
        others = [one for one in model.text("mjcf", folder)[1] if one.startswith("MuJoCo itself")]
        return [*self.lost, *(one for one in others if one not in self.lost)]


def _without_empty(section: Element) -> Element:
    """<custom> without the tuples that have lost all their elements, which MuJoCo refuses."""
    if section.tag != "custom":
        return section
    out = Element(section.tag)
    out.children = [one for one in section.children if one.tag != "tuple" or one.children]
    return out
