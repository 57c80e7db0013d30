"""The page in another one: messages both ways, with the origin that the address names alone; the example in docs; and the
policy of docs/web.md as a header."""
import math
import pathlib
import re
import shutil
import tempfile
import unittest
import urllib.parse

from browser import PAGE, ROOT, PageServer, PageTest, wait_for

# What the page around it keeps of what it is told.
OUTER = """<!doctype html><title>around</title><link rel="icon" href="data:,"><iframe id="frame" style="width: 900px; height: 600px"></iframe>
<script>
window.told = [];
addEventListener("message", (event) => told.push({ origin: event.origin, ...event.data }));
window.send = (message, origin) => document.getElementById("frame").contentWindow.postMessage(message, origin);
</script>"""


class Embedded(PageTest):
    is_main = True
    allowed_errors = ("frame-ancestors", "postMessage")

    def setUp(self):
        super().setUp()
        folder = tempfile.TemporaryDirectory(prefix="ghostforce-outer-")
        self.addCleanup(folder.cleanup)
        self.outer_folder = pathlib.Path(folder.name)
        (self.outer_folder / "outer.html").write_text(OUTER, encoding="utf-8")
        self.outer = PageServer(self.outer_folder)
        self.addCleanup(self.outer.close)

    @staticmethod
    def origin_of(server):
        return server.address("").rstrip("/")

    def embed(self, origin, query="", fragment=""):
        """Opens the page around, with the page in it for messages with that origin."""
        browser = self.start()
        browser.driver.get(self.outer.address("outer.html"))
        inner = self.address(f"?embed={urllib.parse.quote(origin, safe='')}{query}", fragment)
        browser.script("document.getElementById('frame').src = arguments[0]", inner)
        return browser

    def told(self, tells, holds=lambda _: True):
        """The newest message of that kind for which it holds, once there is one."""

        def found():
            messages = self.browser.script("return window.told")
            return next((each for each in reversed(messages) if each.get("tells") == tells and holds(each)), None)

        return wait_for(found, f"a message that tells {tells}", lambda: str(self.browser.script("return window.told")))

    def ask(self, **request):
        self.asked = getattr(self, "asked", 0) + 1
        message = {"ghostforce": 1, "id": self.asked, **request}
        self.browser.script("send(arguments[0], arguments[1])", message, self.origin_of(self.server))
        return self.told("answer", lambda each: each.get("id") == self.asked)

    def test_tells_when_it_is_ready_and_what_has_settled(self):
        self.embed(self.origin_of(self.outer))
        ready = self.told("ready")
        self.assertEqual((ready["ghostforce"], ready["origin"]), (1, self.origin_of(self.server)))
        self.assertEqual(ready["state"]["strategy"], "naive")
        values = self.told("values")["values"]
        self.assertAlmostEqual(math.hypot(*values["ghost_force_N"]), 1.27, delta=0.01)
        count = len(self.browser.script("return window.told"))
        self.assertEqual(self.ask(ask="show", set_up="wall45 --strategy anisotropic")["done"], True)
        values = self.told("values", lambda each: each["values"]["strategy"] == "anisotropic")["values"]
        self.assertLess(math.hypot(*values["ghost_force_N"]), 0.01)
        self.assertLess(len(self.browser.script("return window.told")) - count, 5, "not each frame")

    def test_does_what_it_is_asked_and_says_why_not(self):
        self.embed(self.origin_of(self.outer))
        self.told("ready")
        self.assertTrue(self.ask(ask="act", action="full")["done"])
        self.assertEqual(self.ask(ask="state")["state"]["strategy"], "full")
        self.assertIn("anisotropic", self.ask(ask="actions")["actions"])
        for request, words in (
            ({"ask": "act", "action": "anistropic"}, "did you mean 'anisotropic'?"),
            ({"ask": "show", "set_up": "wall45 --stratgy full"}, "--strategy"),
            ({"ask": "lesson", "name": "gost"}, "ghost"),
            ({"ask": "everything"}, "Ask for one of state, actions, show, lesson, act."),
            ({"ask": "state", "ghostforce": 2}, "version 1"),
        ):
            with self.subTest(request=request):
                answer = self.ask(**request)
                self.assertFalse(answer["done"])
                self.assertIn(words, answer["why"])

    def test_answers_whatever_becomes_of_it(self):
        self.embed(self.origin_of(self.outer))
        self.told("ready")
        for request, why in (
            ({"ask": "act", "action": "undo"}, "undo"),
            ({"ask": "show", "set_up": "x" * 2_000_000}, "longer than 20000 characters"),
        ):
            with self.subTest(ask=request["ask"]):
                answer = self.ask(**request)
                self.assertFalse(answer["done"])
                self.assertIn(why, answer["why"])
        self.browser.driver.switch_to.frame(self.browser.driver.find_element("id", "frame"))
        self.browser.script("window.ghostforce.act = () => { throw new Error('broken'); }")
        self.browser.driver.switch_to.default_content()
        answer = self.ask(ask="act", action="full")
        self.assertEqual((answer["done"], answer["why"]), (False, "broken"))

    def test_tells_what_is_done_but_not_what_is_on_the_clipboard(self):
        self.embed(self.origin_of(self.outer))
        self.told("ready")
        self.ask(ask="act", action="why")
        self.told("action", lambda each: each["action"] == "toggle-mode mode=why")
        browser = self.browser
        browser.driver.switch_to.frame(browser.driver.find_element("id", "frame"))
        browser.script(
            """const clipboardData = new DataTransfer();
            clipboardData.setData("text/plain", "a secret");
            window.dispatchEvent(new ClipboardEvent("paste", { clipboardData, bubbles: true }));"""
        )
        browser.driver.switch_to.default_content()
        pasted = self.told("action", lambda each: each["action"].startswith("paste-set-up"))
        self.assertEqual(pasted["action"], 'paste-set-up line=""')
        state = self.ask(ask="state")["state"]
        self.assertNotIn("notice", state)
        self.assertNotIn("secret", str(self.browser.script("return window.told")))

    def test_tells_that_a_file_is_dropped_but_not_its_name(self):
        self.embed(self.origin_of(self.outer))
        self.told("ready")
        dropped = self.outer_folder / "a secret.toml"
        dropped.write_text("this is no scene", encoding="utf-8")
        self.browser.drop_file(dropped)
        self.told("action", lambda each: each["action"].startswith("drop-files"))
        self.ask(ask="state")
        self.assertNotIn("secret", str(self.browser.script("return window.told")))

    def test_gives_the_keys_back_at_escape(self):
        self.embed(self.origin_of(self.outer))
        self.told("ready")
        browser = self.browser
        browser.script("document.getElementById('frame').focus()")
        browser.driver.switch_to.frame(browser.driver.find_element("id", "frame"))
        browser.script("document.getElementById('stage').focus()")
        browser.press("3")
        browser.wait_until(strategy="anisotropic")
        browser.driver.switch_to.default_content()
        self.told("action", lambda each: each["action"] == "choose-by-number id=anisotropic")
        browser.driver.switch_to.frame(browser.driver.find_element("id", "frame"))
        focused = "return document.activeElement.id"
        wait_for(lambda: browser.press("Escape") or browser.script(focused) == "", "a canvas without the focus")
        browser.press("2")
        browser.next_frame()
        self.assertEqual(browser.state()["strategy"], "anisotropic")

    def test_tells_how_a_lesson_goes(self):
        self.embed(self.origin_of(self.outer))
        self.told("ready")
        self.assertTrue(self.ask(ask="lesson", name="ghost")["done"])
        lesson = self.told("lesson", lambda each: each["lesson"] is not None)["lesson"]
        self.assertEqual((lesson["name"], lesson["step"], lesson["outcome"]), ("ghost", 1, "open"))
        self.assertFalse(self.ask(ask="act", action="workbench")["done"], "a lesson keeps its stage")
        self.assertTrue(self.ask(ask="act", action=f"answer-{lesson['right_answer']}")["done"])
        lesson = self.told("lesson", lambda each: each["lesson"]["outcome"] == "right")["lesson"]
        self.assertEqual(lesson["chosen"], lesson["right_answer"])
        self.ask(ask="act", action="leave-lesson")
        self.told("lesson", lambda each: each["lesson"] is None)

    def test_neither_hears_nor_answers_another_origin(self):
        self.embed("https://course.example.org")
        frame = self.browser.driver.find_element("id", "frame")
        self.browser.driver.switch_to.frame(frame)
        self.browser.wait(lambda state: state["ready"] and state["frames"] > 20, "the page in the frame")
        self.browser.driver.switch_to.default_content()
        self.browser.script("send({ghostforce: 1, ask: 'act', action: 'full'}, '*')")
        self.browser.driver.switch_to.frame(frame)
        frames = self.browser.state()["frames"]
        self.browser.press("Space")
        self.browser.wait(lambda state: state["frames"] > frames, "frames after the message")
        self.assertEqual(self.browser.state()["strategy"], "naive")
        self.browser.driver.switch_to.default_content()
        self.assertEqual(self.browser.script("return window.told"), [])

    def test_with_the_policy_of_the_documentation_works_where_it_may_be_embedded_alone(self):
        guide = (ROOT / "docs/web.md").read_text(encoding="utf-8")
        policy = re.search(r"^Content-Security-Policy: (.*)$", guide, re.MULTILINE).group(1)
        origin = self.origin_of(self.outer)
        self.assertIn("frame-ancestors https://course.example.org", policy)
        for allowed in (True, False):
            with self.subTest(allowed=allowed):
                whom = origin if allowed else "https://course.example.org"
                header = policy.replace("https://course.example.org", whom)
                self.server = PageServer(PAGE.parent, [("Content-Security-Policy", header)])
                self.addCleanup(self.server.close)
                browser = self.embed(origin)
                if allowed:
                    self.told("ready")
                    self.assertTrue(self.ask(ask="act", action="why")["done"])
                else:
                    wait_for(
                        lambda: any("frame-ancestors" in each for each in browser.errors()), "a browser that refuses"
                    )
                    self.assertEqual(browser.script("return window.told"), [])

    def test_asks_no_server_for_an_icon(self):
        self.open()
        self.assertEqual([each for each in self.server.requests if "favicon" in each], [])


