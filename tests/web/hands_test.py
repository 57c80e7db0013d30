"""Keys, mouse and fingers."""
import math
import unittest

from browser import DEVICE_STATUS, HEIGHT, HELP, LESSONS, PLOTS, WIDTH, PageTest, wait_for
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

    def test_lead_out_of_the_workbench_as_it_says(self):
        browser = self.open()
        browser.press("F4")
        browser.wait(
            lambda _: "Esc and then Tab" in browser.script("return document.getElementById('stage').ariaLabel"), "its words"
        )
        for _ in range(2):  # the first one closes the hint
            browser.press("Escape")
            browser.next_frame()
        browser.press("Tab")
        browser.wait(lambda _: browser.script("return document.activeElement.id") != "stage", "what comes after it")

    def test_of_the_plots_opens_them_where_they_are(self):
        browser = self.open()
        browser.press(PLOTS)
        browser.wait_until(face="workbench")

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

    def test_are_given_back_by_escape_until_the_canvas_has_the_focus_again(self):
        browser = self.open()
        focused = "return document.activeElement.id"
        wait_for(lambda: browser.press("Escape") or browser.script(focused) == "", "a canvas without the focus")
        before = browser.state()
        for key in ("3", "Space", "Right"):
            browser.press(key)
        browser.next_frame()
        after = browser.state()
        for key in ("strategy", "paused", "goal_m"):
            self.assertEqual(after[key], before[key], key)
        browser.script("document.getElementById('stage').focus()")
        browser.press("3")
        browser.wait_until(strategy="anisotropic")

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
        # About the middle of hand and handle: both stay in sight, or the view would be made to fit.
        ends = [browser.on_screen(browser.state()[key]) for key in ("goal_m", "device_m")]
        x, y = (0.5 * (one + other) for one, other in zip(*ends))
        left, right = (x - 60, y), (x + 60, y)
        steps = [[(left[0] - 6 * i, left[1]), (right[0] + 6 * i, right[1])] for i in range(11)]
        browser.touch(*steps)  # twice as far apart
        browser.wait(
            lambda _: browser.on_screen((0.01, 0.0))[0] - browser.on_screen((0.0, 0.0))[0] > 1.7 * before,
            "a view twice as close",
        )
        close = browser.on_screen((0.01, 0.0))[0] - browser.on_screen((0.0, 0.0))[0]
        self.assertLess(close, 2.3 * before)
        x, y = browser.on_screen((0.0, 0.0))
        browser.touch(*([(left[0] - 6 * i, left[1] - 4 * i), (right[0] - 6 * i, right[1] - 4 * i)] for i in range(11)))
        browser.wait(lambda _: math.dist(browser.on_screen((0.0, 0.0)), (x - 60, y - 40)) < 15, "a view moved by two")
        self.assert_close(browser.state()["goal_m"], goal, 1e-9, "two fingers do not move the hand")


# On the stage at 1280×800, and in the first lesson's first step.
FIT, RESET, MORE, CONTROLS, FULL_SCREEN = (66, 397), (144, 397), (1196, 49), (1100, 366), (1100, 412)
FIT_IN_LESSON, RESET_IN_LESSON = (66, 464), (149, 464)


