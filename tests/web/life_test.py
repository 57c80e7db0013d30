"""What may happen to a page while it is open: its graphics go away, nobody looks at it, it is loaded again."""
import unittest

from browser import LESSONS, NEXT_THEME, PAGE, SPANISH, PageTest, wait_for
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
        browser.press(LESSONS)
        browser.wait_until(dialog="lessons")
        browser.next_frame()
        browser.click(SPANISH)
        browser.wait_until(language="es")
        browser.press("Escape")
        browser.wait_until(dialog="none")
        browser.press("F4")
        browser.wait_until(face="workbench")
        # Written a moment after the last change.
        browser.wait(lambda _: browser.script("return localStorage.length") > 0, "stored preferences")
        browser.reload()
        browser.wait_until(theme=state["theme"], language="es", face="workbench")

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
