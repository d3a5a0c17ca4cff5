"""Numbers in a row: numpy arrays where numpy is installed, lists elsewhere."""

from __future__ import annotations

import array as bytes_array
import sys
from collections.abc import Sequence
from typing import Any

try:
    import numpy
except ImportError:  # lists will do
    numpy = None  # type: ignore[assignment]

#: A `numpy.ndarray` of float64, or a list of float where numpy is not installed.
Floats = Any

_CODES = {"float32": "f", "float64": "d"}


def array(values: Sequence[float]) -> Floats:
    """Values as an array, or as a list."""
    return list(values) if numpy is None else numpy.asarray(values, dtype=numpy.float64)


def from_little_endian(content: bytes, precision: str) -> list[float]:
    """Numbers of ``float32`` or ``float64`` each, as the database stores them."""
    numbers: bytes_array.array[float] = bytes_array.array(_CODES[precision])
    numbers.frombytes(content)
    if sys.byteorder == "big":
        numbers.byteswap()
    return numbers.tolist()


def columns_of(content: bytes, precision: str, width: int) -> list[Floats]:
    """Columns of rows of `width` numbers each, as float64."""
    if numpy is not None:
        kind = "<f4" if precision == "float32" else "<f8"
        table = numpy.frombuffer(content, dtype=kind).reshape(-1, width).astype(numpy.float64)
        return [table[:, column].copy() for column in range(width)]
    numbers = from_little_endian(content, precision)
    return [numbers[column::width] for column in range(width)]


def subtracted(left: Floats, right: Floats) -> Floats:
    """left − right, one by one."""
    return [a - b for a, b in zip(left, right)] if numpy is None else left - right
