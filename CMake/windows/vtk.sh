#!/bin/sh
# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
#
# Cross-builds the modules of VTK that this project needs for Windows, with MinGW-w64:
#
#   vtk.sh FOLDER [rendering]
#
# FOLDER receives the sources, the build tree and the installation (FOLDER/install). Debian's source package of VTK
# lacks the libraries that VTK brings along, and MinGW's Debian packages have hardly any of them. The source package of
# ParaView has them, with the VTK that ParaView uses (9.2), so this script takes VTK from there.
set -e
here=$(cd "$(dirname "$0")" && pwd)
mkdir -p "$1"
cd "$1"
if [ ! -d source ]; then
  "$here/source.sh" paraview .
  # GCC treats an exported variable as a definition unless its declaration says extern.
  sed -i -E 's/^(vtktiff_EXPORT (TIFFErrorHandler|const TIFFCodec))/extern \1/' \
    source/VTK/ThirdParty/tiff/vtktiff/libtiff/tiffiop.h
fi
modules="CommonCore CommonDataModel CommonExecutionModel CommonMath CommonSystem CommonTransforms FiltersCore
  FiltersFlowPaths FiltersGeneral FiltersGeometry FiltersSources IOCore IOEnSight IOGeometry IOImage IOInfovis IOLegacy IOPLY
  IOXML IOXMLParser ImagingCore RenderingCore hdf5 jsoncpp lz4 tiff vtksys"
if [ "$2" = rendering ]; then
  modules="$modules ChartsCore CommonComputationalGeometry ImagingMorphological InteractionStyle InteractionWidgets
    IOOggTheora RenderingAnnotation
    RenderingContext2D RenderingContextOpenGL2 RenderingFreeType RenderingOpenGL2 RenderingVolume
    RenderingVolumeOpenGL2 TestingRendering glew"
fi
set --
for module in $modules; do
  set -- "$@" "-DVTK_MODULE_ENABLE_VTK_$module=YES"
done
for group in Imaging MPI Qt Rendering StandAlone Views Web; do
  set -- "$@" "-DVTK_GROUP_ENABLE_$group=DONT_WANT"
done
cmake -S source/VTK -B build -G Ninja -DCMAKE_TOOLCHAIN_FILE="$here/mingw.cmake" \
  -DCMAKE_BUILD_TYPE=Release '-DCMAKE_C_FLAGS_RELEASE=-O1 -DNDEBUG' '-DCMAKE_CXX_FLAGS_RELEASE=-O1 -DNDEBUG' \
  -DCMAKE_INSTALL_PREFIX="$PWD/install" -DBUILD_SHARED_LIBS=ON -DVTK_VERSIONED_INSTALL=OFF -DBUILD_TESTING=OFF \
  -DVTK_BUILD_TESTING=OFF -DVTK_ENABLE_WRAPPING=OFF -DVTK_ENABLE_REMOTE_MODULES=OFF -DVTK_LEGACY_REMOVE=ON \
  -DVTK_SMP_IMPLEMENTATION_TYPE=STDThread -DVTK_DEBUG_LEAKS=OFF "-DCMAKE_PROJECT_VTK_INCLUDE=$here/sources.cmake" "$@"
ninja -C build
ninja -C build install > install.log
