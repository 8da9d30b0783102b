#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Unpacks the source package NAME of this Debian into FOLDER, from the mirrors that apt-get uses, without changing the
# system: usage: source.sh NAME FOLDER
set -e
name=$1
mkdir -p "$2"
cd "$2"
apt=$PWD/apt
mkdir -p "$apt/lists/partial"
# shellcheck disable=SC2016 # apt-get replaces the names
apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' \
  'Created-By: Packages' 'ORIGIN: Debian' | sed 's/^/deb-src /' | sort -u > "$apt/sources.list"
private() {
  apt-get -q -o Dir::Etc::sourcelist="$apt/sources.list" -o Dir::Etc::sourceparts=- \
    -o Dir::State::lists="$apt/lists" -o Dir::Cache="$apt" "$@"
}
private update
private source --download-only "$name"
dsc=$(ls -- *.dsc)
dpkg-source --no-check -x "$dsc" source
