"""What `plugins` returns."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Optional

from .._answer import Answer
from .._tables import Record, Table


@dataclass(frozen=True)
class Component:
    """Something that experiment files can name.

    Attributes
    ----------
    kind : str
        Such as ``effect`` or ``robot format``.
    name : str
        As experiment files name it.
    summary : str
        What it is.
    file : str
        Its library.
    problem : str or None
        Why it cannot be used. None: it can.
    remark : str or None
        What it does and should not. None: nothing.
    """

    kind: str
    name: str
    summary: str
    file: str
    problem: Optional[str] = None
    remark: Optional[str] = None


@dataclass(frozen=True)
class PluginList(Answer, Table):
    """Every component of every plugin. As a table: a row for each.

    Attributes
    ----------
    components : tuple of Component
        By kind and name.
    problems : tuple of str
        Libraries that cannot be used, with the reason.
    """

    components: tuple[Component, ...]
    problems: tuple[str, ...]

    def to_records(self) -> list[Record]:
        """A row for each component: `kind`, `name`, `summary`."""
        return [{"kind": one.kind, "name": one.name, "summary": one.summary} for one in self.components]
