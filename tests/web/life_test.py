"""What may happen to a page while it is open: its graphics go away, nobody looks at it, it is loaded again."""
import unittest
import urllib.parse

from browser import NEXT_THEME, PAGE, PageTest, wait_for
from pictures import difference

PREFERENCES = "Object.keys(localStorage).filter(each => each.startsWith('ghostforce'))"


class Context(PageTest):
    allowed_errors = ("CONTEXT_LOST_WEBGL",)

    def test_that_is_lost_comes_back_with_the_same_picture(self):
        browser = self.open()
        browser.press("Space")
        browser.wait_until(paused=True)
        for losses, face in ((1, "stage"), (2, "workbench")):
            with self.subTest(face=face):
                if browser.state()["face"] != face:
                    browser.press("F4")
                browser.wait_until(face=face)
                before = browser.still_picture()
                browser.script(
                    """const gl = document.getElementById('stage').getContext('webgl2');
                       window.lost = gl.getExtension('WEBGL_lose_context');
                       window.lost.loseContext();"""
                )
                browser.wait_until(context_losses=losses)
                browser.script("window.lost.restoreContext()")
                # Nothing but the picture tells that it is back.
                browser.wait(lambda _: difference(browser.picture(), before) < 0.001, "the same picture as before")
        # And it goes on.
        browser.press("Space")
        browser.press("3")
        browser.wait_until(paused=False, strategy="anisotropic")
        browser.wait(lambda _: difference(browser.picture(), before) > 0.002, "another picture")


    def test_that_stays_away_leaves_words_and_a_way_back(self):
        browser = self.open()
        browser.press("3")
        browser.press("W")
        state = browser.wait(
            lambda now: now["strategy"] == "anisotropic" and now["set_up"] in urllib.parse.unquote(now["url"]),
            "an address that holds what is shown",
        )
        browser.script(
            "document.getElementById('stage').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()"
        )
        browser.wait(lambda _: "taken the graphics away" in browser.body_text(), "words about the graphics")
        nodes = browser.command("Accessibility.getFullAXTree")["nodes"]
        dialog = next(each for each in nodes if each.get("role", {}).get("value") == "alertdialog")
        self.assertIn("where you were is in its address", dialog["name"]["value"])
        browser.driver.find_element("css selector", "#way-back button").click()
        again = browser.wait(
            lambda now: now["ready"] and now["context_losses"] == 0 and now["renderer"], "the page loaded again"
        )
        for key in ("strategy", "set_up", "theme"):
            self.assertEqual(again[key], state[key], key)
        self.assertNotIn("taken the graphics away", browser.body_text())

    def test_that_stays_away_in_a_lesson_leads_back_to_its_step(self):
        browser = self.open(query="?lesson=ghost")
        for _ in range(2):  # the first one shows the answer
            browser.press("PageDown")
        browser.wait(lambda now: "lesson=ghost&step=2" in now["url"], "an address that names the step")
        browser.script(
            "document.getElementById('stage').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()"
        )
        browser.wait(lambda _: "is in its address" in browser.body_text(), "words about the graphics")
        browser.driver.find_element("css selector", "#way-back button").click()
        again = browser.wait(
            lambda now: now["ready"] and now["context_losses"] == 0 and now["renderer"], "the page loaded again"
        )
        self.assertEqual((again["lesson"]["name"], again["lesson"]["step"]), ("ghost", 2))

    def test_that_stays_away_in_a_kiosk_says_that_it_begins_anew(self):
        browser = self.open(query="?kiosk&lesson=ghost")
        browser.script(
            "document.getElementById('stage').getContext('webgl2').getExtension('WEBGL_lose_context').loseContext()"
        )
        browser.wait(lambda _: "the lesson has to begin anew" in browser.body_text(), "words about the lesson")

    def test_that_comes_back_late_takes_the_words_away(self):
        browser = self.open()
        browser.script(
            """window.lost = document.getElementById('stage').getContext('webgl2').getExtension('WEBGL_lose_context');
               window.lost.loseContext();"""
        )
        browser.wait(lambda _: "taken the graphics away" in browser.body_text(), "words about the graphics")
        browser.script("window.lost.restoreContext()")
        browser.wait(lambda _: "taken the graphics away" not in browser.body_text(), "a page without them")


class System(PageTest):
    """What the person has set for all pages."""

    is_main = True

    def test_reduces_motion_when_asked_to(self):
        browser = self.open()
        self.assertFalse(browser.state()["reduces_motion"])
        browser.emulate(prefers_reduced_motion="reduce")
        browser.wait_until(reduces_motion=True)
        # A lesson's hand does not glide: it is there with the step.
        browser.open(self.address("?lesson=lose-a-motor"))
        browser.wait_until(reduces_motion=True)
        before = browser.state()["goal_m"]
        browser.press("PageDown")
        browser.wait(lambda state: state["lesson"]["step"] == 2, "the second step")
        places = {tuple(browser.state()["goal_m"]) for _ in range(20)}
        self.assertLessEqual(len(places | {tuple(before)}), 2)
        browser.emulate(prefers_reduced_motion="no-preference")
        browser.wait_until(reduces_motion=False)

    def test_forces_its_colours_on_the_page_and_lets_go(self):
        browser = self.open()
        theme = browser.state()["theme"]
        browser.emulate(forced_colors="active")
        browser.wait_until(theme="system")
        canvas = browser.script(
            "const probe = document.body.appendChild(document.createElement('i'));"
            "probe.style.forcedColorAdjust = 'none'; probe.style.color = 'Canvas';"
            "const colour = getComputedStyle(probe).color.match(/[0-9]+/g).map(Number); probe.remove(); return colour"
        )
        picture = browser.still_picture()
        self.assertEqual(list(picture.getpixel((10, picture.height - 300))), canvas[:3])
        browser.emulate(forced_colors="none")
        browser.wait_until(theme=theme)


