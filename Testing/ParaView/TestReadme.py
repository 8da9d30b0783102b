# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The script in README.md, section "In ParaView", runs, and its hand feels something."""

import os
import re
import sys

PLUGIN, _, SOURCE, _ = sys.argv[1:5]
with open(os.path.join(SOURCE, "README.md"), encoding="utf-8") as file:
    section = file.read().split("\n## In ParaView\n")[1].split("\n## ")[0]
script = re.search("```python\n(.*?)```", section, re.S).group(1)
script, replaced = re.subn(r'"build/plugin/[^"]*VolumeHapticsPlugin\.so"', repr(PLUGIN), script)
assert replaced == 1, script

os.chdir(SOURCE)
names = {}
exec(compile(script, "README.md", "exec"), names)
assert names["touch"].PointData["Force"].GetRange(-1)[1] > 1.0
assert names["touch"].Preset == "Custom" and names["touch"].StiffnessScale == 800
