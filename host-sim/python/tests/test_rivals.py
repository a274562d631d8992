"""The life that the rivals of Stable-Baselines3 live; they themselves need PyTorch (`tests/run python_rivals`)."""

import importlib.util
import json
from pathlib import Path

import pytest

HERE = Path(__file__).parents[1]


@pytest.fixture(scope="module")
def rivals():
    spec = importlib.util.spec_from_file_location("rivals", HERE / "examples/rivals.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_rows_are_a_table_of_means_by_learner_and_training(rivals, tmp_path):
    rows = [
        {"learner": name, "seed": seed, "training": training, "damage": "dead:s3", "undamaged": taken, "damaged": 1}
        for name, seed, training, taken in [("ppo", 101, 20_000, 14), ("ppo", 100, 20_000, 10), ("dqn", 100, 500, 3)]
    ]
    path = tmp_path / "rows.jsonl"
    path.write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")
    table = rivals.table(rivals.read(path)).splitlines()
    assert table[2:] == [
        "| dqn | 500 | 3 | `dead:s3` | 1 | 100–100, n = 1 |",
        "| ppo | 20,000 | 12 ± 3 | `dead:s3` | 1 ± 0 | 100–101, n = 2 |",
    ]


def test_a_course_is_two_rooms_a_third_one_and_a_damage(rivals):
    course = rivals.Course(seed=7, training=20, damage="stuck:s1", test=10, frames=4)
    assert course.reset()[0].shape == (28,)
    seen, poses = [], []
    for _ in range(45):
        observation, *_, info = course.step(2)
        if len(seen) > 3:
            # The first of the frames is the newest of three actions ago.
            assert observation[0] == seen[-3]
        seen.append(observation[21])
        poses.append(info["heading"])
    assert len(course.parts) == 5 and course.done == 45
    # After 10 and 20 actions it is elsewhere; from the damage on s1 is on.
    assert course.rooms == rivals.envs.rooms(7) and len(set(course.rooms)) == 3
    assert course.world._world.facts()["actions"] == 25
    assert all(seen[29:]) and not all(seen[:29])
    assert sum(course.parts) == 0
