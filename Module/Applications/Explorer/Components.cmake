# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause
# The VTK components that the program needs, for find_package(VTK).
set(Explore_VTK_COMPONENTS
  ChartsCore
  CommonCore
  CommonDataModel
  CommonExecutionModel
  CommonMath
  CommonSystem
  FiltersCore
  FiltersGeometry
  FiltersSources
  IOCore
  IOEnSight
  IOGeometry
  IOImage
  IOLegacy
  IOPLY
  IOXML
  IOXMLParser
  ImagingCore
  ImagingMorphological
  InteractionStyle
  InteractionWidgets
  RenderingAnnotation
  RenderingContext2D
  RenderingContextOpenGL2
  RenderingCore
  RenderingFreeType
  RenderingOpenGL2
  RenderingVolume
  RenderingVolumeOpenGL2
  vtksys)

# Everything but main(), relative to this folder: the image tests compile it, too.
set(Explore_SOURCES
  Analysis/BodyIsolation.cxx
  Analysis/ValueProbe.cxx
  Analysis/VolumeAnalysis.cxx
  Errors/CheckedReading.cxx
  Errors/MessageCapture.cxx
  Exploration/Exploration.cxx
  Exploration/GuideFile.cxx
  Exploration/HeardTicks.cxx
  Exploration/Inspection.cxx
  Exploration/ModeChoice.cxx
  Exploration/ShapeFile.cxx
  Exploration/TissueTable.cxx
  HelpText.cxx
  Live/FreeFile.cxx
  Live/HandTool.cxx
  Live/KeptWork.cxx
  Live/KeyBinding.cxx
  Live/LiveRun.cxx
  Live/LookSwitch.cxx
  Live/SavedMeasurements.cxx
  Live/ToolFile.cxx
  Live/TouchReplay.cxx
  Live/TouchScene.cxx
  Live/WindowFiles.cxx
  Live/WindowRecorder.cxx
  Options.cxx
  Path/SurfaceMap.cxx
  Path/TipPathPlanner.cxx
  Record/DemoScript.cxx
  Report/ForcePicture.cxx
  Report/ReportFiles.cxx
  Report/TraceSound.cxx
  Report/TraceSummary.cxx
  Scene/ExplorerScene.cxx
  Scene/VolumeCut.cxx
  Scene/VolumeLook.cxx
  Sound/ContactSound.cxx
  Sound/SoundStream.cxx
  Sound/WaveFile.cxx
  View/Display.cxx
  View/ListOverlay.cxx
  View/LoadingScreen.cxx
  View/SceneCamera.cxx
  View/StereoModes.cxx
  View/ViewFrame.cxx
  Volume/DicomFolder.cxx
  Volume/DicomHeader.cxx
  Volume/DicomPixels.cxx
  Volume/DicomSegmentation.cxx
  Volume/DicomSeries.cxx
  Volume/DicomStream.cxx
  Volume/GridLoader.cxx
  Volume/LabelLoader.cxx
  Volume/LabelMap.cxx
  Volume/LargeLoader.cxx
  Volume/SliceGeometry.cxx
  Volume/VolumeChecks.cxx
  Volume/VolumeFields.cxx
  Volume/VolumeLoader.cxx
  Volume/VolumeOrientation.cxx
  Volume/VolumeSeries.cxx
  Volume/WholeFile.cxx)

# Whether compressed files are whole.
find_package(ZLIB REQUIRED)
set(Explore_LIBRARIES ${ZLIB_LIBRARIES})
set(Explore_INCLUDE_DIRS ${ZLIB_INCLUDE_DIRS})

# The movies of key F9. The project looks for the module beside the components.
if (VTK_IOOggTheora_FOUND)
  list(APPEND Explore_VTK_COMPONENTS IOOggTheora)
  list(APPEND Explore_SOURCES Record/TheoraFile.cxx)
else ()
  list(APPEND Explore_SOURCES Record/NoMovieFile.cxx)
endif ()

# The sound of --sound. PulseAudio's library is used if it is found.
include("${CMAKE_CURRENT_LIST_DIR}/../../UseLibrary.cmake")
find_package(PkgConfig QUIET)
if (PKG_CONFIG_FOUND)
  pkg_check_modules(PULSE QUIET libpulse)
endif ()
volume_haptics_use(Explore_LIBRARIES PULSE PULSE_FOUND "Let the explorer be heard through PulseAudio or PipeWire"
  "pkg-config libpulse-dev")
if (VolumeHaptics_USE_PULSE)
  list(APPEND Explore_INCLUDE_DIRS ${PULSE_INCLUDE_DIRS})
  list(APPEND Explore_SOURCES Sound/PulseOutput.cxx)
else ()
  list(APPEND Explore_SOURCES Sound/NoSoundOutput.cxx)
endif ()

# Compressed DICOM slices, by GDCM's library if it is found. Debian's package for CMake asks for GDCM's programs, too.
find_path(GDCM_INCLUDE_DIR gdcmImageReader.h PATH_SUFFIXES gdcm-3.0)
find_library(GDCM_MSFF_LIBRARY gdcmMSFF)
find_library(GDCM_DSED_LIBRARY gdcmDSED)
find_library(GDCM_COMMON_LIBRARY gdcmCommon)
mark_as_advanced(GDCM_INCLUDE_DIR GDCM_MSFF_LIBRARY GDCM_DSED_LIBRARY GDCM_COMMON_LIBRARY)
set(GDCM_LINK_LIBRARIES "${GDCM_MSFF_LIBRARY}" "${GDCM_DSED_LIBRARY}" "${GDCM_COMMON_LIBRARY}")
set(GDCM_FOUND FALSE)
if (GDCM_INCLUDE_DIR AND GDCM_MSFF_LIBRARY AND GDCM_DSED_LIBRARY AND GDCM_COMMON_LIBRARY)
  set(GDCM_FOUND TRUE)
endif ()
volume_haptics_use(Explore_LIBRARIES GDCM GDCM_FOUND "Let the explorer read compressed DICOM slices" "libgdcm-dev")
if (VolumeHaptics_USE_GDCM)
  list(APPEND Explore_INCLUDE_DIRS "${GDCM_INCLUDE_DIR}")
  list(APPEND Explore_SOURCES Volume/GdcmUnpacking.cxx)
else ()
  list(APPEND Explore_SOURCES Volume/NoUnpacking.cxx)
endif ()
