# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes a wheel `vtk-sdk` if the registry has none: python3 assemble_vtk_sdk.py VERSION FOLDER

The wheel has the same parts as VTK's own `vtk-sdk`: headers, the CMake package, the wrapping tools and the module
hierarchy. They come from a newer Debian's VTK of the same VERSION, downloaded with apt-get into FOLDER and nowhere
else. Programs link to the libraries in the wheel `vtk` of the same version, by name. The script runs on x86-64
Debian 12, with the Python that the wheel is for, and its result works on that machine only.

If Debian's VTK was configured differently from the wheel, the headers are corrected: no TBB, VTK's own jsoncpp, lz4,
hdf5 and tiff. Exits with 3 if that is not possible, for example if Debian no longer has VERSION.
"""
import pathlib
import re
import shutil
import stat
import subprocess
import sys
import zipfile

ARCHITECTURE = "x86_64-linux-gnu"
SUITES = ("forky", "sid", "trixie")
# Packages whose headers match the libraries in VTK 9.6. VTK adds a prefix to the namespace of jsoncpp and to the
# functions of lz4, hdf5 and tiff. The third text is the library that Debian's VTK links instead.
JSONCPP = ("libjsoncpp-dev", "1.9.6", "JsonCpp::JsonCpp")
LZ4 = ("liblz4-dev", "1.10.0", "LZ4::LZ4")
HDF5 = ("libhdf5-dev", "1.14.5", "hdf5::hdf5;hdf5::hdf5_hl;VTK::mpi")  # the wheel may contain a later 1.14
# the wheel may contain 4.6, which has the same functions that are used here
TIFF = ("libtiff-dev", "4.7.0", "TIFF::TIFF")
BUNDLED = {"jsoncpp": JSONCPP, "lz4": LZ4, "hdf5": HDF5, "tiff": TIFF}
TOOLS = ("vtkWrapHierarchy", "vtkWrapPython", "vtkWrapPythonInit")

APT_OPTIONS = """\
Dir::Etc::sourcelist "{apt}/sources.list";
Dir::Etc::sourceparts "-";
Dir::State::lists "{apt}/lists";
Dir::Cache "{apt}/cache";
APT::Sandbox::User "root";
"""

# Packages that Debian's VTK configuration looks up on the system, although the wheel contains their libraries.
FIND_PACKAGES = """\
find_package(Threads REQUIRED)
if (NOT TARGET Python3::Module)
  find_package(Python3 REQUIRED COMPONENTS Interpreter Development.Module)
endif ()
foreach (external IN ITEMS {externals})
  if (NOT TARGET "${{external}}")
    add_library("${{external}}" INTERFACE IMPORTED)
  endif ()
endforeach ()
"""

# These tools need a newer C library than that of Debian 12, so a copy of that library and its loader is stored beside
# them.
TOOL = """\
#!/bin/sh
here=$(dirname "$(readlink -f "$0")")
exec "$here/newer/ld-linux-x86-64.so.2" --library-path "$here/newer" "$here/newer/{tool}" "$@"
"""

METADATA = """\
Metadata-Version: 2.1
Name: vtk-sdk
Version: {version}
Summary: What VTK {version}'s own vtk-sdk has, assembled from Debian's packages for this machine
Requires-Dist: vtk=={version}
"""


class NotToBeHad(Exception):
    """Raised with the reason why no SDK can be assembled."""


def run(*command, **options):
    ended = subprocess.run(command, check=False, stdout=subprocess.PIPE, text=True, **options)
    if ended.returncode != 0:
        raise NotToBeHad(f"this failed: {' '.join(command)}")
    return ended.stdout


class Debian:
    """Gets packages of newer suites, beside the system's own and from the same servers."""

    def __init__(self, folder):
        self.folder = folder
        apt = folder / "apt"
        for name in ("lists/partial", "cache/archives/partial"):
            (apt / name).mkdir(parents=True, exist_ok=True)
        only = ("Label: Debian", "Identifier: Packages")
        known = run("apt-get", "indextargets", "--format", "$(REPO_URI)", *only).split()
        if not known:
            raise NotToBeHad("apt-get knows no mirror of Debian")
        key = "/usr/share/keyrings/debian-archive-keyring.gpg"
        (apt / "sources.list").write_text("".join(
            f"deb [signed-by={key}] {known[0]} {suite} main\n" for suite in SUITES))
        (apt / "apt.conf").write_text(APT_OPTIONS.format(apt=apt))
        self.options = ("-c", str(apt / "apt.conf"))
        run("apt-get", *self.options, "-qq", "update")

    def find(self, package, version):
        """Returns the package's full version, or None."""
        for line in run("apt-cache", *self.options, "madison", package).splitlines():
            found = line.split("|")[1].strip()
            if re.split(r"[+-]", found)[0] == version:
                return found
        return None

    def unpack(self, package, version, into):
        """Unpacks a version of a package; None means the newest."""
        archive = f"{package}={version}" if version else package
        run("apt-get", *self.options, "-qq", "download", archive, cwd=self.folder)
        archive = next(self.folder.glob(f"{package}_*.deb"))
        run("dpkg-deb", "-x", str(archive), str(into))
        archive.unlink()


