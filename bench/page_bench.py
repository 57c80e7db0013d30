#!/usr/bin/python3
"""How long the page takes, in Chromium, by the browser's own clock: script per frame while the hand is dragged round,
ticks a second where frames are few, and script until the first picture.

    bench/page_bench.py [--write bench/RESULTS.md]

The picture is drawn in software by another process of the browser. On a machine with few processors that process takes
time from the page. What the page's own thread costs is its processor time."""
import argparse
import datetime
import math
import os
import pathlib
import platform
import re
import statistics
import subprocess
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "tests/web"))
from browser import HEIGHT, PAGE, WIDTH, Browser, PageServer  # noqa: E402

TITLE = "The page"
STARTS = 7
FRAMES = 300  # that the page's own figures are about
SECONDS = 10.0

# As a slow browser would: frames only at multiples of this period.
FEW_FRAMES = """
const period_ms = 1000 / FRAMES_PER_SECOND;
window.requestAnimationFrame = callback => setTimeout(
  () => callback(performance.now()), period_ms - performance.now() % period_ms);
window.cancelAnimationFrame = clearTimeout;
"""


class Hand:
    """Goes round in the wall, a step at a time, by the mouse."""

    def __init__(self, browser):
        self.browser = browser
        self.angle = 0.0
        self._event("mousePressed")

    def _event(self, kind):
        x, y = self.browser.on_screen((0.014 + 0.006 * math.cos(self.angle), -0.014 + 0.006 * math.sin(self.angle)))
        self.browser.command("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left", buttons=1, clickCount=1)

    def step(self):
        self.angle += 0.1
        self._event("mouseMoved")

    def let_go(self):
        self._event("mouseReleased")


def round_for(browser, done):
    """Drags the hand round until done(state); returns that state. Seldom asked for: the page computes it."""
    hand = Hand(browser)
    while not done(state := browser.state()):
        for _ in range(20):
            hand.step()
    hand.let_go()
    return state


def script_of_frames(address, key=None):
    """Script of a frame and ticks in it, by the clock; processor time of all script, on average."""
    browser = Browser()

    def processor_s():
        metrics = browser.command("Performance.getMetrics")["metrics"]
        return next(each["value"] for each in metrics if each["name"] == "ScriptDuration")

    try:
        browser.open(address)
        if key:
            browser.press(key)
        browser.command("Performance.enable", timeDomain="threadTicks")
        first = browser.state()["frames"]
        begin = round_for(browser, lambda state: state["frames"] > first + 50)["frames"]
        before_s = processor_s()
        state = round_for(browser, lambda state: state["frames"] > begin + FRAMES)
        processor_ms = 1000.0 * (processor_s() - before_s) / (state["frames"] - begin)
        return state["script_ms"], state["servo_ms"], processor_ms
    finally:
        browser.close()


def ticks_per_second(address, frames_per_second=None, slower=None):
    """What was asked for, as seen: frames and ticks per second of the browser's clock."""
    browser = Browser()
    try:
        if frames_per_second:
            browser.run_before_page(FEW_FRAMES.replace("FRAMES_PER_SECOND", str(frames_per_second)))
        browser.open(address)
        if slower:
            browser.command("Emulation.setCPUThrottlingRate", rate=slower)
        look = "const s = window.ghostforce.state(); return [performance.now(), s.frames, s.tick]"
        begin = browser.script(look)
        ends = time.monotonic() + SECONDS
        round_for(browser, lambda _: time.monotonic() > ends)
        passed_ms, frames, ticks = (b - a for a, b in zip(begin, browser.script(look)))
        return 1000.0 * frames / passed_ms, 1000.0 * ticks / passed_ms
    finally:
        browser.close()


def ready_ms(address):
    found = []
    for _ in range(STARTS):
        browser = Browser()
        try:
            browser.open(address)
            found.append(browser.state()["ready_ms"])
        finally:
            browser.close()
    return found


def machine_and_day():
    processor = re.search(r"model name\s*: (.+)", pathlib.Path("/proc/cpuinfo").read_text()) or ["", platform.machine()]
    chromium = subprocess.run(["chromium", "--version"], capture_output=True, text=True, check=True).stdout.split()[1]
    return (
        f"{processor[1]}, {len(os.sched_getaffinity(0))} processors, Linux {platform.release()}, Chromium {chromium}, "
        f"{datetime.date.today()}"
    )


def with_section(text, section):
    """Instead of the section that is there, or as the last one."""
    there = re.compile(rf"^## {TITLE}\n.*?(?=^## |\Z)", re.MULTILINE | re.DOTALL)
    if there.search(text):
        return there.sub(lambda _: section + "\n", text).rstrip("\n") + "\n"
    return text.rstrip("\n") + "\n\n" + section


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--write", metavar="FILE", help="write the section there, too")
    file = parser.parse_args().write

    rows = []

    def row(what, measured, unit, limit=None, *, at_least=False):
        goal = met = ""
        if limit is not None:
            goal = f"{'≥' if at_least else '≤'} {limit:g} {unit}"
            met = "yes" if (measured >= limit if at_least else measured <= limit) else "no"
        rows.append(f"| {what} | {measured:.{0 if measured >= 100 else 2}f} {unit} | {goal} | {met} |")

    server = PageServer(PAGE.parent)
    address = server.address(PAGE.name)
    for face, key in (("stage", None), ("workbench", "F4")):
        script, servo, processor_ms = script_of_frames(address, key)
        row(f"{face}: script per frame", script["median"], "ms", 3.0)
        row(f"{face}: all script per frame, in processor time, mean", processor_ms, "ms")
        row(f"{face}: the same, 95th percentile", script["p95"], "ms")
        row(f"{face}: of it the servo's ticks", servo["median"], "ms")
    for frames in (60, 30, 10):
        seen, ticks = ticks_per_second(address, frames_per_second=frames)
        row(f"ticks at {seen:.1f} frames a second", ticks, "/s", 990.0, at_least=True)
    seen, ticks = ticks_per_second(address, slower=6)
    row(f"ticks with the page's thread slowed 6 times, at {seen:.1f} frames a second", ticks, "/s")
    starts = ready_ms(address)
    row(f"script and compiling until the first picture, median of {STARTS} starts", statistics.median(starts), "ms", 1000.0)
    row("the slowest of them", max(starts), "ms")
    server.close()

    section = "\n".join(
        [
            f"## {TITLE}",
            "",
            machine_and_day(),
            "",
            f"{PAGE.name}, {PAGE.stat().st_size / 1e6:.2f} MB, at {WIDTH}×{HEIGHT} in headless Chromium, which draws in "
            "software, while the mouse drags the hand round. On the page's one thread, by the browser's clock; "
            "in processor time where a row says so.",
            "",
            "| what | measured | goal | met |",
            "| --- | ---: | ---: | --- |",
            *rows,
            "",
        ]
    )
    print(section)
    if file:
        path = pathlib.Path(file)
        path.write_text(with_section(path.read_text(encoding="utf-8"), section), encoding="utf-8")


if __name__ == "__main__":
    main()
