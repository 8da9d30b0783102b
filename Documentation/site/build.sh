#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the documentation as a site that can be read without a network, and treats every warning as an error.
#
# usage: Documentation/site/build.sh [FOLDER]
#
# Installs what is missing: Doxygen from Debian, Sphinx into build/site-python, from the wheels in build/site-wheels. The
# first time these are fetched from PyPI; with them, it needs no network, also on another computer that they are copied
# to. The site's first page is FOLDER/index.html; FOLDER is build/site by default. Exits with 3 if there are no such
# wheels and pip reaches no registry.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
case ${1:-} in
  -h | --help) sed -n '5,12s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
site=$(realpath -m "${1:-$root/build/site}")
cd "$root"
# shellcheck source=../../CMake/install-packages.sh
source CMake/install-packages.sh
require_packages cmake doxygen python3 python3-venv

packages=(--require-hashes -r Documentation/site/requirements.txt)
python=build/site-python
wheels=build/site-wheels
if ! "$python/bin/python" -c 'import myst_parser, pydata_sphinx_theme, sphinx_gallery' 2> /dev/null; then
  rm -rf "$python"
  /usr/bin/python3 -m venv "$python"
  install=("$python/bin/pip" install -q --no-index --find-links "$wheels" "${packages[@]}")
  if ! "${install[@]}" 2> /dev/null &&
    ! { "$python/bin/pip" wheel -q -w "$wheels" "${packages[@]}" && "${install[@]}"; }; then
    rm -rf "$python"
    exit 3
  fi
fi

rm -rf "$site" build/pyvista-pages
mkdir -p "$site"
cmake -D page=build/settings.md -P CMake/Settings.cmake
warnings=$(mktemp)
trap 'rm -f "$warnings"' EXIT
"$python/bin/sphinx-build" -q -W --keep-going -c Documentation/site -d "$root/build/site-doctrees" . "$site"
(cat Documentation/site/Doxyfile; echo "OUTPUT_DIRECTORY = $site"; echo "WARN_LOGFILE = $warnings") | doxygen -
if [ -s "$warnings" ]; then
  cat "$warnings" >&2
  exit 1
fi
cat > "$site/index.html" << 'PAGE'
<!DOCTYPE html>
<meta http-equiv="refresh" content="0; url=Documentation/index.html">
<title>VTK Volume Haptics</title>
<a href="Documentation/index.html">VTK Volume Haptics</a>
PAGE
echo "The site: $site/index.html"
