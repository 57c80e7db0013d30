"""What the page looks like, beside stored pictures. Loosely: the pixels are the desktop's business (tests/snapshots).

To store them anew, after looking at them: GHOSTFORCE_STORE_PICTURES=1 python3 -m unittest pictures_test"""
import os
import pathlib
import unittest
import urllib.parse

from PIL import Image

from browser import PageTest, wait_for
from model import Rest
from pictures import difference

FOLDER = pathlib.Path(__file__).parent / "pictures"
TOLERANCE = 0.004  # of the pixels: digits of a time, and a driver's own edges


class Pictures(PageTest):
    is_main = True

    def compare(self, name):
        stored = FOLDER / f"{name}.png"
        if os.environ.get("GHOSTFORCE_STORE_PICTURES"):
            self.browser.still_picture().save(stored, optimize=True)
            self.skipTest(f"{stored} is stored anew")
        with Image.open(stored) as wanted:
            wanted.load()
        seen = pathlib.Path(os.environ.get("GHOSTFORCE_TEST_OUTPUT", ".")) / f"{name}.actual.png"

        def told():
            picture = self.browser.picture()
            picture.save(seen)
            return f"{difference(picture, wanted):.2%} of the pixels differ; see {seen}"

        wait_for(lambda: difference(self.browser.picture(), wanted) <= TOLERANCE, f"a picture like {stored}", told)

    def at_rest(self, strategy, view):
        """Opened there: where labels stand also depends on what was shown before."""
        line = f"ghostforce run wall45 --strategy {strategy} --view {view}"
        browser = self.open(fragment="#" + urllib.parse.quote(line))
        state = browser.wait_until(strategy=strategy, face=view)
        browser.wait_for_rest(Rest(state["goal_m"], strategy), 1e-4)

    def test_stage(self):
        self.at_rest("naive", "stage")
        self.compare("stage")

    def test_stage_with_the_cure(self):
        self.at_rest("anisotropic", "stage")
        self.compare("stage-anisotropic")

    def test_workbench(self):
        self.at_rest("naive", "workbench")
        self.browser.press("Space")  # its status bar counts the seconds
        self.browser.wait_until(paused=True)
        self.compare("workbench")


if __name__ == "__main__":
    unittest.main()
