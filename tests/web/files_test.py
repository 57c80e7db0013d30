"""Files in and out of the page: scenes, recordings, pictures; and recordings between the page and the desktop program."""
import math
import tempfile
import tomllib
import unittest

from PIL import Image

from browser import HEIGHT, RECORD_BUTTON, ROOT, SAVE_PICTURE, WIDTH, PageTest, wait_for
from controls_test import ControlsTest
from display import display


class Scenes(PageTest):
    is_main = True

    def test_is_opened(self):
        browser = self.open()
        path = browser.downloads / "mine.toml"
        text = (ROOT / "assets/scenes/fig1.toml").read_text(encoding="utf-8")
        path.write_text(text.replace("normal_deg = 135.0", "normal_deg = 111.0"), encoding="utf-8")
        self.assertIn("111.0", path.read_text(encoding="utf-8"))
        browser.choose_file(path)
        state = browser.wait(lambda state: "wall.normal_deg=111" in state["set_up"], "the wall of the scene")
        self.assertIn("fig1", state["set_up"])

    def test_is_dropped(self):
        browser = self.open()
        browser.drop_file(ROOT / "assets/scenes/fig1.toml")
        browser.wait(lambda state: "fig1" in state["set_up"], "the scene that was dropped")

    def test_that_is_broken_is_told_of_and_changes_nothing(self):
        browser = self.open()
        before = browser.state()["set_up"]
        path = browser.downloads / "broken.toml"
        path.write_text("format = 1\ntitel = 'x'\n", encoding="utf-8")
        browser.choose_file(path)
        browser.wait(lambda state: "broken.toml:2" in state["notice"], "words about line 2")
        self.assertEqual(browser.state()["set_up"], before)

    def test_is_saved_and_reads_back_the_same(self):
        browser = self.open()
        x, _ = browser.state()["goal_m"]
        browser.press("[")
        browser.press("3")
        browser.press("Ctrl+Left")
        before = browser.wait(
            lambda state: state["strategy"] == "anisotropic" and math.isclose(state["goal_m"][0], x - 0.01),
            "the goal 10 mm to the left",
        )
        browser.press("Ctrl+S")
        browser.wait_until(dialog="save_scene")
        browser.press("Enter")
        path = browser.downloaded(".toml")
        scene = tomllib.loads(path.read_text(encoding="utf-8"))
        self.assertEqual(scene["format"], 1)
        self.assertEqual(scene["rendering"]["strategy"], "anisotropic")
        self.assert_close(scene["goal"]["path_mm"][-1], [1000 * each for each in before["goal_m"]], 1e-6)
        self.assertEqual(scene["device"]["actuated_deg"], 5.0)
        # And the desktop program reads it.
        answer = self.program("equilibrium", str(path), "--json")
        self.assertEqual(answer.returncode, 0, answer.stderr)

        browser.open(self.address())
        browser.wait(lambda state: state["set_up"] != before["set_up"], "the usual scene")
        browser.choose_file(path)
        browser.wait_until(set_up=before["set_up"])

    def test_that_is_a_lesson_begins(self):
        browser = self.open()
        path = browser.downloads / "mine.toml"
        path.write_bytes((ROOT / "assets/lessons/ghost.toml").read_bytes())
        browser.choose_file(path)
        browser.wait(lambda state: state["lesson"] and state["lesson"]["name"] == "mine", "the lesson of the file")


