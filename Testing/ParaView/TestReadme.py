# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts in Documentation/paraview.md run one after the other, and their hands feel a force."""

import os
import re
import sys
import tempfile

PLUGIN, _, SOURCE, _ = sys.argv[1:5]
DOCUMENT = os.path.join(SOURCE, "Documentation", "paraview.md")
with open(DOCUMENT, encoding="utf-8") as file:
    text = file.read()
scripts = [script for script in re.findall("```python\n(.*?)```", text, re.S) if "Connect(" not in script]
(large,) = [script for script in scripts if "HapticLargeFile(" in script]
scripts.remove(large)
assert len(scripts) == 4
scripts[0], replaced = re.subn(r'"build/plugin/[^"]*VolumeHapticsPlugin\.so"', repr(PLUGIN), scripts[0])
assert replaced == 1, scripts[0]

os.chdir(SOURCE)
names = {"__name__": "__main__"}
felt = []
names["print"] = lambda *words: felt.append(words[0])
for script in scripts:
    exec(compile(script, DOCUMENT, "exec"), names)
touch, device, link = names["touch"], names["device"], names["link"]
assert touch.PointData["Force"].GetRange(-1)[1] > 1.0
assert touch.Preset == "Custom" and touch.StiffnessScale == 800
assert max(sum(f * f for f in force) ** 0.5 for force in felt[1:]) > 0.5, felt
held = names["follow"].PointData["Force"].GetRange(-1)[1]
assert 0.3 < held <= 0.8 + 1e-9, held
assert link.Attached == 1
link.Attached = 0

# Write an array in Zarr version 2 in place of the user's file.
with tempfile.TemporaryDirectory(suffix=".zarr") as folder:
    with open(os.path.join(folder, ".zarray"), "w", encoding="utf-8") as file:
        file.write('{"zarr_format": 2, "shape": [16, 16, 16], "chunks": [16, 16, 16], "dtype": "<i2", "compressor": null, '
                   '"fill_value": 0, "order": "C", "filters": null}')
    with open(os.path.join(folder, "0.0.0"), "wb") as file:
        file.write(bytes(2 * 16**3))
    assert "Bone.vtkhdf" in large
    exec(compile(large.replace("Bone.vtkhdf", folder), DOCUMENT, "exec"), names)
    names["bone"].UpdatePipeline()
    assert names["bone"].GetDataInformation().GetNumberOfPoints() > 0