class Buttons(PageTest):
    """That the stage has for those who know no key."""

    def is_fitted_again_by(self, button):
        browser = self.browser
        fitted = browser.on_screen((0.01, 0.0))
        for _ in range(3):
            browser.press("Z")
        browser.wait(lambda _: math.dist(browser.on_screen((0.01, 0.0)), fitted) > 20, "a closer view")
        browser.click(button)
        browser.wait(lambda _: math.dist(browser.on_screen((0.01, 0.0)), fitted) < 1, "the view as it was")

    def test_fit_and_reset(self):
        browser = self.open()
        self.is_fitted_again_by(FIT)
        goal = browser.state()["goal_m"]
        for _ in range(5):
            browser.press("Right")
        browser.wait(lambda state: math.dist(state["goal_m"], goal) > 0.004, "the hand elsewhere")
        browser.click(RESET)
        browser.wait(lambda state: math.dist(state["goal_m"], goal) < 1e-9, "the hand where it began")

    def test_fit_and_reset_in_a_lesson(self):
        browser = self.open(query="?lesson=ghost")
        browser.wait(lambda state: state["lesson"] is not None, "the lesson")
        browser.next_frame()
        self.is_fitted_again_by(FIT_IN_LESSON)
        before = browser.state()
        ticks = before["tick"]
        browser.click(RESET_IN_LESSON)
        browser.wait(lambda state: state["tick"] < ticks, "the motion begun anew")
        self.assertEqual(browser.state()["lesson"], before["lesson"])

    def test_words_and_controls_are_in_the_menu(self):
        browser = self.open()
        browser.click(MORE)
        browser.click(CONTROLS)
        browser.wait(lambda _: browser.script("return document.activeElement.matches('#controls h1')"), "the heading")
        self.assertGreater(browser.script("return document.getElementById('controls').clientWidth"), 200, "in sight")
        browser.click((1000, 400))
        browser.wait(lambda _: browser.script("return document.activeElement.id") == "stage", "the picture")

    def test_full_screen_is_in_the_menu(self):
        browser = self.open()
        browser.click(MORE)
        browser.click(FULL_SCREEN)
        browser.wait(lambda _: browser.script("return document.fullscreenElement !== null"), "the full screen")
        browser.press("X")
        browser.wait(lambda _: browser.script("return document.fullscreenElement === null"), "the window again")

    def test_fit_of_the_address_holds_at_each_size(self):
        browser = self.open(query="?fit")
        # The first picture's size is a new one, too.
        browser.wait(lambda state: state["frames"] > 3, "some pictures")
        fitted = browser.on_screen((0.01, 0.0))
        browser.press("Z")
        browser.wait(lambda _: math.dist(browser.on_screen((0.01, 0.0)), fitted) > 5, "a closer view")
        browser.resize((1000, 700))
        browser.wait_until(size_px=[1000, 700])
        browser.resize((WIDTH, HEIGHT))
        browser.wait_until(size_px=[WIDTH, HEIGHT])
        browser.wait(lambda _: math.dist(browser.on_screen((0.01, 0.0)), fitted) < 1, "everything in sight again")


class Phone(PageTest):
    """A small screen, and nothing but fingers."""

    def test_that_is_turned_has_everything_in_its_picture(self):
        browser = self.open()
        for size in ((390, 844), (844, 390), (390, 844)):
            browser.resize(size)
            browser.wait_until(size_px=list(size))

            def is_seen(state, size=size):
                places = (browser.on_screen(state[key]) for key in ("goal_m", "device_m", "proxy_m"))
                return all(0 < x < size[0] and 0 < y < size[1] for x, y in places)

            browser.wait(is_seen, f"hand, handle and wall in a picture of {size}")

    def test_has_no_workbench_and_says_so(self):
        browser = self.start(size=(390, 844))
        browser.open(self.address())
        browser.press("F4")
        state = browser.wait(lambda state: state["notice"], "words about the workbench")
        self.assertIn("larger window", state["notice"])
        self.assertEqual(state["face"], "stage")
        browser.resize((844, 600))
        browser.wait_until(size_px=[844, 600])
        browser.press("F4")
        browser.wait_until(face="workbench")
        browser.resize((390, 844))
        browser.wait_until(face="stage")

    def test_that_was_pinched_has_the_hand_in_its_picture(self):
        browser = self.start(size=(390, 844))
        browser.open(self.address())
        middle = browser.on_screen((0.03, 0.03))
        steps = [[(middle[0] - 10 - 16 * i, middle[1]), (middle[0] + 10 + 16 * i, middle[1])] for i in range(10)]
        browser.touch(*steps)

        def is_seen(state):
            x, y = browser.on_screen(state["goal_m"])
            return 0 < x < 390 and 0 < y < 844

        browser.wait(is_seen, "the hand in the picture")

    def test_whose_view_was_moved_has_the_handle_above_the_strategies(self):
        browser = self.start(size=(390, 844))
        browser.open(self.address())
        browser.touch(*[[(100 + 10 * i, 300 + 12 * i), (200 + 10 * i, 300 + 12 * i)] for i in range(11)])
        highest_card = 660

        def is_seen(state):
            places = (browser.on_screen(state[key]) for key in ("goal_m", "device_m"))
            return all(0 < x < 390 and 0 < y < highest_card for x, y in places)

        browser.wait(is_seen, "hand and handle in sight")


if __name__ == "__main__":
    unittest.main()
