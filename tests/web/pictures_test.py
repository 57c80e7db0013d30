"""What the page looks like, beside stored pictures. Loosely: the pixels are the desktop's business (tests/snapshots).

To store them anew, after looking at them: GHOSTFORCE_STORE_PICTURES=1 python3 -m unittest pictures_test"""
import os
import pathlib
import unittest

from PIL import Image

from browser import PageTest
from model import Rest
from pictures import difference

FOLDER = pathlib.Path(__file__).parent / "pictures"
TOLERANCE = 0.004  # of the pixels: digits of a time, and a driver's own edges


class Pictures(PageTest):
    def compare(self, name):
        picture = self.browser.picture()
        stored = FOLDER / f"{name}.png"
        if os.environ.get("GHOSTFORCE_STORE_PICTURES"):
            picture.quantize(64).save(stored, optimize=True)
            self.skipTest(f"{stored} is stored anew")
        with Image.open(stored) as wanted:
            share = difference(picture, wanted)
            if share > TOLERANCE:
                seen = pathlib.Path(os.environ.get("GHOSTFORCE_TEST_OUTPUT", ".")) / f"{name}.actual.png"
                picture.save(seen)
                self.fail(f"{share:.2%} of the pixels differ from {stored}; see {seen}")

    def at_rest(self, *keys, strategy="naive"):
        browser = self.open()
        for key in keys:
            browser.press(key)
        browser.wait_until(strategy=strategy)
        state = browser.state()
        browser.wait_for_rest(Rest(state["goal_m"], strategy), 1e-4)

    def test_stage(self):
        self.at_rest()
        self.compare("stage")

    def test_stage_with_the_cure(self):
        self.at_rest("3", strategy="anisotropic")
        self.compare("stage-anisotropic")

    def test_workbench(self):
        self.at_rest("F4")
        self.browser.press("Space")
        self.browser.wait_until(face="workbench", paused=True)
        self.browser.next_frame()
        self.compare("workbench")


if __name__ == "__main__":
    unittest.main()
