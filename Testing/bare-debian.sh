#!/usr/bin/env bash
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Runs a command on the committed sources in a bare Debian, such as one with another VTK than this computer's.
#
# usage: Testing/bare-debian.sh [--root] SUITE FOLDER COMMAND [ARGUMENT...]
#
#   Testing/bare-debian.sh trixie /var/tmp/trixie ./Examples/explore.sh
#   Testing/bare-debian.sh forky /var/tmp/forky ./Testing/run.sh
#
# FOLDER gets a tree of debootstrap's variant minbase with sudo, git and certificates, from the mirror that apt-get uses
# here, and in it a user. The command runs as this user, or as root with --root. A FOLDER that already has a tree keeps
# its packages and builds, and gets the sources again. The command has a separate process space, and shares this
# computer's network and /tmp. Needs root. The tree takes 4 GB with the packages of run.sh; rm -r --one-file-system
# removes it.
set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
user=tester
if [ "${1:-}" = --root ]; then
  user=root
  shift
fi
case ${1:-} in
  -h | --help) sed -n '5,17s/^# \{0,1\}//p' "${BASH_SOURCE[0]}"; exit 0 ;;
esac
if [ $# -lt 3 ] || [ "$(id -u)" -ne 0 ]; then
  echo "$0: needs root, and three arguments; try --help" >&2
  exit 2
fi
suite=$1
mkdir -p "$2"
tree=$(cd "$2" && pwd)
shift 2
# shellcheck source=../CMake/install-packages.sh
source "$root/CMake/install-packages.sh"
require_packages debootstrap git

# usage: home_of USER
home_of()
{
  [ "$1" = root ] && echo /root || echo "/home/$1"
}

# usage: inside USER COMMAND [ARGUMENT...]
# Runs a command in the tree as a user.
inside()
{
  # shellcheck disable=SC2016 # the inner shell expands it
  unshare --mount --pid --fork --kill-child bash -c '
    mount --make-rprivate /
    mount -t proc proc "$1/proc"
    mount --rbind /dev "$1/dev"
    mount -t tmpfs -o mode=1777 tmpfs "$1/dev/shm"
    mount --bind /tmp "$1/tmp" # X display numbers in use are shared by the whole network
    exec chroot --userspec="$2" "$1" env -i HOME="$3" USER="$2" LOGNAME="$2" TERM="${TERM:-dumb}" LANG=C.UTF-8 \
      PATH=/usr/local/bin:/usr/bin:/bin:/usr/sbin:/sbin "${@:4}"' _ "$tree" "$1" "$(home_of "$1")" "${@:2}"
}

if [ ! -f "$tree/etc/made" ]; then
  # shellcheck disable=SC2016 # apt-get expands it
  mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Label: Debian' 'Identifier: Packages' | sed -n 1p)
  script=/usr/share/debootstrap/scripts/$suite
  [ -e "$script" ] || script=/usr/share/debootstrap/scripts/sid # for a suite that is newer than debootstrap
  debootstrap --variant=minbase "$suite" "$tree" "$mirror" "$script"
  # Don't let dpkg wait for the disk: after a crash, the files are useless, and a slow disk takes minutes to write each
  # file.
  echo force-unsafe-io > "$tree/etc/dpkg/dpkg.cfg.d/unsafe-io"
  # Accept an outdated suite of a mirror.
  echo 'Acquire::Check-Valid-Until "false";' > "$tree/etc/apt/apt.conf.d/old-state"
  echo "127.0.0.1 localhost $(hostname)" > "$tree/etc/hosts"
  inside root apt-get update -qq
  inside root env DEBIAN_FRONTEND=noninteractive \
    apt-get install -y -qq --no-install-recommends sudo git ca-certificates
  inside root useradd --create-home --shell /bin/bash tester
  echo "tester ALL=(ALL) NOPASSWD: ALL" > "$tree/etc/sudoers.d/tester"
  chmod 440 "$tree/etc/sudoers.d/tester"
  touch "$tree/etc/made"
fi
# Use this computer's network configuration and trusted certificates.
cp --remove-destination /etc/resolv.conf "$tree/etc/resolv.conf"
cp -r /usr/local/share/ca-certificates "$tree/usr/local/share"
inside root update-ca-certificates > /dev/null

# Copy only committed files. Preserve the times of unchanged files, so that they are not built again.
home=$(home_of $user)
sources=$tree$home/volume-haptics
if [ ! -d "$sources" ]; then
  git clone -q --no-hardlinks "$root" "$sources"
fi
git -c safe.directory='*' -C "$sources" fetch -q "$root" HEAD
git -c safe.directory='*' -C "$sources" update-index -q --refresh || true # also the owner, which chown has changed
git -c safe.directory='*' -C "$sources" reset -q --hard FETCH_HEAD
inside root chown -R "$user:" "$home/volume-haptics"
# shellcheck disable=SC2016
inside "$user" bash -c 'cd ~/volume-haptics && exec "$@"' _ "$@"
