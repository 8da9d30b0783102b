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
 * Plans by Core/Regions/RegionPlan.h for a hand: converts speeds to the world's units, and measures
 * the latency. Set the whole volume, then the lengths, which ConfigurePlanner() computes for a
 * filter. Not thread-safe.
 */
class VTKVOLUMEHAPTICS_EXPORT RegionPlanner
{
public:
  double MaximumSpeed = 0.5; ///< speed of the hand that a region allows for (m/s)
  double MetersPerWorldUnit = 0.001;
  ///@{
  /** See RegionNeeds (world units). */
  double SpringLength = 4.0;
  double Reach = 8.0;
  double Band = 4.0;
  ///@}

  /** Sets the whole volume: nine numbers of the direction, row by row. */
  void SetWhole(const int extent[6], const double origin[3], const double spacing[3],
    const double direction[9]);
  /**
   * Sets the whole volume from an image: the whole itself, or a region of it that
   * vtkHapticRegionFilter has made. False, with an error, if the field arrays are malformed.
   */
  bool SetWhole(vtkImageData* image, std::string& error);
  const WholeGeometry& GetWhole() const { return this->Whole; }

  /** Sets the largest number of voxels of a region, clamped to 4096 to 512^3. Default 128^3. */
  void SetMaximumVoxels(vtkIdType voxels);
  vtkIdType GetMaximumVoxels() const { return this->MaximumVoxels; }

  ///@{
  /**
   * The latency (s), from a plan to the moment at which the region can be felt: the smoothed value
   * of the measurements given to AddLatency. The first measurement counts fully. At most 10; 0.2
   * until there is a measurement. Numbers that are negative or not finite are ignored.
   */
  void AddLatency(double seconds);
  void ResetLatency();
  double GetLatency() const { return this->Latency; }
  ///@}

  /** Returns the half-width of the wanted region (world units), before it is cut. */
  double GetHalfWidth() const;
  /** See PlanRegion(). */
  bool Plan(
    const double tip[3], const double velocity[3], const int resident[6], int wanted[6]) const;
  /** See ComputeSpareRoom(). */
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
