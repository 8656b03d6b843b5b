# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""The names and habits of PyODE 1.2, so that its programs run with one changed import:

>>> import epode.ode as ode
>>> world = ode.World()
>>> world.setGravity((0, 0, -9.81))
>>> ball = ode.Body(world)
>>> world.step(0.1)
>>> ball.getLinearVel()
(0.0, 0.0, -0.9810000000000001)

As there, objects are destroyed when nothing refers to them any more: a space does not keep its geoms, and a world does
not keep its bodies; a joint group keeps its joints. What the library refuses raises ``epode.RefusedError``, a ValueError.
"""
from ._base import *  # noqa: F403
from ._dynamics import *  # noqa: F403
from ._geoms import *  # noqa: F403
from ._parameters import *  # noqa: F403
from ._spaces import *  # noqa: F403
