"""Runs code that documents show, cell by cell in one namespace, and compares what it prints with what they show."""

from __future__ import annotations

import ast
import contextlib
import io
import json
import re
import sys
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Optional

#: Figures that rest on many last digits differ from processor to processor by less than this.
TOLERANCE = 0.02
ANYTHING = "…"

_NUMBER = re.compile(r"[-+−]?\d+(?:\.\d+)?(?:e[-+]?\d+)?")


@dataclass(frozen=True)
class Cell:
    """Code, and what is shown of its output. None: nothing is shown."""

    place: str
    code: str
    shown: Optional[str]


def cells_of_page(page: Path) -> list[Cell]:
    """Blocks ```python, each with the ```text block that follows it at once, if one does."""
    text = page.read_text()
    cells = []
    for found in re.finditer(r"^```python\n(.*?)^```\n(?:\n```text\n(.*?)^```$)?", text, re.MULTILINE | re.DOTALL):
        line = text.count("\n", 0, found.start()) + 1
        cells.append(Cell(f"{page.name}:{line}", found.group(1), found.group(2)))
    return cells


def cells_of_notebook(notebook: Path) -> list[Cell]:
    """Code cells with the text of their outputs. None: the cell has no outputs."""
    document = json.loads(notebook.read_text())
    code = [cell for cell in document["cells"] if cell["cell_type"] == "code"]
    return [
        Cell(f"{notebook.name}, cell {number}", "".join(cell["source"]), _text_of(cell["outputs"]))
        for number, cell in enumerate(code, start=1)
    ]


def run_cell(cell: Cell, names: dict[str, Any]) -> str:
    """What the code prints, with the value of a last expression, as a notebook shows it."""
    tree = ast.parse(cell.code, cell.place)
    last = tree.body.pop() if tree.body and isinstance(tree.body[-1], ast.Expr) else None
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        exec(compile(tree, cell.place, "exec"), names)
        if isinstance(last, ast.Expr):
            value = eval(compile(ast.Expression(last.value), cell.place, "eval"), names)
            if value is not None:
                print(repr(value))
    return printed.getvalue()


def difference(shown: str, printed: str) -> str:
    """Where two texts differ, or nothing. Figures may differ by `TOLERANCE` or a unit of the last digit shown; a line
    that is only … stands for any lines."""
    said, got = _lines(shown), _lines(printed)
    while said and got and said[0] != ANYTHING:
        if not _alike(said[0], got[0]):
            return f"shown:   {said[0]}\nprinted: {got[0]}"
        said, got = said[1:], got[1:]
    if said and said[0] == ANYTHING:
        rest = "\n".join(said[1:])
        if not rest:
            return ""
        tries = [difference(rest, "\n".join(got[skipped:])) for skipped in range(len(got) + 1)]
        return "" if "" in tries else tries[0]
    return "" if not said and not got else f"shown besides: {said}\nprinted besides: {got}"


def _lines(text: str) -> list[str]:
    return [" ".join(line.split()) for line in text.strip("\n").splitlines()]


def _alike(said: str, got: str) -> bool:
    if _NUMBER.sub("#", said) != _NUMBER.sub("#", got):
        return False
    return all(_close(one, other) for one, other in zip(_NUMBER.findall(said), _NUMBER.findall(got)))


def _close(said: str, got: str) -> bool:
    a, b = (float(text.replace("−", "-")) for text in (said, got))
    decimals = len(said.split("e")[0].partition(".")[2])
    digit = 10.0**-decimals * 10.0 ** int(said.partition("e")[2] or 0)
    whole = "." not in said and "e" not in said
    return a == b if whole and abs(a) < 20 else abs(a - b) <= max(TOLERANCE * abs(a), 1.001 * digit)


def _text_of(outputs: list[dict[str, Any]]) -> Optional[str]:
    if not outputs:
        return None
    parts = [one["text"] if one["output_type"] == "stream" else one["data"]["text/plain"] for one in outputs]
    return "\n".join("".join(part) for part in parts)


def write_outputs(notebook: Path) -> None:
    """Puts what the cells print now into the notebook."""
    document = json.loads(notebook.read_text())
    names: dict[str, Any] = {"__name__": "__main__"}
    cells = [cell for cell in document["cells"] if cell["cell_type"] == "code"]
    for number, (cell, one) in enumerate(zip(cells, cells_of_notebook(notebook)), start=1):
        text = run_cell(one, names)
        lines = text.splitlines(keepends=True)
        cell["execution_count"] = number
        cell["outputs"] = [{"name": "stdout", "output_type": "stream", "text": lines}] if lines else []
    notebook.write_text(json.dumps(document, indent=1, ensure_ascii=False) + "\n")


if __name__ == "__main__":  # in a folder with the files that the notebook needs
    write_outputs(Path(sys.argv[1]).resolve())
