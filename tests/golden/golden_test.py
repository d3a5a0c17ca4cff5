"""That tools/golden names what differs and passes over sentences and times."""

import importlib.machinery
import importlib.util
import pathlib
import sys
import tempfile
import unittest

TOOL = pathlib.Path(__file__).resolve().parents[2] / "tools" / "golden"


def load_tool():
    sys.dont_write_bytecode = True  # it would lie beside the tool
    loader = importlib.machinery.SourceFileLoader("golden", str(TOOL))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("golden", loader))
    loader.exec_module(module)
    return module


golden = load_tool()
ANSWER = {"verdict": "effect_found", "seconds": 3.25, "findings": ["The residual depends on velocity.", "Another finding."],
          "ranking": [{"gain": 0.1, "ci95": [None, 0.2]}, {"gain": 1e-17, "ci95": []}]}


class Golden(unittest.TestCase):
    def test_fields_have_the_name_of_their_place_and_every_digit(self):
        self.assertEqual(golden.lines(ANSWER), {
            "verdict": '"effect_found"', "findings": '["...", "..."]',
            "ranking[0].gain": "0.1", "ranking[0].ci95": "[null, 0.2]",
            "ranking[1].gain": "1e-17", "ranking[1].ci95": "[]"})

    def test_sentences_and_times_may_differ_but_not_how_many_sentences(self):
        other = {**ANSWER, "seconds": 9.0, "findings": ["In other words.", "As before."]}
        self.assertEqual(list(golden.differences(golden.lines(ANSWER), golden.lines(other))), [])
        fewer = {**ANSWER, "findings": ["Only one sentence."]}
        self.assertEqual(list(golden.differences(golden.lines(ANSWER), golden.lines(fewer))),
                         [("findings", '["...", "..."]', '["..."]')])

    def test_a_difference_has_the_field_before_and_after(self):
        other = {**ANSWER, "ranking": [{"gain": 0.10000000000000002, "ci95": [None, 0.2]}]}
        self.assertEqual(list(golden.differences(golden.lines(ANSWER), golden.lines(other))),
                         [("ranking[0].gain", "0.1", "0.10000000000000002"),
                          ("ranking[1].gain", "1e-17", "(absent)"), ("ranking[1].ci95", "[]", "(absent)")])

    def test_a_kept_answer_is_read_again_as_it_was(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "case.txt"
            golden.write_golden(file, golden.lines(ANSWER))
            self.assertEqual(golden.read_golden(file), golden.lines(ANSWER))


if __name__ == "__main__":
    unittest.main()
