"""The worlds of the project as environments of Gymnasium.

=====================  ==========================================================================
``cla/Pioneer-v0``     a robot with gripper and camera among specimens in a round room (chapter 6)
``cla/Microworld-v0``  an eye, a hand and a ball on a 7 x 7 grid (chapter 5)
``cla/Shuttle-v0``     Chrisman's shuttle between two stations
``cla/Vacuum-v0``      a room to keep clean
``cla/Lake-v0``        the slippery frozen lake, 4 x 4
``cla/Keys-v0``        keys and doors, 48 items
``cla/Generated-v0``   a world that ``world=SEED`` has made
``cla/Pomdp-v0``       the world of a ``.POMDP`` file, ``file=PATH``
=====================  ==========================================================================

An observation is ``MultiBinary(items)``: 1 where an item is on, 0 where it is off or unknown.
``info`` has what nobody in the world perceives (the pose, what was captured), and under ``"cla"`` what
a learner needs to live as in Rust: ``felt``, the percept before any reflex with -1 for what is unknown,
and ``reflexes``, for each what was perceived before, the action it ended as, what was perceived after.
The reward is that of the action and of the reflexes that it led to: the Pioneer's gripper closes by one.

``reset(seed=s)`` makes the world of that seed, the same as in Rust.  ``reset()`` begins the next
episode; a world that is one long episode is made anew by a seed that the environment draws.
"""

from __future__ import annotations

from typing import Any

import gymnasium
import numpy as np
from gymnasium import spaces
from numpy.typing import NDArray

from cla import _checked
from cla._native import World as _World
from cla._native import rooms as _rooms

__all__ = ["World", "Pioneer", "Microworld", "Shuttle", "Vacuum", "Lake", "Keys", "Generated", "Pomdp", "rooms"]


class World(gymnasium.Env[NDArray[np.int8], np.int64]):
    """What all worlds of the project share.

    Parameters
    ----------
    damage : str, optional
        What breaks, ``"camera:+12"``, ``"dead:s3"``, ``"swap:turnl,turnr"``, ``"slip:0.2"`` ...
    damage_at : int
        After how many actions it breaks, counted from when the world was made, across episodes; 0, the
        default, from the beginning.
    **options : float
        The numbers of the world.
    """

    metadata: dict[str, Any] = {"render_modes": []}
    _name = ""
    _episodic = False

    def __init__(self, *, damage: str | None = None, damage_at: int = 0, **options: float) -> None:
        self.render_mode = None
        self._damage = None if damage is None else _checked.text("a damage", damage)
        self._damage_at = _checked.whole("damage_at", damage_at, 0, 2**53)
        self._options = {name: _checked.finite(name, it) for name, it in options.items()}
        self._closed = False
        # Tells names and numbers, and refuses what cannot be, before anybody lives here.
        self._world = self._made(0)
        if self._damage is not None and self._damage_at > 0:
            # What breaks later must be able to break: seen in a world that nobody lives in.
            self._made(0).break_after(self._damage, 0)
        self._begun = False
        self._anew = True
        self.items: tuple[str, ...] = tuple(self._world.items())
        self.actions: tuple[str, ...] = tuple(self._world.actions())
        self.observation_space = spaces.MultiBinary(len(self.items))
        self.action_space = spaces.Discrete(len(self.actions))

    def _text(self) -> str | None:
        return None

    def _made(self, seed: int) -> _World:
        world = _World(self._name, seed, self._options, self._text())
        if self._damage is not None:
            world.break_after(self._damage, self._damage_at)
        return world

    def _open(self) -> _World:
        if self._closed:
            raise ValueError("the environment is closed")
        return self._world

    def reset(
        self, *, seed: int | None = None, options: dict[str, Any] | None = None
    ) -> tuple[NDArray[np.int8], dict[str, Any]]:
        """Begins an episode: of the world of a seed, or of the next one."""
        world = self._open()
        if seed is not None:
            seed = _checked.seed_of(seed)
        super().reset(seed=seed)
        if seed is not None:
            world = self._made(seed)
        elif self._episodic and self._begun:
            world.begin_episode()
        else:
            world = self._made(int(self.np_random.integers(2**63)))
        self._world, self._begun, self._anew = world, True, True
        felt = world.sense()
        return self._seen(felt), self._info(felt, [])

    def step(
        self, action: Any
    ) -> tuple[NDArray[np.int8], float, bool, bool, dict[str, Any]]:
        """Does an action and the reflexes that follow; the reward is all that was earned."""
        world = self._open()
        if not self._begun:
            raise ValueError("the environment has to be reset before its first step")
        index = _checked.whole("an action", action, 0, len(self.actions) - 1)
        felt, earned, reflexes = world.step(index)
        self._anew = False
        over, out_of_time = world.ended()
        info = self._info(felt, reflexes)
        return self._seen(world.sense()), earned, over and not out_of_time, out_of_time, info

    def _live(self, agent: Any, actions: int, paid: bool) -> tuple[float, int, int]:
        """A life that is led in Rust; it begins the world when nobody has."""
        if not self._begun:
            self.reset()
        lived: tuple[float, int, int] = agent.live(self._open(), actions, paid)
        self._anew = False
        return lived

    def _is_ours(self) -> bool:
        """Whether its steps are those of Rust, and not those of a class that stands on this one."""
        ours = ("reset", "step", "_seen", "_info")
        return all(getattr(type(self), name) is getattr(World, name) for name in ours)

    def suffer(self, damage: str) -> None:
        """Something breaks now; it stays broken until the world is made anew.

        A world has at most 32 damages.
        """
        self._open().break_after(_checked.text("a damage", damage), 0)

    def percept(self) -> NDArray[np.int8]:
        """What is sensed now, shape (items,): 1 on, 0 off, -1 unknown."""
        return self._open().sense()

    def close(self) -> None:
        """Ends the environment: afterwards nothing can be done in it."""
        self._closed = True

    @staticmethod
    def _seen(felt: NDArray[np.int8]) -> NDArray[np.int8]:
        return np.maximum(felt, 0)

    def _info(self, felt: NDArray[np.int8], reflexes: list[Any]) -> dict[str, Any]:
        info: dict[str, Any] = self._world.facts()
        info["cla"] = {"felt": felt, "reflexes": reflexes}
        return info


