"""How the page starts, on what, and what it asks of a network."""
import unittest

from browser import HEIGHT, LESSONS, PAGE, PLOTS, ROOT, WIDTH, PageTest, wait_for


class Start(PageTest):
    is_main = True

    def expect_stage(self, browser):
        state = browser.state()
        self.assertEqual(state["face"], "stage")
        self.assertEqual(state["language"], "en")
        self.assertEqual(state["size_px"], [WIDTH, HEIGHT])
        self.assertIsNone(state["lesson"])
        self.assertFalse(state["paused"])
        self.assertGreater(state["frames"], 0)
        browser.wait(lambda now: now["tick"] > state["tick"], "ticks that go on")
        # Of one colour it would be, had nothing been drawn.
        self.assertGreater(len(browser.picture().getcolors(WIDTH * HEIGHT)), 50)

    def test_from_a_disk(self):
        browser = self.start()
        browser.open(PAGE.as_uri())
        self.expect_stage(browser)

    def test_from_a_server_in_one_request_and_none_after(self):
        browser = self.open()
        self.expect_stage(browser)
        browser.press("F4")
        browser.wait_until(face="workbench")
        browser.press(PLOTS)
        browser.press("F4")
        browser.press(LESSONS)
        browser.wait_until(dialog="lessons")
        browser.press("Escape")
        browser.press("3")
        browser.wait_until(dialog="none", strategy="anisotropic")
        self.assertEqual(browser.requests(), [self.address()])
        self.assertEqual(self.server.requests, ["/" + PAGE.name])

    def test_is_one_small_file(self):
        self.assertLessEqual(PAGE.stat().st_size, 3_000_000)

    def test_in_a_dense_picture(self):
        browser = self.open(density=2.0, size=(640, 400))
        state = browser.state()
        self.assertEqual(state["size_px"], [1280, 800])
        self.assertEqual(state["density"], 2.0)
        drawn = browser.script("const c = document.getElementById('stage'); return [c.width, c.height]")
        self.assertEqual(drawn, [1280, 800])

    def test_follows_the_size_of_its_window(self):
        browser = self.open()
        browser.resize((900, 700))
        browser.wait_until(size_px=[900, 700])

    def test_speaks_the_language_of_the_browser(self):
        browser = self.open(language="es")
        self.assertEqual(browser.state()["language"], "es")


class Words(PageTest):
    def test_of_the_notices_are_shown_in_place_of_the_program(self):
        browser = self.start()
        browser.driver.get(self.address(query="?notices"))
        words = wait_for(browser.body_text, "the notices")
        for file in ("LICENSE", "THIRD_PARTY_NOTICES.md"):
            self.assertIn((ROOT / file).read_text(encoding="utf-8").strip(), words)
        self.assertIsNone(browser.state())
        self.assertEqual(browser.script("return document.getElementById('reading').lang"), "en")

    def test_about_the_state_name_each_of_its_keys(self):
        state = self.open(query="?lesson=ghost").state()
        told = (ROOT / "docs/web.md").read_text(encoding="utf-8")
        self.assertEqual([key for key in [*state, *state["lesson"]] if f"`{key}`" not in told], [])


class WithoutWebGL2(PageTest):
    def start_without(self, **how):
        browser = self.start(**how)
        browser.run_before_page(
            """const get = HTMLCanvasElement.prototype.getContext;
               HTMLCanvasElement.prototype.getContext = function (kind, ...others) {
                 return kind === 'webgl2' ? null : get.call(this, kind, ...others);
               };"""
        )
        browser.driver.get(self.address())
        return wait_for(lambda: "WebGL 2" in browser.body_text() and browser.body_text(), "words about WebGL 2")

    def test_says_what_is_missing_and_what_to_do(self):
        words = self.start_without()
        self.assertRegex(words, r"(?i)\b(update|other browser|another browser|Firefox|Chrome)\b", "what to do")
        self.assertRegex(words, r"(?i)hardware|graphics", "what to look at")

    def test_says_it_in_the_language_of_the_browser(self):
        self.assertIn("navegador", self.start_without(language="es"))

    def test_says_it_to_a_new_person_in_the_language_of_the_browser(self):
        self.start_without()
        self.browser.script("localStorage.setItem('ghostforce:preferences.toml', 'language = \"es\"')")
        language = "return document.documentElement.lang"
        for query, wanted in (("", "es"), ("?reset", "en")):
            self.browser.driver.get(self.address(query))
            self.assertEqual(self.browser.script(language), wanted, query)


if __name__ == "__main__":
    unittest.main()
