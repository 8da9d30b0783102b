// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * From vtkImageData and vtkHapticProperty to the core's HapticModel, with every check of the input.
 */
#ifndef HapticModelBuilder_h
#define HapticModelBuilder_h

#include "Core/Model/HapticModel.h"
#include "VTK/Baking/HapticFrames.h"
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
   * The kernel, the settings and the placement of the device; a radius of 0 is half a voxel. The
   * builder fills in the volume, the material and the settings of the property.
   */
  HapticModelDescription Description;
  HapticSurface* Surfaces = nullptr; ///< for HapticMethod::SurfaceProxy
  vtkPolyData* Surface = nullptr;    ///< or else the isosurface
  RegionSeries* Regions = nullptr;   ///< earlier models, if the image may be a region
  std::vector<HapticFrame> Frames;   ///< of a volume that moves; the image is at its first step
  std::string Displacements;         ///< the name of their array; empty if they have none
  FrameSeries Series;                ///< of which Frames are a part
  OutsideSamples Outside;            ///< of Frames, with which they are filled
  HapticModes Modes;                 ///< for HapticMethod::Primitives
  vtkHapticTool* Tool = nullptr;     ///< null for a point
  vtkHapticRemoval* Removal = nullptr;
  const HapticCut* Cut = nullptr; ///< null if nothing is cut away
  double MetersPerWorldUnit = 0.001;
};

/** The shape that all frames of a volume have. */
struct FrameShape
{
  VolumeView View; ///< the samples don't matter
  Affine3 IndexToWorld;
  FrameSeries Series; ///< frames before its end need displacements
  int KernelRadius;
  std::string Displacements; ///< the name of their array; empty if there are none
  OutsideSamples Outside;    ///< with which each frame is filled
};

/**
 * The frame of a model. False, with the reason and the cure in `error`, if it has another shape or
 * can't be touched.
 */
bool MakeVolumeFrame(
  const HapticFrame& read, const FrameShape& shape, VolumeFrame& frame, std::string& error);

/**
 * A baked volume with other frames of it, which may be of another region. Bakes nothing again but
 * the meshes of SURFACE_PROXY that the frames lack.
 * Null if the frames can't be touched, or are not alike: their geometry or their numbers.
 * @param displacements the name of their array; empty if there are none
 * @param outside with which the frames are filled
 */
std::shared_ptr<const BakedVolume> GoOnWithFrames(const BakedVolume& volume,
  const std::vector<HapticFrame>& frames, const FrameSeries& series, int kernelRadius,
  const std::string& displacements, const OutsideSamples& outside);

/**
 * Bakes a model that keeps the scalar array alive. If the input can't be touched, returns null, and
 * `error` names the input and the cure. `notice` says what was guessed about the values; empty if
 * nothing was.
 */
std::shared_ptr<const HapticModel> BuildHapticModel(vtkImageData* image, vtkDataArray* scalars,
  vtkHapticProperty* property, const HapticModelOptions& options, std::string& notice,
  std::string& error);

} // namespace VolumeHaptics

#endif
