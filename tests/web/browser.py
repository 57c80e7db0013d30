"""Chromium with the page in it: started, driven by real keys, pointer and fingers, and asked for the state that the page
exports. Nothing here or in the tests decides by the clock: a wait is for a condition, and its limit is only there so
that a page that never gets there is told of."""
import contextlib
import functools
import http.server
import io
import json
import os
import pathlib
import subprocess
import tempfile
import threading
import time
import unittest

from PIL import Image
from selenium import webdriver
from selenium.common.exceptions import JavascriptException, WebDriverException
from selenium.webdriver.chrome.options import Options
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.keys import Keys

ROOT = pathlib.Path(__file__).resolve().parents[2]
PAGE = pathlib.Path(os.environ.get("GHOSTFORCE_PAGE", ROOT / "build/web/ghostforce.html"))
PROGRAM = pathlib.Path(os.environ.get("GHOSTFORCE_PROGRAM", ROOT / "build/release/bin/ghostforce"))

# Calls back when what came before has been drawn; the first of these may still be under way.
NEXT_FRAME = """
const done = arguments[0];
let frames = 4;
const count = () => --frames > 0 ? requestAnimationFrame(count) : done();
requestAnimationFrame(count);
"""

PATIENCE_S = 60.0  # machines that run tests may be slow and busy; a good run never waits that long
WIDTH, HEIGHT = 1280, 800

MODIFIERS = {"Ctrl": Keys.CONTROL, "Shift": Keys.SHIFT, "Alt": Keys.ALT}
NAMED_KEYS = {
    "Enter": Keys.ENTER, "Escape": Keys.ESCAPE, "Space": Keys.SPACE, "Tab": Keys.TAB, "Backspace": Keys.BACKSPACE,
    "Left": Keys.LEFT, "Right": Keys.RIGHT, "Up": Keys.UP, "Down": Keys.DOWN, "Home": Keys.HOME, "End": Keys.END,
    "PageDown": Keys.PAGE_DOWN, "PageUp": Keys.PAGE_UP, "F1": Keys.F1, "F2": Keys.F2, "F3": Keys.F3, "F4": Keys.F4,
    "F5": Keys.F5, "F6": Keys.F6, "F7": Keys.F7, "F8": Keys.F8, "F9": Keys.F9,
}  # fmt: skip

# The page's own, where the browser keeps the desktop's for itself: app/state/front_keys.h.
HELP, LESSONS, DEVICE_STATUS, PLOTS, NEXT_THEME, SAVE_PICTURE = "KMDNCI"

# At 1280×800, what no key does: the workbench's button that starts and ends a recording.
RECORD_BUTTON = (864, 23)


class PageServer:
    """Serves one folder on this machine alone, at a port that is free, and knows what was asked for. `headers` go with
    each answer."""

    def __init__(self, folder, headers=()):
        self.requests = []
        self._pages = {}  # by path: what a test serves besides
        requests, pages = self.requests, self._pages

        class Handler(http.server.SimpleHTTPRequestHandler):
            def log_message(self, *_):
                requests.append(self.path)

            def do_GET(self):
                if self.path not in pages:
                    return super().do_GET()
                self.log_message("")
                self.send_response(200)
                self.send_header("Content-Type", "text/html; charset=utf-8")
                self.end_headers()
                self.wfile.write(pages[self.path].encode())

            def end_headers(self):
                self.send_header("Cache-Control", "no-store")  # each opening asks anew
                for name, value in headers:
                    self.send_header(name, value)
                super().end_headers()

        self._server = http.server.ThreadingHTTPServer(
            ("127.0.0.1", 0), functools.partial(Handler, directory=str(folder))
        )
        threading.Thread(target=self._server.serve_forever, daemon=True).start()

    def add(self, path, page):
        """Serves this text as HTML, too."""
        self._pages[path] = page

    def address(self, name):
        return f"http://127.0.0.1:{self._server.server_port}/{name}"

    def close(self):
        self._server.shutdown()
        self._server.server_close()


