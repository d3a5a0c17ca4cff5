"""Runs the tests of one file: ``run_test.py NAME``. Where all were skipped, says so as the other tests do."""

from __future__ import annotations

import sys
import unittest

SKIPPED = 77


def main() -> int:
    result = unittest.TextTestRunner(verbosity=2).run(unittest.defaultTestLoader.loadTestsFromName(sys.argv[1]))
    if result.wasSuccessful() and result.testsRun == 0:
        print("no test was found")
        return 1
    if result.wasSuccessful() and len(result.skipped) == result.testsRun:
        print(f"Skipped\n{result.skipped[0][1]}", flush=True)
        return SKIPPED
    return 0 if result.wasSuccessful() else 1


if __name__ == "__main__":
    sys.exit(main())
