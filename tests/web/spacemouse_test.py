"""A SpaceMouse by the browser's WebHID. No machine of a test has one, nor can a headless browser ask: a stand-in for
navigator.hid tells the page what a browser with a device would."""
import unittest

from browser import PageTest

# `permitted`: whether the person has let the page use it; `answers`: whether they choose it when asked.
STAND_IN = """
class Device extends EventTarget {
  vendorId = 0x256F;
  productId = 0xC635;
  productName = "SpaceMouse Compact";
  opened = false;
  collections = [{ usagePage: 1, usage: 8 }];
  async open() {
    if (test.is_busy) throw new DOMException("Failed to open the device.", "NotAllowedError");
    this.opened = true;
  }
  async close() { this.opened = false; }
}
const hid = new EventTarget();
const device = new Device();
const test = window.test = {
  device, asked: [], is_plugged_in: true, is_permitted: false, is_chosen: true, is_busy: false,
  report(number, values) {
    const event = new Event("inputreport");
    event.device = device;
    event.reportId = number;
    event.data = new DataView(new Int16Array(values).buffer);
    device.dispatchEvent(event);
  },
  plug(is_plugged_in) {
    test.is_plugged_in = is_plugged_in;
    if (!is_plugged_in) device.opened = false;
    const event = new Event(is_plugged_in ? "connect" : "disconnect");
    event.device = device;
    hid.dispatchEvent(event);
  },
};
hid.getDevices = async () => test.is_plugged_in && test.is_permitted ? [device] : [];
hid.requestDevice = async (options) => {
  if (!navigator.userActivation.isActive) throw new DOMException("Must be handling a user gesture.", "SecurityError");
  test.asked.push(options);
  if (!test.is_plugged_in || !test.is_chosen) return [];
  test.is_permitted = true;
  return [device];
};
Object.defineProperty(navigator, "hid", { value: hid });
"""

# On the workbench at 1280×800: the choice of inputs and its rows, and the button that asks.
INPUT_CHOICE = (1140, 637)
SPACEMOUSE_ROW = (1046, 519)
ASK_BUTTON = (950, 668)

FULL = 350
REACH_M = 0.060


class SpaceMouse(PageTest):
    def open_with(self, **how):
        """With the input chosen, on the workbench."""
        browser = self.start()
        browser.run_before_page("{" + STAND_IN + "".join(f"test.{k} = {str(v).lower()};" for k, v in how.items()) + "}")
        browser.open(self.address())
        browser.press("F4")
        browser.wait_until(face="workbench")
        browser.next_frame()
        browser.click(INPUT_CHOICE)
        browser.next_frame()
        browser.click(SPACEMOUSE_ROW)
        browser.wait_until(input="spacemouse")
        return browser

    def wait_for_opened(self, browser, is_opened=True):
        browser.wait(lambda _: browser.script("return test.device.opened") == is_opened, f"the device open: {is_opened}")

    def deflect(self, browser, *axes):
        browser.script("test.report(1, arguments[0])", list(axes))

    def wait_for_goal(self, browser, goal):
        return browser.wait(
            lambda state: max(abs(a - b) for a, b in zip(state["goal_m"], goal)) < 1e-5, f"the goal at {goal}"
        )

    def asked(self, browser):
        return browser.script("return test.asked.length")

    def test_moves_the_goal(self):
        browser = self.open_with()
        self.wait_for_opened(browser)
        asked = browser.script("return test.asked")
        self.assertEqual(
            asked, [{"filters": [{"vendorId": each, "usagePage": 1, "usage": 8} for each in (0x046D, 0x256F)]}]
        )
        x, y = browser.state()["goal_m"]
        self.deflect(browser, FULL, 0, 0, 0, 0, 0)
        self.wait_for_goal(browser, (x + REACH_M, y))
        self.deflect(browser, 0, 0, -FULL, 0, 0, 0)
        self.wait_for_goal(browser, (x, y + REACH_M))
        self.deflect(browser, 0, 0, 0)
        self.wait_for_goal(browser, (x, y))

    def test_that_is_permitted_is_opened_without_asking_and_kept_by_another_scene(self):
        browser = self.open_with(is_permitted=True)
        self.wait_for_opened(browser)
        browser.script("location.hash = '#fig1'")
        x, y = browser.wait(lambda state: "fig1" in state["set_up"], "the other scene")["goal_m"]
        self.wait_for_opened(browser)
        self.assertEqual(self.asked(browser), 0)
        self.deflect(browser, -FULL, 0, 0, 0, 0, 0)
        self.wait_for_goal(browser, (x - REACH_M, y))

    def test_that_is_unplugged_leaves_the_goal_until_it_is_back(self):
        browser = self.open_with()
        self.wait_for_opened(browser)
        x, y = browser.state()["goal_m"]
        self.deflect(browser, FULL, 0, 0, 0, 0, 0)
        self.wait_for_goal(browser, (x + REACH_M, y))
        browser.script("test.plug(false)")
        tick = browser.state()["tick"]
        browser.wait(lambda state: state["tick"] > tick + 200, "ticks without the device")
        self.wait_for_goal(browser, (x + REACH_M, y))
        browser.script("test.plug(true)")
        self.wait_for_opened(browser)
        self.deflect(browser, -FULL, 0, 0, 0, 0, 0)
        self.wait_for_goal(browser, (x, y))
        self.assertEqual(self.asked(browser), 1)

    def test_that_was_not_chosen_is_asked_for_by_the_button(self):
        browser = self.open_with(is_chosen=False)
        browser.wait(lambda _: self.asked(browser) == 1, "the browser to be asked")
        self.assertFalse(browser.script("return test.device.opened"))
        browser.script("test.is_chosen = true")
        browser.next_frame()
        browser.click(ASK_BUTTON)
        self.wait_for_opened(browser)
        self.assertEqual(self.asked(browser), 2)

    def test_that_another_program_has_opens_by_the_button_later(self):
        browser = self.open_with(is_permitted=True, is_busy=True)
        browser.wait(lambda _: self.asked(browser) == 1, "the browser to be asked for another one")
        browser.script("test.is_busy = false")
        browser.next_frame()
        browser.click(ASK_BUTTON)
        self.wait_for_opened(browser)

    def test_is_let_go_with_another_input(self):
        browser = self.open_with()
        self.wait_for_opened(browser)
        browser.click(INPUT_CHOICE)
        browser.press("Home")
        browser.press("Enter")
        browser.wait_until(input="mouse")
        self.wait_for_opened(browser, False)


if __name__ == "__main__":
    unittest.main()