class WithoutTheCanvas(ControlsTest):
    """What dialogs do, by their controls beside the picture."""

    is_main = True

    def open_dialog(self, key, dialog):
        """By its key on the canvas; then Tab leads to what is in it."""
        browser = self.open()
        browser.press(key)
        browser.wait_until(dialog=dialog)
        self.wait_for_control("dialog")
        browser.press("Tab")
        self.assertEqual(self.focused(), "control-dialog-close")

    def test_the_browsers_own_dialog_is_one_of_the_buttons(self):
        self.open_dialog("Ctrl+O", "open")
        self.browser.expect_file_dialog(lambda: self.use("open-file"))

    def test_a_scene_is_opened(self):
        self.open_dialog("Ctrl+O", "open")
        self.use("open-fig1")
        self.browser.wait(lambda state: "fig1" in state["set_up"] and state["dialog"] == "none", "the scene")

    def test_a_scene_is_saved(self):
        self.open_dialog("Ctrl+S", "save_scene")
        self.use("save-scene")
        scene = tomllib.loads(self.browser.downloaded(".toml").read_text(encoding="utf-8"))
        self.assertEqual(scene["device"]["actuated_deg"], 0.0)
        self.browser.wait_until(dialog="none")

    def test_a_picture_of_the_scene_alone_is_saved(self):
        self.open_dialog(SAVE_PICTURE, "save_picture")
        self.use("save-scene-alone")
        self.assertTrue(self.browser.downloaded(".png").name.startswith("a-wall-at-45"), "it has the proposed name")
        self.browser.wait_until(dialog="none")

    def test_preferences_are_reset(self):
        browser = self.open()
        browser.press("C")
        browser.wait(lambda state: state["theme"] != "light", "another theme")
        browser.use_action("Reset all preferences")
        browser.wait_until(dialog="reset_preferences")
        self.use("reset-yes")
        browser.wait_until(theme="light", dialog="none")

    def test_escape_leads_back_to_what_has_opened_it(self):
        self.open()
        row = self.browser.script(
            """
            document.getElementById("control-actions").open = true;
            const rows = [...document.querySelectorAll("#control-actions button")];
            return rows.find((each) => each.textContent === "Save a picture").id.slice("control-".length);
            """
        )
        self.use(row)
        self.expect_dialog("save_picture")
        self.listen()
        self.browser.press("Escape")
        self.browser.wait_until(dialog="none")
        wait_for(lambda: "Closed: Save a picture." in self.heard(), "that it is closed", self.browser.told_state)
        wait_for(lambda: self.focused() == "control-" + row, "the focus where it was", self.browser.told_state)

    def expect_dialog(self, dialog):
        self.browser.wait_until(dialog=dialog)
        wait_for(lambda: self.focused() == "control-dialog-name", "the focus in the dialog", self.browser.told_state)

    def test_one_leads_to_another(self):
        self.open_dialog("Ctrl+P", "palette")
        row = self.browser.script(
            """
            const rows = [...document.querySelectorAll("#control-dialog button")];
            return rows.find((each) => each.textContent === "Save a picture").id.slice("control-".length);
            """
        )
        self.use(row)
        self.expect_dialog("save_picture")
        self.browser.press("Escape")
        wait_for(lambda: self.focused() == "stage", "the focus on the canvas", self.browser.told_state)

    def test_a_lesson_is_begun(self):
        self.open_dialog("M", "lessons")
        self.assertIsNone(self.text("lessons"), "the list is not there twice")
        self.use("begin-ghost")
        self.browser.wait(lambda state: state["lesson"] and state["dialog"] == "none", "the lesson")
        wait_for(lambda: self.focused() == "control-lesson-name", "the focus at the lesson", self.browser.told_state)


class Pictures(PageTest):
    def save(self):
        browser = self.browser
        browser.press(SAVE_PICTURE)
        browser.wait_until(dialog="save_picture")
        browser.press("Enter")
        return browser.downloaded(".png")

    def test_is_saved_with_its_set_up_and_opens_again(self):
        browser = self.open()
        browser.press("[")
        browser.press("3")
        before = browser.wait_until(strategy="anisotropic")
        path = self.save()
        with Image.open(path) as picture:
            picture.load()
            width, height = picture.size  # as many times the window's as the dialog says
            self.assertEqual(width * HEIGHT, height * WIDTH)
            self.assertGreaterEqual(width, WIDTH)
            self.assertGreater(len(picture.convert("RGB").getcolors(width * height)), 50)
            lines = [text for text in picture.text.values() if text.startswith("ghostforce run ")]
        self.assertEqual(lines, [before["set_up"]])
        browser.open(self.address())
        browser.wait(lambda state: state["set_up"] != before["set_up"], "the usual scene")
        browser.choose_file(path)
        browser.wait_until(set_up=before["set_up"])


