#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Installs a build tree into a new prefix, builds Examples/Cxx against it as other projects do, and runs the README's
# examples from there.
# usage: install.sh SOURCE_DIR BUILD_DIR WRAPPED_FOR_PYTHON
set -euo pipefail

source_dir=$1
build_dir=$2
python=$3
work=$build_dir/Testing/Package/install
prefix=$work/prefix
head=$source_dir/Data/HeadPhantom.vti

rm -rf "$work"
mkdir -p "$work"
cmake --install "$build_dir" --prefix "$prefix" >"$work/install.log"
config=$(find "$prefix" -name VolumeHapticsConfig.cmake)
sanitize=$(sed -n 's/^VolumeHaptics_SANITIZE:STRING=//p' "$build_dir/CMakeCache.txt")
cmake -S "$source_dir/Examples/Cxx" -B "$work/examples" -G Ninja \
  -DVolumeHaptics_DIR="$(dirname "$config")" \
  ${sanitize:+-DCMAKE_CXX_FLAGS="-fsanitize=$sanitize"} >"$work/configure.log"
cmake --build "$work/examples" >"$work/build.log"
# Build a viewer with the CMakeLists.txt in Documentation/window.md.
mkdir "$work/viewer"
# shellcheck disable=SC2016 # fences of Markdown
sed -n '/^```cmake$/,/^```$/{/^```/d;p}' "$source_dir/Documentation/window.md" > "$work/viewer/CMakeLists.txt"
cp "$source_dir/Examples/Cxx/DropIn.cxx" "$work/viewer/viewer.cxx"
cmake -S "$work/viewer" -B "$work/viewer/build" -G Ninja -DCMAKE_PREFIX_PATH="$prefix" \
  ${sanitize:+-DCMAKE_CXX_FLAGS="-fsanitize=$sanitize"} >"$work/configure-viewer.log"
cmake --build "$work/viewer/build" >"$work/build-viewer.log"
[[ -x $work/viewer/build/viewer ]] || { echo "the viewer of window.md was not built" >&2; exit 1; }
from_cxx=$("$work/examples/first-touch" "$head")
echo "C++:    $from_cxx"
case $from_cxx in
  0\ N | '') echo "first-touch felt nothing" >&2; exit 1 ;;
esac

from_own=$("$work/examples/own-device")
echo "$from_own"
case $from_own in
  *"Running: own:0"*) ;;
  *) echo "own-device did not run" >&2; exit 1 ;;
esac
"$prefix/bin/volumehaptics-device" list
# Install the example plug-in in a folder that no other user can write to.
vendor=$work/plugins
mkdir -p "$vendor"
cp "$work/examples/libvolumehaptics-example.so" "$vendor"
chmod go-w "$vendor" "$vendor"/*
if from_plugin=$(VOLUMEHAPTICS_VENDOR_PATH=$vendor "$prefix/bin/volumehaptics-device" list) &&
  [[ $from_plugin == *vendor:example:0* ]]; then
  VOLUMEHAPTICS_VENDOR_PATH=$vendor "$prefix/bin/volumehaptics-device" monitor vendor:example --seconds 0.3
else
  # If the folders above the build tree belong to other users, the tool must report it.
  echo "$from_plugin"
  [[ $from_plugin == *"others may write"* || $from_plugin == *"belongs to another user"* ]] ||
    { echo "the plug-in of the examples is not listed" >&2; exit 1; }
fi
# The guard must print its purpose, and that users must not start it.
if "$prefix/bin/volumehaptics-guard" 2>"$work/guard.txt" || ! grep -q 'zero force' "$work/guard.txt"; then
  echo "the guard of devices is not installed" >&2
  exit 1
fi
rules=$(find "$prefix" -path '*/udev/rules.d/70-volume-haptics.rules')
[ -n "$rules" ] || { echo "the udev rules are not installed" >&2; exit 1; }

