# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The vector of environments, and the scalar one, as Gymnasium has them."""
from __future__ import annotations

from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import Any, Literal

import numpy as np
from gymnasium import Env, spaces
from gymnasium.vector import AutoresetMode, VectorEnv
from gymnasium.vector.utils import batch_space
from numpy.typing import NDArray

from .. import _c
from .. import robot
from ..batch import Batch
from ..robot import Model
from .task import Distribution, Task
from .tasks import TASKS

_MODES = {AutoresetMode.NEXT_STEP: 0, AutoresetMode.SAME_STEP: 1, AutoresetMode.DISABLED: 2}


def _text_of(source: str) -> str:
    if source.lstrip().startswith("<"):
        return source
    if "/" not in source and not Path(source).exists():
        import gymnasium
        source = str(Path(gymnasium.__file__).parent / "envs" / "mujoco" / "assets" / source)
    return Path(source).read_text()


class VectorEnvironment(VectorEnv[NDArray[Any], NDArray[Any], NDArray[Any]]):
    """Copies of one robot with Gymnasium's steps and episodes; ``epode.vector.make`` makes it. ``batch`` is the epode.Batch beneath,
    to look at and to record. Arrays that step and reset return are copies, or with ``copy=False`` the environment's own, which the next
    step overwrites. The reward is of the whole step, in doubles; ``infos["bad"]`` are copies that left the finite, which ends their
    episode."""

    def __init__(self, task: Task, model: Model, num_envs: int, *, stepsize: float, time_limit: int, autoreset: AutoresetMode, copy: bool,
                 with_infos: bool, first: int, batch_options: Mapping[str, Any]) -> None:
        self.batch = Batch(model, num_envs, stepsize=stepsize, **batch_options)
        self.task, self.num_envs, self.copy, self.with_infos = task, num_envs, copy, with_infos
        self.metadata = {"autoreset_mode": autoreset, "render_modes": [], "render_fps": round(1 / (stepsize * task.frame_skip))}
        self.autoreset_mode, self.render_mode, self.spec = autoreset, None, None
        self._set_spaces(model)
        n, width, columns = num_envs, task.size, task.columns
        self._arrays: dict[str, NDArray[Any]] = {
            "observations": np.zeros((n, width), self.batch.dtype), "final_observations": np.zeros((n, width), self.batch.dtype),
            "rewards": np.zeros(n), "infos": np.zeros((n, len(columns))), "final_infos": np.zeros((n, len(columns))),
            **{name: np.zeros(n, bool) for name in ("terminated", "truncated", "begun", "bad")}}
        self._at_reset = [any(term.at_reset for term in task.terms if term.name == name) for name in columns]
        self._environments = _c._Environments(self.batch._batch, task._packed(time_limit), _MODES[autoreset], first, self._arrays)
        self._was_reset = False

    def _set_spaces(self, model: Model) -> None:
        high = np.asarray(self.task.high or [np.inf] * self.task.size, self.batch.dtype)
        self.single_observation_space = spaces.Box(-high, high, dtype=self.batch.dtype.type)
        if self.task.choices:
            self.single_action_space: Any = spaces.Discrete(len(self.task.choices))
        else:
            low, high = (np.array([getattr(a, side) for a in model.actuators], np.float32) for side in ("low", "high"))
            self.single_action_space = spaces.Box(low, high, dtype=np.float32)
        self.observation_space = batch_space(self.single_observation_space, self.num_envs)
        self.action_space = batch_space(self.single_action_space, self.num_envs)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[NDArray[Any], dict[str, Any]]:
        """Begins episodes, of all copies or of those in ``options["reset_mask"]``. A copy's episodes follow from the seed, its number and
        theirs; without a seed the first reset draws one, later ones go on."""
        if seed is None and not self._was_reset:
            seed = int(np.random.SeedSequence().generate_state(1, np.uint64)[0])
        if seed is not None and not 0 <= seed < 2**64:
            raise ValueError("seed: a whole number from 0 to 2^64 - 1 is expected")
        mask = self._mask(options)
        if mask is not None and not self._was_reset:
            raise ValueError("the first reset is of all copies: options['reset_mask'] comes later")
        self._environments.reset(seed, mask)
        self._was_reset = True
        begun = np.ones(self.num_envs, bool) if mask is None else mask
        return self._given("observations"), self._first_infos(begun) if self.with_infos else {}

    def _mask(self, options: Mapping[str, Any] | None) -> NDArray[np.bool_] | None:
        if options is None or "reset_mask" not in options:
            return None
        mask = options["reset_mask"]
        if not isinstance(mask, np.ndarray) or mask.dtype != np.bool_:
            raise TypeError("options['reset_mask']: an array of bool is expected")
        if mask.shape != (self.num_envs,) or not mask.any():
            raise ValueError(f"options['reset_mask']: ({self.num_envs},) with a copy to reset is expected")
        return np.ascontiguousarray(mask)

    def step(self, actions: NDArray[Any]) -> tuple[NDArray[Any], NDArray[Any], NDArray[Any], NDArray[Any], dict[str, Any]]:
        """Steps all copies in one call of the engine, while other threads of Python go on."""
        if not self._was_reset:
            raise RuntimeError("reset comes before the first step")
        given = np.asarray(actions)
        if given.shape != self.action_space.shape:
            raise ValueError(f"actions {self.action_space.shape} are expected, not {given.shape}")
        if given.dtype.kind not in ("iu" if self.task.choices else "iuf"):
            raise ValueError(f"actions of {self.action_space.dtype} are expected, not {given.dtype}")
        self._environments.step(np.ascontiguousarray(given, np.float64))
        self.batch._take(self.task.frame_skip)
        infos = self._infos() if self.with_infos else {}
        return (self._given("observations"), self._given("rewards"), self._given("terminated"), self._given("truncated"), infos)

    def _given(self, name: str) -> NDArray[Any]:
        return self._arrays[name].copy() if self.copy else self._arrays[name]

    def _put(self, infos: dict[str, Any], name: str, values: NDArray[Any], present: NDArray[np.bool_]) -> None:
        infos[name], infos["_" + name] = values.copy(), present.copy()

    def _first_infos(self, begun: NDArray[np.bool_]) -> dict[str, Any]:
        infos: dict[str, Any] = {}
        for column, name in enumerate(self.task.columns):
            if self._at_reset[column]:
                self._put(infos, name, self._arrays["infos"][:, column] * begun, begun)
        return infos

    def _infos(self) -> dict[str, Any]:
        infos: dict[str, Any] = {}
        arrays = self._arrays
        begun, table = arrays["begun"], arrays["infos"]
        stepped, every = ~begun, np.ones(self.num_envs, bool)
        if self.autoreset_mode == AutoresetMode.SAME_STEP and begun.any():
            self._put_final(infos, begun)
        for column, name in enumerate(self.task.columns):
            if self._at_reset[column] or stepped.any():
                self._put(infos, name, table[:, column], every if self._at_reset[column] else stepped)
        if arrays["bad"].any():
            self._put(infos, "bad", arrays["bad"], arrays["bad"])
        return infos

    def _put_final(self, infos: dict[str, Any], ended: NDArray[np.bool_]) -> None:
        observations = np.full(self.num_envs, None, object)
        for i in np.flatnonzero(ended):
            observations[i] = self._arrays["final_observations"][i].copy()
        infos["final_obs"], infos["_final_obs"] = observations, ended.copy()
        final: dict[str, Any] = {}
        for column, name in enumerate(self.task.columns):
            self._put(final, name, self._arrays["final_infos"][:, column] * ended, ended)
        infos["final_info"], infos["_final_info"] = final, ended.copy()


