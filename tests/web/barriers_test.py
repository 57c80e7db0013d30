"""Barriers of the page: what a program can find of WCAG 2.2, and the keyboard that comes in and gets out again."""
import os
import pathlib
import unittest

from browser import wait_for
from controls_test import ControlsTest


class Axe(ControlsTest):
    """Rules of WCAG 2.2 AA that a program can check."""

    def expect_none(self, where):
        axe = os.environ.get("GHOSTFORCE_AXE")
        if not axe or not pathlib.Path(axe).is_file():
            self.skipTest("axe-core is not there; ./check web fetches it")
        browser = self.browser
        browser.script(pathlib.Path(axe).read_text(encoding="utf-8"))
        found = browser.driver.execute_async_script(
            """
            const done = arguments[0];
            const tags = ["wcag2a", "wcag2aa", "wcag21a", "wcag21aa", "wcag22aa", "best-practice"];
            axe.run(document, { runOnly: tags }).then((results) => done({
              violations: results.violations.map((v) => [v.id, v.nodes.map((n) => n.html.slice(0, 200))]),
              passes: results.passes.length,
            }), (error) => done("" + error));
            """
        )
        self.assertGreater(found["passes"], 10, where)
        self.assertEqual(found["violations"], [], where)

    def test_finds_no_barrier(self):
        browser = self.open()
        self.expect_none("the stage")
        browser.script("for (const each of document.querySelectorAll('details')) each.open = true")
        # Shown, so that it measures contrast.
        self.focus("strategy-naive")
        for theme in ("light", "dark", "projector"):
            browser.script("document.activeElement.blur()")
            browser.wait(lambda state: state["ready"], "the page")
            colour = "return getComputedStyle(document.documentElement).getPropertyValue('--background')"
            while browser.state()["theme"] != theme:
                before = browser.script(colour)
                browser.press("C")
                wait_for(lambda: browser.script(colour) != before, "another theme's colours")
            self.focus("strategy-naive")
            browser.next_frame()
            self.expect_none(theme)

    def test_finds_no_barrier_in_spanish_nor_in_the_dialog_of_the_link(self):
        browser = self.open(query="?language=es")
        self.expect_none("the stage in Spanish")
        browser.press("M")
        self.wait_for_control("dialog")
        self.expect_none("the lessons in Spanish")
        browser.press("Escape")
        browser.wait_until(dialog="none")
        browser.press("U")
        wait_for(lambda: browser.script("return document.getElementById('link').open"), "the link")
        self.expect_none("the link")

    def test_finds_no_barrier_in_dialogs(self):
        browser = self.open()
        dialogs = (("K", "help"), ("D", "device"), ("M", "lessons"), ("I", "save_picture"), ("Ctrl+O", "open"))
        for key, dialog in dialogs + (("Ctrl+S", "save_scene"), ("Ctrl+P", "palette")):
            with self.subTest(dialog):
                browser.press(key)
                browser.wait_until(dialog=dialog)
                self.focus("dialog-close")
                self.expect_none(dialog)
                browser.press("Escape")
                wait_for(lambda: self.focused() == "stage", "the way back to the canvas", browser.told_state)

    def test_finds_no_barrier_in_a_lesson(self):
        self.open(query="?lesson=ghost")
        self.focus("answer-1")
        self.expect_none("a question")


class NoTrap(ControlsTest):
    is_main = True

    def around(self):
        """A page of its own with a link before and after the program; returns how many times Tab may be pressed."""
        browser = self.open()
        browser.driver.get(self.server.address("around.html"))
        ready = "return document.querySelector('iframe').contentWindow.ghostforce?.state().ready"
        wait_for(lambda: browser.script(ready), "the page in its frame")
        there = "return document.querySelector('iframe').contentDocument.getElementById('control-actions') !== null"
        wait_for(lambda: browser.script(there), "the controls in the frame")
        return 40

    def setUp(self):
        super().setUp()
        name = self.address().rpartition("/")[2]
        page = f"""
          <link rel="icon" href="data:,">
          <a id="before" href="#a">before</a>
          <iframe src="/{name}" width="900" height="600"></iframe>
          <a id="after" href="#b">after</a>
        """
        self.server.add("/around.html", page)

    def places(self, key, most):
        """Where the focus is, Tab by Tab, until it is at the other end."""
        browser = self.browser
        where = """
          const at = document.activeElement;
          return at.tagName === 'IFRAME' ? 'frame ' + at.contentDocument.activeElement.id : at.id;
        """
        found = []
        for _ in range(most):
            browser.press(key)
            found.append(browser.script(where))
            if found[-1] == ("after" if key == "Tab" else "before"):
                return found
        self.fail(f"{key} never left: {found}")

    def test_takes_no_focus_in_a_frame_and_leaves_it_at_both_ends(self):
        most = self.around()
        browser = self.browser
        self.assertEqual(browser.script("return document.activeElement.tagName"), "BODY")
        there = self.places("Tab", most)
        self.assertEqual(there[0], "before")
        self.assertEqual(there.count("frame stage"), 1)
        self.assertIn("frame control-hand-depth", there)
        back = self.places("Shift+Tab", most)
        self.assertEqual(back.count("frame stage"), 1)
        # Each control that Tab comes to, it comes to from the other side, too.
        self.assertEqual(sorted(there[1:-1]), sorted(back[:-1]))

    def test_leaves_a_dialog_too(self):
        most = self.around()
        browser = self.browser
        self.places("Tab", most)
        browser.press("Shift+Tab")
        browser.script("document.querySelector('iframe').contentDocument.getElementById('stage').focus()")
        browser.press("K")
        there = "return document.querySelector('iframe').contentDocument.getElementById('control-dialog') !== null"
        wait_for(lambda: browser.script(there), "the dialog in the frame")
        self.assertIn("frame control-dialog-close", self.places("Tab", most))

    def test_escape_gives_the_keys_back(self):
        browser = self.open()
        self.assertEqual(self.focused(), "stage")
        browser.press("Q")
        browser.wait_until(mode="predict")
        browser.press("Escape")
        browser.wait_until(mode="none")
        self.assertEqual(self.focused(), "stage", "it has closed something")
        self.listen()
        wait_for(lambda: browser.press("Escape") or self.focused() == "", "a canvas without the focus")
        self.assertIn("Tab leads to what it shows, and Shift+Tab from there back to the picture.", self.heard()[-1])
        browser.press("Tab")
        self.assertTrue(browser.script("return document.getElementById('controls').contains(document.activeElement)"))

    def test_tab_shows_where_it_is_on_the_canvas(self):
        browser = self.open()
        browser.press("Tab")
        browser.press("Shift+Tab")
        self.assertEqual(self.focused(), "stage")
        self.assertEqual(browser.script("return getComputedStyle(document.activeElement).outlineStyle"), "solid")


if __name__ == "__main__":
    unittest.main()
