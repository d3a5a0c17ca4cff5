"""Results that are tables."""

from __future__ import annotations

import html
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    import pandas

Record = dict[str, Any]


class Table:
    """A result that is a table: as a list of dictionaries everywhere, as a pandas table where pandas is installed."""

    def to_records(self) -> list[Record]:
        """The rows, a dictionary each. Every row has the same keys in the same order."""
        raise NotImplementedError

    def to_frame(self) -> pandas.DataFrame:
        """The rows as a `pandas.DataFrame`.

        Raises
        ------
        ImportError
            pandas is not installed; `to_records` gives the same rows without it.
        """
        try:
            import pandas
        except ImportError as error:
            raise ImportError(
                "to_frame needs pandas, which is not installed; install it (Debian: python3-pandas), or use to_records()"
            ) from error
        return pandas.DataFrame.from_records(self.to_records())

    def _repr_html_(self) -> str:
        """What a notebook shows."""
        records = self.to_records()
        columns = list(records[0]) if records else []
        head = "".join(f"<th>{html.escape(name)}</th>" for name in columns)
        rows = "".join(
            "<tr>" + "".join(f"<td>{html.escape(_cell(row[name]))}</td>" for name in columns) + "</tr>" for row in records
        )
        return f"<table><thead><tr>{head}</tr></thead><tbody>{rows}</tbody></table>"


def _cell(value: Any) -> str:
    if value is None:
        return ""
    return f"{value:.4g}" if isinstance(value, float) else str(value)
