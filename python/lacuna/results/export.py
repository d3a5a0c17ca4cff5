"""What `Experiment.export` returns."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from .._answer import Answer


@dataclass(frozen=True)
class AbsorbedEffect:
    """An effect that is a value of the robot in the file.

    Attributes
    ----------
    effect : str
        The effect with its place.
    addresses : tuple of str
        Values of the robot that stand for it.
    """

    effect: str
    addresses: tuple[str, ...]


@dataclass(frozen=True)
class ExportedFile:
    """A robot file that was written.

    Attributes
    ----------
    format : str
        ``toml``, ``urdf`` or ``mjcf``.
    file : str
        The file, as it was asked for; relative to `Experiment.folder`.
    model_file : str
        File beside it with what the format has no place for: a ``[model]`` table.
    keeps_original : bool
        Whether it is the model's file with the identified values in it.
    absorbed : tuple of AbsorbedEffect
        Effects that the file has as values of the robot.
    set : mapping of str to float
        Values without a place in the file, by address, SI; they stand in the model file.
    effects : tuple of str
        Ids of effects without a place in the file; they stand in the model file.
    left_out : tuple of str
        What is in neither file, a sentence each.
    """

    format: str
    file: str
    model_file: str
    keeps_original: bool
    absorbed: tuple[AbsorbedEffect, ...]
    set: Mapping[str, float]
    effects: tuple[str, ...]
    left_out: tuple[str, ...]


@dataclass(frozen=True)
class Export(Answer):
    """The identified robot, written.

    Attributes
    ----------
    experiment : str
        Its name.
    revision : int
        Revision of the model that was written.
    files : tuple of ExportedFile
        What was written.
    """

    experiment: str
    revision: int
    files: tuple[ExportedFile, ...]
