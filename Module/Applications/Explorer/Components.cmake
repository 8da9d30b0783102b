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
  BodyIsolation.cxx
  CoarseFrames.cxx
  DicomFolder.cxx
  Explorer.cxx
  ExplorerScene.cxx
  ForceChart.cxx
  HeaderText.cxx
  LiveRun.cxx
  MessageCapture.cxx
  MethodScale.cxx
  Options.cxx
  PolarGrid.cxx
  SceneCamera.cxx
  StereoModes.cxx
  SurfaceMap.cxx
  TipPathPlanner.cxx
  TouchScene.cxx
  TissueTable.cxx
  TraceFiles.cxx
  TraceSummary.cxx
  Trail.cxx
  ValueProbe.cxx
  ViewFrame.cxx
  VolumeAnalysis.cxx
  VolumeChecks.cxx
  VolumeLoader.cxx
  VolumeLook.cxx
  VolumeOrientation.cxx)
