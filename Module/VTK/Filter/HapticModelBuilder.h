// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Builds the core's HapticModel from a vtkImageData and a vtkHapticProperty, after checking all
 * input.
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
   * The caller sets the kernel, the settings and the placement of the device; a kernel radius of 0
   * stands for half a voxel. The builder adds the volume, the material and the settings of the
   * property.
   */
  HapticModelDescription Description;
  HapticSurface* Surfaces = nullptr; ///< meshes for HapticMethod::SurfaceProxy
  vtkPolyData* Surface = nullptr;    ///< surface to touch; null: the isosurface
  RegionSeries* Regions = nullptr;   ///< models of earlier regions, to compare with if the image is
                                     ///< a region
  /** Time steps of a moving volume; the image is at its first step. */
  std::vector<ImageTimeStep> TimeSteps;
  std::string Displacements;     ///< name of the displacement array; empty if there is none
  TimeStepSeries Series;         ///< whole series, of which TimeSteps is a part
  OutsideSamples Outside;        ///< outside samples in TimeSteps that have to be filled
  HapticModes Modes;             ///< modes for HapticMethod::Primitives
  vtkHapticTool* Tool = nullptr; ///< null: the hand touches with a point
  vtkHapticRemoval* Removal = nullptr;
  const HapticCut* Cut = nullptr; ///< null if nothing is cut away
  double MetersPerWorldUnit = 0.001;
};

/** Properties that all time steps of a volume share. */
struct TimeStepShape
{
  VolumeView View; ///< gives the layout only; its samples are not used
  Affine3 IndexToWorld;
  TimeStepSeries Series; ///< all time steps except its last one need displacements
  int KernelRadius;
  std::string Displacements; ///< name of the displacement array; empty if there is none
  OutsideSamples Outside;    ///< outside samples in each time step that have to be filled
};

/**
 * Converts a time step for a model. Returns false, with the reason and the cure in `error`, if the
 * time step has another shape or can't be touched.
 */
bool MakeVolumeTimeStep(const ImageTimeStep& read, const TimeStepShape& shape,
  VolumeTimeStep& timeStep, std::string& error);

/**
 * Returns a copy of a baked volume with other time steps, which may be of another region. Makes
 * only the meshes of SURFACE_PROXY that the time steps lack. Returns null if the time steps can't
 * be touched, or differ from the volume in their geometry or type of numbers.
 * @param displacements name of the displacement array; empty if there is none
 * @param outside outside samples in the time steps that have to be filled
 */
std::shared_ptr<const BakedVolume> GoOnWithTimeSteps(const BakedVolume& volume,
  const std::vector<ImageTimeStep>& timeSteps, const TimeStepSeries& series, int kernelRadius,
  const std::string& displacements, const OutsideSamples& outside);

/**
 * Bakes a model, which owns a reference to the scalar array. If the input can't be touched, returns
 * null, and names the input and the cure in `error`. Sets `notice` to a description of what was
 * guessed about the values; empty if nothing was.
 */
std::shared_ptr<const HapticModel> BuildHapticModel(vtkImageData* image, vtkDataArray* scalars,
  vtkHapticProperty* property, const HapticModelOptions& options, std::string& notice,
  std::string& error);

} // namespace VolumeHaptics

#endif
