# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Touches in a browser: the mouse and keys of a headless Chromium move the tip. Needs Debian's chromium and
chromium-driver, and trame and selenium from pip; otherwise the test is skipped."""

import asyncio
import os
import re
import shutil
import signal
import subprocess
import sys
import threading
import time

import pytest
import volumehaptics

web = pytest.importorskip("volumehaptics.web", reason="needs trame: pip install trame trame-vuetify trame-rca")
pytest.importorskip("selenium", reason="pip install selenium")
from selenium import webdriver  # noqa: E402
from selenium.common.exceptions import StaleElementReferenceException  # noqa: E402
from selenium.webdriver.common.action_chains import ActionChains  # noqa: E402
from selenium.webdriver.common.by import By  # noqa: E402
from selenium.webdriver.common.keys import Keys  # noqa: E402
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin  # noqa: E402
from selenium.webdriver.support.ui import WebDriverWait  # noqa: E402

CHROMIUM, DRIVER = shutil.which("chromium"), shutil.which("chromedriver")
pytestmark = pytest.mark.skipif(not (CHROMIUM and DRIVER), reason="needs chromium and chromium-driver")
SCENE = ".remote-controlled-area"
PATIENCE = 60.0  # s; no test depends on how long it takes


@pytest.fixture(scope="module")
def browser(tmp_path_factory):
    options = webdriver.ChromeOptions()
    options.binary_location = CHROMIUM
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=700,560",
                 f"--user-data-dir={tmp_path_factory.mktemp('chromium')}"):
        options.add_argument(word)
    driver = webdriver.Chrome(options=options, service=webdriver.ChromeService(executable_path=DRIVER))
    yield driver
    driver.quit()


class Page:
    """The actions of a person in the page, while the server runs in the same process."""

    def __init__(self, driver, haptics):
        self.driver = driver
        self.haptics = haptics

    async def wait(self, holds, what):
        end = time.monotonic() + PATIENCE
        while not holds():
            assert time.monotonic() < end, f"{what}; {self.haptics.device.GetStatusText()}"
            await asyncio.sleep(0.01)

    async def do(self, function, *arguments):
        return await asyncio.to_thread(function, *arguments)

    async def wait_for_page(self, holds, what):
        def holds_now():
            try:
                return holds()
            except StaleElementReferenceException:  # the page has replaced the element meanwhile
                return False

        end = time.monotonic() + PATIENCE
        while not await self.do(holds_now):
            assert time.monotonic() < end, what
            await asyncio.sleep(0.05)

    def find(self, word):
        return self.driver.find_element(By.CSS_SELECTOR, f"[data-id={word}]")

    async def click(self, word):
        await self.do(lambda: self.find(word).click())

    async def choose(self, word, choice):
        await self.click(word)

        def entry():
            found = [item for item in self.driver.find_elements(By.CSS_SELECTOR, ".v-list-item") if item.text == choice]
            return found[0] if found and found[0].is_displayed() else None

        def pick():
            item = entry()
            if item:
                item.click()
            return item

        await self.wait_for_page(entry, f"no {choice} to choose")
        await asyncio.sleep(0.4)  # the list opens with an animation and moves
        await self.wait_for_page(pick, f"{choice} is not to be chosen")

    async def move(self, right, down):
        """Moves the pointer to a place relative to the middle of the scene (pixels), without a button."""
        scene = self.driver.find_element(By.CSS_SELECTOR, SCENE)
        await self.do(ActionChains(self.driver, duration=50).move_to_element_with_offset(scene, right, down).perform)

    async def turn_wheel(self, steps):
        """Turns the wheel away from the user, into the screen."""
        scene = self.driver.find_element(By.CSS_SELECTOR, SCENE)
        for _ in range(steps):
            await self.do(ActionChains(self.driver, duration=0).scroll_from_origin(
                ScrollOrigin.from_element(scene), 0, -100).perform)
            await asyncio.sleep(0.25)  # faster steps would count as a gesture, with few events

    async def press(self, key):
        await self.do(ActionChains(self.driver, duration=0).send_keys(key).perform)

    def picture(self):
        """Returns the address of the last picture that the page has received."""
        return self.driver.execute_script(
            f"const p = document.querySelector('{SCENE} img'); return p && p.naturalWidth > 300 ? p.src : ''")

    def force(self):
        return sum(x * x for x in self.haptics.device.GetState().GetForce()) ** 0.5

    def is_armed(self):
        return "100 % of the force" in self.haptics.device.GetStatusText()


def run_in_page(driver, haptics, steps):
    """Runs the steps after the page has received a picture."""
    async def run():
        frame = await web.show(haptics)
        address = re.search(r'src="([^"]+)"', frame._repr_html_()).group(1)
        page = Page(driver, haptics)
        try:
            await page.do(driver.get, address)
            await page.wait_for_page(page.picture, "no picture")
            await steps(page)
        finally:
            await page.do(driver.get, "about:blank")
            frame.view.close()
            await frame.view.server.stop()

    asyncio.run(run())


def test_the_mouse_touches(window, hands, browser):
    haptics = hands().haptics

    async def steps(page):
        style, device = haptics.style, haptics.device
        await page.click("touch")
        await page.wait(style.GetTouchMode, "the button does not begin the touch")
        await page.wait(page.is_armed, "it does not arm")
        await page.wait_for_page(lambda: page.find("touch").text.upper() == "LET GO", "the button does not follow")
        await page.move(0, 0)
        await page.turn_wheel(5)
        await page.wait(lambda: device.GetState().GetContact() and page.force() > 0.01, "the wheel does not press")
        before, picture = device.GetState().GetProxyPosition(), await page.do(page.picture)
        await page.move(25, 0)
        await page.wait(lambda: sum(abs(a - b) for a, b in zip(device.GetState().GetProxyPosition(), before)) > 1.0,
                        "a motion without a button does not stroke")
        await page.wait_for_page(lambda: page.picture() not in ("", picture), "nothing is drawn anew")
        await page.wait_for_page(lambda: re.search(r"at [1-9]\d* Hz beside the server", page.find("status").text),
                                 "nobody tells of the servo")
        await page.wait_for_page(lambda: "ms away, for the eye alone" in page.find("status").text, "no round trip")
        await page.press(Keys.ESCAPE)
        await page.wait(lambda: not style.GetTouchMode() and page.force() == 0.0, "Escape does not let go")
        await page.wait_for_page(lambda: page.find("touch").text.upper() == "TOUCH", "the button does not follow a key")
        await page.press("t")
        await page.wait(style.GetTouchMode, "the key t does not touch")
        await page.wait(page.is_armed, "t does not arm")
        await page.choose("method", "force-field")
        await page.wait(lambda: haptics.filter.GetMethodName() == "force-field", "the method is another one")
        await page.choose("preset", "CT contrast")
        await page.wait(lambda: haptics.filter.GetProperty().GetStiffness().GetValue(900.0) != 500.0, "the preset is another one")
        # Closing a page must release the mouse button.
        await page.do(browser.get, "about:blank")
        await page.wait(lambda: not style.GetTouchMode() and page.force() == 0.0, "a closed page goes on pressing")

    run_in_page(browser, haptics, steps)


def test_a_hidden_page_lets_go(window, hands, browser):
    haptics = hands().haptics
    page_of_server = browser.current_window_handle

    async def steps(page):
        await page.click("touch")
        await page.wait(page.is_armed, "it does not arm")
        await page.do(browser.switch_to.new_window, "tab")
        try:
            await page.wait(lambda: not haptics.style.GetTouchMode() and page.force() == 0.0, "a hidden page goes on")
        finally:
            await page.do(browser.close)
            await page.do(browser.switch_to.window, page_of_server)
        await page.click("touch")
        await page.wait(page.is_armed, "it does not arm again")

    run_in_page(browser, haptics, steps)


def test_a_hidden_page_of_a_program_with_a_view_of_trame_lets_go(window, hands, browser):
    """The view stands for trame's VtkRemoteView, as in TestTrame.py; server, page and browser are real."""
    from trame.app import get_server
    from trame.ui.vuetify3 import VAppLayout
    from trame.widgets import html

    class View:
        def __init__(self, server, window):
            self.server, self.__view = server, window

        def update(self):
            pass

    plotter = hands().plotter
    plotter.show(auto_close=False)
    server = get_server("hides", client_type="vue3")
    haptics = volumehaptics.add_haptics(View(server, plotter.render_window))
    with VAppLayout(server):
        html.Div("a program", data_id="program", __properties=[("data_id", "data-id")])

    async def run():
        server.start(exec_mode="task", port=0, open_browser=False, show_connection_info=False, timeout=0)
        await server.ready
        page = Page(browser, haptics)
        page_of_server = browser.current_window_handle
        try:
            await page.do(browser.get, f"http://localhost:{server.port}/index.html")
            await page.wait_for_page(lambda: browser.find_elements(By.CSS_SELECTOR, "[data-id=program]"), "no page")
            haptics.widget.TouchModeOn()  # like a button of the program
            await page.wait(page.is_armed, "it does not arm")
            await page.do(browser.switch_to.new_window, "tab")
            await page.wait(lambda: not haptics.widget.GetTouchMode() and page.force() == 0.0, "a hidden page goes on")
            await page.do(browser.close)
            await page.do(browser.switch_to.window, page_of_server)
        finally:
            haptics.close()
            await page.do(browser.get, "about:blank")
            await server.stop()

    asyncio.run(run())


