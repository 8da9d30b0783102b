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

# All sources except main(), relative to this folder. The image tests compile them, too.
set(Explore_SOURCES
  Analysis/BodyIsolation.cxx
  Analysis/ValueProbe.cxx
  Analysis/VolumeAnalysis.cxx
  Bar/CommandBar.cxx
  Bar/CommandTable.cxx
  Bar/Icons.cxx
  Exploration/Exploration.cxx
  Exploration/GuideFile.cxx
  Exploration/HeardTicks.cxx
  Exploration/Inspection.cxx
  Exploration/ModeChoice.cxx
  Exploration/ShapeFile.cxx
  Exploration/TissueTable.cxx
  HelpText.cxx
  Live/FileDialog.cxx
  Live/FreeFile.cxx
  Live/HandHold.cxx
  Live/HandLabel.cxx
  Live/HandTool.cxx
  Live/KeptWork.cxx
  Live/LiveRun.cxx
  Live/LookSwitch.cxx
  Live/SavedMeasurements.cxx
  Live/TimeSlider.cxx
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
  View/ViewFrame.cxx)

set(Explore_LIBRARIES)
set(Explore_INCLUDE_DIRS)

# The movies of key F9 need a module of VTK that the project looks for together with the components.
if (VTK_IOOggTheora_FOUND)
  list(APPEND Explore_VTK_COMPONENTS IOOggTheora)
  list(APPEND Explore_SOURCES Record/TheoraFile.cxx)
else ()
  list(APPEND Explore_SOURCES Record/NoMovieFile.cxx)
endif ()

# The sound of --sound uses PulseAudio's library if it is found.
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
