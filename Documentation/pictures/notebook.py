#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Takes notebook.png, the page of `python -m volumehaptics --web --demo` while its mouse touches, in headless Chromium.

usage: notebook.py [FOLDER]

Writes to FOLDER, by default the folder of this script. Needs the package, PyVista, trame, trame-vuetify, trame-rca and
selenium, Debian's chromium and chromium-driver, and a display, such as that of xvfb-run -a.
"""

import pathlib
import re
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from selenium import webdriver
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.actions.wheel_input import ScrollOrigin
from selenium.webdriver.common.by import By

SCENE = ".remote-controlled-area"
PATIENCE = 120.0  # s


def wait(holds, what):
    end = time.monotonic() + PATIENCE
    while not holds():
        if time.monotonic() > end:
            raise SystemExit(f"There is no {what} after {PATIENCE:.0f} s.")
        time.sleep(0.1)


def open_browser(profile):
    options = webdriver.ChromeOptions()
    options.binary_location = shutil.which("chromium")
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage", "--window-size=1000,780",
                 f"--user-data-dir={profile}"):
        options.add_argument(word)
    return webdriver.Chrome(options=options, service=webdriver.ChromeService(executable_path=shutil.which("chromedriver")))


def touch(browser, file):
    """Presses with the wheel, strokes without a button, and takes the picture of a hand that rests."""
    def scene():
        return browser.find_element(By.CSS_SELECTOR, SCENE)

    def has_picture():
        return browser.execute_script(f"const p = document.querySelector('{SCENE} img'); return p && p.naturalWidth > 300")

    def move(right, down, milliseconds):
        ActionChains(browser, duration=milliseconds).move_to_element_with_offset(scene(), right, down).perform()

    wait(has_picture, "picture")
    time.sleep(3.0)
    move(10, -60, 100)
    browser.find_element(By.CSS_SELECTOR, "[data-id=touch]").click()
    time.sleep(2.0)
    move(10, -60, 100)
    for _ in range(5):
        ActionChains(browser, duration=0).scroll_from_origin(ScrollOrigin.from_element(scene(), 10, -60), 0, -100).perform()
        time.sleep(0.3)
    for step in range(1, 13):
        move(10 + 2.5 * step, -60, 50)
        time.sleep(0.1)
    time.sleep(2.0)
    if not re.search(r"Hz beside the server", browser.find_element(By.CSS_SELECTOR, "[data-id=status]").text):
        raise SystemExit("The servo does not run.")
    browser.save_screenshot(str(file))


def main():
    folder = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).resolve().parent
    server = subprocess.Popen([sys.executable, "-m", "volumehaptics", "--web", "--demo", "--no-browser", "--port", "0"],
                              stdout=subprocess.PIPE, text=True)
    with tempfile.TemporaryDirectory() as profile:
        browser = open_browser(profile)
        try:
            browser.get(next(line.split()[3] for line in server.stdout if line.startswith("Touch it at ")))
            touch(browser, folder / "notebook.png")
        finally:
            browser.quit()
            server.send_signal(signal.SIGINT)
            server.wait(60)


if __name__ == "__main__":
    main()
