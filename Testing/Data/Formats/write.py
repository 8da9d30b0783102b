# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the input of each case, or of the named cases, into a folder for each, and the expected content into
cases.json: write.py FOLDER [NAME...], with * for any letters."""

import json
import sys
from fnmatch import fnmatch
from pathlib import Path

import write_brain  # noqa: F401 the writers register their cases
import write_codecs  # noqa: F401
import write_dicom  # noqa: F401
import write_images  # noqa: F401
import write_nifti  # noqa: F401
import write_odd  # noqa: F401
import write_threads  # noqa: F401
from cases import CASES

folder = Path(sys.argv[1]).resolve()
written = []
for one in [case for case in CASES if not sys.argv[2:] or any(fnmatch(case.name, name) for name in sys.argv[2:])]:
    place = folder / one.name
    place.mkdir(parents=True)
    named = one.write(place)
    written.append({**{key: value for key, value in vars(one).items() if key != "write"}, "path": str(named)})
(folder / "cases.json").write_text(json.dumps(written, indent=1))
print(len(written), "inputs")
