"""The words and controls beside the canvas: used by the keyboard alone, and read as a screen reader reads them, from
the browser's accessibility tree. Nothing here touches the canvas."""
import math
import unittest

from browser import PageTest, wait_for
from model import Rest, ghost_force


class ControlsTest(PageTest):
    """What the tests below have in common."""

    def open(self, *where, **how):
        """The controls follow the first picture by some frames."""
        browser = super().open(*where, **how)
        self.wait_for_control("actions")
        return browser

    def focus(self, control):
        """As Tab would, which is tested by itself."""
        self.wait_for_control(control)
        self.browser.script("document.getElementById('control-' + arguments[0]).focus()", control)

    def use(self, control, key="Enter"):
        self.focus(control)
        self.browser.press(key)

    def text(self, control):
        return self.browser.script("return document.getElementById('control-' + arguments[0])?.textContent", control)

    def wait_for_control(self, control):
        wait_for(lambda: self.text(control) is not None, f"the control {control}", self.browser.told_state)

    def wait_for_text(self, control, holds, what):
        return wait_for(
            lambda: (text := self.text(control)) is not None and holds(text) and text, what, self.browser.told_state
        )

    def listen(self):
        """From now on heard() has all that is told, whether it still stands there or not."""
        self.browser.script(
            """
            window.told = [];
            new MutationObserver((changes) => {
              for (const change of changes) for (const node of change.addedNodes) told.push(node.textContent);
            }).observe(document.getElementById("polite"), { childList: true });
            """
        )

    def heard(self):
        return self.browser.script("return told")

    def spoken(self):
        """What stands where it is told politely."""
        return self.browser.script("return document.getElementById('polite').textContent")

    def focused(self):
        """The id of what has the focus."""
        return self.browser.script("return document.activeElement.id")

    def tree(self):
        """What a screen reader is given: of each node its role, name, value and description."""
        nodes = self.browser.command("Accessibility.getFullAXTree")["nodes"]
        read = lambda node, key: node.get(key, {}).get("value", "")
        return [
            {
                "role": read(node, "role"),
                "name": read(node, "name"),
                "value": read(node, "value"),
                "description": read(node, "description"),
                **{each["name"]: each["value"].get("value") for each in node.get("properties", [])},
            }
            for node in nodes
            if not node["ignored"]
        ]

    def in_tree(self, role, beginning):
        return next(each for each in self.tree() if each["role"] == role and each["name"].startswith(beginning))


