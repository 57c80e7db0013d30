"""Keys, mouse and fingers."""
import math
import unittest

from browser import DEVICE_STATUS, HEIGHT, HELP, LESSONS, WIDTH, PageTest
from model import Rest, ghost_force


class Keys(PageTest):
    is_main = True

    def test_choose_the_strategy(self):
        browser = self.open()
        goal = browser.state()["goal_m"]
        for key, strategy in (("1", "full"), ("2", "naive"), ("3", "anisotropic")):
            browser.press(key)
            browser.wait_until(strategy=strategy)
            state = browser.wait_for_rest(Rest(goal, strategy))
            self.assert_close(state["device_m"], Rest(goal, strategy).device, 1e-4)
        browser.press("2")
        browser.wait_for_rest(Rest(goal, "naive"))
        browser.wait(
            lambda state: abs(math.hypot(*state["ghost_force_N"]) - ghost_force(goal, "naive")) < 0.01,
            "the ghost force at rest",
        )

    def test_pause_and_step(self):
        browser = self.open()
        browser.press("Space")
        browser.wait_until(paused=True)
        browser.next_frame()
        tick = browser.state()["tick"]
        browser.press(".")
        browser.wait_until(tick=tick + 1)
        browser.press(",")
        browser.wait_until(tick=tick)
        browser.press("Space")
        browser.wait(lambda state: not state["paused"] and state["tick"] > tick + 50, "ticks after the pause")

    def test_change_the_face_and_back(self):
        browser = self.open()
        browser.press("F4")
        browser.wait_until(face="workbench")
        browser.press("F4")
        browser.wait_until(face="stage")

    def test_modes_of_the_stage(self):
        browser = self.open()
        for key in "QYLOH":
            before = browser.state()["mode"]
            browser.press(key)
            browser.wait(lambda state, before=before: state["mode"] != before, f"another mode by {key}")
        browser.press("H")
        browser.wait_until(mode="none")

    def test_arrows_move_the_goal_by_a_millimetre(self):
        browser = self.open()
        x, y = browser.state()["goal_m"]
        browser.press("Left")
        browser.press("Ctrl+Down")
        browser.press("Shift+Right")
        browser.wait(lambda state: math.dist(state["goal_m"], (x - 0.0009, y - 0.01)) < 1e-9, "all three steps")

    def test_help_and_lessons_open_and_close(self):
        browser = self.open()
        others = (("Ctrl+O", "open"), ("Ctrl+P", "palette"))
        for key, dialog in ((HELP, "help"), (LESSONS, "lessons"), (DEVICE_STATUS, "device"), *others):
            browser.press(key)
            browser.wait_until(dialog=dialog)
            browser.press("Escape")
            browser.wait_until(dialog="none")

    def test_none_is_lost_however_fast(self):
        browser = self.open()
        x, y = browser.state()["goal_m"]
        browser.type("[" * 30)
        browser.type("]" * 30)
        for _ in range(10):
            browser.press("Right")
        state = browser.wait(lambda state: math.isclose(state["goal_m"][0], x + 0.01), "ten steps to the right")
        self.assert_close(state["goal_m"], (x + 0.01, y), 1e-9)
        self.assertNotIn("actuated_deg", state["set_up"])


class Mouse(PageTest):
    is_main = True

    def test_a_drag_moves_the_goal_and_the_force_follows_the_model(self):
        browser = self.open()
        begin = browser.on_screen(browser.state()["goal_m"])
        end = browser.on_screen((0.020, -0.010))
        browser.drag(begin, ((begin[0] + end[0]) / 2, (begin[1] + end[1]) / 2), end)
        origin = browser.on_screen((0.0, 0.0))
        pixel_m = 0.01 / (browser.on_screen((0.01, 0.0))[0] - origin[0])
        state = browser.wait(
            lambda state: math.dist(state["goal_m"], (0.020, -0.010)) < 1.5 * pixel_m, "the goal at the pointer"
        )
        for strategy, key in (("naive", "2"), ("full", "1")):
            browser.press(key)
            state = browser.wait_for_rest(Rest(state["goal_m"], strategy))
            self.assertEqual(state["strategy"], strategy)

    def test_the_wheel_zooms_at_the_pointer(self):
        browser = self.open()
        browser.press("F4")
        browser.wait_until(face="workbench")
        at = (0.0, 0.0)
        x, y = browser.on_screen(at)
        before = browser.on_screen((0.01, 0.0))[0] - x
        browser.command("Input.dispatchMouseEvent", type="mouseMoved", x=x, y=y)
        browser.command("Input.dispatchMouseEvent", type="mouseWheel", x=x, y=y, deltaX=0, deltaY=-120)
        browser.wait(
            lambda _: browser.on_screen((0.01, 0.0))[0] - browser.on_screen(at)[0] > 1.05 * before, "a closer view"
        )
        self.assert_close(browser.on_screen(at), (x, y), 1.0)


class Fingers(PageTest):
    def test_one_drags_the_goal(self):
        browser = self.open()
        begin = browser.on_screen(browser.state()["goal_m"])
        end = browser.on_screen((0.020, -0.012))
        browser.touch([begin], [((begin[0] + end[0]) / 2, (begin[1] + end[1]) / 2)], [end])
        origin = browser.on_screen((0.0, 0.0))
        pixel_m = 0.01 / (browser.on_screen((0.01, 0.0))[0] - origin[0])
        state = browser.wait(
            lambda state: math.dist(state["goal_m"], (0.020, -0.012)) < 1.5 * pixel_m, "the goal at the finger"
        )
        browser.wait_for_rest(Rest(state["goal_m"], state["strategy"]))

    def test_two_zoom_and_move_the_view(self):
        browser = self.open()
        goal = browser.state()["goal_m"]
        at = browser.on_screen((0.0, 0.0))
        before = browser.on_screen((0.01, 0.0))[0] - at[0]
        left, right = (WIDTH / 2 - 60, HEIGHT / 2), (WIDTH / 2 + 60, HEIGHT / 2)
        steps = [[(left[0] - 6 * i, left[1]), (right[0] + 6 * i, right[1])] for i in range(11)]
        browser.touch(*steps)  # twice as far apart
        browser.wait(
            lambda _: browser.on_screen((0.01, 0.0))[0] - browser.on_screen((0.0, 0.0))[0] > 1.7 * before,
            "a view twice as close",
        )
        close = browser.on_screen((0.01, 0.0))[0] - browser.on_screen((0.0, 0.0))[0]
        self.assertLess(close, 2.3 * before)
        x, y = browser.on_screen((0.0, 0.0))
        browser.touch(*([(left[0] + 8 * i, left[1] + 4 * i), (right[0] + 8 * i, right[1] + 4 * i)] for i in range(11)))
        browser.wait(lambda _: math.dist(browser.on_screen((0.0, 0.0)), (x + 80, y + 40)) < 15, "a view moved by two")
        self.assert_close(browser.state()["goal_m"], goal, 1e-9, "two fingers do not move the hand")


if __name__ == "__main__":
    unittest.main()