class Recordings(PageTest):
    def record(self):
        """Some motion under two strategies, with a setting changed meanwhile; where its file is."""
        browser = self.browser
        browser.press("F4")
        browser.wait_until(face="workbench")
        browser.click(RECORD_BUTTON)
        first = browser.wait_until(recording=True)["tick"]
        for key in ("Ctrl+Left", "3", "Ctrl+Up", "W", "Ctrl+Right", "2"):
            browser.press(key)
            tick = browser.state()["tick"]
            browser.wait(lambda state, tick=tick: state["tick"] > tick + 50, "50 ticks more")
        browser.wait(lambda state: state["tick"] > first + 500, "half a second of ticks")
        browser.click(RECORD_BUTTON)
        browser.wait_until(recording=False)
        return browser.downloaded(".csv")

    def test_of_the_page_replays_on_the_desktop(self):
        self.open()
        path = self.record()
        text = path.read_text(encoding="utf-8")
        self.assertGreater(sum(line.startswith("naive,") for line in text.splitlines()), 500)
        self.assertIn("# set t_s=", text)
        answer = self.program("replay", str(path), "-o", str(path.with_name("again.csv")))
        self.assertEqual(answer.returncode, 0, answer.stderr + answer.stdout)
        print(answer.stderr.strip())

    def test_of_the_page_opens_in_it(self):
        browser = self.open()
        path = self.record()
        goals = [
            tuple(map(float, line.split(",")[2:4]))
            for line in path.read_text(encoding="utf-8").splitlines()
            if line.startswith("naive,")
        ]
        browser.open(self.address())
        browser.choose_file(path)
        browser.wait_until(input="replay")
        browser.wait(
            lambda state: min(math.dist(state["goal_m"], goal) for goal in goals) < 1e-6, "a goal of the recording"
        )

    def test_of_the_desktop_replays_in_the_page(self):
        browser = self.open()
        path = browser.downloads / "desktop.csv"
        with display() as name, tempfile.TemporaryDirectory() as home:
            answer = self.program(
                "run", "fig1", "--input", "script", "--no-hints", "--exit-after", "2", "--record", str(path),
                DISPLAY=name, HOME=home, XDG_CONFIG_HOME=home, XDG_STATE_HOME=home,
            )  # fmt: skip
        self.assertEqual(answer.returncode, 0, answer.stderr)
        text = path.read_text(encoding="utf-8")
        self.assertGreater(sum(line.startswith("naive,") for line in text.splitlines()), 100)
        verdict = browser.script("return window.ghostforce.replay(arguments[0])", text)
        self.assertTrue(verdict["agrees"], verdict)
        print(verdict["words"])
        browser.choose_file(path)
        state = browser.wait_until(input="replay")
        self.assertIn("fig1", state["set_up"])

    def test_of_the_desktop_that_was_changed_is_found_out(self):
        browser = self.open()
        answer = self.program("simulate", "fig1", "--strategy", "all")
        lines = answer.stdout.splitlines()
        last = max(i for i, line in enumerate(lines) if line.startswith("naive,"))
        values = lines[last].split(",")
        values[4] = repr(float(values[4]) * (1.0 + 1e-9))
        lines[last] = ",".join(values)
        verdict = browser.script("return window.ghostforce.replay(arguments[0])", "\n".join(lines) + "\n")
        self.assertFalse(verdict["agrees"], verdict)


if __name__ == "__main__":
    unittest.main()