class CoursePage(PageTest):
    def test_of_the_documentation_reads_the_ghost_force(self):
        folder = tempfile.TemporaryDirectory(prefix="ghostforce-course-")
        self.addCleanup(folder.cleanup)
        shutil.copy(PAGE, folder.name)
        shutil.copy(ROOT / "docs/course-page.html", folder.name)
        server = PageServer(folder.name)
        self.addCleanup(server.close)
        browser = self.start(size=(1280, 1400))
        browser.driver.get(server.address("course-page.html"))

        def force():
            return browser.script("return document.getElementById('force').textContent")

        wait_for(lambda: force() == "1.27 N", "the ghost force of the left picture", force)
        wait_for(lambda: browser.script("return 'cured' in newest"), "the values of the right one")
        browser.script("ask('naive', {ask: 'show', set_up: 'wall45 --goal-mm=7.071,-7.071 --strategy naive'})")
        wait_for(lambda: force() == "0.64 N" or force() == "0.63 N", "half of it", force)
        browser.driver.find_element("id", "guess").send_keys("0,5")
        browser.driver.find_element("css selector", "#quiz button").click()
        verdict = browser.driver.find_element("id", "verdict")
        wait_for(lambda: verdict.text.startswith("Yes"), "the right answer taken", lambda: verdict.text)
        browser.driver.find_element("id", "reset").click()
        wait_for(lambda: force() == "1.27 N", "both as they were", force)


if __name__ == "__main__":
    unittest.main()