def test_a_page_that_does_not_answer_lets_go(window, hands, browser):
    haptics = hands().haptics

    async def steps(page):
        await page.click("touch")
        await page.wait(page.is_armed, "it does not arm")
        children = subprocess.run(["pgrep", "-P", str(browser.service.process.pid)], capture_output=True, text=True,
                                  check=True).stdout.split()
        group = [int(child) for child in children]
        for child in list(group):
            group += [int(pid) for pid in subprocess.run(
                ["pgrep", "-P", str(child)], capture_output=True, text=True, check=False).stdout.split()]
        for pid in group:
            os.kill(pid, signal.SIGSTOP)
        try:
            await page.wait(lambda: not haptics.style.GetTouchMode(), "a browser that stands still goes on pressing")
        finally:
            for pid in group:
                os.kill(pid, signal.SIGCONT)

    run_in_page(browser, haptics, steps)


def test_the_program_serves_the_demo(browser):
    server = subprocess.Popen([sys.executable, "-m", "volumehaptics", "--web", "--demo", "--no-browser"],
                              stdout=subprocess.PIPE, text=True)
    try:
        address = ""
        for line in server.stdout:
            if line.startswith("Touch it at "):
                address = line.split()[3]
                break
        browser.get(address)
        end = time.monotonic() + PATIENCE
        while not browser.execute_script(
                f"const p = document.querySelector('{SCENE} img'); return p && p.naturalWidth > 300"):
            assert time.monotonic() < end, "no picture"
            time.sleep(0.1)
        browser.get("about:blank")
        server.send_signal(signal.SIGINT)
        assert server.wait(PATIENCE) in (0, -signal.SIGINT)
    finally:
        server.kill()