class Pioneer(World):
    """The book's robot: five sectors of a camera, a gripper, a bump sensor; six actions (6.1, 6.2).

    A reward of 1 for every specimen; ``info`` has ``x`` and ``y`` in metres, ``heading`` in radians,
    ``captures`` and ``bump_reflexes``.

    Options: ``radius`` (m, 5), ``specimens`` (28), ``forward`` and ``backward`` (m, 0.5), ``turn``
    (degrees, 5), ``camera_offset`` (degrees, 0), ``camera_range`` (m, 8), ``drop_out`` (share of blobs
    missed, 0.17), ``step_noise`` (share, 0.03), ``turn_noise`` (degrees, 0.5), ``replaced`` (1: taken
    specimens come back elsewhere).
    """

    _name = "pioneer"


class Microworld(World):
    """An eye, a hand and a ball: 76 items, ten actions, no reward (5.4).

    Options: ``slip`` (probability that an action does nothing, 0), ``hidden_body`` (0).
    """

    _name = "microworld"


class Shuttle(World):
    """Chrisman's shuttle: five observations, three actions, hidden states."""

    _name = "shuttle"


class Vacuum(World):
    """A 7 x 7 room to keep clean: 15 items, five actions, a reward of 1 for every piece of dirt."""

    _name = "vacuum"


class Lake(World):
    """The slippery frozen lake: 16 items, four actions; ends at the goal, in a hole, after 100 steps."""

    _name = "lake"
    _episodic = True


class Keys(World):
    """Three rooms and two locked doors: 48 items, six actions; ends with the prize or after 200 steps."""

    _name = "keys"
    _episodic = True


class Generated(World):
    """A world by chance: 6 to 64 items, 3 to 12 actions.

    Options: ``world``, the seed that makes it (0); the seed of ``reset`` decides a life in it.
    """

    _name = "generated"


class Pomdp(World):
    """The world of a ``.POMDP`` file in Cassandra's format; observations are items.

    Parameters
    ----------
    file : str or path
        The file; what is wrong in it is told with line and column.
    """

    _name = "pomdp"

    def __init__(self, file: Any, **arguments: Any) -> None:
        with open(_checked.path("a file", file), encoding="utf-8") as text:
            try:
                self._file = text.read()
            except UnicodeDecodeError as error:
                raise ValueError(f"the file is no text: {error.reason} at byte {error.start}") from None
        super().__init__(**arguments)

    def _text(self) -> str | None:
        return self._file


def rooms(seed: int) -> tuple[int, int, int]:
    """The seeds of the rooms of a life in the experiments of ``host-sim``: two of its childhood, and the third,
    in which it is tested and something breaks."""
    first, second, third = _rooms(_checked.seed_of(seed))
    return first, second, third


def register() -> None:
    """Makes the worlds known to ``gymnasium.make``; done when :mod:`cla` is imported."""
    for world in (Pioneer, Microworld, Shuttle, Vacuum, Lake, Keys, Generated, Pomdp):
        name = f"cla/{world.__name__}-v0"
        if name not in gymnasium.registry:
            gymnasium.register(name, entry_point=f"cla.envs:{world.__name__}", order_enforce=False)
