"""What comes in from Python, made into what the native half takes, or refused in one sentence."""

from __future__ import annotations

import operator
import os
from typing import Any, Sequence

import numpy as np
from numpy.typing import NDArray


def whole(what: str, value: Any, least: int, most: int) -> int:
    """An integer between two others, of any type that has an index."""
    try:
        number = operator.index(value)
    except TypeError:
        raise ValueError(f"{what} is a whole number, not {value!r}") from None
    if not least <= number <= most:
        raise ValueError(f"{what} is from {least} to {most}, not {number}")
    return number


def seed_of(value: Any) -> int:
    """A seed: 0 to 2**64 - 1."""
    return whole("a seed", value, 0, 2**64 - 1)


def finite(what: str, value: Any) -> float:
    """A finite number."""
    try:
        number = float(value)
    except (TypeError, ValueError):
        raise ValueError(f"{what} is a number, not {value!r}") from None
    if not np.isfinite(number):
        raise ValueError(f"{what} is finite, not {number}")
    return number


def percept(observation: Any, items: Sequence[str]) -> NDArray[np.int8]:
    """An observation as one ``int8`` for every item: -1 unknown, 0 off, 1 on."""
    array = np.asarray(observation)
    if array.shape != (len(items),):
        raise ValueError(
            f"an observation has one number for each of {len(items)} items, not shape {array.shape}"
        )
    if array.dtype.kind not in "biuf":
        raise ValueError(f"an observation has numbers, not {array.dtype}")
    if array.dtype != np.int8:
        wrong = ~np.isin(array, (-1, 0, 1))
        if wrong.any():
            at = int(np.argmax(wrong))
            raise ValueError(f"item {at} ({items[at]}) is 0, 1 or -1 for unknown, not {array[at]}")
        array = array.astype(np.int8)
    return np.ascontiguousarray(array)


def named(what: str, names: Any) -> tuple[str, ...]:
    """Names that are texts without signs, slashes or doubles."""
    if isinstance(names, str):
        raise ValueError(f"{what} are a list of names, not one text")
    all_names = tuple(names)
    for at, name in enumerate(all_names):
        if not isinstance(name, str) or not name:
            raise ValueError(f"{what}[{at}] is a name, not {name!r}")
        if any(sign in name for sign in "+-/"):
            raise ValueError(f"{what}[{at}] is {name!r}, and a name has no +, - or /")
    if len(set(all_names)) != len(all_names):
        double = next(name for name in all_names if all_names.count(name) > 1)
        raise ValueError(f"{what} have {double!r} twice")
    return all_names


def setting(name: str, value: Any) -> Any:
    """A value of a configuration: a word, a list of words, or a finite number."""
    if value is None or isinstance(value, (str, bool)):
        return value
    if isinstance(value, (list, tuple)) and all(isinstance(it, str) for it in value):
        return list(value)
    number = finite(name, value)
    return int(number) if number.is_integer() else number


def text(what: str, value: Any) -> str:
    """A text."""
    if not isinstance(value, str):
        raise ValueError(f"{what} is a text, not {value!r}")
    return value


def path(what: str, value: Any) -> str | os.PathLike[str]:
    """The name of a file."""
    if not isinstance(value, (str, os.PathLike)):
        raise ValueError(f"{what} is the path of a file, not {value!r}")
    return value
