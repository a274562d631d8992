"""The rows of the rivals of Stable-Baselines3, and the table that the documents make of them.

``UPDATE_ROWS=1 pytest tests/test_rivals.py`` writes the table anew.
"""

import importlib.util
import os
from pathlib import Path

import pytest

HERE = Path(__file__).parents[1]
ROWS, PAGE = HERE / "rivals.jsonl", HERE.parents[1] / "docs/python.md"
BEGIN, END = "<!-- rows: rivals -->\n", "<!-- end -->"


@pytest.fixture(scope="module")
def rivals():
    spec = importlib.util.spec_from_file_location("rivals", HERE / "examples/rivals.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_the_table_of_the_page_is_that_of_the_rows(rivals):
    page = PAGE.read_text(encoding="utf-8")
    before, rest = page.split(BEGIN)
    _, after = rest.split(END, 1)
    told = before + BEGIN + rivals.table(rivals.read(ROWS)) + END + after
    if os.environ.get("UPDATE_ROWS"):
        PAGE.write_text(told, encoding="utf-8")
    else:
        assert page == told, "run UPDATE_ROWS=1 pytest tests/test_rivals.py"


def test_no_life_is_told_twice_and_all_are_of_the_chosen_settings(rivals):
    rows = rivals.read(ROWS)
    lives = [(row["learner"], row["training"], row["damage"], row["seed"]) for row in rows]
    assert len(set(lives)) == len(lives)
    for row in rows:
        assert row["settings"] == rivals.CHOSEN[row["learner"]] and row["test"] == rivals.TEST
        assert 100 <= row["seed"] < 200


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
