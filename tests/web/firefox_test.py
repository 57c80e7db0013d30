"""Much less than in Chromium, in another browser: that the page does not live by one browser's ways."""
import math
import unittest
import urllib.parse

from browser import PAGE, PageServer, wait_for
from firefox import Firefox
from model import Rest

LINE = "ghostforce run wall45 --set wall.normal_deg=120.0 --goal-mm=10,-17.32 --strategy anisotropic --view workbench"


class InFirefox(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        assert PAGE.is_file(), f"{PAGE} is not there; ./web builds it"
        cls.server = PageServer(PAGE.parent)
        cls.addClassCleanup(cls.server.close)
        cls.browser = Firefox()
        cls.addClassCleanup(cls.browser.close)

    def rest_of(self, goal, strategy, **wall):
        rest = Rest(goal, strategy, **wall)
        self.browser.wait(
            lambda state: math.dist(state["force_N"], rest.force) < 0.01, f"a force of {rest.force} N, as {strategy}"
        )

    def test_starts_from_a_disk(self):
        self.browser.open(PAGE.as_uri())
        state = self.browser.state()
        self.assertEqual(state["face"], "stage")
        self.browser.wait(lambda now: now["tick"] > state["tick"], "ticks that go on")

    def test_keys_choose_strategy_pause_and_face(self):
        self.browser.open(self.server.address(PAGE.name))
        goal = self.browser.state()["goal_m"]
        for key, strategy in (("1", "full"), ("2", "naive"), ("3", "anisotropic")):
            self.browser.press(key)
            self.browser.wait_until(strategy=strategy)
            self.rest_of(goal, strategy)
        self.browser.press("Space")
        self.browser.wait_until(paused=True)
        self.browser.press("Space")
        self.browser.press("F4")
        self.browser.wait_until(paused=False, face="workbench")
        self.browser.press("F4")
        self.browser.wait_until(face="stage")

    def test_a_drag_moves_the_goal(self):
        browser = self.browser
        browser.open(self.server.address(PAGE.name))
        browser.drag(browser.on_screen(browser.state()["goal_m"]), browser.on_screen((0.020, -0.010)))
        pixel_m = 0.01 / (browser.on_screen((0.01, 0.0))[0] - browser.on_screen((0.0, 0.0))[0])
        state = browser.wait(
            lambda state: math.dist(state["goal_m"], (0.020, -0.010)) < 1.5 * pixel_m, "the goal at the pointer"
        )
        self.rest_of(state["goal_m"], state["strategy"])

    def test_shows_the_set_up_of_the_fragment(self):
        self.browser.open(self.server.address(PAGE.name) + "#" + urllib.parse.quote(LINE))
        state = self.browser.wait_until(face="workbench", strategy="anisotropic")
        self.assertLess(math.dist(state["goal_m"], (0.010, -0.01732)), 1e-9)
        self.rest_of(state["goal_m"], "anisotropic", normal_deg=120.0)

    def test_has_words_and_controls_beside_the_picture(self):
        browser = self.browser
        browser.open(self.server.address(PAGE.name))
        there = "return document.getElementById('control-actions') !== null"
        wait_for(lambda: browser.script(there), "the controls")
        for selector, role, beginning in (
            ("#stage", ("img", "image", "graphic"), "The stage as a picture"),
            ("#controls h1", ("heading",), "ghostforce"),
            ("#control-strategy-naive", ("radio",), "Naïve"),
            ("#control-hand-depth", ("slider",), "Hand: depth in the wall"),
            ("#control-mode-why", ("button",), "Why?"),
        ):
            told = browser.as_told(selector)
            self.assertIn(told[0], role, selector)
            self.assertTrue(told[1].startswith(beginning), told)
        browser.press("M")
        wait_for(lambda: browser.script("return document.getElementById('control-dialog') !== null"), "the dialog")
        self.assertEqual(browser.as_told("#control-dialog"), ("dialog", "Lessons: choose one"))
        browser.script("for (const each of document.querySelectorAll('details')) each.open = true")
        # Each of them has the role of its kind, and a name.
        roles = {"H1": "heading", "H2": "heading", "H3": "heading", "BUTTON": "button", "radio": "radio", "range": "slider"}
        found = browser.script(
            """
            const all = document.querySelectorAll("#controls :is(button, input, h1, h2, h3)[id]");
            return [...all].map((each) => [each.id, each.tagName === "INPUT" ? each.type : each.tagName]);
            """
        )
        self.assertGreater(len(found), 50)
        for each, kind in found:
            role, name = browser.as_told(f"[id='{each}']")
            self.assertEqual(role, roles[kind], each)
            self.assertTrue(name, each)
        browser.press("Escape")
        wait_for(lambda: browser.script("return document.getElementById('control-dialog') === null"), "no dialog")
        # By Tab from the canvas to the strategies, and by an arrow to another one.
        focused = lambda: browser.script("return document.activeElement.id")
        self.assertEqual(focused(), "stage")
        for _ in range(10):
            if focused().startswith("control-strategy-"):
                break
            browser.press("Tab")
        before = browser.state()["strategy"]
        browser.press("Down")
        browser.wait(lambda state: state["strategy"] != before, "another strategy")
        browser.press("Escape")
        self.assertEqual(focused(), "stage")

    def test_asks_its_server_for_nothing_but_itself(self):
        before = len(self.server.requests)
        self.browser.open(self.server.address(PAGE.name))
        self.browser.press("F4")
        self.browser.wait_until(face="workbench")
        self.browser.press("F4")
        self.browser.wait_until(face="stage")
        self.assertEqual(self.server.requests[before:], ["/" + PAGE.name])


if __name__ == "__main__":
    unittest.main()
