#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Checks that what the documents name exists: links, headings, files, folders, members and tests.

usage: documents.py [REPOSITORY]
"""

import pathlib
import re
import sys

ROOT = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
ROOMS = "Module|Plugin|Examples|Testing|Data|CMake|Documentation|Core|Devices|VTK|[.]ci|[.]github"
# Folders whose files are searched for the names of documents and tests.
SOURCES = ("Module", "Plugin", "Examples", "Testing", "Data", "CMake")
README_LINES = 100


def documents():
    yield from sorted(ROOT.glob("*.md"))
    for folder in ("Documentation", "Examples", "Data", "Testing"):
        yield from sorted((ROOT / folder).rglob("*.md"))


def anchors(text):
    """Returns the anchors of a document's headings, as GitHub makes them."""
    headings = re.findall(r"^#+ (.+)$", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S), re.M)
    return {re.sub(r"[^\w\- ]", "", heading.lower()).strip().replace(" ", "-") for heading in headings}


def check_links(document, text):
    for link in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"\w+:", link):
            continue
        name, _, anchor = link.partition("#")
        target = (document.parent / name).resolve() if name else document
        if not target.exists():
            yield f"links to {name}, which does not exist"
        elif anchor and anchor not in anchors(target.read_text(encoding="utf-8")):
            yield f"links to {link}, which has no such heading"


def check_paths(text):
    for path in re.findall(rf"`[.]?/?((?:{ROOMS})/[\w./*+-]+)`", text):
        if "NAME" in path:
            continue
        folder = ROOT / "Module" if re.match("(Core|Devices|VTK)/", path) else ROOT
        if not any(folder.glob(path.rstrip("/"))):
            yield f"names {path}, which does not exist"


def check_tests(text, tests):
    for suite, case in re.findall(r"`([A-Z]\w+)[.]([A-Z][\w.]+)`", text):
        if case.endswith("SUITE.CASE"):
            continue
        if suite == "VolumeHaptics":
            pattern = re.escape(f"{suite}.{case}")
        else:
            pattern = rf"TEST(?:_F|_P)?\(\s*{suite},\s*{case}\s*\)"
        if not re.search(pattern, tests):
            yield f"names the test {suite}.{case}, which does not exist"
    for name in re.findall(r"`(test_\w+)`", text):
        if not re.search(rf"def {name}\(", tests):
            yield f"names the test {name}, which does not exist"


def check_members(text, sources):
    for owner, member in re.findall(r"`(\w+)::(\w+)", text):
        if owner not in ("VTK", "VolumeHaptics") and not re.search(rf"\b{member}\b", sources):
            yield f"names {owner}::{member}, which does not exist"


def check_mentions(path, text):
    for name in re.findall(r"\bDocumentation/[\w/-]+[.]md\b", text):
        if not (ROOT / name).exists():
            yield f"{path}: names {name}, which does not exist"


def check_class_index():
    """Checks that the index of classes lists every public class."""
    page = "Documentation/first-touch.md"
    index = (ROOT / page).read_text(encoding="utf-8")
    for header in sorted((ROOT / "Module" / "VTK").rglob("vtk*.h")):
        if f"class VTKVOLUMEHAPTICS_EXPORT {header.stem}" in header.read_text(encoding="utf-8"):
            if f"`{header.stem}`" not in index:
                yield f"{page}: lists no {header.stem}"


def main():
    wrong = [*check_class_index()]
    sources, tests = [], []
    for path in (path for folder in SOURCES for path in sorted((ROOT / folder).rglob("*"))):
        if path.suffix in (".h", ".cxx", ".txt", ".cmake", ".py", ".sh"):
            text = path.read_text(encoding="utf-8", errors="replace")
            wrong += check_mentions(path.relative_to(ROOT), text)
            if path.suffix in (".cxx", ".h", ".txt") or path.name.startswith("Test") and path.suffix == ".py":
                (tests if path.relative_to(ROOT).parts[0] == "Testing" else sources).append(text)
    sources, tests = "\n".join(sources), "\n".join(tests)
    found = 0
    for document in documents():
        found += 1
        text = document.read_text(encoding="utf-8")
        errors = [*check_links(document, text), *check_paths(text), *check_tests(text, tests)]
        if not re.search("^# .+$", text, re.M):
            errors.append("has no title")
        errors += check_members(text, sources)
        wrong += [f"{document.relative_to(ROOT)}: {error}" for error in errors]
    lines = len((ROOT / "README.md").read_text(encoding="utf-8").splitlines())
    if lines > README_LINES:
        wrong.append(f"README.md: has {lines} lines; more than {README_LINES} belong in Documentation")
    print("\n".join(wrong) if wrong else f"{found} documents name nothing that is not there")
    return 1 if wrong or found < 8 else 0


sys.exit(main())
