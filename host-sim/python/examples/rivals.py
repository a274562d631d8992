"""Rivals of Stable-Baselines3 live the life of ``one.recover``: two rooms, a third one, then a damage.

    python examples/rivals.py ppo 100..110 --out rows.jsonl     # one line of JSON a life
    python examples/rivals.py --table rows.jsonl                # those lines as a table

``ppo`` and ``dqn`` see the last four percepts, ``recurrent`` (PPO of sb3-contrib) has an LSTM.  A life
is ``--training`` actions in two rooms, 3000 in a third one, and 3000 more after the damage; nobody tells
the learner, which goes on learning all the time.  The reward is 1 for a specimen.

Needs stable-baselines3, sb3-contrib and PyTorch; one thread, no GPU.
"""

from __future__ import annotations

import argparse
import json
import statistics
import sys
import time
from collections import defaultdict, deque
from pathlib import Path
from typing import Any

import gymnasium
import numpy as np

from cla import envs

TEST = 3000
FRAMES = 4

#: What differs from the usual of Stable-Baselines3: a rollout of 250 actions, a discount for rewards that
#: come every ten actions or so, some chance.  Written before the first life and not tuned since: ``--tune``
#: lives those of ``TRIED``, which for the recurrent learner are those of PPO.
CHOSEN: dict[str, dict[str, Any]] = {
    "ppo": {"learning_rate": 1e-3, "n_steps": 250, "batch_size": 125, "gamma": 0.95, "ent_coef": 0.01},
    "dqn": {"learning_rate": 1e-3, "gamma": 0.95, "exploration_final_eps": 0.05, "train_freq": 4},
    "recurrent": {"learning_rate": 1e-3, "n_steps": 250, "batch_size": 125, "gamma": 0.95, "ent_coef": 0.01},
}
TRIED: dict[str, list[dict[str, Any]]] = {
    "ppo": [
        {"learning_rate": rate, "n_steps": 250, "batch_size": 125, "gamma": gamma, "ent_coef": 0.01}
        for rate in (3e-4, 1e-3, 3e-3)
        for gamma in (0.95, 0.99)
    ],
    "dqn": [
        {"learning_rate": rate, "gamma": gamma, "exploration_final_eps": 0.05, "train_freq": 4}
        for rate in (3e-4, 1e-3, 3e-3)
        for gamma in (0.95, 0.99)
    ],
}
TRIED["recurrent"] = TRIED["ppo"]


class Course(gymnasium.Env[Any, Any]):
    """The whole life as one environment, which counts what is captured in every part."""

    def __init__(self, seed: int, training: int, damage: str, test: int, frames: int = 1) -> None:
        self.world = envs.Pioneer()
        self.frames: deque[Any] = deque(maxlen=frames)
        self.rooms = envs.rooms(seed)
        self.damage = damage
        self.changes = {
            training // 2: self._enter_second,
            training: self._enter_third,
            training + test: self._break,
            # What PPO collects beyond it, in whole rollouts, is no part of the life.
            training + 2 * test: lambda observation: observation,
        }
        self.parts, self.done = [0], 0
        size = (frames * len(self.world.items),)
        self.observation_space = gymnasium.spaces.Box(0.0, 1.0, size, np.float32)
        self.action_space = self.world.action_space

    def _seen(self, observation: Any) -> Any:
        """The last percepts, the newest at the end."""
        while len(self.frames) < self.frames.maxlen - 1:
            self.frames.append(observation)
        self.frames.append(observation)
        return np.concatenate(self.frames).astype(np.float32)

    def _enter_second(self, _: Any) -> Any:
        return self.world.reset(seed=self.rooms[1])[0]

    def _enter_third(self, _: Any) -> Any:
        return self.world.reset(seed=self.rooms[2])[0]

    def _break(self, _: Any) -> Any:
        self.world.suffer(self.damage)
        return np.maximum(self.world.percept(), 0)

    def reset(self, *, seed: int | None = None, options: dict[str, Any] | None = None) -> Any:
        super().reset(seed=seed)
        self.frames.clear()
        return self._seen(self.world.reset(seed=self.rooms[0])[0]), {}

    def step(self, action: Any) -> Any:
        observation, reward, *rest = self.world.step(int(action))
        self.parts[-1] += int(reward)
        self.done += 1
        change = self.changes.get(self.done)
        if change is not None:
            observation = change(observation)
            self.parts.append(0)
        return (self._seen(observation), reward, *rest)


