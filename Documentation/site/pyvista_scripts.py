# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""The scripts of Examples/PyVista as Sphinx-Gallery reads them: with a title and a picture, which are not in them."""

import re

TITLES = {"numpy_gyroid": "A gyroid of NumPy", "qt_window": "A Qt window"}
HEADER = """PyVista scripts
===============

Each script runs by itself, on the package's own head phantom; some also take a volume of yours. They share
:download:`gallery.py`. :doc:`How to run them </Examples/PyVista/README>`.
"""


def find_picture(root, name):
    """The picture of a script: beside it, or among those of the documentation."""
    beside = f"Examples/PyVista/{name}.png"
    return beside if (root / beside).exists() else f"Documentation/pictures/pyvista/{name}.jpg"


def write_script(root, script, folder):
    text = script.read_text(encoding="utf-8")
    docstring = re.search(r'^"""(.+?)"""\n', text, re.M | re.S)
    title = TITLES.get(script.stem, script.stem.replace("_", " ").capitalize())
    picture = find_picture(root, script.stem)
    if not (root / picture).exists():
        raise FileNotFoundError(f"{script} has no picture {picture}: add one, 720 pixels wide, or its page is empty.")
    page = "\n".join((
        '"""', title, "=" * len(title), "", docstring[1], "", f".. image:: /{picture}", f"   :alt: {title}", '"""',
        f'# sphinx_gallery_thumbnail_path = "{picture}"', ""))
    (folder / script.name).write_text(text[:docstring.start()] + page + text[docstring.end():], encoding="utf-8")


def write_scripts(root, folder):
    """Writes all of them to a folder; returns the settings of Sphinx-Gallery. The site's build runs no script."""
    folder.mkdir(parents=True, exist_ok=True)
    for old in folder.iterdir():
        old.unlink()
    (folder / "GALLERY_HEADER.rst").write_text(HEADER, encoding="utf-8")
    for script in sorted((root / "Examples" / "PyVista").glob("*.py")):
        if script.stem == "gallery":
            (folder / script.name).write_bytes(script.read_bytes())
        else:
            write_script(root, script, folder)
    return {
        "examples_dirs": [str(folder)],
        "gallery_dirs": ["build/pyvista-pages"],
        "ignore_pattern": r"^gallery\.py$",
        "copyfile_regex": r"gallery\.py",
        "within_subsection_order": "FileNameSortKey",
        "remove_config_comments": True,
        "plot_gallery": False,
        "download_all_examples": False,
        "write_computation_times": False,
        "show_signature": False,
    }