def replace(path, *pairs):
    """Replaces texts in a file; each of the pairs (pattern, replacement) has to occur."""
    text = path.read_text()
    for pattern, replacement in pairs:
        text, count = re.subn(pattern, replacement, text, flags=re.MULTILINE)
        if count == 0:
            raise NotToBeHad(f"{path.name} is not what was expected: it lacks {pattern}")
    path.write_text(text)


def name_as_vtk(header, library, prefix):
    """Adds macros at the beginning of a header, which give a library's functions the names that they have in the
    wheel."""
    names = re.findall(rf"\b{prefix}(\w+)(?:@+\S+)?$", run("nm", "-D", "--defined-only", str(library)), flags=re.MULTILINE)
    # Leave out names that end in _async: the headers define macros of these names themselves.
    macros = "".join(f"#define {name} {prefix}{name}\n" for name in names if not name.endswith("_async"))
    header.write_text(macros + header.read_text())


def place_headers(include, headers, libraries):
    """Places the headers of lz4, hdf5 and tiff, which lie below `headers`, beside VTK's own."""
    for name in ("lz4", "hdf5", "tiff"):
        replace(include / f"vtk_{name}.h", (rf"^(#define VTK_MODULE_USE_EXTERNAL_vtk{name}) 1", r"\1 0"))
    lz4 = include / "vtklz4" / "lib" / "lz4.h"
    lz4.parent.mkdir(parents=True)
    shutil.copy(headers / "usr/include/lz4.h", lz4)
    name_as_vtk(lz4, libraries / "libvtklz4.so", "vtklz4_")

    tiff = include / "vtktiff" / "libtiff"
    tiff.mkdir(parents=True)
    for header in (headers / "usr/include" / ARCHITECTURE).glob("tiff*.h"):
        shutil.copy(header, tiff)
    name_as_vtk(tiff / "tiffio.h", libraries / "libvtktiff.so", "vtktiff_")

    library = libraries / "libvtkhdf5.so"
    version = re.search(rb"HDF5 library version: (\d+\.\d+)\.(\d+)", library.read_bytes())
    if version is None or version.group(1).decode() != HDF5[1].rpartition(".")[0]:
        raise NotToBeHad("the HDF5 in VTK's wheel is not of the version of the headers")
    for folder in ("src", "hl/src"):
        places = include / "vtkhdf5" / folder
        shutil.copytree(headers / "usr/include/hdf5/serial", places)
        replace(places / "H5public.h", (r"^(#define H5_VERS_RELEASE +)\d+", rf"\g<1>{version.group(2).decode()}"))
        name_as_vtk(places / "hdf5.h", library, "vtkhdf5_")


def correct_headers(include, json):
    replace(include / "vtkSMP.h",
            (r"^#define VTK_SMP_TBB$", "#define VTK_SMP_Sequential"),
            (r'VTK_SMP_BACKEND "TBB"', 'VTK_SMP_BACKEND "Sequential"'),
            (r"(VTK_SMP_(ENABLE|DEFAULT_IMPLEMENTATION)_TBB) 1", r"\1 0"),
            (r"(VTK_SMP_DEFAULT_IMPLEMENTATION_SEQUENTIAL) 0", r"\1 1"))
    for name in ("vtk_jsoncpp.h", "vtk_jsoncpp_fwd.h"):
        replace(include / name,
                (r"^(#define VTK_MODULE_USE_EXTERNAL_vtkjsoncpp) 1", r"\1 0\n#define Json vtkJson"))
    shutil.copytree(json, include / "vtkjsoncpp" / "json")
    shutil.copy(json / "forwards.h", include / "vtkjsoncpp" / "json" / "json-forwards.h")


