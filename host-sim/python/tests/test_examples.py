"""Every example runs by itself, within a minute, and says what it found."""

import subprocess
import sys
from pathlib import Path

import pytest

EXAMPLES = sorted((Path(__file__).parents[1] / "examples").glob("chapter*.py"))


def test_there_is_one_for_every_chapter_with_results():
    assert [it.name.split("_")[0] for it in EXAMPLES] == [f"chapter{it}" for it in (2, 3, 4, 5, 6, 7)]


@pytest.mark.parametrize("path", EXAMPLES, ids=lambda it: it.stem)
def test_an_example_runs_within_a_minute(path, tmp_path):
    done = subprocess.run(
        [sys.executable, path], cwd=tmp_path, capture_output=True, text=True, timeout=60, check=False
    )
    assert done.returncode == 0, done.stderr
    assert len(done.stdout.splitlines()) >= 3
