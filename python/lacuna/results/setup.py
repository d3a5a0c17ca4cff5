"""Setups: what was different on the rig in some recordings."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass


@dataclass(frozen=True)
class Quantity:
    """A number with its unit.

    Attributes
    ----------
    value : float
        In `unit`.
    unit : str
        SI unit, such as ``N*m``; ``1``: none.
    """

    value: float
    unit: str


@dataclass(frozen=True)
class Setup:
    """A load or a gain that some recordings have.

    Attributes
    ----------
    name : str
        As ``trial(setup=...)`` takes it; empty: the model without a setup.
    set : mapping of str to Quantity
        Values that are known, by address such as ``body.load.mass``.
    own : tuple of str
        Addresses of values that are fitted to recordings of this setup alone.
    names : tuple of str
        All names of this setup: recordings that set the same share one.
    recordings : tuple of str
        Recordings that have it.
    """

    name: str
    set: Mapping[str, Quantity]
    own: tuple[str, ...]
    names: tuple[str, ...] = ()
    recordings: tuple[str, ...] = ()
