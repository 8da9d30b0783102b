#!/usr/bin/env python3
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Lists the texts that people read, for those who read them with fresh eyes, and finds phrases that software doesn't say.

usage: strings.py [--check] [DOOR...]

DOOR      explorer, scene, paraview, python or device (default: all)
--check   prints only the texts with a phrase of PHRASES; exit status 1 if there is one

A line is "file:line: text"; an ellipsis stands for a value.
"""

import ast
import pathlib
import re
import sys
import xml.etree.ElementTree as xml

ROOT = pathlib.Path(__file__).resolve().parents[2]
DOORS = {
    "explorer": ("Module/Applications/Explorer", "Module/VTK/Reading"),
    "scene": ("Module/VTK/Scene", ),
    "paraview": ("Plugin", ),
    "python": ("Module/Python", ),
    "device": ("Module/Applications/DeviceTool", "Module/Devices", "Module/VTK/Device"),
}
# Phrases that are literal translations, and their idiomatic replacements.
PHRASES = {
    r"\b(is|are) looked for\b": "looking for ...",
    r"\bto and fro\b": "back and forth",
    r"\bPushed by\b": "Force of",
    r"\b(Drills|Plays|Records|Writes), ": "Drilling, ...",
    r"\bno more can be\b": "... is full",
    r"\bwork of last time\b": "unsaved work",
    r"\b(is|are) done again\b": "redone",
    r"\bon by [\d.]+ s\b": "forward 0.1 s",
    r"\b(These|Those) settings are\b": "... is kept",
    r"\bsee the messages\b": "where the reason is",
    r"\bas \S+ says\b(?! to)": "from ...",
    r"\bsaved to [^:]*: …$": "5 measurements saved to ...",
}
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"(\w*)\((.*?)\)\1"|"((?:\\.|[^"\\\n])*)"|\'(?:\\.|[^\'\\])+\'|#[^\n]*|[;{},?]|\S', re.S)


def is_read(text):
    """Returns whether a text is a sentence or a phrase, and not a name, path, format or code."""
    return bool(re.search(r"[A-Za-z]{2,}[,:;.)]? +[(\"']?[A-Za-z…\d]", text)) and "#include" not in text


def texts_of_cxx(source):
    """Yields the joined literals of each argument or statement, with the number of their line."""
    parts, line = [], 0
    for token in TOKEN.finditer(source):
        word = token.group(0)
        literal = token.group(2) if token.group(2) is not None else token.group(3)
        if literal is not None:
            line = line if parts else source.count("\n", 0, token.start()) + 1
            parts.append(literal.replace('\\"', '"').replace("\\n", " "))
        elif word in (";", "{", "}", ",", "?"):
            if parts:
                yield line, "".join(parts)
            parts = []
        elif not word.startswith(("//", "/*", "#")) and parts and parts[-1] != "…":
            parts.append("…")


def texts_of_xml(source):
    for number, line in enumerate(source.splitlines(), 1):
        for text in re.findall(r'(?:label|short_help|long_help|text|name)="([^"]+)"', line):
            yield number, text
    for element in xml.fromstring(source).iter():
        if element.tag == "Documentation" and element.text:
            yield 1, " ".join(element.text.split())


def texts_of_python(source):
    tree = ast.parse(source)
    help_texts = {id(node.body[0].value) for node in ast.walk(tree)
                  if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef))
                  and node.body and isinstance(node.body[0], ast.Expr)}
    parts = {id(part) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield node.lineno, "".join(part.value if isinstance(part, ast.Constant) else "…" for part in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in help_texts | parts:
            yield node.lineno, node.value


READERS = {".cxx": texts_of_cxx, ".h": texts_of_cxx, ".xml": texts_of_xml, ".py": texts_of_python}


def texts(door):
    for folder in DOORS[door]:
        for file in sorted((ROOT / folder).rglob("*")):
            if file.suffix in READERS:
                for line, text in READERS[file.suffix](file.read_text(encoding="utf-8")):
                    if is_read(text):
                        yield f"{file.relative_to(ROOT)}:{line}", " ".join(text.split())


def main():
    words = sys.argv[1:]
    check = "--check" in words
    doors = [word for word in words if word != "--check"] or list(DOORS)
    unknown = set(doors) - set(DOORS)
    if unknown:
        sys.exit(f"{', '.join(sorted(unknown))}: take one of {', '.join(DOORS)}")
    found = 0
    for door in doors:
        for place, text in texts(door):
            faults = [f"{phrase}: {cure}" for phrase, cure in PHRASES.items() if re.search(phrase, text)]
            found += bool(faults)
            if faults or not check:
                print(f"{place}: {text}", *[f"\n    say rather: {fault}" for fault in faults if check], sep="")
    sys.exit(1 if check and found else 0)


if __name__ == "__main__":
    main()
