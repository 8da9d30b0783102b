# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Sphinx's settings for the site, which `Documentation/site/build.sh` builds.

The pages are the Markdown files of the repository as they are (MyST), so that the same links work on both.
The repository's root is the source folder. The C++ reference is Doxygen's, linked, not Breathe's: Doxygen expands
VTK's macros by itself, and its pages are complete.
"""

import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).parent))

from pyvista_scripts import write_scripts  # noqa: E402

root = pathlib.Path(__file__).parents[2]

project = "VTK Volume Haptics"
author = "VTK Volume Haptics contributors"
copyright = author
version = release = re.search(
    r"project\(VolumeHaptics\s+VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text(encoding="utf-8")
)[1]

extensions = ["myst_parser", "sphinx_gallery.gen_gallery"]
templates_path = ["templates"]
root_doc = "Documentation/index"
include_patterns = ["*.md", "Documentation/*.md", "Documentation/devices/*.md", "Examples/**.md", "Data/README.md", "build/pyvista-pages/*.rst", "build/settings.md"]
# Writes build/pyvista-pages from the scripts.
sphinx_gallery_conf = write_scripts(root, root / "build" / "pyvista-scripts")

# Generate the anchors of headings as GitHub does, because the documents link to them.
myst_heading_anchors = 4
# Program output and equations in blocks are not highlighted unless the block names a language.
highlight_language = "none"

html_theme = "pydata_sphinx_theme"
html_title = f"{project} {version}"
html_theme_options = {
    "show_prev_next": False,
    "secondary_sidebar_items": ["page-toc"],
    "navbar_end": ["api-link", "theme-switcher"],  # Doxygen's pages
    "footer_start": ["copyright"],
    "footer_end": [],
}
html_sidebars = {"**": []}
html_show_sourcelink = False
