"""What the address says: a set-up as its fragment, a lesson, a kiosk; and the same set-up as pasted text."""
import unittest
import urllib.parse

from browser import LESSONS, NEXT_THEME, PLOTS, PageTest
from model import Rest

LINE = "ghostforce run wall45 --set wall.normal_deg=120.0 --goal-mm=10,-17.32 --strategy anisotropic --view workbench"


def fragment_of(line):
    return "#" + urllib.parse.quote(line)


class SetUp(PageTest):
    is_main = True

    def test_of_the_fragment_is_shown(self):
        browser = self.open(fragment=fragment_of(LINE))
        state = browser.wait_until(face="workbench", strategy="anisotropic")
        self.assert_close(state["goal_m"], (0.010, -0.01732), 1e-9)
        self.assertIn("wall.normal_deg=120", state["set_up"])
        browser.wait_for_rest(Rest((0.010, -0.01732), "anisotropic", normal_deg=120.0))

    def test_of_a_page_opens_the_same_in_another(self):
        browser = self.open()
        browser.press("W")
        browser.press("[")
        browser.press("Up")
        browser.press("3")
        browser.press("F4")
        state = browser.wait_until(face="workbench", strategy="anisotropic")
        # The address follows what is shown, though not each frame.
        state = browser.wait(
            lambda now: now["set_up"] in urllib.parse.unquote(now["url"]), "an address that holds what is shown"
        )
        browser.open(state["url"])
        again = browser.wait_until(set_up=state["set_up"])
        for key in ("face", "mode", "strategy"):
            self.assertEqual(again[key], state[key], key)
        self.assert_close(again["goal_m"], state["goal_m"], 1e-8)  # as a file rounds it

    def test_follows_a_change_of_the_fragment(self):
        browser = self.open()
        browser.script("location.hash = arguments[0]", fragment_of(LINE))
        state = browser.wait_until(face="workbench", strategy="anisotropic")
        self.assert_close(state["goal_m"], (0.010, -0.01732), 1e-9)

    def test_that_nobody_can_read_is_told_of_and_changes_nothing(self):
        usual = self.open().state()["set_up"]
        self.browser.open(self.address(fragment="#ghostforce%20run%20wall45%20--stratgy%20naive"))
        state = self.browser.wait(lambda state: "--stratgy" in state["notice"], "words about the wrong option")
        self.assertEqual(state["set_up"], usual)
        for broken, words in (("%E0%A4%A", "%A"), ("wall45%00", "U+0000"), ("wall45%", "%")):
            with self.subTest(fragment=broken):
                self.browser.open(self.address(fragment="#" + broken))
                state = self.browser.wait(lambda state: "set-up in the address" in state["notice"], "words about it")
                self.assertIn(words, state["notice"])
                self.assertEqual(state["set_up"], usual)

    def test_is_pasted(self):
        browser = self.open()
        browser.set_clipboard(LINE)
        browser.press("Ctrl+V")
        state = browser.wait_until(face="workbench", strategy="anisotropic")
        self.assert_close(state["goal_m"], (0.010, -0.01732), 1e-9)

    def test_is_copied(self):
        browser = self.open()
        browser.press("3")
        set_up = browser.wait_until(strategy="anisotropic")["set_up"]
        browser.set_clipboard("nothing yet")
        browser.press("Ctrl+C")

        def copied(_):
            text = browser.driver.execute_async_script(
                "const done = arguments[0]; navigator.clipboard.readText().then(done, e => done('' + e));"
            )
            return set_up in text

        browser.wait(copied, "the set-up in the clipboard")

    def test_of_the_link_says_whether_it_is_copied(self):
        browser = self.open()
        browser.press("U")
        browser.wait(lambda _: browser.script("return document.getElementById('link').open"), "the link")
        copy = "return document.getElementById('copy').textContent"
        for is_copied, words in (("false", "Not copied: press Ctrl+C"), ("true", "Copied")):
            browser.script(
                f"""Object.defineProperty(navigator, "clipboard", {{ value: undefined, configurable: true }});
                   document.execCommand = () => {is_copied};
                   document.getElementById("copy").click();"""
            )
            browser.wait(lambda _, words=words: browser.script(copy) == words, f"the words {words}")