def place_targets(cmake, version, libraries):
    """Makes the targets of the wheel's libraries and of the tools. Returns their names."""
    short = ".".join(version.split(".")[:2])
    wheel = "${_IMPORT_PREFIX}/../../vtkmodules"
    python = f"{sys.version_info.major}.{sys.version_info.minor}"
    places = cmake / "VTK-targets-none.cmake"
    first, *blocks = re.split(r"^# Import target ", places.read_text(), flags=re.MULTILINE)
    kept = {}
    for block in blocks:
        library = re.search(rf"/lib(\w+?)(?:3\.\d+)?-{short}\.so\.{short}\"", block)
        name = library.group(1) if library else ""
        name += python if name == "vtkWrappingPythonCore" else ""
        if name in libraries:
            block = re.sub(r'"\$\{_IMPORT_PREFIX\}/lib/[^"]*"', f'"{wheel}/lib{name}.so"', block)
            block = re.sub(r'(IMPORTED_SONAME_NONE) "[^"]*"', rf'\1 "lib{name}.so"', block)
        elif re.search(rf"/bin/({'|'.join(TOOLS)})-", block):
            block = block.replace(f'-{short}"', '"')
        else:
            continue
        kept[block.split('"')[1]] = block
    for bundled in BUNDLED:
        kept[f"VTK::{bundled}"] = f'''"VTK::{bundled}"
set_property(TARGET VTK::{bundled} APPEND PROPERTY IMPORTED_CONFIGURATIONS NONE)
set_target_properties(VTK::{bundled} PROPERTIES
  IMPORTED_LOCATION_NONE "{wheel}/libvtk{bundled}.so" IMPORTED_SONAME_NONE "libvtk{bundled}.so")

'''
    last = "\n# Commands beyond this point"
    end = blocks[-1].partition(last)
    places.write_text("# Import target ".join([first, *(block.partition(last)[0] for block in kept.values())])
                      + end[1] + end[2])
    return set(kept)


def correct_targets(cmake, version, libraries):
    """Removes targets that the wheel lacks; of the system's libraries, only threads and Python remain."""
    kept = place_targets(cmake, version, libraries)
    declared = cmake / "VTK-targets.cmake"
    for bundled, (_, _, linked) in BUNDLED.items():
        replace(declared,
                (rf"add_library\(VTK::{bundled} INTERFACE IMPORTED\)", f"add_library(VTK::{bundled} SHARED IMPORTED)"),
                (f'"{linked}"', '""'))
    first, *blocks = re.split(r"^# Create imported target ", declared.read_text(), flags=re.MULTILINE)
    lacking = {name for name, block in ((block.split()[0], block) for block in blocks[:-1])
               if name not in kept and "INTERFACE IMPORTED)" not in block}
    blocks = [block for block in blocks if block.split()[0] not in lacking]
    expected = re.compile(rf" ({'|'.join(sorted(lacking))})(?=[ )])")
    declared.write_text("# Create imported target ".join([expected.sub("", first), *blocks]))
    for properties in cmake.glob("*-properties.cmake"):
        lines = properties.read_text().splitlines(keepends=True)
        properties.write_text("".join(
            line for line in lines if not any(f'(TARGET "{name}"' in line for name in lacking)))

    externals = set(re.findall(r"\b(?!VTK::)[A-Za-z]\w*::\w+", declared.read_text()))
    (cmake / "VTK-vtk-module-find-packages.cmake").write_text(
        FIND_PACKAGES.format(externals=" ".join(sorted(externals - {"Threads::Threads", "Python3::Module"}))))
    backports = r'^include\("\$\{CMAKE_CURRENT_LIST_DIR\}/vtkCMakeBackports\.cmake"\)$'
    packages = 'include("${CMAKE_CURRENT_LIST_DIR}/VTK-vtk-module-find-packages.cmake")'
    replace(cmake / "vtk-config.cmake",
            (r'(_HAS_(?:VISKORES|VTKm)" )"ON"', r'\1"OFF"'), (backports, packages + r"\n\g<0>"))
    # The wheel's Python modules are only imported, never linked, and the wheel contains no interpreter, so these
    # targets are empty.
    (cmake / "VTKPython-targets.cmake").write_text("")
    (cmake / "VTKPython-targets-none.cmake").unlink()


