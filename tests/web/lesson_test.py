"""A lesson is played to its end, as a person would: by keys and the pointer, and by what the stage says."""
import math
import unittest

from browser import PageTest
from model import Rest, ghost_force


class Lesson(PageTest):
    is_main = True

    def step(self, number, question):
        """Waits for this step, and until the hand has gone where the step wants it."""
        self.browser.wait(
            lambda state: state["lesson"] is not None and state["lesson"]["step"] == number, f"step {number} of the lesson"
        )
        state = self.browser.state()
        self.assertEqual(state["lesson"]["question"], question, state["lesson"])

    def goal_at(self, *goal_m):
        return self.browser.wait(
            lambda state: math.dist(state["goal_m"], goal_m) < 1e-4, f"the hand at {goal_m}, where the step begins"
        )

    def answered(self):
        state = self.browser.wait(lambda state: not state["lesson"]["is_open"], "an answer that was taken")
        self.assertEqual(state["lesson"]["outcome"], "right")

    def choose_rightly(self):
        self.browser.press(str(self.browser.state()["lesson"]["right_answer"]))
        self.answered()

    def go_on(self):
        self.browser.press("PageDown")

    def test_is_played_to_its_end(self):
        browser = self.open()
        before = browser.state()["set_up"]
        self.browser.open(self.address(query="?lesson=ghost"))
        browser.wait(lambda state: state["lesson"] is not None, "the lesson")
        self.assertEqual(browser.state()["lesson"]["steps"], 7)

        self.step(1, "choose")
        self.choose_rightly()
        self.go_on()

        self.step(2, None)
        self.go_on()

        self.step(3, "choose")
        self.choose_rightly()
        self.go_on()

        # One newton of ghost force: it grows with the depth of the hand.
        self.step(4, "task")
        deep = (0.02 * math.sqrt(0.5), -0.02 * math.sqrt(0.5))
        self.goal_at(*deep)
        wanted = tuple(c / ghost_force(deep, "naive") for c in deep)
        browser.drag(browser.on_screen(deep), browser.on_screen(wanted))
        self.answered()
        self.go_on()

        self.step(5, "choose")
        self.choose_rightly()
        self.go_on()

        # The ring lies on the straight way from the hand to the wall until somebody drags it.
        self.step(6, "guess")
        self.goal_at(0.01732, -0.010)
        goal = browser.state()["goal_m"]
        normal = (math.cos(math.radians(150.0)), math.sin(math.radians(150.0)))
        depth = -(normal[0] * goal[0] + normal[1] * goal[1])
        ring = tuple(g + 0.45 * depth * n for g, n in zip(goal, normal))
        rest = Rest(goal, "naive", normal_deg=150.0).device
        browser.drag(browser.on_screen(ring), browser.on_screen(rest))
        browser.press("Enter")
        self.answered()
        self.go_on()

        self.step(7, None)
        self.go_on()
        state = browser.wait(lambda state: state["lesson"] is None or state["lesson"]["is_complete"], "the lesson's end")
        if state["lesson"] is not None:
            browser.press("Escape")
            browser.wait(lambda state: state["lesson"] is None, "the stage without a lesson")
        browser.press("Escape")
        browser.wait_until(dialog="none")
        self.assertEqual(browser.state()["set_up"], before)

        # What was done is kept.
        browser.reload()
        kept = browser.script("return Object.entries(localStorage).map(each => each.join('=')).join('\\n')")
        self.assertIn("ghost", kept)

    def test_goes_back_and_is_left(self):
        browser = self.open(query="?lesson=feel-a-wall")
        self.step(1, None)
        self.go_on()
        self.step(2, "task")
        browser.press("PageUp")
        self.step(1, None)
        browser.press("Escape")
        browser.wait(lambda state: state["lesson"] is None, "the stage without a lesson")


if __name__ == "__main__":
    unittest.main()