class Hidden(PageTest):
    def test_pauses_and_goes_on(self):
        browser = self.start()
        browser.open(self.address())
        browser.wait(lambda state: state["tick"] > 50, "ticks")
        first = browser.driver.current_window_handle
        # The other tab can ask the one that it came from.
        browser.script("window.open('about:blank', '_blank')")
        other = next(each for each in browser.driver.window_handles if each != first)
        browser.driver.switch_to.window(other)

        def hidden():
            return browser.script("return window.opener.ghostforce.state()")

        wait_for(lambda: not hidden()["is_visible"], "a page that knows that it is hidden", lambda: str(hidden()))
        tick = hidden()["tick"]
        # Time passes by this tab's clock; a busy machine makes it longer, and no tick more.
        browser.driver.execute_async_script("setTimeout(arguments[0], 500)")
        self.assertEqual(hidden()["tick"], tick)
        browser.driver.switch_to.window(first)
        browser.wait(lambda state: state["is_visible"] and state["tick"] > tick, "ticks that go on")


class Kept(PageTest):
    def test_preferences_outlive_a_reload(self):
        browser = self.open()
        theme = browser.state()["theme"]
        browser.press(NEXT_THEME)
        state = browser.wait(lambda state: state["theme"] != theme, "another theme")
        browser.use_action("Language: Español")
        browser.wait_until(language="es")
        browser.press("F4")
        browser.wait_until(face="workbench")
        # Written a moment after the last change.
        browser.wait(lambda _: browser.script("return localStorage.length") > 0, "stored preferences")
        browser.reload()
        browser.wait_until(theme=state["theme"], language="es", face="workbench")

    def test_preferences_of_two_tabs_are_both_kept(self):
        browser = self.open()
        theme = browser.state()["theme"]
        first = browser.driver.current_window_handle
        browser.driver.switch_to.new_window("tab")
        browser.driver.get(self.address())
        browser.wait(lambda state: state["ready"], "the second tab's first picture")
        second = browser.driver.current_window_handle
        browser.press("F4")
        browser.wait_until(face="workbench")
        browser.wait(lambda _: "workbench" in browser.script(f"return {PREFERENCES}.map(k => localStorage[k]).join()"), "the second tab's choice kept")
        browser.driver.switch_to.window(first)
        browser.wait(lambda state: state["is_visible"], "the first tab in sight")
        browser.press(NEXT_THEME)
        chosen = browser.wait(lambda state: state["theme"] != theme, "another theme")["theme"]
        browser.wait(lambda _: chosen in browser.script(f"return {PREFERENCES}.map(k => localStorage[k]).join()"), "the first tab's choice kept")
        browser.reload()
        browser.wait_until(theme=chosen, face="workbench")
        browser.driver.switch_to.window(second)
        browser.driver.close()
        browser.driver.switch_to.window(first)

    def test_preferences_of_a_page_from_a_disk_outlive_a_reload(self):
        browser = self.start()
        browser.open(PAGE.as_uri())
        theme = browser.state()["theme"]
        browser.press(NEXT_THEME)
        state = browser.wait(lambda state: state["theme"] != theme, "another theme")
        browser.wait(lambda _: browser.script("return localStorage.length") > 0, "stored preferences")
        browser.reload()
        browser.wait_until(theme=state["theme"])

    def test_broken_preferences_do_not_stop_it(self):
        browser = self.open()
        browser.press(NEXT_THEME)
        names = browser.wait(lambda _: browser.script(f"return {PREFERENCES}.length"), "stored preferences")
        for broken in ("", "}{", "theme = [", "\\u0000\\uffff", "format = 999999999999999999999"):
            with self.subTest(broken=broken):
                names = browser.script(f"return {PREFERENCES}")
                browser.script("for (const each of arguments[0]) localStorage.setItem(each, arguments[1])", names, broken)
                browser.reload()
                self.assertEqual(browser.state()["face"], "stage")

    def test_forbidden_storage_does_not_stop_it(self):
        browser = self.start()
        browser.run_before_page(
            "Object.defineProperty(window, 'localStorage', {get() { throw new DOMException('no', 'SecurityError'); }});"
        )
        browser.open(self.address())
        theme = browser.state()["theme"]
        browser.press(NEXT_THEME)
        browser.wait(lambda state: state["theme"] != theme, "another theme, if not a kept one")

    def test_full_storage_does_not_stop_it(self):
        browser = self.start()
        browser.run_before_page(
            "Storage.prototype.setItem = () => { throw new DOMException('full', 'QuotaExceededError'); };"
        )
        browser.open(self.address())
        theme = browser.state()["theme"]
        browser.press(NEXT_THEME)
        browser.wait(lambda state: state["theme"] != theme, "another theme, if not a kept one")


if __name__ == "__main__":
    unittest.main()
