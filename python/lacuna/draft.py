"""A drafted experiment."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .experiment import Experiment


@dataclass(frozen=True)
class Draft:
    """What `Experiment.new` wrote.

    Attributes
    ----------
    experiment : Experiment
        The drafted experiment.
    text : str
        What the program guessed, and which lines are to be filled in.
    """

    experiment: Experiment
    text: str = field(repr=False)
