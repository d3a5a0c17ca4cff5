"""What every result of a command has."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field
from typing import Any, TypeVar

from ._decode import WHOLE

T = TypeVar("T")


@dataclass(frozen=True)
class Answer:
    """What a command answered.

    Attributes
    ----------
    raw : mapping
        The whole answer of the program, as its JSON.
    """

    raw: Mapping[str, Any] = field(repr=False, compare=False, metadata=WHOLE)


def called(name: str, among: Iterable[T], attribute: str, what: str) -> T:
    """The one whose `attribute` is `name`. Raises `KeyError` with the known names where there is none: `what` begins
    that sentence, such as "the trials are"."""
    known: list[str] = []
    for one in among:
        if getattr(one, attribute) == name:
            return one
        known.append(getattr(one, attribute))
    raise KeyError(f"{name}; {what} {', '.join(known) or 'none'}")
