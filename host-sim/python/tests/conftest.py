"""What the tests share: the lives that Rust's tests hold, too."""

import importlib
import importlib.machinery
import importlib.util
import json
import sys
import types
from pathlib import Path
from typing import Any
from unittest.mock import MagicMock

import numpy as np
import pytest

LIVES = json.loads((Path(__file__).parent / "lives.json").read_text(encoding="utf-8"))


class Digest:
    """FNV-1a over words of percepts, actions and rewards, as ``host_sim::learner::digest`` says it."""

    def __init__(self) -> None:
        self.value = 0xCBF29CE484222325

    def _bytes(self, data: bytes) -> None:
        for byte in data:
            self.value = (self.value ^ byte) * 0x100000001B3 % 2**64

    def percept(self, states: Any) -> None:
        for wanted in (1, 0):
            words = np.zeros(4, dtype="<u4")
            for item in np.flatnonzero(np.asarray(states) == wanted):
                words[item // 32] |= np.uint32(1) << np.uint32(item % 32)
            self._bytes(words.tobytes())

    def hex(self) -> str:
        return f"{self.value:016x}"


@pytest.fixture(scope="session")
def stable_baselines_check():
    """Stable-Baselines3's ``check_env``.

    The package imports PyTorch, gigabytes that the check itself does not use: where it is missing, a
    placeholder stands in for it and the package's front page is passed over.
    """
    found = importlib.util.find_spec("stable_baselines3")
    if found is None or found.submodule_search_locations is None:
        pytest.skip("Stable-Baselines3 is not installed")
    if importlib.util.find_spec("torch") is None:
        package = types.ModuleType("stable_baselines3")
        package.__path__ = list(found.submodule_search_locations)
        sys.modules["stable_baselines3"] = package
        for name in ("torch", "torch.nn", "torch.nn.functional", "torch.distributions"):
            spec = importlib.machinery.ModuleSpec(name, None)
            sys.modules[name] = MagicMock(__path__=[], __spec__=spec)
    return importlib.import_module("stable_baselines3.common.env_checker").check_env
