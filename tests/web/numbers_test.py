"""The page's simulation gives the desktop program's numbers.

A value is compared relative to the greatest magnitude of its column in that run, over all of the strategy's ticks: many
columns pass through zero, where any rounding would be large relative to the value itself. Only the order of roundings in
libm may differ: what is seen is written out."""
import unittest

from browser import ROOT, PageTest

GREATEST = 1e-12
STRATEGIES = ("full", "naive", "anisotropic")


def read(text):
    """Comment lines, and the columns by name."""
    lines = text.splitlines()
    comments = [line for line in lines if line.startswith("#")]
    names, *rows = (line.split(",") for line in lines if not line.startswith("#"))
    return comments, dict(zip(names, zip(*rows), strict=True))


class Numbers(PageTest):
    is_main = True

    def compare(self, found, wanted):
        """The greatest relative difference, and in which column."""
        # The first line tells the build.
        self.assertTrue(found[0][0].startswith(wanted[0][0]), found[0][0])
        self.assertEqual(found[0][1:], wanted[0][1:], "what is said of the run")
        self.assertEqual(list(found[1]), list(wanted[1]), "the columns")
        self.assertEqual(found[1]["strategy"], wanted[1]["strategy"])
        worst = (0.0, "")
        for name in wanted[1]:
            if name == "strategy":
                continue
            ours, theirs = (list(map(float, each[1][name])) for each in (found, wanted))
            self.assertEqual(len(ours), len(theirs), "as many ticks")
            scale = max(map(abs, theirs))
            difference = max(abs(one - other) for one, other in zip(ours, theirs))
            self.assertTrue(scale > 0.0 or difference == 0.0, f"{name} is 0 on the desktop, and {difference} in the page")
            if scale > 0.0:
                worst = max(worst, (difference / scale, name))
        return worst

    def test_are_the_desktops_for_each_scene_and_strategy(self):
        browser = self.open()
        scenes = browser.script("return window.ghostforce.scenes()")
        self.assertEqual(sorted(scenes), sorted(each.stem for each in (ROOT / "assets/scenes").glob("*.toml")))
        worst = (0.0, "", "", "")
        for scene in scenes:
            for strategy in STRATEGIES:
                with self.subTest(scene=scene, strategy=strategy):
                    answer = self.program("simulate", scene, "--strategy", strategy)
                    self.assertEqual(answer.returncode, 0, answer.stderr)
                    text = browser.script("return window.ghostforce.simulate(arguments[0], arguments[1])", scene, strategy)
                    difference, column = self.compare(read(text), read(answer.stdout))
                    self.assertLessEqual(difference, GREATEST, column)
                    worst = max(worst, (difference, scene, strategy, column))
        difference, *where = worst
        print(f"greatest difference: {difference:.2g}{' of ' + ' '.join(where) if difference else ', the same to the last bit'}")


if __name__ == "__main__":
    unittest.main()
