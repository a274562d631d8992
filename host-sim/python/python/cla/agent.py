"""The one learner: what it perceives are binary items, what it does are discrete actions."""

from __future__ import annotations

import json
import os
import struct
from typing import Any, Iterable, Mapping, NamedTuple, Sequence

import gymnasium
import numpy as np
from gymnasium.wrappers import (
    OrderEnforcing,
    PassiveEnvChecker,
    RecordEpisodeStatistics,
    TimeLimit,
)

from cla import _checked
from cla._native import Agent as _Native

__all__ = ["Agent", "Choice", "Life"]

# The version is raised whenever what is pickled beside the image changes.
# Wrappers whose steps are those of what lies in them, to the observation and the action.
_COUNTING = (OrderEnforcing, PassiveEnvChecker, RecordEpisodeStatistics, TimeLimit)
_HEAD = b"CLAPY\x02\x00\x00"
_FRESH = 0xCBF2_9CE4_8422_2325


def _bare(env: Any) -> Any:
    """The world of the project that lies here, where nothing around it changes what comes through."""
    while isinstance(env, (OrderEnforcing, PassiveEnvChecker)):
        env = env.env
    is_ours = getattr(env, "_is_ours", None) if not isinstance(env, gymnasium.Wrapper) else None
    return env if is_ours is not None and is_ours() else None


def _behind(env: Any) -> Any:
    """The world of the project around which wrappers at most count and end; else ``None``."""
    while isinstance(env, gymnasium.Wrapper):
        passes = type(env).step is gymnasium.Wrapper.step
        if not passes and type(env) not in _COUNTING:
            return None
        env = env.env
    is_ours = getattr(env, "_is_ours", None)
    return env if is_ours is not None and is_ours() else None


class Choice(NamedTuple):
    """What :meth:`Agent.choose` decided."""

    action: int
    """The index of the action."""
    value: float
    """What it is held to be worth, in discounted rewards."""
    motive: str
    """Who decided: a voice, ``"chance"``, ``"escape"`` from a loop, or ``"goal"``."""


class Life(NamedTuple):
    """What came of :meth:`Agent.live`."""

    earned: float
    """Rewards less costs, as the world counts them."""
    actions: int
    """Actions done."""
    episodes: int
    """Episodes that ended."""


