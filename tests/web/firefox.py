"""Firefox with the page in it. Debian has no geckodriver; Firefox itself speaks Marionette, which geckodriver only
translates: messages of JSON, each behind its length, through a socket. A window under Xvfb, because Firefox without one
draws no WebGL in software."""
import contextlib
import json
import os
import pathlib
import socket
import subprocess
import tempfile

from browser import HEIGHT, NAMED_KEYS, NEXT_FRAME, WIDTH, wait_for
from display import display, end

PREFERENCES = """
user_pref("marionette.port", 0);
user_pref("app.normandy.enabled", false);
user_pref("app.update.enabled", false);
user_pref("browser.shell.checkDefaultBrowser", false);
user_pref("browser.startup.homepage_override.mstone", "ignore");
user_pref("datareporting.policy.dataSubmissionEnabled", false);
user_pref("extensions.update.enabled", false);
user_pref("intl.accept_languages", "en-US");
user_pref("network.captive-portal-service.enabled", false);
user_pref("network.connectivity-service.enabled", false);
user_pref("toolkit.telemetry.enabled", false);
user_pref("webgl.force-enabled", true);
"""


class Firefox:
    def __init__(self):
        self._ways_out = contextlib.ExitStack()
        try:
            self._start()
        except BaseException:
            self._ways_out.close()
            raise

    def _start(self):
        folder = tempfile.TemporaryDirectory(prefix="ghostforce-firefox-", ignore_cleanup_errors=True)
        self._ways_out.callback(folder.cleanup)
        profile = pathlib.Path(folder.name)
        (profile / "user.js").write_text(PREFERENCES, encoding="utf-8")
        self._log = profile / "log"
        with self._log.open("wb") as log:
            self._firefox = subprocess.Popen(
                ["firefox-esr", "--marionette", "--no-remote", "--profile", profile],
                env={**os.environ, "DISPLAY": self._ways_out.enter_context(display()), "LIBGL_ALWAYS_SOFTWARE": "1", "HOME": folder.name},
                stdout=log,
                stderr=log,
            )
        self._ways_out.callback(end, self._firefox)
        port_file = profile / "MarionetteActivePort"
        port = wait_for(lambda: port_file.exists() and port_file.read_text(), "Firefox to listen", self._log.read_text)
        self._socket = socket.create_connection(("127.0.0.1", int(port)), timeout=300)
        self._ways_out.callback(self._socket.close)
        self._answers = self._socket.makefile("rb")
        self._receive()  # says who it is
        self._sent = 0
        self.send("WebDriver:NewSession")
        # As large as the page is in the other tests, whatever the bars above take.
        across, down = self.script("return [outerWidth - innerWidth, outerHeight - innerHeight]")
        self.send("WebDriver:SetWindowRect", width=WIDTH + across, height=HEIGHT + down)

    def close(self):
        self._ways_out.close()

    # --- Marionette ---

    def _receive(self):
        length = b""
        while (byte := self._answers.read(1)) != b":":
            if not byte:
                raise AssertionError("Firefox has ended: " + self._log.read_text()[-2000:])
            length += byte
        return json.loads(self._answers.read(int(length)))

    def send(self, command, **values):
        self._sent += 1
        message = json.dumps([0, self._sent, command, values]).encode()
        self._socket.sendall(b"%d:%s" % (len(message), message))
        _, _, error, answer = self._receive()
        if error:
            raise AssertionError(f"{command}: {error['error']}: {error['message']}")
        return answer

    def script(self, text, *values):
        return self.send("WebDriver:ExecuteScript", script=text, args=values)["value"]

    # --- The page ---

    def open(self, address):
        self.send("WebDriver:Navigate", url="about:blank")
        self.send("WebDriver:Navigate", url=address)
        self.wait(lambda state: state["ready"], "the page's first picture")

    def state(self):
        return self.script("return window.ghostforce ? window.ghostforce.state() : null")

    def wait(self, holds, what):
        def found():
            state = self.state()
            return state if state is not None and holds(state) else None

        def told():
            return f"state: {self.state()}\npage: {self.script('return document.body.innerText')!r}"

        return wait_for(found, what, told)

    def wait_until(self, **values):
        return self.wait(lambda state: all(state[k] == v for k, v in values.items()), f"the state to have {values}")

    def on_screen(self, point_m):
        return self.script("return window.ghostforce.to_screen(arguments[0], arguments[1])", *point_m)

    def as_told(self, selector):
        """Role and name of an element, as a screen reader is told of it."""
        found = self.send("WebDriver:FindElement", using="css selector", value=selector)["value"]
        (element,) = found.values()
        role = self.send("WebDriver:GetComputedRole", id=element)["value"]
        return role, self.send("WebDriver:GetComputedLabel", id=element)["value"]

    def press(self, key):
        value = NAMED_KEYS.get(key, key)
        actions = [{"type": "keyDown", "value": value}, {"type": "keyUp", "value": value}]
        self.send("WebDriver:PerformActions", actions=[{"type": "key", "id": "keyboard", "actions": actions}])

    def drag(self, begin, *way):
        self._mouse(self._move(begin))
        self._mouse({"type": "pointerDown", "button": 0})
        for point in way:
            self._mouse(self._move(point))
        self._mouse({"type": "pointerUp", "button": 0})

    def _mouse(self, action):
        mouse = {"type": "pointer", "id": "mouse", "parameters": {"pointerType": "mouse"}, "actions": [action]}
        self.send("WebDriver:PerformActions", actions=[mouse])
        self.send("WebDriver:ExecuteAsyncScript", script=NEXT_FRAME, args=[])

    @staticmethod
    def _move(point):
        return {"type": "pointerMove", "x": round(point[0]), "y": round(point[1]), "duration": 0}
