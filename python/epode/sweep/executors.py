# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Where chunks are executed: each place is a ``concurrent.futures.Executor``, Ray's an adapter of a few lines. Scheduling, retries
after lost nodes and moving data are Ray's."""
from __future__ import annotations

import logging
import os
from collections.abc import Callable
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from typing import Any

RETRIES = 10  # of a chunk whose node was lost


class Serial(Executor):
    """Executes in submit."""

    width = 1

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """A future that is done."""
        future: Future[Any] = Future()
        try:
            future.set_result(fn(*args, **kwargs))
        except Exception as problem:
            future.set_exception(problem)
        return future


class Ray(Executor):
    """One task of Ray's, on one CPU, for each call of ``submit``. What is given as bytes first travels once, as an object. Connects
    to the cluster of RAY_ADDRESS or to one that runs here, or starts one of this machine, which ends with it."""

    def __init__(self) -> None:
        try:
            import ray  # type: ignore[import-not-found,import-untyped,unused-ignore]
        except ImportError:
            raise ImportError('executor="ray" needs Ray: pip install epode[sweep]') from None
        self._ray: Any = ray
        self._started = not ray.is_initialized()
        if self._started:
            self._ray.init(log_to_driver=False, logging_level=logging.ERROR, include_dashboard=False)
        self._objects: dict[bytes, Any] = {}
        self._tasks: dict[Future[Any], Any] = {}

        def task(fn: Callable[..., Any], *args: Any) -> Any:
            import ray  # type: ignore[import-not-found,import-untyped,unused-ignore]
            return fn(*args, ray.get_runtime_context().get_node_id())
        self._task = self._ray.remote(num_cpus=1, max_retries=RETRIES)(task)

    @property
    def width(self) -> int:
        """How many CPUs the cluster has now."""
        return int(self._ray.cluster_resources().get("CPU", 1))

    def submit(self, fn: Callable[..., Any], /, *args: Any, **kwargs: Any) -> Future[Any]:
        """The future of a task."""
        first, *others = args
        if first not in self._objects:
            self._objects[first] = self._ray.put(first)
        reference = self._task.remote(fn, self._objects[first], *others, *kwargs.values())
        future: Future[Any] = reference.future()
        self._tasks[future] = reference
        future.add_done_callback(lambda done: self._tasks.pop(done, None))
        return future

    def shutdown(self, wait: bool = True, *, cancel_futures: bool = False) -> None:
        """Cancels what has not ended, if asked to; ends the cluster that this began."""
        del wait
        if cancel_futures:
            for reference in list(self._tasks.values()):
                self._ray.cancel(reference, force=True)
        if self._started:
            self._ray.shutdown()


def executor_of(name: str | Executor) -> tuple[Executor, bool]:
    """The executor, and whether it is ours to shut down."""
    if isinstance(name, Executor):
        return name, False
    if name == "serial":
        return Serial(), True
    if name == "threads":
        return ThreadPoolExecutor(os.cpu_count() or 1), True
    if name == "ray":
        return Ray(), True
    raise ValueError(f"executor {name!r}: \"serial\", \"threads\", \"ray\" or a concurrent.futures.Executor is expected")


def width_of(executor: Executor) -> int:
    """How many calls it executes at a time, about."""
    return int(getattr(executor, "width", 0) or getattr(executor, "_max_workers", 0) or os.cpu_count() or 1)
