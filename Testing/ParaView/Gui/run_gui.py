# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs paraview with the dock window: run_gui.py PARAVIEW PLUGIN VOLUME OUTPUT_FOLDER.

Gui.xml presses the buttons and moves the mouse, session.py checks in ParaView's own Python, step by step, and writes
steps.txt. Needs a display. Exits with 77 if paraview can't open a window.
"""

import os
import shutil
import signal
import subprocess
import sys
import tempfile

PARAVIEW, PLUGIN, VOLUME, OUTPUT = map(os.path.abspath, sys.argv[1:5])
HERE = os.path.dirname(os.path.abspath(__file__))
STEPS = ["setup", "attached", "chosen", "saved", "loaded", "picture_of_dock", "shown_as_ct", "focused", "touch_mode", "contact",
         "at_rest", "picture", "recorded", "opened_while_touched", "escaped", "detached", "keys", "armed_elsewhere",
         "taken_over", "armed", "other_style", "close_view", "view_closed", "delete_device",
         "device_deleted", "cures", "second_hand", "words", "proposed",
         "on_a_server", "armed_at_exit"]
LIMIT = 600  # s; beyond that it hangs: a run takes a minute, or four beside six times the machine's load


def skip(why):
    print("Skipped: " + why)
    sys.exit(77)


def replay(trace):
    """Runs the Python trace of Attach and Touch in a ParaView of its own: the pipeline is the same, and no hand holds a
    device there."""
    script = os.path.join(OUTPUT, "replay.py")
    with open(trace, encoding="utf-8") as file, open(script, "w", encoding="utf-8") as out:
        out.write(f"from paraview import simple\nsimple.LoadPlugin({PLUGIN!r}, remote=False, ns=vars(simple))\n{file.read()}\n"
                  "device = [proxy for proxy in simple.GetSources().values() if proxy.GetXMLName() == 'HapticDevice'][0]\n"
                  "assert device.Touch.Input.GetXMLName() == 'XMLImageDataReader' and not device.Running and not device.Armed\n")
    subprocess.run([os.path.join(os.path.dirname(PARAVIEW), "pvpython"), script], check=True, timeout=LIMIT)


def main():
    if not os.environ.get("DISPLAY"):
        skip("there is no display for paraview to open a window on. Run ctest under xvfb-run.")
    shutil.rmtree(OUTPUT, ignore_errors=True)
    os.makedirs(OUTPUT)
    # Neither read nor write the settings of this computer's user.
    with tempfile.TemporaryDirectory() as home:
        environment = dict(os.environ, HOME=home, XDG_CONFIG_HOME=home, XDG_RUNTIME_DIR=home, QT_QPA_PLATFORM="xcb",
                           GUI_SESSION=os.path.join(HERE, "session.py"), GUI_VOLUME=VOLUME,
                           GUI_OUTPUT=OUTPUT, GUI_SERVER=os.path.join(os.path.dirname(PARAVIEW), "pvserver"))
        command = [PARAVIEW, "-qwindowgeometry", "1280x800+0+0", "--dr", "--plugin-search-paths", os.path.dirname(PLUGIN),
                   "--plugins", os.path.splitext(os.path.basename(PLUGIN))[0], "--test-directory=" + OUTPUT,
                   "--test-script=" + os.path.join(HERE, "Gui.xml"), "--exit"]
        log_name = os.path.join(OUTPUT, "paraview.log")
        with open(log_name, "wb") as log:
            process = subprocess.Popen(command, env=environment, stdout=log, stderr=subprocess.STDOUT, start_new_session=True)
            try:
                code = process.wait(timeout=LIMIT)
            except subprocess.TimeoutExpired:
                os.killpg(process.pid, signal.SIGKILL)
                process.wait()
                code = "none, within %d s" % LIMIT
    with open(log_name, encoding="utf-8", errors="replace") as file:
        log = file.read()
    if "could not connect to display" in log or "no Qt platform plugin could be initialized" in log:
        skip("paraview's Qt can't start here:\n" + log)
    steps_name = os.path.join(OUTPUT, "steps.txt")
    steps = open(steps_name, encoding="utf-8").read() if os.path.exists(steps_name) else ""
    print(log, steps, sep="\n")
    done = [line.split()[1] for line in steps.splitlines() if line.startswith("passed ")]
    assert "failed " not in steps, "a step has failed: see above"
    assert done == STEPS, f"only these steps were taken: {done}"
    assert code == 0, f"paraview's exit code is {code}"
    replay(os.path.join(OUTPUT, "trace.py"))


main()
