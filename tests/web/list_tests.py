"""Prints a line for each class of tests, which share a browser: its name in ctest, and how unittest finds it."""
import pathlib
import unittest

folder = pathlib.Path(__file__).parent


def tests_in(suite):
    for each in suite:
        if isinstance(each, unittest.TestSuite):
            yield from tests_in(each)
        else:
            yield each


tests = tests_in(unittest.defaultTestLoader.discover(str(folder), pattern="*_test.py"))
for each in sorted({test.id().rpartition(".")[0] for test in tests}):
    print(f"web.{each.replace('_test.', '.')}={each}")