class Agent:
    """A learner that is born with the names of its items and actions.

    Parameters
    ----------
    items : sequence of str
        The names of the binary items, 1 to 112 of them; an observation has one number for each.
    actions : sequence of str
        The names of the actions, 1 to 24.
    values : mapping or sequence of float, optional
        What it is worth, in reward, when an item is on after an action: ``{"ingrip": 10.0}``, or a
        number for every item, each from -10,000 to 10,000.  Items without a value are worth nothing.
    profile : str
        How much memory it has, see ``cla.PROFILES``: ``"standard"`` (7168 samples), ``"small"`` or
        ``"planner"``, which has schemas with results, plans and goals.
    seed : int
        Decides everything that is left to chance, 0 to 2**64 - 1.
    **config : float, str or list of str
        Settings, as those of ``host-sim live``: ``exploring=0.2``, ``doubt_lasts=800``,
        ``doubting="never"``, ``heard_doubting=["habits"]``; see ``MindConfig`` in Rust.  One that does
        not exist is refused with the nearest that does.

    A robot whose items and actions are as many as those of a world of the project gets a mind of just
    that size, and its life is that of Rust's.  Others get the smallest of the forms (32, 8), (64, 12)
    and (112, 24) that holds them: see :attr:`form`.

    Examples
    --------
    >>> import cla
    >>> agent = cla.Agent(["light", "lamp"], ["stay", "go"], values={"lamp": 1.0}, seed=1)
    >>> choice = agent.choose([1, 0])
    >>> agent.learn([0, 1])
    1.0
    """

    def __init__(
        self,
        items: Sequence[str],
        actions: Sequence[str],
        values: Mapping[str, float] | Sequence[float] | None = None,
        *,
        profile: str = "standard",
        seed: int = 0,
        **config: Any,
    ) -> None:
        self.items = _checked.named("items", items)
        self.actions = _checked.named("actions", actions)
        self.profile = _checked.text("a profile", profile)
        #: The seed that it was born with; ``None`` when its life was loaded.
        self.seed: int | None = _checked.seed_of(seed)
        self._given = {name: _checked.setting(name, it) for name, it in config.items()}
        self._worth = self._valued(values)
        self._native = self._born()

    @classmethod
    def for_env(
        cls, env: Any, values: Mapping[str, float] | None = None, **arguments: Any
    ) -> "Agent":
        """An agent for an environment of the project, whose items and actions have names."""
        inner = env.unwrapped
        if not hasattr(inner, "items") or not hasattr(inner, "actions"):
            raise ValueError(f"{type(inner).__name__} does not name its items and actions; say them to Agent")
        return cls(inner.items, inner.actions, values, **arguments)

    def _valued(self, values: Any) -> tuple[float, ...]:
        if values is None:
            return (0.0,) * len(self.items)
        if isinstance(values, Mapping):
            unknown = [name for name in values if name not in self.items]
            if unknown:
                raise ValueError(f"values name {unknown[0]!r}, which is no item")
            return tuple(_checked.finite(f"the value of {name}", values.get(name, 0.0)) for name in self.items)
        numbers = tuple(values)
        if len(numbers) != len(self.items):
            raise ValueError(f"{len(self.items)} items have {len(self.items)} values, not {len(numbers)}")
        return tuple(
            _checked.finite(f"the value of {name}", it) for name, it in zip(self.items, numbers)
        )

    def _born(self) -> _Native:
        return _Native(
            list(self.items),
            list(self.actions),
            list(self._worth),
            self.profile,
            self.seed or 0,
            json.dumps(self._given, allow_nan=False),
        )

    # --- a step ---------------------------------------------------------------------------------

    def choose(self, observation: Any, allowed: Iterable[int] | None = None) -> Choice:
        """What to do now.

        Parameters
        ----------
        observation : array of shape (items,)
            0 off, 1 on, -1 unknown; numbers of any type, or booleans.
        allowed : iterable of int, optional
            The actions among which to choose; all when not given.
        """
        mask = None
        if allowed is not None:
            most = len(self.actions) - 1
            mask = [_checked.whole("an allowed action", it, 0, most) for it in allowed]
        now = _checked.percept(observation, self.items)
        return Choice(*self._native.choose(now, mask))

    def learn(self, observation: Any, reward: float = 0.0) -> float:
        """The action that was chosen last has led to ``observation``.

        ``reward`` comes beside the values of the items, from -10,000 to 10,000.
        Returns all that the action brought.
        """
        now = _checked.percept(observation, self.items)
        return self._native.learn(now, _checked.finite("a reward", reward))

    def observe(self, before: Any, action: int, after: Any) -> float:
        """Somebody else's action, a reflex's or a teacher's, has led from ``before`` to ``after``."""
        index = _checked.whole("an action", action, 0, len(self.actions) - 1)
        return self._native.observe(
            _checked.percept(before, self.items), index, _checked.percept(after, self.items)
        )

    def learn_from(self, step: tuple[Any, ...], *, paid: bool | None = None) -> float:
        """Learns from what ``env.step(choice.action)`` returned, reflexes and the end of an episode included.

        ``paid`` says whether the environment's reward counts beside the values of the items; when it
        is not given, it does for an agent without values.
        """
        brought = self._learn_from(step, self._is_paid(paid))
        if step[2] or step[3]:
            self.interrupt()
        return brought

    def _learn_from(self, step: tuple[Any, ...], is_paid: bool) -> float:
        observation, reward, _, _, info = step
        own = info.get("cla", {})
        brought = self.learn(own.get("felt", observation), reward if is_paid else 0.0)
        for before, action, after in own.get("reflexes", ()):
            self.observe(before, action, after)
        return brought

    def _is_paid(self, paid: bool | None) -> bool:
        return not any(self._worth) if paid is None else bool(paid)

    def interrupt(self) -> None:
        """The episode is over: what comes next does not follow from what was."""
        self._native.interrupt()

    def act(self) -> None:
        """Training is over: it goes on learning, and tries less."""
        self._native.act()

    def live(self, env: Any, actions: int, *, paid: bool | None = None) -> Life:
        """Lives in an environment for so many actions, across episodes.

        In a world of the project the whole life is led in Rust, and is the life of Rust to the bit;
        the environment stands where it ended.  Where a wrapper lies around it that may change what
        comes through, and in any other environment with as many binary items and discrete actions, a
        life begins with a reset and goes step by step through ``env.step``: what that returns is all
        that the agent learns from.  Through wrappers that only count and end, such as ``TimeLimit``, it
        learns from the percepts of the world and from its reflexes, as in :meth:`learn_from`.
        After a reset what comes next does not follow from what was: :meth:`interrupt` is called.

        ``paid`` is that of :meth:`learn_from`.
        """
        count = _checked.whole("the number of actions", actions, 0, 2**40)
        is_paid = self._is_paid(paid)
        world = _bare(env)
        if world is not None:
            if world._anew and self._has_lived():
                self.interrupt()
            return Life(*world._live(self._native, count, is_paid))
        if count == 0:
            return Life(0.0, 0, 0)
        earned, episodes, world = 0.0, 0, _behind(env)
        observation = self._reset(env, world)
        for _ in range(count):
            step = env.step(self.choose(observation).action)
            observation, reward, terminated, truncated, _ = step
            if world is None:
                self.learn(observation, reward if is_paid else 0.0)
            else:
                self._learn_from(step, is_paid)
                observation = world.percept()
            earned += float(reward)
            if terminated or truncated:
                episodes += 1
                observation = self._reset(env, world)
        return Life(earned, count, episodes)

    def _reset(self, env: gymnasium.Env[Any, Any], world: Any) -> Any:
        if self._has_lived():
            self.interrupt()
        observation, _ = env.reset()
        return observation if world is None else world.percept()

    def _has_lived(self) -> bool:
        return bool(self._native.inside()["samples"])

    # --- goals and reasons ----------------------------------------------------------------------

    def pursue(self, goal: str | Mapping[str, bool], observation: Any, limit: int = 50) -> str:
        """Pursues a goal from now on, for at most ``limit`` actions; only in the profile ``"planner"``.

        ``goal`` is a conjunction of signed items, ``"+hgr-bump"`` or ``{"hgr": True, "bump": False}``.
        Returns how the pursuit stands, see :attr:`pursuit`.
        """
        steps = _checked.whole("a limit", limit, 1, 65_535)
        now = _checked.percept(observation, self.items)
        return self._native.pursue(self._goal(goal), steps, now)[0]

    def _goal(self, goal: Any) -> list[tuple[int, bool]]:
        if isinstance(goal, str):
            words, sign = {}, None
            for part in goal.replace("-", " -").replace("+", " +").split():
                sign, name = part[0], part[1:]
                if sign not in "+-":
                    raise ValueError(f"a goal is written +item-item, not {goal!r}")
                words[name] = sign == "+"
            goal = words
        if not goal:
            raise ValueError("a goal has at least one item")
        unknown = [name for name in goal if name not in self.items]
        if unknown:
            raise ValueError(f"the goal names {unknown[0]!r}, which is no item")
        return [(self.items.index(name), bool(sign)) for name, sign in goal.items()]

    def give_up(self) -> None:
        """Pursues nothing any more."""
        self._native.give_up()

    @property
    def pursuit(self) -> str:
        """``"nothing"``, ``"underway"``, ``"reached"`` or ``"timed out"``."""
        return self._native.pursuit()[0]

    def way(self, observation: Any) -> int | None:
        """Actions from here to the goal, if all comes as foreseen; ``None`` when no way is known."""
        return self._native.way(_checked.percept(observation, self.items))

    def idle(self, units: int) -> bool:
        """Thinks for so many units of work; whether there is more to think about."""
        return self._native.idle(_checked.whole("units", units, 0, 2**32 - 1))

    def explain(self) -> dict[str, Any] | None:
        """Why the last action was chosen, as a schema in the book's notation; ``None`` after learning."""
        why = self._native.explain()
        return None if why is None else dict(zip(("schema", "value", "motive"), why))

    # --- what it knows --------------------------------------------------------------------------

    def schemas(self) -> list[dict[str, Any]]:
        """All that it says of actions, a dictionary each: ``pandas.DataFrame(agent.schemas())``.

        With the profile ``"planner"`` they are schemas with ``result``, ``successes``, ``activations``
        and ``reliability``; with the others the contexts of its trees, with ``value`` in discounted
        rewards, ``before`` (items when the action before was chosen) and ``after`` (that action).
        """
        return self._native.schemas()

    def inside(self) -> dict[str, Any]:
        """Counts: samples, leaves, alarms, stuck items, bytes, and each voice's record and blocks led."""
        return self._native.inside()

    @property
    def values(self) -> tuple[float, ...]:
        """What each item is worth."""
        return tuple(self._native.values())

    @property
    def config(self) -> dict[str, Any]:
        """The whole configuration: names and values, as ``Agent(…, **config)`` takes them."""
        return json.loads(self._native.config())

    @property
    def form(self) -> tuple[int, int]:
        """Items and actions of the mind's type, which may be more than the robot's."""
        return self._native.form

    @property
    def digest(self) -> str:
        """All that was perceived, chosen and felt, as 16 hexadecimal digits; equal where lives are."""
        return f"{self._native.digest:016x}"

    # --- kept -----------------------------------------------------------------------------------

    def image(self) -> bytes:
        """Its life as the bytes of a snapshot, which Rust and firmware of the same form read too."""
        return self._native.save()

    def save(self, path: str | os.PathLike[str]) -> None:
        """Keeps its life in a file, in place of what the file held."""
        path = _checked.path("what is saved into", path)
        beside = f"{os.fspath(path)}.unfinished.{os.getpid()}"
        try:
            with open(beside, "wb") as file:
                file.write(self.image())
                file.flush()
                os.fsync(file.fileno())
            os.replace(beside, path)
        finally:
            if os.path.exists(beside):
                os.remove(beside)

    def load(self, image: str | os.PathLike[str] | bytes) -> None:
        """Takes a life from a file or from the bytes of an image; with an error it is as it was.

        Values and configuration are those of that life, its seed is not known any more, and its
        :attr:`digest` begins anew.
        """
        if isinstance(image, (bytes, bytearray, memoryview)):
            data = bytes(image)
        else:
            with open(_checked.path("an image", image), "rb") as file:
                data = file.read()
        self._native.load(data, _FRESH)
        self.seed = None
        self._worth, self._given = self.values, self.config

    def __getstate__(self) -> dict[str, Any]:
        state = {name: it for name, it in self.__dict__.items() if name != "_native"}
        state["image"] = _HEAD + struct.pack("<Q", self._native.digest) + self.image()
        return state

    def __setstate__(self, state: dict[str, Any]) -> None:
        kept = dict(state)
        image = kept.pop("image")
        if image[: len(_HEAD)] != _HEAD:
            was = f"version {image[5]}" if image[:5] == _HEAD[:5] and len(image) > 5 else "no version"
            raise ValueError(f"a pickled agent of {was}: those of version {_HEAD[5]} can be read")
        self.__dict__.update(kept)
        self._native = self._born()
        (digest,) = struct.unpack_from("<Q", image, len(_HEAD))
        self._native.load(image[len(_HEAD) + 8 :], digest)

    def __repr__(self) -> str:
        return (
            f"Agent({len(self.items)} items, {len(self.actions)} actions, "
            f"profile={self.profile!r}, seed={self.seed})"
        )
