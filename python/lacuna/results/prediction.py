"""What `Experiment.predict` returns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from .._answer import Answer, called
from .._arrays import Floats, array, subtracted
from .._tables import Record, Table
from .setup import Setup


@dataclass(frozen=True)
class PredictedChannel:
    """A channel of a predicted test.

    Attributes
    ----------
    channel, unit : str
        Sensor channel and its SI unit.
    predicted : tuple of float
        At the times of the test. NaN: not known.
    measured : tuple of float or None
        What was measured. None: the test was not carried out.
    """

    channel: str
    unit: str
    predicted: tuple[float, ...]
    measured: Optional[tuple[float, ...]]


@dataclass(frozen=True)
class PredictedTest:
    """A test, or a fit trial, as the model predicts it.

    Attributes
    ----------
    name : str
        Of the trial, or the test.
    times : tuple of float
        s.
    channels : tuple of PredictedChannel
        What the sensors would read.
    """

    name: str
    times: tuple[float, ...]
    channels: tuple[PredictedChannel, ...]


@dataclass(frozen=True)
class Prediction(Answer, Table):
    """The fitted model, simulated. As a table: a row for each test, time and channel.

    Attributes
    ----------
    experiment : str
        Its name.
    revision : int
        Revision of the model.
    fitted : bool
        Whether values were fitted; else they are those of the file.
    models : int
        How many models predict: the fitted one.
    test : str or None
        The test. None: the fit trials.
    setup : Setup or None
        Setup of the test. None: no recording has one.
    failed : tuple of str
        What cannot be simulated, a sentence each.
    predictions : tuple of PredictedTest
        The test, or each fit trial.
    """

    experiment: str
    revision: int
    fitted: bool
    models: int
    test: Optional[str]
    setup: Optional[Setup]
    failed: tuple[str, ...]
    predictions: tuple[PredictedTest, ...]

    def times(self, name: Optional[str] = None) -> Floats:
        """Times of a test, s: a numpy array where numpy is installed, else a list. Default: the first test."""
        return array(self._test(name).times)

    def predicted(self, channel: str, name: Optional[str] = None) -> Floats:
        """What the model predicts of a channel, SI, at `times`."""
        return array(self._channel(channel, name).predicted)

    def residual(self, channel: str, name: Optional[str] = None) -> Floats:
        """Measured − predicted, SI. Raises `ValueError` where the test was not carried out."""
        one = self._channel(channel, name)
        if one.measured is None:
            raise ValueError(f"{channel}: the test was not carried out, so nothing was measured")
        return subtracted(array(one.measured), array(one.predicted))

    def to_records(self) -> list[Record]:
        """A row for each test, time and channel: `name`, `time` (s), `channel`, `unit`, `predicted`, `measured`."""
        return [
            {
                "name": test.name,
                "time": time,
                "channel": one.channel,
                "unit": one.unit,
                "predicted": one.predicted[row],
                "measured": one.measured[row] if one.measured is not None else None,
            }
            for test in self.predictions
            for one in test.channels
            for row, time in enumerate(test.times)
        ]

    def _test(self, name: Optional[str]) -> PredictedTest:
        if name is None and self.predictions:
            return self.predictions[0]
        return called(name or "a test", self.predictions, "name", "predicted are")

    def _channel(self, channel: str, name: Optional[str]) -> PredictedChannel:
        return called(channel, self._test(name).channels, "channel", "the channels are")
