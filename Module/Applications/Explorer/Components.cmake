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
  IOCore
  IOImage
  IOXML
  ImagingCore
  ImagingMorphological
  InteractionStyle
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
  Errors/MessageCapture.cxx
  Exploration/Exploration.cxx
  Exploration/MethodScale.cxx
  Exploration/TissueTable.cxx
  Live/LiveRun.cxx
  Live/TouchScene.cxx
  Options.cxx
  Path/PolarGrid.cxx
  Path/SurfaceMap.cxx
  Path/TipPathPlanner.cxx
  Report/ForcePicture.cxx
  Report/ReportFiles.cxx
  Report/TraceSummary.cxx
  Scene/CoarseFrames.cxx
  Scene/ExplorerScene.cxx
  Scene/Trail.cxx
  Scene/VolumeLook.cxx
  View/SceneCamera.cxx
  View/StereoModes.cxx
  View/ViewFrame.cxx
  Volume/DicomFolder.cxx
  Volume/HeaderText.cxx
  Volume/LabelLoader.cxx
  Volume/VolumeChecks.cxx
  Volume/VolumeLoader.cxx
  Volume/VolumeOrientation.cxx)
