// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Plans which region of a large or remote volume to fetch, and when.
 */
#ifndef RegionPlanner_h
#define RegionPlanner_h

#include "Core/Regions/RegionPlan.h"

#include "vtkType.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string>

class vtkImageData;

namespace VolumeHaptics
{

/**
 * Plans regions for a hand, following Core/Regions/RegionPlan.h: converts speeds to the world's
 * units, and measures the latency. First set the whole volume, then the lengths from
 * ConfigurePlanner(). Not thread-safe.
 */
class VTKVOLUMEHAPTICS_EXPORT RegionPlanner
{
public:
  double MaximumSpeed = 0.5; ///< largest speed (m/s) of the hand that regions are planned for
  double MetersPerWorldUnit = 0.001;
  ///@{
  /** Lengths in world units: see RegionNeeds. */
  double SpringLength = 4.0;
  double Reach = 8.0;
  double Band = 4.0;
  ///@}

  /** Sets the whole volume; the nine numbers of the direction are row by row. */
  void SetWhole(const int extent[6], const double origin[3], const double spacing[3],
    const double direction[9]);
  /**
   * Sets the whole volume from an image, which is the whole itself or a region from
   * vtkHapticRegionFilter. Returns false, with an error, if the field arrays are malformed.
   */
  bool SetWhole(vtkImageData* image, std::string& error);
  const WholeGeometry& GetWhole() const { return this->Whole; }

  /** Sets the largest number of voxels in a region, clamped to 4096 to 512^3. Default 128^3. */
  void SetMaximumVoxels(vtkIdType voxels);
  vtkIdType GetMaximumVoxels() const { return this->MaximumVoxels; }

  ///@{
  /**
   * Latency (s) from a plan until the region can be felt. AddLatency adds a measurement to the
   * smoothed value; the first measurement replaces the initial 0.2. At most 10. Ignores numbers
   * that are negative or not finite.
   */
  void AddLatency(double seconds);
  void ResetLatency();
  double GetLatency() const { return this->Latency; }
  ///@}

  /**
   * Returns the half-width (world units) of the wanted region, before it is clipped to the volume.
   */
  double GetHalfWidth() const;
  /** Plans the next region for the tip: see PlanRegion(). */
  bool Plan(
    const double tip[3], const double velocity[3], const int resident[6], int wanted[6]) const;
  /** Returns how much room a region has around the tip: see ComputeSpareRoom(). */
  double ComputeRoom(const double tip[3], const int region[6]) const;

private:
  RegionNeeds ComputeNeeds() const;

  WholeGeometry Whole;
  vtkIdType MaximumVoxels = 2097152;
  double Latency = RegionNeeds{}.Latency;
  bool HasLatency = false;
};

} // namespace VolumeHaptics

#endif
