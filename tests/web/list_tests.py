"""Prints a line for each test that ctest shall run by itself: its name there, and how unittest finds it."""
import pathlib
import unittest

folder = pathlib.Path(__file__).parent


def tests_in(suite):
    for each in suite:
        if isinstance(each, unittest.TestSuite):
            yield from tests_in(each)
        else:
            yield each


found = {}
for test in tests_in(unittest.defaultTestLoader.discover(str(folder), pattern="*_test.py")):
    module, suite, method = test.id().split(".")
    whole = getattr(test, "one_browser", False)
    name = f"{module.removesuffix('_test')}.{suite}" + ("" if whole else f".{method.removeprefix('test_')}")
    found[f"web.{name}"] = f"{module}.{suite}" + ("" if whole else f".{method}")
for name, test in found.items():
    print(f"{name}={test}")
