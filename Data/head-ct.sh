# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# shellcheck shell=bash
# A function that downloads a real head CT, for scripts that a person starts.

# Extracts Cranium.mhd from Debian's example data for InVesalius into a folder, without installing the package:
# get_head_ct FOLDER. Ends its output with the licence. If it fails, prints a remedy and returns 1.
get_head_ct()
{
  local data=$1
  local examples="$data/package/usr/share/doc/invesalius-examples"
  local volume="$data/Cranium.mhd"
  if [[ ! -f "$volume" ]]
  then
    rm -rf "$data"
    mkdir -p "$data/package"
    if ! (cd "$data" && apt-get download -qq invesalius-examples 2> download.log)
    then
      # This machine has no package lists yet.
      if [[ "$(id -u)" -eq 0 ]]
      then
        apt-get update -qq
      elif command -v sudo > /dev/null
      then
        sudo apt-get update -qq
      fi
      if ! (cd "$data" && apt-get download -qq invesalius-examples)
      then
        echo "The Debian package invesalius-examples could not be downloaded." >&2
        echo "Cure: check the network and /etc/apt/sources.list, or name a VOLUME of yours." >&2
        return 1
      fi
    fi
    dpkg -x "$data"/invesalius-examples_*.deb "$data/package"
    # The archive makes its files writable by everybody, and tar run by root would preserve that.
    tar -xzf "$examples/examples/Cranium.inv3" -C "$data" --strip-components=1 --wildcards \
      --no-same-permissions --no-same-owner '*/matrix.dat'
    if [[ "$(stat -c %s "$data/matrix.dat")" -ne $((256 * 256 * 108 * 2)) ]]
    then
      echo "invesalius-examples holds another head than the one known here." >&2
      echo "Cure: name a VOLUME of yours." >&2
      return 1
    fi
    # The rows run from the back to the front, opposite to DICOM's order, which explains the -1.
    cat > "$volume.part" << 'EOF'
ObjectType = Image
NDims = 3
BinaryData = True
BinaryDataByteOrderMSB = False
CompressedData = False
TransformMatrix = 1 0 0 0 -1 0 0 0 1
Offset = 0 244.042905 0
ElementSpacing = 0.957031 0.957031 1.5
DimSize = 256 256 108
ElementType = MET_SHORT
ElementDataFile = matrix.dat
EOF
    mv "$volume.part" "$volume"
  fi
  chmod go-w "$data/matrix.dat"
  echo "Cranium from Debian's invesalius-examples: (c) Centro de Tecnologia da Informacao Renato"
  echo "Archer, licence GPL-2. It stays in $data and is not part of this project."
  echo "Licence text: $examples/copyright"
}
