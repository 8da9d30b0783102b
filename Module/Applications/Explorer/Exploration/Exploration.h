// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_Exploration_h
#define Explore_Exploration_h

#include "Applications/Explorer/Analysis/VolumeAnalysis.h"
#include "Applications/Explorer/Path/TipPathPlanner.h"
#include "Applications/Explorer/View/ViewFrame.h"
#include "VTK/Reading/VolumeLoader.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"
#include "vtkVolumeHapticsFilter.h"

#include <functional>
#include <string>
#include <vector>

namespace Explore
{
enum class Estimator
{
  CentralDifference,
  Gaussian,
  CubicBSpline
};

/// The settings of an exploration.
struct Settings
{
  std::string Preset = "auto";
  std::string Front = "-y"; // world axis that the front (such as a face) points along
  std::string Up = "+z";    // world axis that points to the top
  Estimator Gradient = Estimator::Gaussian;
  // Name as in vtkVolumeHapticsFilter::GetMethodNames, or "auto": primitives, which follow the
  // vectors, if the volume is a grid with vectors, and otherwise proxy.
  std::string Method = "auto";
  std::vector<std::string> Modes; // modes of the method primitives: see ModeChoice.h
  std::string Guide;              // a file that guides the hand: see GuideFile.h; empty: none
};

/// The results, which the pictures and the summary present.
struct Exploration
{
  Volume Input;
  // Input without the parts that are not connected to the body.
  vtkSmartPointer<vtkImageData> Body;
  // describes the hidden parts, which can still be felt; empty if there are hardly any
  std::string Hidden;
  Analysis Values;
  ViewFrame View;
  TipPath Tip;
  vtkSmartPointer<vtkVolumeHapticsFilter> Filter;
  vtkSmartPointer<vtkPolyData> Trace; // output of the filter
  std::string Materials;              // name of the preset that was applied
  std::string Estimator;
  std::string Method;     // the method of the trace, for users
  int KernelRadius = 0;   // voxels
  double ServoRate = 0.0; // Hz
  double FilterSeconds = 0.0;
};

/// Analyses the values, plans a tip path and computes the force along it. Throws InputError.
/// `progress` may be null; it is called at the beginning of each step, with the fraction of the
/// work that is done.
using Progress = std::function<void(const std::string& step, double fraction)>;
Exploration ExploreVolume(
  const Volume& volume, const Settings& settings, const Progress& progress = nullptr);
} // namespace Explore

#endif