class Controls(ControlsTest):
    is_main = True

    def test_choose_and_move_and_tell_the_numbers_that_the_model_has(self):
        browser = self.open()
        self.use("strategy-naive", "Space")
        browser.wait_until(strategy="naive")
        # Arrow keys choose among the strategies, as in any group of radio buttons.
        browser.press("Down")
        browser.wait_until(strategy="anisotropic")
        browser.press("Up")
        browser.wait_until(strategy="naive")

        self.focus("hand-depth")
        browser.press("Left")
        browser.press("Left")
        wall = (math.cos(math.radians(135.0)), math.sin(math.radians(135.0)))
        goal = tuple(-0.018 * each for each in wall)
        browser.wait(lambda state: math.dist(state["goal_m"], goal) < 1e-9, "the hand 18 mm deep")
        browser.wait_for_rest(Rest(goal, "naive"))
        force = f"{ghost_force(goal, 'naive'):.2f} N"
        told = self.wait_for_text("value-ghost", lambda text: force in text, "the force")
        self.assertTrue(told.startswith("ghost force"), told)
        # Where the hand is now and what that has led to, in one message.
        slide = self.text("value-slide")
        hand = "hand: 18.0 mm deep in the wall, 0.0 mm along it"
        wait_for(lambda: f"{hand}. {told}. {slide}." in self.spoken(), "what is told", browser.told_state)
        self.assertEqual(self.in_tree("slider", "Hand: depth in the wall")["value"], 18)

    def test_tell_a_change_of_strategy_once_it_is_over(self):
        browser = self.open(fragment="#wall45%20--strategy%20naive")
        self.wait_for_text("value-ghost", lambda text: "1.27 N" in text, "the ghost force")
        self.listen()
        browser.press("Shift+3")  # slowly: there is time to hear of it
        wait_for(lambda: any("0.00 N" in each for each in self.heard()), "the new force", browser.told_state)
        wait_for(lambda: any("is gone" in each for each in self.heard()), "the new sentence", browser.told_state)
        self.assertEqual([each for each in self.heard() if "On the way" in each], [])

    def test_tell_a_slider_in_one_go(self):
        self.open()
        self.wait_for_control("ratio")
        ratio = (
            "Ratio ρ, of the anisotropic strategy alone: how firmly the mark follows along the motor, "
            "over how firmly in the direction without a motor"
        )
        tree = self.tree()
        for control, name, value in (
            ("hand-depth", "Hand: depth in the wall", "20.0 mm deep in the wall"),
            ("wall", "Wall: angle of its push, counterclockwise from the right", "135°"),
            ("ratio", ratio, "ρ = 4.00"),
        ):
            with self.subTest(name):
                # Name, value and unit are the slider's, and stand nowhere beside it. The protocol has no value text.
                self.assertEqual([each["role"] for each in tree if each["name"] == name], ["slider"])
                told = [each for each in tree if each["name"] == value and each["role"] != "InlineTextBox"]  # no line of a text
                self.assertEqual(told, [])
                text = "return document.getElementById('control-' + arguments[0]).getAttribute('aria-valuetext')"
                self.assertEqual(self.browser.script(text, control), value)

    def test_speak_of_one_thing_by_one_word(self):
        self.open()
        told = [each["name"] for each in self.tree()]
        self.assertIn("the motor's part of the wall's push: 2.12 N", told)
        about = self.browser.script("return document.getElementById('about').textContent")
        self.assertIn("is the hollow mark, also called the proxy", about)
        self.assertIn("in the direction without a motor, it follows only softly", about)
        # Lessons have words of their own.
        rest = about + self.text("strategies") + self.text("settings") + self.text("actions").replace("Lesson: Ani", "")
        for other in ("actuated direction", "Rendered", "nisotropic rendering"):
            self.assertNotIn(other, rest)

    def test_have_a_name_for_each_group(self):
        browser = self.open()
        groups = lambda: [each["name"] for each in self.tree() if each["role"] in ("group", "radiogroup", "region")]
        for opened in (False, True):
            browser.script(
                "for (const each of document.querySelectorAll('details')) each.open = arguments[0]", opened
            )
            found = groups()
            self.assertNotIn("", found)
            for name in ("Lessons", "All keys", "All actions"):
                self.assertIn(name, found)
        self.use("mode-predict")
        self.wait_for_control("guess-depth")
        self.assertNotIn("", groups())

    def test_say_what_each_mode_is(self):
        self.open()
        told = {each["name"]: each["description"] for each in self.tree() if "pressed" in each}
        self.assertEqual(told["Last minute"], "Look back at what has just happened.")
        self.assertTrue(told["Measure the hand"].startswith("The motor trembles for 2 seconds"), told)
        self.assertEqual(told["Workbench"], "All settings, numbers and plots.")
        self.assertEqual([name for name, about in told.items() if not about], [])

    def test_list_actions_and_keys_in_groups(self):
        self.open()
        self.browser.script("for (const each of document.querySelectorAll('details')) each.open = true")
        tree = self.tree()
        groups = [each["name"] for each in tree if each["role"] == "group"]
        headings = [each["name"] for each in tree if each["role"] == "heading" and each.get("level") == 3]
        for name in ("Stage and lessons", "View and looks", "Undo, files and pictures"):
            self.assertEqual(groups.count(name), 2, "of the keys and of the actions")
            self.assertEqual(headings.count(name), 2)
        self.assertEqual(headings[0], "Strategies")
        most = self.browser.script(
            "return Math.max(...[...document.querySelectorAll('#control-actions ul')].map((list) => list.children.length))"
        )
        self.assertLessEqual(most, 25)

    def test_say_again_why_they_cannot_be_used(self):
        self.open()
        self.listen()
        told = lambda: len([each for each in self.heard() if self.text("notice") in each])
        for count in (1, 2):
            self.browser.script("document.querySelector('#control-actions [aria-disabled]').click()")
            wait_for(lambda: self.text("notice") and told() == count, f"the refusal told {count} times")

    def test_say_again_what_a_key_has_done(self):
        browser = self.open()
        self.listen()
        told = lambda: len([each for each in self.heard() if "Copied the live values" in each])
        for count in (1, 2):
            browser.press("V")
            wait_for(lambda: told() == count, f"that the values were copied, told {count} times")

    def test_tell_the_workbench_and_a_dialog_by_their_names(self):
        browser = self.open()
        browser.press("F4")
        self.wait_for_text("sentence", lambda text: text.startswith("The workbench is open"), "the workbench")
        browser.press("D")
        self.wait_for_text("dialog", lambda text: "Device status" in text, "the dialog's name")
        self.assertTrue(self.in_tree("dialog", "Device status")["name"])

    def test_tell_how_far_a_key_has_turned_the_motor(self):
        browser = self.open()
        self.listen()
        browser.press("[")
        wait_for(lambda: any("the motor pushes at 5°" in each for each in self.heard()), "the angle", browser.told_state)

    def test_keys_in_them_are_not_the_programs(self):
        browser = self.open()
        before = browser.state()
        self.focus("strategy-naive")
        for key in ("3", "R", "F", "PageDown"):
            browser.press(key)
        browser.next_frame()
        after = browser.state()
        for key in ("strategy", "set_up", "goal_m"):
            self.assertEqual(after[key], before[key])
        # On the canvas they are.
        browser.press("Escape")
        self.assertEqual(self.focused(), "stage")
        browser.press("3")
        browser.wait_until(strategy="anisotropic")

    def test_are_all_there_for_a_screen_reader(self):
        browser = self.open()
        self.wait_for_control("sentence")
        tree = self.tree()
        names = [each["name"] for each in tree]
        self.assertTrue([each for each in tree if each["role"] == "main"])
        headings = [each["name"] for each in tree if each["role"] == "heading"]
        self.assertEqual(headings[0], "ghostforce")
        for wanted in ("Values", "Hand, motor and wall", "What else there is to do"):
            self.assertIn(wanted, headings)
        self.assertEqual(len([each for each in tree if each["role"] == "radio"]), 3)
        picture = next(each for each in tree if each["role"] in ("image", "img") and "picture" in each["name"])
        self.assertEqual(picture["description"], self.text("sentence"))
        # Whoever reads nothing else has read what a ghost force is.
        self.assertTrue(any("that excess is the ghost force" in each for each in names), names)
        # Everything that can be used has a name.
        usable = ("button", "radio", "slider", "textbox", "DisclosureTriangle", "link")
        self.assertEqual([each for each in tree if each["role"] in usable and not each["name"]], [])
        self.assertEqual(browser.script("return document.documentElement.lang"), "en")

    def test_predict_is_played(self):
        browser = self.open()
        self.use("mode-predict")
        browser.wait_until(mode="predict")
        self.wait_for_text("value-ghost", lambda text: "hidden" in text, "a force that is not told yet")
        goal = browser.state()["goal_m"]
        self.wait_for_control("guess-depth")
        rest = Rest(goal, browser.state()["strategy"]).device
        wall = (math.cos(math.radians(135.0)), math.sin(math.radians(135.0)))
        deep_mm = -1000.0 * (wall[0] * rest[0] + wall[1] * rest[1])
        self.focus("guess-depth")
        value = lambda: float(browser.script("return document.activeElement.value"))
        for _ in range(60):
            if abs(value() - deep_mm) <= 0.5:
                break
            browser.press("Right" if value() < deep_mm else "Left")
        self.use("next")
        self.wait_for_text("sentence", lambda text: "mm off" in text, "how far the guess was off")

    def test_why_is_read_to_its_end(self):
        browser = self.open(fragment="#wall45%20--strategy%20naive")
        self.wait_for_control("mode-why")
        self.listen()
        self.use("mode-why")
        browser.wait_until(mode="why")
        wait_for(lambda: "One motor cannot." in self.spoken(), "the sentence of Why?", browser.told_state)
        # A later text has not taken the first step away, which a screen reader may not have read yet.
        self.assertIn("1  the wall pushes straight out: 3.00 N", self.spoken())
        for step in range(1, 5):
            self.wait_for_control(f"why-{step}")
            words = self.text(f"why-{step}")
            wait_for(lambda: any(words in each for each in self.heard()), f"step {step} told")
            if step < 4:
                self.use("next")
        self.assertIn("ghost force", self.text("why-4"))
        self.assertEqual(self.focused(), "control-next")
        self.wait_for_text("next", lambda text: "Back" in text, "the way back")
        browser.press("Enter")
        browser.wait_until(mode="none")
        # What had the focus has gone; it is still among the controls.
        wait_for(
            lambda: browser.script("return document.getElementById('controls').contains(document.activeElement)"),
            "the focus among the controls",
        )

    def test_follow_the_language(self):
        browser = self.open(query="?language=es")
        self.wait_for_text("value-ghost", lambda text: text.startswith("fuerza fantasma"), "Spanish words")
        self.assertEqual(browser.script("return document.documentElement.lang"), "es")
        keys = browser.script("return [...document.querySelectorAll('#control-keys p')].map((row) => row.textContent)")
        self.assertIn("Flechas: Mover mano o apuesta 1 mm (Mayús: 0.1, Ctrl: 10)", keys)
        self.assertIn("M: Lecciones: elegir una", keys)
        self.assertEqual(browser.script("return document.querySelectorAll('#controls [lang]').length"), 0)
        browser.press("V")
        self.wait_for_text("notice", lambda text: text.startswith("Valores copiados"), "a notice in Spanish")
        self.assertIn("Mover la mano con: Ratón", self.text("actions"))
        browser.press("U")
        link = lambda: browser.script("return document.querySelector('dialog[open]')?.textContent")
        words = wait_for(link, "the link")
        self.assertIn("Quien abra este enlace", words)
        self.assertIn("Cerrar", words)

    def test_stay_out_of_sight_until_the_keyboard_is_in_them(self):
        browser = self.open()
        width = lambda: browser.script("return document.getElementById('controls').getBoundingClientRect().width")
        self.assertLessEqual(width(), 1)
        self.focus("strategy-naive")
        self.assertGreater(width(), 200)
        inside = """
          const box = document.activeElement.getBoundingClientRect();
          return box.top >= 0 && box.bottom <= innerHeight;
        """
        self.assertTrue(browser.script(inside), "what has the focus is seen")
        self.focus("workbench")
        browser.resize((390, 844))
        wait_for(lambda: browser.script(inside), "what has the focus, in a narrow window")
        fits = "const c = document.getElementById('controls'); return c.scrollWidth <= c.clientWidth"
        self.assertTrue(browser.script(fits), "nothing is cut off at the side")