class Address(PageTest):
    def test_begins_a_lesson(self):
        browser = self.open(query="?lesson=ghost")
        state = browser.wait(lambda state: state["lesson"] is not None, "a lesson")
        self.assertEqual((state["lesson"]["name"], state["lesson"]["step"]), ("ghost", 1))
        self.assertEqual(state["face"], "stage")

    def test_begins_a_lesson_at_a_step_and_follows_it(self):
        browser = self.open(query="?lesson=ghost&step=3")
        state = browser.wait(lambda state: state["lesson"] is not None, "a lesson")
        self.assertEqual(state["lesson"]["step"], 3)
        browser.press("PageUp")
        browser.wait(lambda state: "lesson=ghost&step=2" in state["url"], "the step before, in the address")
        browser.press("Escape")
        browser.wait(lambda state: state["lesson"] is None and "lesson" not in state["url"], "an address without it")

    def test_of_a_lesson_that_is_not_there_is_told_of(self):
        browser = self.open(query="?lesson=gost")
        state = browser.wait(lambda state: "gost" in state["notice"], "words about the lesson")
        self.assertIn("ghost", state["notice"])
        self.assertIsNone(state["lesson"])

    def test_that_asks_for_what_there_is_not_is_told_of(self):
        for query, words in (
            ('?language="><script>', "<script>"),
            ("?lessons=ghost", "did you mean 'lesson'?"),
            ("?lesson=", "lesson has no value"),
            ("?embed=*", "not the origin of a page"),
            ("?embed=http://[", "not the origin of a page"),
            ("?embed=http://[0:0:0:0:0:0:0:1]", "not the origin of a page"),
            ("?embed=https://a:443", "not the origin of a page"),
            ("?embed=https://a/b", "not the origin of a page"),
            ("?embed=httpx://a", "not the origin of a page"),
            ("?fit=banana", "fit takes no value but 1"),
            ("?notices=no", "notices takes no value but 1"),
            ("?lesson=ghost&step=9", "Step 9 in the address of this page cannot be used: the lesson has 7 steps"),
            ("?lesson=ghost#broken", "is not used: the lesson comes before it"),
        ):
            with self.subTest(query=query):
                state = self.open(query=query).wait(lambda state: state["notice"], "words about the address")
                self.assertIn(words, state["notice"])

    def test_takes_the_origin_of_any_page(self):
        for origin in ("http://[::1]:8000", "https://a:80", "http://localhost:8000"):
            with self.subTest(origin=origin):
                state = self.open(query=f"?embed={origin}").wait(lambda state: state["frames"] > 3, "a few frames")
                self.assertEqual(state["notice"], "")

    def test_of_a_new_person_uses_nothing_that_is_kept(self):
        browser = self.open()
        theme = browser.state()["theme"]
        browser.press(NEXT_THEME)
        kept = browser.wait(lambda state: state["theme"] != theme, "another theme")["theme"]
        browser.wait(lambda _: browser.script("return localStorage.length") > 0, "stored preferences")
        browser.open(self.address("?reset"))
        browser.wait_until(theme=theme)
        browser.press("F4")
        browser.wait_until(face="workbench")
        browser.next_frame()
        browser.open(self.address())
        browser.wait_until(theme=kept, face="stage")

    def test_makes_a_kiosk(self):
        browser = self.open(query="?kiosk")
        state = browser.wait(lambda state: state["lesson"] is not None, "the first lesson")
        self.assertTrue(state["kiosk"])
        self.assertEqual(state["lesson"]["name"], browser.script("return window.ghostforce.lessons()")[0])
        # Nothing leads out of it.
        for key in ("F4", "Escape", "Ctrl+O", "Ctrl+S", LESSONS, PLOTS, "Space", "Q", "Ctrl+V"):
            browser.press(key)
            browser.next_frame()
        after = browser.state()
        for key in ("face", "mode", "dialog", "paused"):
            self.assertEqual(after[key], state[key], key)
        self.assertEqual(after["lesson"]["name"], state["lesson"]["name"])
        language = "return document.getElementById('control-lesson-language')?.lang"
        browser.wait(lambda _: browser.script(language) == "es", "the button Español, in its own language")

    def test_makes_a_kiosk_of_one_lesson(self):
        browser = self.open(query="?kiosk&lesson=ghost")
        browser.wait(lambda state: state["lesson"] and state["lesson"]["name"] == "ghost", "that lesson")
        browser.press("Escape")
        browser.next_frame()
        self.assertEqual(browser.state()["lesson"]["name"], "ghost")


if __name__ == "__main__":
    unittest.main()
