"""How far a command is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Optional


@dataclass(frozen=True)
class Progress:
    """One report of a command that works, at most five a second.

    Attributes
    ----------
    phase : str
        What is done now, such as ``refits of candidates``.
    fraction : float
        Share of the whole that is done, 0 to 1, an estimate.
    seconds_left : float or None
        Time until the command ends, s, an estimate. None: not known yet.
    """

    phase: str
    fraction: float
    seconds_left: Optional[float] = None

    def __str__(self) -> str:
        done = f"{self.phase} · {100 * self.fraction:.0f} %"
        return done if self.seconds_left is None else f"{done} · {self.seconds_left:.0f} s left"


ProgressCallback = Callable[[Progress], None]
