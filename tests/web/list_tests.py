"""Prints a line for each class of tests, which share a browser: its name in ctest, how unittest finds it, and its label
there: "main" where the class has is_main, else "more"."""
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
classes = {test.id().rpartition(".")[0]: type(test) for test in tests}
for each, suite in sorted(classes.items()):
    label = "main" if getattr(suite, "is_main", False) else "more"
    print(f"web.{each.replace('_test.', '.')}={each}={label}")
