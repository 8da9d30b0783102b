# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python blocks of the documents as printed, and checks that the programs named in shell commands have the
options used there.

Other tests run the remaining blocks: TestExamples.py and TestLarge.py run python.md and measuring.md;
Testing/PyVista/TestSnippets.py runs the blocks on PyVista and notebooks; Testing/Hosts runs hosts.md; TestReadme.py
and TestServer.py of Testing/ParaView run the blocks on ParaView; Testing/Package/snippets.py compiles the C++
blocks, and TestWindowPage.py runs some of them; Testing/Package/install.sh builds the CMake block.
"""

import re
import subprocess

import numpy as np
import pytest
import volumehaptics
from conftest import ROOT
from volumehaptics import arrays, examples

DOCUMENTS = [ROOT / "README.md", *sorted((ROOT / "Documentation").rglob("*.md"))]
PAGES = [*DOCUMENTS, ROOT / "CONTRIBUTING.md", ROOT / "Data" / "README.md", ROOT / "Examples" / "PyVista" / "README.md"]
# Files whose Python blocks a test runs, and their number of blocks.
RUN = {
    "README.md": 1, "first-touch.md": 1, "devices.md": 1, "hosts.md": 11, "materials.md": 8, "measuring.md": 1, "notebook.md": 1,
    "paraview.md": 6, "python.md": 9, "window.md": 1,
}


def blocks(path, language):
    return re.findall(rf"```{language}\n(.*?)```", path.read_text(encoding="utf-8"), re.DOTALL)


@pytest.mark.parametrize("path", DOCUMENTS, ids=lambda path: path.name)
def test_every_block_of_python_is_run_by_a_test(path):
    assert len(blocks(path, "python")) == RUN.get(path.name, 0), "add the block to a test, and its number to RUN"


PROGRAMS = re.compile(r"(?:sudo |\w+=\S+ )*(?:[.]/|[.] |\S+[.]sh\b|apt|cd |cmake|ctest|docker|git|pip|pv|python|\S*/python|"
                      r"volumehaptics-|xvfb-run|mpiexec)")


@pytest.mark.parametrize("path", PAGES, ids=lambda path: path.name)
def test_commands_are_in_blocks_that_say_so(path):
    """A block without a language is a formula or a program's output, and is not checked."""
    found = re.findall(r"^```(\S*)\n(.*?)^```$", path.read_text(encoding="utf-8"), re.DOTALL | re.MULTILINE)
    for language, text in found:
        if not language:
            assert not PROGRAMS.match(text.strip()), f"this block needs the language sh: {text}"


def test_the_cmake_of_documents_is_that_of_a_test():
    pages = [path for path in PAGES for _ in blocks(path, "cmake")]
    assert [path.name for path in pages] == ["window.md"], "let Testing/Package/install.sh configure it"


def test_readme(capsys):
    (code,) = blocks(ROOT / "README.md", "python")
    exec(compile(code, "README.md", "exec"), {})
    newtons = float(re.fullmatch(r"(\d+\.\d+) N\n", capsys.readouterr().out)[1])
    assert 0.1 < newtons < 5.0


def write_labels(folder):
    """Writes the input of the page on materials: a segmentation as 3D Slicer writes it, and a table."""
    labels = np.zeros((16, 16, 16), np.uint8)
    labels[4:12, 4:12, 4:12] = 5
    header = ("NRRD0005\ntype: uint8\ndimension: 3\nsizes: 16 16 16\nencoding: raw\nspace: left-posterior-superior\n"
              "space directions: (1,0,0) (0,1,0) (0,0,1)\nspace origin: (0,0,0)\n"
              "Segment0_LabelValue:=5\nSegment0_Name:=liver\nSegment0_Layer:=0\nSegment0_Color:=0.8 0.2 0.2\n\n")
    (folder / "Liver.seg.nrrd").write_bytes(header.encode() + labels.tobytes())
    (folder / "materials.csv").write_text("label,stiffness\n5,450\n", encoding="utf-8")


def test_materials(tmp_path, monkeypatch):
    """Each block uses the variables of the blocks before it."""
    write_labels(tmp_path)
    monkeypatch.chdir(tmp_path)
    head = examples.phantom()
    haptics = volumehaptics.vtkVolumeHapticsFilter()
    haptics.SetInputData(head)
    segmentation = np.zeros(head.GetDimensions()[::-1], np.uint8)
    names = {
        **vars(volumehaptics), "volumehaptics": volumehaptics, "haptics": haptics, "image": head,
        "tip": np.linspace((0, -120, 60), (0, -75, 60), 400),
        "segmentation": volumehaptics.image(segmentation, spacing=head.GetSpacing(), origin=head.GetOrigin()),
    }
    codes = blocks(ROOT / "Documentation" / "materials.md", "python")
    for code in codes:
        exec(compile(code, "materials.md", "exec"), names)
    table = names["table"]
    assert table.GetForbidden(52)
    assert table.GetStandOff() == 2.0 and table.GetLabelName(5) == "liver" and table.GetStiffness(5) == 450.0
    names["reader"].Update()
    assert haptics.GetLabelTable().GetLabelName(5) == "liver"
    strength = names["feel"].GetSurfaceStrength()
    assert strength.GetValue(60.0) == 2.5 and strength.GetValue(-100.0) == 1.0
    assert np.linalg.norm(arrays.arrays(names["trace"])["Force"], axis=1).max() > 0.1


def test_who_could_tell(document, capsys):
    section = document("python.md").split("\n## Who could tell materials apart\n")[1].split("\n## ")[0]
    (code,) = re.findall(r"```python\n(.*?)```", section, re.DOTALL)
    names = {}
    exec(compile(code, "python.md", "exec"), names)
    assert names["found"].confusion.shape == (2, 2) and capsys.readouterr().out


def commands():
    """Yields the calls of this project's programs in the documents' shell blocks, with the document's name."""
    for path in DOCUMENTS:
        for block in blocks(path, "sh"):
            for line in block.replace("\\\n", " ").splitlines():
                call = line.split("#")[0].strip()
                if call:
                    yield path.name, call


def test_commands_have_the_options_that_documents_give_them():
    sources = {
        "volumehaptics-explore": ROOT / "Module/Applications/Explorer",
        "volumehaptics-device": ROOT / "Module/Applications/DeviceTool",
    }
    texts = {
        name: "\n".join(file.read_text(encoding="utf-8") for file in folder.rglob("*.cxx"))
        for name, folder in sources.items()
    }
    checked = 0
    for document, call in commands():
        words = call.split()
        program = words[0].rsplit("/", 1)[-1]
        if program in texts:
            wanted = [word for word in words[1:] if word.startswith("--")]
            if program == "volumehaptics-device":
                wanted.append(words[1])
            for word in wanted:
                assert f'"{word}"' in texts[program] or f"{word} " in texts[program], f"{document}: {call}: {word}"
                checked += 1
        elif words[0].endswith(".sh"):
            script = ROOT / words[0]
            assert script.is_file(), f"{document}: {call}"
            subprocess.run(["bash", "-n", str(script)], check=True)
            text = script.read_text(encoding="utf-8")
            if script.name == "explore.sh":  # explore.sh passes its options on to the explorer
                text += texts["volumehaptics-explore"]
            for word in words[1:]:
                if word.startswith("--"):
                    assert word in text, f"{document}: {call}: {word}"
            checked += 1
        elif words[0].startswith("python") and words[1].endswith(".py"):
            assert (ROOT / words[1]).is_file(), f"{document}: {call}"
            checked += 1
    assert checked > 10