def learner(name: str, env: Any, seed: int, settings: dict[str, Any]) -> Any:
    """A newborn of Stable-Baselines3."""
    import stable_baselines3
    import torch

    torch.set_num_threads(1)
    common: dict[str, Any] = {"seed": seed, "device": "cpu", "verbose": 0}
    if name == "ppo":
        return stable_baselines3.PPO("MlpPolicy", env, **common, **settings)
    if name == "dqn":
        usual = {"buffer_size": 50_000, "learning_starts": 500, "target_update_interval": 500}
        return stable_baselines3.DQN("MlpPolicy", env, **common, **usual, **settings)
    import sb3_contrib

    policy = {"lstm_hidden_size": 32}
    return sb3_contrib.RecurrentPPO("MlpLstmPolicy", env, policy_kwargs=policy, **common, **settings)


def life(name: str, seed: int, training: int, damage: str, test: int, settings: dict[str, Any]) -> dict[str, Any]:
    """One life, as a row."""
    begun = time.process_time()
    course = Course(seed, training, damage, test, 1 if name == "recurrent" else FRAMES)
    whole = training + 2 * test
    # DQN's chance falls in the first half of the training.
    falling = {"exploration_fraction": training / 2 / whole} if name == "dqn" else {}
    model = learner(name, course, seed, {**settings, **falling})
    model.learn(whole)
    trained = course.parts[0] + course.parts[1]
    assert course.done >= whole and len(course.parts) == 5
    return {
        "learner": name,
        "seed": seed,
        "training": training,
        "damage": damage,
        "test": test,
        "in_training": trained,
        "undamaged": course.parts[2],
        "damaged": course.parts[3],
        "seconds": round(time.process_time() - begun, 1),
        "settings": settings,
    }


def table(rows: list[dict[str, Any]]) -> str:
    """Means and standard deviations of the rows that were made alike, in Markdown."""
    groups = defaultdict(list)
    for row in rows:
        settings = ", ".join(f"{name} {it}" for name, it in row["settings"].items())
        groups[row["training"], row["learner"], row["damage"], row["test"], settings].append(row)
    lines = [
        "| learner | training | undamaged | damage | damaged | test | seeds | settings |",
        "|---|---:|---:|---|---:|---:|---|---|",
    ]
    for (training, name, damage, test, settings), group in sorted(groups.items()):
        seeds = sorted(row["seed"] for row in group)
        cells = [spread([row[part] for row in group]) for part in ("undamaged", "damaged")]
        lines.append(
            f"| {name} | {training:,} | {cells[0]} | `{damage}` | {cells[1]} | {test:,} "
            f"| {seeds[0]}–{seeds[-1]}, n = {len(seeds)} | {settings} |"
        )
    return "\n".join(lines) + "\n"


def spread(values: list[float]) -> str:
    """A mean and the standard deviation over seeds."""
    deviation = f" ± {statistics.stdev(values):.0f}" if len(values) > 1 else ""
    return f"{statistics.mean(values):.0f}{deviation}"


def read(path: Path) -> list[dict[str, Any]]:
    """The rows of a file."""
    return [json.loads(line) for line in path.read_text(encoding="utf-8").splitlines()]


def main() -> None:
    """The command."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("learner", nargs="?", choices=sorted(CHOSEN))
    parser.add_argument("seeds", nargs="?", help="A..B")
    parser.add_argument("--training", type=int, default=20_000)
    parser.add_argument("--damage", default="camera:+12")
    parser.add_argument("--test", type=int, default=TEST, help="actions before and after the damage")
    parser.add_argument("--tune", action="store_true", help="every setting of the grid, not the chosen one")
    parser.add_argument("--out", type=Path, help="where rows are appended")
    parser.add_argument("--table", type=Path, help="a file of rows to be shown")
    given = parser.parse_args()
    if given.table is not None:
        print(table(read(given.table)), end="")
        return
    if given.learner is None or given.seeds is None:
        parser.error("a learner and its seeds are needed")
    first, end = map(int, given.seeds.split(".."))
    tried = TRIED[given.learner] if given.tune else [CHOSEN[given.learner]]
    for settings in tried:
        for seed in range(first, end):
            row = life(given.learner, seed, given.training, given.damage, given.test, settings)
            line = json.dumps(row)
            print(line, flush=True)
            if given.out is not None:
                with given.out.open("a", encoding="utf-8") as file:
                    print(line, file=file)


if __name__ == "__main__":
    sys.exit(main())