PROGRAM = """
import pyvista as pv
import volumehaptics
from volumehaptics import examples

add = volumehaptics.add_haptics


def add_and_tell(*words):
    haptics = add(*words)
    haptics.style.AddObserver(haptics.style.ContactBeginEvent, lambda *_: print("felt", flush=True))
    return haptics


volumehaptics.add_haptics = add_and_tell
plotter = pv.Plotter(off_screen=True, window_size=(400, 300))
plotter.add_volume(pv.wrap(examples.phantom()), clim=(-600, 1000), opacity=[0, 0.35, 0.6, 1], show_scalar_bar=False)
plotter.view_vector((1, -0.8, 0.35), (0, 0, 1))
"""


def test_the_lines_on_programs_of_others_serve(browser, root):
    """Runs the lines on trame of hosts.md, pasted after a program's plotter: the volume in the browser is felt where it
    is seen."""
    page = (root / "Documentation" / "hosts.md").read_text(encoding="utf-8")
    lines = re.search(r"```python\n(.*?)```", page.split("\n## trame\n")[1], re.DOTALL)[1]
    server = subprocess.Popen([sys.executable, "-u", "-c", PROGRAM + lines], stdout=subprocess.PIPE, text=True,
                              env=os.environ | {"BROWSER": "true"})
    try:
        address = next(line.split()[3] for line in server.stdout if line.startswith("Touch it at "))
        browser.get(address)
        area = WebDriverWait(browser, PATIENCE).until(lambda _: browser.find_element(By.CSS_SELECTOR, f"{SCENE} img"))
        browser.find_element(By.CSS_SELECTOR, "[data-id=touch]").click()
        felt = threading.Event()
        threading.Thread(target=lambda: [felt.set() for line in server.stdout if line == "felt\n"], daemon=True).start()
        end = time.monotonic() + PATIENCE
        while not felt.wait(0.25):
            assert time.monotonic() < end, "nothing is felt"
            ActionChains(browser, duration=0).scroll_from_origin(ScrollOrigin.from_element(area), 0, -100).perform()
        browser.get("about:blank")
        server.send_signal(signal.SIGINT)
        assert server.wait(PATIENCE) in (0, -signal.SIGINT)
    finally:
        server.kill()


def run(*arguments):
    return subprocess.run([sys.executable, "-m", "volumehaptics", "--web", *arguments], capture_output=True, text=True,
                          check=False, timeout=120)


def test_bad_input_is_told_once(tmp_path):
    (tmp_path / "empty.nii").write_bytes(b"")
    for arguments, fault in (([], "give one volume, or --demo"), (["none.vti"], "none.vti: there is no such file"),
                             ([str(tmp_path / "empty.nii")], "empty.nii"), (["--demo", "--preset", "Cheese"], "Cheese")):
        result = run(*arguments)
        assert result.returncode == 2 and fault in result.stderr, result.stderr
        assert "Traceback" not in result.stderr


def test_without_trame_it_says_what_helps():
    code = "import sys; sys.modules['trame'] = None; from volumehaptics.__main__ import main; sys.exit(main(['--web']))"
    result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=False)
    assert result.returncode == 2 and "pip install pyvista trame trame-vuetify trame-rca" in result.stderr
    assert "Traceback" not in result.stderr


def test_the_notebook_backend_needs_a_notebook(window, hands):
    import pyvista as pv

    with pytest.raises(ValueError, match="add_haptics"):
        web.show_plotter(pv.Plotter(off_screen=True))
    plotter = hands().plotter
    with pytest.raises(RuntimeError, match="is for notebooks"):
        web.show_plotter(plotter)
    if hasattr(pv, "registered_jupyter_backends"):
        assert "haptics" in [backend.name for backend in pv.registered_jupyter_backends()]


def test_the_notebook_backend_shows_a_frame(window, hands):
    pytest.importorskip("nest_asyncio2", reason="pip install nest_asyncio2")
    hand = hands()

    async def cell():
        frame = web.show_plotter(hand.plotter)
        assert re.search(r'src="http://localhost:\d+/index.html', frame._repr_html_())
        frame.view.close()
        await frame.view.server.stop()

    asyncio.run(cell())