class LessonWithoutTheCanvas(ControlsTest):
    is_main = True

    def lesson(self):
        return self.browser.state()["lesson"]

    def go_on(self, step):
        self.use("lesson-next")
        self.browser.wait(lambda state: state["lesson"] is None or state["lesson"]["step"] == step, f"step {step}")
        # The same button does something else there: nobody is to press it once more unawares.
        wait_for(lambda: self.focused() == "control-lesson-name", "the focus at the step", self.browser.told_state)
        wait_for(lambda: f"{step} of 7" in self.spoken(), "which step it is", self.browser.told_state)

    def choose_rightly(self):
        self.use(f"answer-{self.lesson()['right_answer']}")
        self.browser.wait(lambda state: state["lesson"]["outcome"] == "right", "a right answer")
        self.wait_for_text("lesson-outcome", lambda text: text == "Right.", "that it is right")

    def move(self, control, wanted):
        """By arrow keys, to the nearest step."""
        self.focus(control)
        value = lambda: float(self.browser.script("return document.activeElement.value"))
        for _ in range(120):
            if abs(value() - wanted) <= 0.5:
                return
            self.browser.press("Right" if value() < wanted else "Left")
        self.fail(f"{control} is at {value()} and not at {wanted}")

    def test_is_played_to_its_end(self):
        browser = self.open()
        self.wait_for_control("lessons")
        self.browser.script("document.querySelector('#control-lessons summary').focus()")
        browser.press("Enter")
        self.use("begin-ghost")
        browser.wait(lambda state: state["lesson"] is not None, "the lesson")
        wait_for(lambda: self.focused() == "control-lesson-name", "the focus at the lesson", browser.told_state)
        self.wait_for_text("lesson-place", lambda text: text == "1 of 7", "the first step")
        self.choose_rightly()
        self.go_on(2)
        self.go_on(3)
        self.choose_rightly()
        self.go_on(4)
        # One newton of ghost force: it grows with the depth of the hand.
        self.wait_for_control("hand-depth")
        browser.wait(lambda state: abs(math.hypot(*state["goal_m"]) - 0.02) < 1e-4, "the hand where the step begins")
        self.assertIn("ghost force", self.text("task-1"))
        self.move("hand-depth", 20.0 / ghost_force((0.02 * math.sqrt(0.5), -0.02 * math.sqrt(0.5)), "naive"))
        browser.wait(lambda state: not state["lesson"]["is_open"], "the task that is done")
        self.go_on(5)
        self.choose_rightly()
        self.go_on(6)
        browser.wait(lambda state: math.dist(state["goal_m"], (0.01732, -0.010)) < 1e-4, "the hand at its place")
        goal = browser.state()["goal_m"]
        rest = Rest(goal, "naive", normal_deg=150.0).device
        normal = (math.cos(math.radians(150.0)), math.sin(math.radians(150.0)))
        right = (normal[1], -normal[0])
        self.wait_for_control("guess-depth")
        self.move("guess-depth", -1000.0 * (normal[0] * rest[0] + normal[1] * rest[1]))
        self.move("guess-along", 1000.0 * (right[0] * rest[0] + right[1] * rest[1]))
        self.use("lesson-next")
        browser.wait(lambda state: state["lesson"]["outcome"] == "right", "a good guess")
        self.go_on(7)
        self.use("lesson-next")
        browser.wait(lambda state: state["lesson"] is None or state["lesson"]["is_complete"], "the lesson's end")


if __name__ == "__main__":
    unittest.main()
