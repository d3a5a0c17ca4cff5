"""The page and the notebook of the documents do what they show."""

from __future__ import annotations

import importlib.util
import json
import os
import tempfile
import unittest
from pathlib import Path
from typing import Any
from unittest import mock

from shown_code import Cell, cells_of_notebook, cells_of_page, difference, run_cell
from support import SOURCE, WithRig

HOW_TO = SOURCE / "docs" / "how-to"
PAGE = HOW_TO / "use-from-python.md"
NOTEBOOK = HOW_TO / "find-the-missing-effect.ipynb"


class GuidesTest(WithRig):
    def setUp(self) -> None:
        for name in ("numpy", "pandas"):
            if importlib.util.find_spec(name) is None:
                self.skipTest(f"{name} is not installed (Debian: python3-{name})")
        super().setUp()

    def follow(self, cells: list[Cell]) -> None:
        names: dict[str, Any] = {"__name__": "__main__"}
        with mock.patch.dict(os.environ, {"COLUMNS": "80"}):
            for cell in cells:
                printed = run_cell(cell, names)
                if cell.shown is not None:
                    self.assertEqual(difference(cell.shown, printed), "", f"{cell.place} prints\n{printed}")

    def test_the_page_does_what_it_shows(self) -> None:
        cells = cells_of_page(PAGE)
        self.assertGreater(len(cells), 8)
        self.assertGreater(len([one for one in cells if one.shown]), 4)
        self.follow(cells)

    def test_the_notebook_does_what_it_shows(self) -> None:
        document = json.loads(NOTEBOOK.read_text())
        self.assertEqual((document["nbformat"], document["metadata"]["kernelspec"]["name"]), (4, "python3"))
        cells = cells_of_notebook(NOTEBOOK)
        self.assertGreater(len(cells), 6)
        self.follow(cells)


class ShownCodeTest(unittest.TestCase):
    def test_output_may_differ_in_last_digits_and_width_only(self) -> None:
        self.assertEqual(difference("a  14.19 x\n", "a 14.3 x"), "")
        self.assertEqual(difference("0.0010", "0.00109"), "")
        self.assertEqual(difference("first\n…\nlast 2", "first\nsecond\nthird\nlast 2"), "")
        self.assertEqual(difference("first\n…", "first\nsecond"), "")
        for shown, printed in (("14.19", "15.0"), ("a 2", "a 3"), ("a", "b"), ("a", "a\nb"), ("a\nb", "a"), ("…\nb", "a")):
            self.assertNotEqual(difference(shown, printed), "", (shown, printed))

    def test_the_last_expression_of_a_cell_is_shown(self) -> None:
        names: dict[str, Any] = {}
        self.assertEqual(run_cell(Cell("x", "a = 1\nprint('p')\na + 1", None), names), "p\n2\n")
        self.assertEqual(run_cell(Cell("x", "b = a", None), names), "")

    def test_blocks_of_a_page_are_found_with_their_output(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        page = Path(folder.name) / "page.md"
        page.write_text("a\n```python\nx\n```\n\n```text\n1\n```\n\n```python\ny\n```\nprose\n\n```text\nno\n```\n")
        cells = cells_of_page(page)
        self.assertEqual([(one.code, one.shown) for one in cells], [("x\n", "1\n"), ("y\n", None)])
        self.assertEqual(cells[1].place, "page.md:10")


if __name__ == "__main__":
    unittest.main()
