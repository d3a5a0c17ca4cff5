"""Python values as arguments of the program."""

from __future__ import annotations

import json
import math
import os
from collections.abc import Iterable, Mapping
from typing import Union

from .program import PathLike

#: One name or several.
Names = Union[str, Iterable[str]]

#: One path or several.
Paths = Union[PathLike, Iterable[PathLike]]


def listed(names: Names) -> list[str]:
    """Several names, of which a single text is one."""
    return [names] if isinstance(names, str) else [str(name) for name in names]


def path_list(paths: Paths) -> list[str]:
    """Several paths, of which a single one is one."""
    return [os.fspath(one) for one in ([paths] if isinstance(paths, (str, os.PathLike)) else paths)]


def repeated(option: str, names: Names) -> list[str]:
    """``--option NAME`` for each."""
    return [word for name in listed(names) for word in (option, name)]


def option(name: str, value: object) -> list[str]:
    """``--name VALUE``, nothing where there is no value, and the flag alone of True."""
    if value is None or value is False:
        return []
    if value is True:
        return [name]
    return [name, os.fspath(value) if isinstance(value, os.PathLike) else str(value)]


def file_argument(path: PathLike) -> str:
    """A path that is no option, whatever its name."""
    name = os.fspath(path)
    return os.path.join(".", name) if name.startswith("-") else name


def toml_value(value: object) -> str:
    """A value as TOML, for ``--set``.

    Raises `TypeError` for what TOML does not have.
    """
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, float) and not math.isfinite(value):
        return "nan" if math.isnan(value) else ("inf" if value > 0 else "-inf")
    if isinstance(value, (int, float)):
        return repr(value)
    if isinstance(value, (str, os.PathLike)):
        return json.dumps(os.fspath(value), ensure_ascii=False).replace("\x7f", "\\u007f")
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(key))} = {toml_value(one)}" for key, one in value.items()) + "}"
    if isinstance(value, Iterable):
        return "[" + ", ".join(toml_value(one) for one in value) + "]"
    if hasattr(value, "item"):  # a number of numpy
        return toml_value(value.item())
    raise TypeError(f"{value!r} has no form in TOML; write numbers, texts, lists and dictionaries")