def wait_for(found, what, told=lambda: ""):
    """Returns what found() returns, once that counts as true. Fails with these words and what told() says."""
    deadline = time.monotonic() + PATIENCE_S
    while not (result := found()):
        if time.monotonic() > deadline:
            raise AssertionError(f"waited {PATIENCE_S:.0f} s for {what}\n{told()}")
        time.sleep(0.02)
    return result


class Browser:
    """One Chromium with a profile and a download folder of its own."""

    def __init__(self, *, density=1.0, size=(WIDTH, HEIGHT), language="en-US", arguments=()):
        self._folder = tempfile.TemporaryDirectory(prefix="ghostforce-page-", ignore_cleanup_errors=True)
        folder = pathlib.Path(self._folder.name)
        self.downloads = folder / "downloads"
        self.downloads.mkdir()
        options = Options()
        options.binary_location = "/usr/bin/chromium"
        for each in (
            "--headless=new",
            "--no-sandbox",  # root has none, nor have many containers; only the page is opened
            "--use-angle=swiftshader",
            "--enable-unsafe-swiftshader",
            "--disable-background-networking",
            "--disable-component-update",
            "--disable-sync",
            "--disable-quic",
            "--disable-dev-shm-usage",
            "--no-first-run",
            f"--lang={language}",
            f"--user-data-dir={folder / 'profile'}",
            *arguments,
        ):
            options.add_argument(each)
        options.add_experimental_option(
            "prefs",
            {
                "download.default_directory": str(self.downloads),
                "download.prompt_for_download": False,
                "intl.accept_languages": language,
            },
        )
        options.set_capability("goog:loggingPrefs", {"performance": "ALL", "browser": "ALL"})
        self.driver = webdriver.Chrome(service=Service("/usr/bin/chromedriver"), options=options)
        self.driver.set_script_timeout(PATIENCE_S)
        self.told = []  # by the page's console, of errors
        self.resize(size, density)

    def close(self):
        self.driver.quit()
        self._folder.cleanup()

    def begin_anew(self):
        """As if just started, for a page from another address: each address has preferences of its own."""
        self.driver.get("about:blank")
        self.resize((WIDTH, HEIGHT))
        for each in self.downloads.iterdir():
            each.unlink()
        self._messages()
        self.errors()
        self.told = []

    # --- What is shown ---

    def resize(self, size, density=1.0):
        self.command(
            "Emulation.setDeviceMetricsOverride",
            width=size[0],
            height=size[1],
            deviceScaleFactor=density,
            mobile=False,
        )

    def command(self, name, **values):
        """Of the DevTools protocol."""
        return self.driver.execute_cdp_cmd(name, values)

    def emulate(self, **features):
        """What the person has set for all pages: prefers_reduced_motion="reduce"."""
        named = [{"name": name.replace("_", "-"), "value": value} for name, value in features.items()]
        self.command("Emulation.setEmulatedMedia", features=named)

    def run_before_page(self, script):
        """In every page opened from now on, before a script of its own."""
        self.command("Page.enable")
        self.command("Page.addScriptToEvaluateOnNewDocument", source=script)

    def open(self, address):
        """Opens the page and waits until it has drawn its first picture."""
        # A mere change of the fragment would not load it anew.
        self.driver.get("about:blank")
        self.driver.get(address)
        self.wait(lambda state: state["ready"], "the page's first picture")

    def reload(self):
        self.driver.refresh()
        self.wait(lambda state: state["ready"], "the page's first picture after it was loaded again")

    def picture(self):
        """What is on the screen, as it is seen."""
        return Image.open(io.BytesIO(self.driver.get_screenshot_as_png())).convert("RGB")

    def still_picture(self):
        """Once several in a row are the same: what has been decided may not be drawn yet."""
        same, picture = 0, self.picture()

        def found():
            nonlocal same, picture
            self.next_frame()
            before, picture = picture, self.picture()
            same = same + 1 if before.tobytes() == picture.tobytes() else 0
            return same >= 4

        wait_for(found, "a picture that stands still", self.told_state)
        return picture

    def script(self, text, *values):
        return self.driver.execute_script(text, *values)

    def body_text(self):
        return self.script("return document.body ? document.body.innerText : ''")

    # --- The state ---

    def state(self):
        """As the page exports it; None while there is none."""
        return self.script("return window.ghostforce ? window.ghostforce.state() : null")

    def told_state(self):
        with contextlib.suppress(WebDriverException):
            words = [f"state: {json.dumps(self.state())}", f"page: {self.body_text()!r}"]
            return "\n".join(words + self.errors())
        return "the page does not answer"

    def wait(self, holds, what):
        """Until holds(state); returns that state."""

        def found():
            try:
                state = self.state()
            except JavascriptException:  # not begun
                return None
            return state if state is not None and holds(state) else None

        return wait_for(found, what, self.told_state)

    def wait_until(self, **values):
        """Until the state has these values."""
        return self.wait(lambda state: all(state[k] == v for k, v in values.items()), f"the state to have {values}")

    def wait_for_rest(self, rest, tolerance_N=0.01):
        """Until the force is the one at rest, by the model."""
        return self.wait(
            lambda state: all(abs(is_ - should) < tolerance_N for is_, should in zip(state["force_N"], rest.force)),
            f"a force of {rest.force} N",
        )

    def on_screen(self, point_m):
        return self.script("return window.ghostforce.to_screen(arguments[0], arguments[1])", *point_m)

    def errors(self):
        """What the console has told of errors so far."""
        self.told += [each["message"] for each in self.driver.get_log("browser") if each["level"] == "SEVERE"]
        return self.told

    def requests(self):
        """Addresses that the page has asked a network for since the last call."""
        found = []
        for message in self._messages():
            if message["method"] == "Network.requestWillBeSent":
                found.append(message["params"]["request"]["url"])
            elif message["method"] in ("Network.webSocketCreated", "Network.webTransportCreated"):
                found.append(message["params"]["url"])
        # Chromium's own empty tab, and what the page holds in itself.
        return [each for each in found if not each.startswith(("chrome", "about:", "data:", "blob:"))]

    def _messages(self):
        """What the browser has told of itself since the last call."""
        return [json.loads(entry["message"])["message"] for entry in self.driver.get_log("performance")]

    # --- Hands ---

    def press(self, keys):
        """"F4", "Ctrl+S", "3": pressed and let go, as by a keyboard."""
        *modifiers, key = keys.split("+")
        chain = ActionChains(self.driver, duration=0)
        for each in modifiers:
            chain.key_down(MODIFIERS[each])
        chain.send_keys(NAMED_KEYS.get(key, key.lower()))
        for each in reversed(modifiers):
            chain.key_up(MODIFIERS[each])
        chain.perform()

    def type(self, text):
        ActionChains(self.driver, duration=0).send_keys(text).perform()

    def drag(self, begin, *way):
        """By the mouse, in CSS pixels; lets go at the end of the way. The page draws what each moment brings before the
        next one comes: on a busy machine a hand is not faster than the picture either."""
        self._mouse("mouseMoved", begin)
        self._mouse("mousePressed", begin, button="left", clickCount=1)
        for point in way:
            self._mouse("mouseMoved", point, button="left", buttons=1)
        self._mouse("mouseReleased", (way or (begin,))[-1], button="left", clickCount=1)

    def _mouse(self, kind, point, **more):
        self.command("Input.dispatchMouseEvent", type=kind, x=round(point[0]), y=round(point[1]), **more)
        self.next_frame()

    def click(self, point):
        self.drag(point)

    def touch(self, *moments):
        """Each moment is where the fingers are then, at the places 0, 1 …; None: this finger is in the air. Between two
        moments the page draws a frame."""
        down = set()
        for moment in [*moments, []]:
            points = [{"x": p[0], "y": p[1], "id": i} for i, p in enumerate(moment) if p is not None]
            now = {each["id"] for each in points}
            if now - down:
                kind = "touchStart"
            elif down - now:
                kind = "touchEnd"
            else:
                kind = "touchMove"
            self.command("Input.dispatchTouchEvent", type=kind, touchPoints=points)
            self.next_frame()
            down = now

    def next_frame(self):
        self.driver.execute_async_script(NEXT_FRAME)

    def use_action(self, words):
        """By its button in the list of all actions beside the picture."""
        script = """
          const rows = [...document.querySelectorAll('#control-actions button')];
          const found = rows.find((row) => row.textContent === arguments[0]);
          found?.click();
          return found !== undefined;
        """
        wait_for(lambda: self.script(script, words), f"the action {words}", self.told_state)

    # --- Files ---

    def expect_file_dialog(self, act):
        """That act() opens the browser's own dialog to choose a file, which nobody sees."""
        self.command("Page.enable")
        self.command("Page.setInterceptFileChooserDialog", enabled=True)
        act()
        wait_for(
            lambda: any(each["method"] == "Page.fileChooserOpened" for each in self._messages()),
            "the browser's dialog to choose a file",
            self.told_state,
        )
        self.command("Page.setInterceptFileChooserDialog", enabled=False)

    def choose_file(self, path):
        """In the browser's own dialog to open one."""
        chooser = wait_for(
            lambda: self.driver.find_elements("id", "file-chooser"), "the input to choose a file by", self.told_state
        )
        chooser[0].send_keys(str(path))

    def drop_file(self, path):
        """On the middle of the page, from another window."""
        data = {"items": [], "files": [str(path)], "dragOperationsMask": 1}
        for kind in ("dragEnter", "dragOver", "drop"):
            self.command("Input.dispatchDragEvent", type=kind, x=WIDTH / 2, y=HEIGHT / 2, data=data)

    def downloaded(self, ending, count=1):
        """The newest download of this ending, once it is whole and there are so many."""

        def found():
            whole = [each for each in self.downloads.iterdir() if each.suffix == ending]
            return len(whole) >= count and not list(self.downloads.glob("*.crdownload")) and whole

        whole = wait_for(found, f"a download *{ending}", lambda: f"{list(self.downloads.iterdir())}\n{self.told_state()}")
        return max(whole, key=lambda each: each.stat().st_mtime_ns)

    def set_clipboard(self, text):
        """Only pages that came by http may."""
        self.command("Browser.grantPermissions", permissions=["clipboardReadWrite", "clipboardSanitizedWrite"])
        answer = self.driver.execute_async_script(
            "const done = arguments[1]; navigator.clipboard.writeText(arguments[0]).then(() => done(''), e => done('' + e));",
            text,
        )
        assert answer == "", answer


