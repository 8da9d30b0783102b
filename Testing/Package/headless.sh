#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Builds the module without rendering, and touches a volume from Python without a display.
# usage: headless.sh SOURCE_DIR BUILD_DIR WRAP_PYTHON
set -euo pipefail

work=$2/Testing/Package/headless
graphics='libvtk(Charts|RenderingContext2D|RenderingOpenGL2|RenderingUI|RenderingVolume|InteractionStyle)|lib(GL|EGL|OpenGL|GLX|X11)[.]'
rm -rf "$work"
mkdir -p "$work"
# Use the build type Debug without debugging information, because it builds fastest.
cmake -S "$1" -B "$work" -G Ninja -DVolumeHaptics_USE_RENDERING=OFF -DVolumeHaptics_WRAP_PYTHON="$3" \
  -DVolumeHaptics_BUILD_TOOLS=OFF -DVolumeHaptics_USE_LIBUSB=OFF -DVolumeHaptics_USE_HIDAPI=OFF \
  -DVolumeHaptics_USE_BEAST=OFF \
  -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_FLAGS_DEBUG= -DCMAKE_UNITY_BUILD=ON >"$work/configure.log"
cmake --build "$work" >"$work/build.log"

library=$(find "$work/lib" -name 'libvtkVolumeHaptics.so' | head -n 1)
if ldd "$library" | grep -E "$graphics"; then
  echo "the library links a graphics library, though it was built without rendering" >&2
  exit 1
fi
if [ "$3" = ON ]; then
  site=$(dirname "$(dirname "$(find "$work/lib" -path '*/volumehaptics/__init__.py')")")
  env -u DISPLAY -u WAYLAND_DISPLAY PYTHONPATH="$site" GRAPHICS="$graphics" /usr/bin/python3 - <<'END'
import os
import re

from volumehaptics import examples, touch, vtkHapticDevice

trace = touch(examples.phantom(), examples.stroke(), preset="CT contrast")
force = trace.GetPointData().GetArray("Force").GetMaxNorm()
assert force > 0.1, f"felt {force} N"
device = vtkHapticDevice()
assert device.Open("virtual") and device.Start()
device.Stop()
with open("/proc/self/maps", encoding="ascii") as maps:
    found = {line.split()[-1] for line in maps if re.search(os.environ["GRAPHICS"], line)}
assert not found, f"touching a volume loads graphics: {found}"
print(f"felt {force:.2f} N without graphics")
END
fi
