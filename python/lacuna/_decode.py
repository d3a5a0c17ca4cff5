"""JSON of the program as frozen dataclasses, by their type hints."""

from __future__ import annotations

import dataclasses
import json
import math
import typing
from collections.abc import Mapping
from typing import Any, TypeVar, Union

from .errors import AnswerError

T = TypeVar("T")

#: Metadata of a field that holds the whole document.
WHOLE = {"whole": True}


def named(name: str) -> dict[str, str]:
    """Metadata of a field that has another name in JSON."""
    return {"json": name}


def parse(output: bytes) -> Any:
    """The document that the program printed."""
    try:
        return json.loads(output)
    except ValueError as error:
        raise AnswerError(f"the program's answer is no JSON ({error}); use a program of this package's version") from None


def decode(kind: type[T], document: Any, place: str = "") -> T:
    """A dataclass of a JSON object. Members that the class does not have are left out, so newer programs do no harm.

    Raises `AnswerError` where a member without a default is missing or of another type.
    """
    if not isinstance(document, Mapping):
        raise _unlike(place, "an object", document)
    hints = _hints_of(kind)
    values: dict[str, Any] = {}
    for one in dataclasses.fields(kind):
        if one.metadata.get("whole"):
            values[one.name] = dict(document)
            continue
        name = one.metadata.get("json", one.name)
        if name in document:
            values[one.name] = _convert(hints[one.name], document[name], f"{place}.{name}".lstrip("."))
        elif one.default is dataclasses.MISSING and one.default_factory is dataclasses.MISSING:
            raise AnswerError(
                f"the program's answer lacks {place or kind.__name__}.{name}; use a program of this package's version"
            )
    return kind(**values)


_hints: dict[type, dict[str, Any]] = {}


def _hints_of(kind: type) -> dict[str, Any]:
    if kind not in _hints:
        _hints[kind] = typing.get_type_hints(kind)
    return _hints[kind]


def _convert(hint: Any, value: Any, place: str) -> Any:
    if hint is Any:
        return value
    if hint is float:
        return _number(value, place)
    if dataclasses.is_dataclass(hint):
        return decode(typing.cast("type[Any]", hint), value, place)
    origin, inner = typing.get_origin(hint), typing.get_args(hint)
    if origin is Union:  # Optional, the only one
        return None if value is None else _convert(inner[0], value, place)
    if origin is tuple:
        return _sequence(inner, value, place)
    if isinstance(origin, type) and issubclass(origin, Mapping):
        if not isinstance(value, Mapping):
            raise _unlike(place, "an object", value)
        return {str(key): _convert(inner[1], one, f"{place}.{key}") for key, one in value.items()}
    if isinstance(value, hint) and (hint is bool or not isinstance(value, bool)):
        return value
    raise _unlike(place, hint.__name__, value)


def _number(value: Any, place: str) -> float:
    """null stands for what is not known or not finite."""
    if value is None:
        return math.nan
    if isinstance(value, (int, float)) and not isinstance(value, bool):
        return float(value)
    raise _unlike(place, "a number", value)


def _sequence(inner: tuple[Any, ...], value: Any, place: str) -> tuple[Any, ...]:
    if not isinstance(value, list):
        raise _unlike(place, "a list", value)
    if len(inner) == 2 and inner[1] is Ellipsis:
        return tuple(_convert(inner[0], one, f"{place}[{index}]") for index, one in enumerate(value))
    if len(inner) != len(value):
        raise _unlike(place, f"a list of {len(inner)}", value)
    return tuple(_convert(hint, one, f"{place}[{index}]") for index, (hint, one) in enumerate(zip(inner, value)))


def _unlike(place: str, wanted: str, value: Any) -> AnswerError:
    return AnswerError(
        f"the program's answer has at {place or 'its top'} {value!r:.60}, not {wanted}; "
        "use a program of this package's version"
    )