class PageTest(unittest.TestCase):
    """A test with a browser, and with the page where its server or the disk has it. The tests of a class share one
    browser, which takes as long to start as many of them take."""

    is_main = False  # whether .ci/run runs them, which has a minute for all of these; .ci/long runs the others too
    allowed_errors = ()  # parts of what the console may tell
    shared = None

    def setUp(self):
        self.assertTrue(PAGE.is_file(), f"{PAGE} is not there; ./web builds it")
        self.server = PageServer(PAGE.parent)
        self.addCleanup(self.server.close)

    def start(self, **how):
        """A browser that is like no other test's, or that keeps something."""
        self.browser = Browser(**how)
        self.addCleanup(self.browser.close)
        return self.browser

    def open(self, query="", fragment="", **how):
        if how:
            browser = self.start(**how)
        else:
            suite = type(self)
            if suite.shared is None:
                suite.shared = Browser()
                suite.addClassCleanup(suite.shared.close)
            browser = self.browser = suite.shared
            browser.begin_anew()
        browser.open(self.address(query, fragment))
        return browser

    def address(self, query="", fragment=""):
        return self.server.address(PAGE.name) + query + fragment

    def tearDown(self):
        if (browser := getattr(self, "browser", None)) is None:
            return
        told = [each for each in browser.errors() if not any(part in each for part in self.allowed_errors)]
        self.assertEqual(told, [], "the console has told of errors")

    def assert_close(self, found, wanted, tolerance, message=""):
        for one, other in zip(found, wanted, strict=True):
            self.assertAlmostEqual(one, other, delta=tolerance, msg=f"{message} {found} {wanted}")

    def program(self, *arguments, **environment):
        """Runs the desktop program; returns what subprocess says of it. Without the program the test is skipped."""
        if not PROGRAM.is_file():
            self.skipTest(f"{PROGRAM} is not there, which the page is compared with; ./check web builds it")
        return subprocess.run(
            [PROGRAM, *arguments], env={**os.environ, **environment}, capture_output=True, text=True, check=False
        )