class Scalar(Env[NDArray[Any], Any]):
    """One environment: a vector of one copy. ``copy`` is its number, as in a vector of many."""

    metadata: dict[str, Any] = {"render_modes": []}  # noqa: RUF012

    def __init__(self, task: str, *, copy: int = 0, render_mode: str | None = None, **options: Any) -> None:
        del render_mode
        options.setdefault("threads", 1)
        options.setdefault("max_episode_steps", 0)  # Gymnasium's wrapper counts
        self.vector = make(task, 1, autoreset_mode="Disabled", first=copy, copy=True, **options)
        self.observation_space, self.action_space = self.vector.single_observation_space, self.vector.single_action_space
        self.metadata = {key: value for key, value in self.vector.metadata.items() if key != "autoreset_mode"}

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> tuple[NDArray[Any], dict[str, Any]]:
        """Begins an episode."""
        super().reset(seed=seed)
        del options
        observation, infos = self.vector.reset(seed=seed)
        return observation[0], _of_one(infos)

    def step(self, action: Any) -> tuple[NDArray[Any], float, bool, bool, dict[str, Any]]:
        """Steps it."""
        observation, reward, terminated, truncated, infos = self.vector.step(np.asarray(action)[None])
        return observation[0], float(reward[0]), bool(terminated[0]), bool(truncated[0]), _of_one(infos)


def _of_one(infos: Mapping[str, Any]) -> dict[str, Any]:
    return {name: value[0] for name, value in infos.items() if not name.startswith("_")}


def make(task: str, num_envs: int = 1, *, autoreset_mode: AutoresetMode | str = AutoresetMode.NEXT_STEP, max_episode_steps: int | None = None,
         dtype: Literal["float32", "float64"] = "float32", threads: int = 0, randomise: Mapping[str, Distribution] | None = None,
         observation_noise: float | Sequence[float] = 0.0, copy: bool = True, infos: bool = True, first: int = 0, xml_file: str | None = None,
         render_mode: str | None = None, batch_options: Mapping[str, Any] | None = None, **arguments: Any) -> VectorEnvironment:
    """A vector of environments: Ant, HalfCheetah, Humanoid, Hopper, Walker2d, Swimmer, Reacher, Pusher,
    InvertedPendulum, InvertedDoublePendulum, CartPole, Quadruped, RoughQuadruped, Lift.

    autoreset_mode: Gymnasium's. max_episode_steps: 0 for no limit. dtype: of the batch and of observations. threads: 0 for all.
    randomise: parameters of the model (epode.Batch.set) that each episode draws, ``{"friction": ("uniform", 0.4, 1.2)}`` or
    ``("normal", mean, deviation)``: one number in place of the model's; with ``"scale"`` after it times the model's, with ``"each"`` one
    for each. observation_noise: deviations. copy=False: arrays are overwritten by the next step. infos=False: none. first: the number of
    the first copy. xml_file: another model of the same structure. Other arguments are those of Gymnasium's environment."""
    if task not in TASKS:
        raise ValueError(f"no environment is called {task!r}: {', '.join(TASKS)}")
    if render_mode is not None:
        raise ValueError("a vector of environments shows nothing: env.batch.world(i) is a copy to look at")
    described, source, limit = TASKS[task]
    text = _text_of(xml_file or (source if isinstance(source, str) else source()))
    model = robot.from_text(text, keep_fixed=True)
    made = described(model, **arguments).varied(randomise or {}, observation_noise)
    limit = limit if max_episode_steps is None else max_episode_steps
    return VectorEnvironment(made, model, num_envs, stepsize=model.stepsize or 0.002, time_limit=limit, autoreset=AutoresetMode(autoreset_mode),
                             copy=copy, with_infos=infos, first=first,
                             batch_options={"dtype": dtype, "threads": threads, **(batch_options or {})})
