#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Tests the back ends of real devices on a real kernel in a virtual machine, with emulated USB devices.
#
# usage: Testing/VirtualMachine/run.sh [BUILD_DIR] [--gtest_OPTION...]
#
# In other tests of emulated devices, umockdev takes the kernel's place. Here, libusb and hidapi use Debian's kernel,
# whose USB core gets the devices from vhci_hcd. Installs what is missing (but only unpacks a kernel in
# BUILD_DIR/virtual-machine), builds in BUILD_DIR (default build/test), boots without KVM, and runs for about ten
# minutes. --gtest_filter=PATTERN chooses tests. Exits with the test program's status, or 125 if there was none. Writes
# the kernel's messages to BUILD_DIR/virtual-machine/kernel.log.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)
build_dir=$root/build/test
options=()
for argument in "$@"; do
  case $argument in
    -h | --help) sed -n '5,13s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
    --gtest_*) options+=("$argument") ;;
    -*) echo "$0: unknown option $argument; try --help" >&2; exit 2 ;;
    *) build_dir=$argument ;;
  esac
done
if [ "$(uname -m)" != x86_64 ]; then
  echo "$0: this is only made for x86_64; you can't run it here" >&2
  exit 2
fi

# shellcheck source=../../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages cmake ninja-build g++ libvtk9-dev libgtest-dev pkg-config libusb-1.0-0-dev libhidapi-dev \
  qemu-system-x86 busybox-static cpio kmod

echo "== Building in $build_dir"
cmake -S "$root" --preset dev -B "$build_dir"
cmake --build "$build_dir" --target VolumeHapticsVirtualMachineTest volumehaptics-guard
program=$build_dir/bin/VolumeHapticsVirtualMachineTest

machine=$(mkdir -p "$build_dir/virtual-machine" && cd "$build_dir/virtual-machine" && pwd)
package=$(apt-cache depends linux-image-amd64 | sed -n 's/^ *Depends: *\(linux-image-.*\)/\1/p' | head -n 1)
if [ -z "$package" ]; then
  echo "$0: apt knows no kernel; run apt-get update" >&2
  exit 1
fi
kernel=$machine/$package
if [ ! -e "$kernel" ]; then
  echo "== Unpacking $package"
  rm -rf "$machine/download"
  mkdir "$machine/download"
  (cd "$machine/download" && apt-get download -qq "$package")
  dpkg -x "$machine"/download/*.deb "$machine/download"
  rm "$machine"/download/*.deb
  mv "$machine/download" "$kernel"
fi
version=${package#linux-image-}
depmod -b "$kernel" "$version"

echo "== Packing the machine"
files=$machine/files
rm -rf "$files"
mkdir -p "$files"/{bin,dev,proc,run,sys,tmp,modules}
cp /bin/busybox "$files/bin"
cp "$program" "$files/bin/test-program"
cp "$build_dir/bin/volumehaptics-guard" "$files/bin"
ldd "$program" "$build_dir/bin/volumehaptics-guard" | sed -n 's/.*=> \(\/[^ ]*\) .*/\1/p; s/^\t\(\/[^ ]*\) .*/\1/p' | sort -u |
  while read -r library; do
    install -D "$library" "$files$library"
  done
# List the modules in the order of their dependencies, in which udev would load them. hid-logitech handles the older
# SpaceMice.
for module in vhci-hcd usbhid hid-generic hid-logitech evdev joydev ftdi_sio; do
  modprobe -d "$kernel" -S "$version" --show-depends "$module" | sed -n 's/^insmod \([^ ]*\).*/\1/p'
done | awk '!seen[$0]++' > "$machine/modules"
while read -r file; do
  cp "$file" "$files/modules"
done < "$machine/modules"
{
  cat << 'EOF'
#!/bin/busybox sh
/bin/busybox --install -s /bin
export PATH=/bin
mount -t proc none /proc
mount -t sysfs none /sys
mount -t devtmpfs none /dev
EOF
  sed 's/.*\//insmod \/modules\//' "$machine/modules"
  echo "cd /tmp"
  printf '%q ' test-program "${options[@]}"
  cat << 'EOF'
< /dev/null > /dev/ttyS1 2>&1
echo $? > /dev/ttyS2
sync
poweroff -f
EOF
} > "$files/init"
chmod +x "$files/init"
(cd "$files" && find . | cpio --quiet -o -H newc | gzip -1) > "$machine/initramfs.gz"

echo "== Running in the machine"
: > "$machine/status"
# Emulate one processor. On a busy computer, two emulated processors wait for milliseconds to wake each other up.
timeout 3000 qemu-system-x86_64 -accel tcg -cpu max -smp 1 -m 1024 -nodefaults -no-reboot -display none \
  -kernel "$kernel/boot/vmlinuz-$version" -initrd "$machine/initramfs.gz" \
  -append "console=ttyS0 panic=-1" \
  -serial "file:$machine/kernel.log" -serial stdio -serial "file:$machine/status" < /dev/null |
  sed -u 's/\r$//' || true
status=$(tr -dc '0-9' < "$machine/status")
if [ -z "$status" ]; then
  tail -n 30 "$machine/kernel.log" >&2
  echo "$0: the machine ended without a result; see above, and $machine/kernel.log" >&2
  exit 125
fi
echo "== The test program ended with $status"
exit "$status"
