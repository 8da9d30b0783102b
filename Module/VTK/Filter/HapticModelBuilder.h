// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Builds the core's HapticModel from a vtkImageData and a vtkHapticProperty, with every check of
 * the input.
 */
#ifndef HapticModelBuilder_h
#define HapticModelBuilder_h

#include "Core/Model/HapticModel.h"
#include "VTK/Baking/ImageTimeSteps.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Modes/HapticModes.h"

#include <string>
#include <vector>

class vtkDataArray;
class vtkHapticProperty;
class vtkHapticRemoval;
class vtkHapticTool;
class vtkImageData;
class vtkPolyData;

namespace VolumeHaptics
{
class HapticSurface;
struct HapticCut;
class RegionSeries;

struct HapticModelOptions
{
  /**
   * Kernel, settings and placement of the device. If the kernel's radius is 0, half a voxel is
   * used. The builder fills in the volume, the material and the settings of the property.
   */
  HapticModelDescription Description;
  HapticSurface* Surfaces = nullptr; ///< meshes for HapticMethod::SurfaceProxy
  vtkPolyData* Surface = nullptr;    ///< surface to touch; null for the isosurface
  RegionSeries* Regions = nullptr;   ///< earlier models, if the image may be a region
  /** Time steps of a moving volume; the image is at its first step. */
  std::vector<ImageTimeStep> TimeSteps;
  std::string Displacements;     ///< name of the displacements' array; empty if there is none
  TimeStepSeries Series;         ///< the whole series that contains TimeSteps
  OutsideSamples Outside;        ///< outside samples of TimeSteps, to be filled
  HapticModes Modes;             ///< modes for HapticMethod::Primitives
  vtkHapticTool* Tool = nullptr; ///< null for a point
  vtkHapticRemoval* Removal = nullptr;
  const HapticCut* Cut = nullptr; ///< null if nothing is cut away
  double MetersPerWorldUnit = 0.001;
};

/** The facts that all time steps of a volume have in common. */
struct TimeStepShape
{
  VolumeView View; ///< only its layout is used, not its samples
  Affine3 IndexToWorld;
  TimeStepSeries Series; ///< all time steps but its last one need displacements
  int KernelRadius;
  std::string Displacements; ///< name of the displacements' array; empty if there is none
  OutsideSamples Outside;    ///< outside samples of each time step, to be filled
};

/**
 * Makes the time step of a model. Returns false, with the reason and the cure in `error`, if the
 * time step has another shape or can't be touched.
 */
bool MakeVolumeTimeStep(const ImageTimeStep& read, const TimeStepShape& shape,
  VolumeTimeStep& timeStep, std::string& error);

/**
 * Returns a copy of a baked volume with other time steps, which may be of another region. Bakes
 * nothing again except the meshes of SURFACE_PROXY that the time steps lack. Returns null if the
 * time steps can't be touched, or differ from the volume in their geometry or type of numbers.
 * @param displacements name of the displacements' array; empty if there is none
 * @param outside outside samples of the time steps, to be filled
 */
std::shared_ptr<const BakedVolume> GoOnWithTimeSteps(const BakedVolume& volume,
  const std::vector<ImageTimeStep>& timeSteps, const TimeStepSeries& series, int kernelRadius,
  const std::string& displacements, const OutsideSamples& outside);

/**
 * Bakes a model that keeps the scalar array alive. If the input can't be touched, returns null, and
 * `error` names the input and the cure. Writes to `notice` what was guessed about the values; empty
 * if nothing was guessed.
 */
std::shared_ptr<const HapticModel> BuildHapticModel(vtkImageData* image, vtkDataArray* scalars,
  vtkHapticProperty* property, const HapticModelOptions& options, std::string& notice,
  std::string& error);

} // namespace VolumeHaptics

#endif
