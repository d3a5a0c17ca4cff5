"""What `Experiment.trial` and `Experiment.write_commands` return."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Optional

from .._decode import named
from .setup import Setup


@dataclass(frozen=True)
class Trial:
    """A test that was carried out on the target; the database has it.

    Attributes
    ----------
    trial : str
        Its name.
    test : str
        The test.
    duration : float
        s.
    samples : int
        Readings.
    held_out : bool
        Whether it is kept from every fit.
    seed : int
        Seed of the sensors' noise.
    database : str
        File that has it.
    """

    trial: str
    test: str
    duration: float
    samples: int
    held_out: bool
    seed: int
    database: str


@dataclass(frozen=True)
class CommandTable:
    """Commands of a test, written for a rig.

    Attributes
    ----------
    test : str
        The test.
    duration : float
        s.
    samples : int
        Rows of the table.
    held_out : bool
        Whether the recording is to be held out.
    setup : Setup or None
        Setup that the rig is to have. None: no recording has a setup.
    file : str
        The table, CSV; relative to `Experiment.folder`.
    """

    test: str
    duration: float
    samples: int
    held_out: bool
    setup: Optional[Setup]
    file: str = field(metadata=named("csv"))
