// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef HapticBaker_h
#define HapticBaker_h

#include "vtkVolumeHapticsFilter.h"

#include <memory>

namespace VolumeHaptics
{

/**
 * Makes models of a filter and what is connected to it, for those who tick on them: the device, and
 * the search for a surface under the mouse. Models are no part of the filter's public interface.
 */
class HapticBaker
{
public:
  explicit HapticBaker(vtkVolumeHapticsFilter* filter)
    : Filter(filter)
  {
  }

  /**
   * Brings port 0 up to date and bakes it, with the property and all settings, for a servo that
   * ticks at a rate (Hz) and drives a device with caps of its own. The matrix takes the servo's
   * device space (m) to the world; nullptr stands for the world scaled by MetersPerWorldUnit.
   * Returns null after an error.
   */
  std::shared_ptr<const HapticModel> Bake(
    double rate, const ForceCaps& deviceCaps, vtkMatrix4x4* deviceToWorld) const
  {
    return this->Filter->Bake(rate, deviceCaps, deviceToWorld);
  }

  /**
   * About how long (s) Bake() would take now on a desktop computer, not counting the pipeline
   * before the filter. It takes time only to make the mesh of SURFACE_PROXY, and 0 if the mesh is
   * up to date.
   */
  double EstimateTime() const { return this->Filter->EstimateBakeTime(); }

  /** The same of vtkVolumeHapticsFilter::HashScalars(). */
  double EstimateHashTime() const { return this->Filter->EstimateHashTime(); }

private:
  vtkVolumeHapticsFilter* const Filter;
};

} // namespace VolumeHaptics

#endif
