"""The life that the rivals of Stable-Baselines3 live; they themselves need PyTorch (`tests/run python_rivals`)."""

import importlib.util
import json
from pathlib import Path

import pytest

HERE = Path(__file__).parents[1]
ROOMS_OF_7 = (7, 4603104468681784384, 3141236514677479789)


@pytest.fixture(scope="module")
def rivals():
    spec = importlib.util.spec_from_file_location("rivals", HERE / "examples/rivals.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_rows_are_a_table_of_means_by_what_they_were_made_with(rivals, tmp_path):
    rows = [
        {
            "learner": name,
            "seed": seed,
            "training": training,
            "damage": "dead:s3",
            "test": 3000,
            "undamaged": taken,
            "damaged": 1,
            "settings": {"gamma": gamma},
        }
        for name, seed, training, taken, gamma in [
            ("ppo", 101, 20_000, 14, 0.95),
            ("ppo", 100, 20_000, 10, 0.95),
            ("ppo", 100, 20_000, 99, 0.99),
            ("dqn", 100, 500, 3, 0.95),
        ]
    ]
    path = tmp_path / "rows.jsonl"
    path.write_text("".join(json.dumps(row) + "\n" for row in rows), encoding="utf-8")
    table = rivals.table(rivals.read(path)).splitlines()
    assert table[2:] == [
        "| dqn | 500 | 3 | `dead:s3` | 1 | 3,000 | 100–100, n = 1 | gamma 0.95 |",
        "| ppo | 20,000 | 12 ± 3 | `dead:s3` | 1 ± 0 | 3,000 | 100–101, n = 2 | gamma 0.95 |",
        "| ppo | 20,000 | 99 | `dead:s3` | 1 | 3,000 | 100–100, n = 1 | gamma 0.99 |",
    ]


def test_every_learner_can_be_tuned_and_what_was_chosen_was_tried(rivals):
    assert set(rivals.TRIED) == set(rivals.CHOSEN)
    for name, chosen in rivals.CHOSEN.items():
        assert chosen in rivals.TRIED[name]


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
    # The rooms are those of Rust's `host_sim::world::setting::rooms`, whose example has the same numbers.
    assert course.rooms == ROOMS_OF_7
    assert course.world._world.facts()["actions"] == 25
    assert all(seen[29:]) and not all(seen[:29])
    assert sum(course.parts) == 0
