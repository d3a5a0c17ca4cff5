"""What `Experiment.check` returns."""

from __future__ import annotations

from dataclasses import asdict, dataclass, field
from typing import Optional

from .._answer import Answer
from .._decode import named
from .._tables import Record, Table
from .setup import Setup


@dataclass(frozen=True)
class ModelRobot:
    """The robot of the model.

    Attributes
    ----------
    name : str
        As its file calls it.
    plugin : str
        What made it: ``declared`` of a robot file, else a robot plugin.
    bodies, joints, actuators, sensors : tuple of str
        Names of its elements, in the order of the file.
    """

    name: str
    plugin: str
    bodies: tuple[str, ...]
    joints: tuple[str, ...]
    actuators: tuple[str, ...]
    sensors: tuple[str, ...]


@dataclass(frozen=True)
class FreeValue:
    """A value that a fit may change.

    Attributes
    ----------
    address : str
        Such as ``joint.hinge.damping``.
    unit : str
        SI unit of the numbers.
    start, lower, upper : float
        Where the fit begins, and its bounds.
    """

    address: str
    unit: str
    start: float
    lower: float
    upper: float


@dataclass(frozen=True)
class Effect:
    """A physical effect that the model includes.

    Attributes
    ----------
    id : str
        Its name in the experiment file; its parameters are ``effect.ID.PARAMETER``.
    effect : str
        Name of the effect in the library, such as ``coulomb_friction``.
    where : tuple of str
        Elements on which it is placed, such as ``joint.hinge``; empty: the world.
    optional : bool
        Whether a run of the algorithm may leave it out.
    """

    id: str
    effect: str
    where: tuple[str, ...]
    optional: bool


@dataclass(frozen=True)
class ReadTrial:
    """A recording as it was read.

    Attributes
    ----------
    trial : str
        Its name.
    held_out : bool
        Whether it is kept from every fit.
    samples : int
        Rows that were read.
    duration : float
        From the first row to the last one, s.
    """

    trial: str
    held_out: bool
    samples: int
    duration: float = field(metadata=named("duration_s"))


@dataclass(frozen=True)
class Channel:
    """A channel of the recordings.

    Attributes
    ----------
    channel : str
        Sensor channel or actuator.
    kind : str
        ``measured`` or ``commanded``.
    column : str
        Column of the files.
    column_unit : str
        Unit in which the column is read.
    unit : str
        SI unit of `smallest` and `largest`.
    smallest, largest : float
        Range of its values in all trials. NaN: it has no values.
    missing : int
        Values that are not compared.
    """

    channel: str
    kind: str
    column: str
    column_unit: str
    unit: str
    smallest: float
    largest: float
    missing: int


@dataclass(frozen=True)
class Note:
    """What looks odd in a file, but is taken.

    Attributes
    ----------
    file : str
        The file.
    line, column : int
        Place in it, from 1; 0: not known.
    message : str
        A sentence.
    """

    file: str
    line: int
    column: int
    message: str


@dataclass(frozen=True, repr=False)
class Check(Answer, Table):
    """An experiment file with everything that it names, as the program understood it. As a table: the channels.

    Attributes
    ----------
    experiment : str
        Its name.
    database : str
        File in which results are kept unless another one is named.
    target : str
        Kind of the target: ``recorded``, ``simulated`` or ``process``.
    robot : ModelRobot
        The robot of the model.
    free : tuple of FreeValue
        Values to be fitted.
    effects : tuple of Effect
        Effects that the model includes.
    trials : tuple of ReadTrial
        Recordings, those to be fitted first.
    channels : tuple of Channel
        Measured and commanded channels with their ranges: a wrong unit or sign shows here.
    setups : tuple of Setup
        Setups, where recordings have some.
    notes : tuple of Note
        What looks odd.
    """

    experiment: str
    database: str
    target: str
    robot: ModelRobot
    free: tuple[FreeValue, ...]
    effects: tuple[Effect, ...]
    trials: tuple[ReadTrial, ...]
    channels: tuple[Channel, ...]
    setups: tuple[Setup, ...]
    notes: tuple[Note, ...]

    def __repr__(self) -> str:
        return f"Check({self.experiment}: {len(self.trials)} trials, {len(self.free)} free values, {len(self.notes)} notes)"

    def to_records(self) -> list[Record]:
        """A row for each channel, with the fields of `Channel`."""
        return [asdict(channel) for channel in self.channels]

    def channel(self, name: str) -> Optional[Channel]:
        """The channel of this name, or None."""
        return next((channel for channel in self.channels if channel.channel == name), None)