def write_tools(usr, content, version):
    short = ".".join(version.split(".")[:2])
    newer = content / "bin" / "newer"
    newer.mkdir(parents=True)
    libraries = usr / "lib" / ARCHITECTURE
    for name in ("ld-linux-x86-64.so.2", "libc.so.6", f"libvtkWrappingTools-{short}.so.1"):
        shutil.copy(libraries / name, newer / name)
    for tool in TOOLS:
        shutil.copy(usr / "bin" / f"{tool}-{short}", newer / tool)
        script = content / "bin" / tool
        script.write_text(TOOL.format(tool=tool))
        script.chmod(0o755)


def pack(tree, version, folder):
    """Packs the tree as a wheel; the tool that repacks the wheel writes the list of its files."""
    tag = f"cp{sys.version_info.major}{sys.version_info.minor}"
    info = tree / f"vtk_sdk-{version}.dist-info"
    info.mkdir()
    (info / "METADATA").write_text(METADATA.format(version=version))
    (info / "WHEEL").write_text(
        f"Wheel-Version: 1.0\nGenerator: assemble_vtk_sdk\nRoot-Is-Purelib: false\nTag: {tag}-{tag}-linux_x86_64\n")
    (info / "entry_points.txt").write_text("[cmake.prefix]\nany = vtk_sdk.content\n")
    files = sorted(path for path in tree.rglob("*") if path.is_file())
    record = info / "RECORD"
    record.write_text("".join(f"{path.relative_to(tree)},,\n" for path in [*files, record]))
    wheel = folder / f"vtk_sdk-{version}-{tag}-{tag}-linux_x86_64.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path in [*files, record]:
            entry = zipfile.ZipInfo(str(path.relative_to(tree)))
            entry.external_attr = (stat.S_IFREG | stat.S_IMODE(path.stat().st_mode)) << 16
            archive.writestr(entry, path.read_bytes(), zipfile.ZIP_DEFLATED, 1)
    return wheel


def main(version, folder):
    folder = pathlib.Path(folder).absolute()
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    debian = Debian(folder)
    found = debian.find("libvtk9-dev", version)
    headers = {package: debian.find(package, number) for package, number, _ in BUNDLED.values()}
    if found is None or None in headers.values():
        raise NotToBeHad(f"Debian ({', '.join(SUITES)}) has no VTK {version}, or not the headers of its libraries")
    usr = folder / "debian" / "usr"
    for package in ("libvtk9-dev", "vtk9", "python3-vtk9", f"libvtk{'.'.join(version.split('.')[:2])}"):
        debian.unpack(package, found, usr.parent)
    debian.unpack("libc6", None, usr.parent)
    for package, number in headers.items():
        debian.unpack(package, number, folder / "headers")

    run(sys.executable, "-m", "pip", "download", "-q", "--no-deps", "-d", str(folder), f"vtk=={version}")
    vtk = next(folder.glob("vtk-*.whl"))
    with zipfile.ZipFile(vtk) as archive:
        libraries = set(re.findall(r"vtkmodules/lib([\w.]+)\.so\b", "\n".join(archive.namelist())))
        for name in ("lz4", "hdf5", "tiff"):
            archive.extract(f"vtkmodules/libvtk{name}.so", folder / "headers")

    short = f"vtk-{'.'.join(version.split('.')[:2])}"
    content = folder / "tree" / "vtk_sdk" / "content"
    for part in (f"include/{short}", f"lib/{ARCHITECTURE}/cmake/{short}", f"lib/{ARCHITECTURE}/{short}/hierarchy"):
        shutil.copytree(usr / part, content / part)
    correct_headers(content / "include" / short, folder / "headers/usr/include/jsoncpp/json")
    place_headers(content / "include" / short, folder / "headers", folder / "headers" / "vtkmodules")
    correct_targets(content / "lib" / ARCHITECTURE / "cmake" / short, version, libraries)
    write_tools(usr, content, version)
    (content.parent / "__init__.py").touch()
    (content / "__init__.py").touch()
    wheel = pack(folder / "tree", version, folder)
    for rest in ("apt", "debian", "headers", "tree"):
        shutil.rmtree(folder / rest)
    print(wheel)


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    try:
        main(*sys.argv[1:])
    except NotToBeHad as why:
        print(f"no vtk-sdk could be assembled: {why}", file=sys.stderr)
        sys.exit(3)
