"""The chapter of the guide on Python: its code runs, block after block, as one program."""

import re
from pathlib import Path

import pytest

CHAPTER = Path(__file__).parents[3] / "docs/guide/src/python.md"


def test_the_code_of_the_chapter_runs(monkeypatch, tmp_path, capsys):
    pytest.importorskip("pandas")
    monkeypatch.chdir(tmp_path)
    blocks = re.findall(r"^```python\n(.*?)^```", CHAPTER.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    assert len(blocks) >= 6
    names = {"__name__": "guide"}
    for number, block in enumerate(blocks):
        exec(compile(block, f"{CHAPTER.name}, block {number}", "exec"), names)
    assert (tmp_path / "courier.brain").is_file()
    assert "parcels in 1000 actions" in capsys.readouterr().out