# Configure a program that finds VTK before this package.
cmake -S "$source_dir/Testing/Package/Consumer" -B "$work/consumer" -G Ninja \
  -DVolumeHaptics_DIR="$(dirname "$config")" \
  ${sanitize:+-DCMAKE_CXX_FLAGS="-fsanitize=$sanitize"} >"$work/configure-consumer.log"
cmake --build "$work/consumer" >"$work/build-consumer.log"
"$work/consumer/consumer"

# The build tree must also hide private folders.
from_build=$(dirname "$(find "$build_dir/lib" -path '*/cmake/*/VolumeHapticsConfig.cmake')")
cmake -S "$source_dir/Testing/Package/Consumer" -B "$work/build-tree" -G Ninja \
  -DVolumeHaptics_DIR="$from_build" >"$work/configure-build-tree.log"

# Starts a program, and fails if its window closes unexpectedly.
stays_open() {
  "$@" &
  local window=$!
  sleep 5
  if ! kill -0 "$window" 2>/dev/null; then
    echo "$* did not stay open" >&2
    return 1
  fi
  kill -TERM "$window"
  wait "$window" || true
}
if [ -n "${DISPLAY:-}" ]; then
  stays_open "$work/examples/drop-in" "$head"
  stays_open "$work/examples/beside-style" "$head"
fi

# Only public headers may be installed: those of the public classes and of the interfaces for vendors' libraries, for
# volumes in pieces and for Qt.
installed=$(find "$prefix/include" -name '*.h' -not -name '*Module.h' -exec basename {} \; | sort)
expected=$({ find "$source_dir/Module/VTK" -name 'vtk*.h' -printf '%f\n' | grep -vE 'Compat|Internals'
  printf '%s\n' DeviceBackend.h DeviceKind.h ForceCaps.h Vector3.h NoiseSamples.h Quaternion.h VendorPlugin.h \
    WidgetWatch.h; } | sort)
if [ "$installed" != "$expected" ]; then
  printf 'installed headers:\n%s\nexpected:\n%s\n' "$installed" "$expected" >&2
  exit 1
fi

elsewhere=$(find "$prefix/include" -name '*.h' -not -path "$prefix/include/volumehaptics/*")
if [ -n "$elsewhere" ]; then
  printf 'headers that are not in include/volumehaptics:\n%s\n' "$elsewhere" >&2
  exit 1
fi

if [ "$python" = ON ]; then
  package=$(find "$prefix" -path '*/volumehaptics/__init__.py')
  site=$(dirname "$(dirname "$package")")
  installed=$(cd "$site/volumehaptics" && find . -type f -not -name 'vtkVolumeHaptics*' | sort)
  expected=$(printf './%s\n' __init__.py __main__.py _files.py _grids.py _hosts.py _identify.py _inspect.py _labels.py \
    _large.py _paths.py _plotting.py _qt.py _tools.py _touch.py _trame.py _version.py _webdoor.py _webview.py \
    arrays.py data/HeadPhantom.vti data/README.txt examples.py py.typed pyvista.py web.py | sort)
  if [ "$installed" != "$expected" ]; then
    printf 'installed Python package:\n%s\nexpected:\n%s\n' "$installed" "$expected" >&2
    exit 1
  fi
  PYTHONPATH=$site PYTHONDONTWRITEBYTECODE=1 /usr/bin/python3 -c \
    'from volumehaptics import examples; examples.first_touch()'
  from_python=$(PYTHONPATH=$site /usr/bin/python3 "$source_dir/Examples/Python/first_touch.py" "$head")
  echo "Python: $from_python"
  if [ -n "${DISPLAY:-}" ]; then
    PYTHONPATH=$site stays_open /usr/bin/python3 "$source_dir/Examples/Python/explore.py" "$head"
  fi
  [ "${from_cxx%.*}" = "${from_python%%.*}" ] ||
    { echo "C++ and Python disagree" >&2; exit 1; }
fi
