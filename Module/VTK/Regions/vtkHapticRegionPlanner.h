// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHapticRegionPlanner
 * @brief   plans which region of a remote volume the hand needs next, and when
 *
 * Plans which region of a volume to fetch, and when. From the position and velocity of the tip,
 * Plan computes the wanted region, and whether to fetch it now, before the tip can leave the
 * resident region:
 *
 *   planner->SetWholeExtent(...); planner->SetOrigin(...); planner->SetSpacing(...);
 *   haptics->ConfigurePlanner(planner); // SpringLength, Reach, Band, MetersPerWorldUnit
 *   ... in the GUI's timer ...
 *   if (planner->Plan(device->GetState()->GetTipPosition(), velocity, resident, wanted))
 *   {
 *     ... fetch it: vtkHapticRegionFilter's Region where the data are; then give it to the filter,
 *     and Publish ...
 *     planner->AddLatency(seconds);     // from Plan to Publish
 *   }
 *
 * The wanted region is a cube around the position that the tip will have when the region comes. It
 * is so wide that no hand slower than MaximumSpeed leaves it during the Latency:
 * Documentation/method.md, "Regions of a volume", has the equation. The region is clipped to the
 * whole, and cut to MaximumVoxels. A cut region lies less far ahead, so that a hand that stops
 * still has its data. If the whole has at most MaximumVoxels, the region is the whole. A region is
 * fetched as soon as the tip has less than half the room in the resident region that it would have
 * in the wanted region, so that a resting hand fetches nothing.
 *
 * Not thread-safe: belongs to one thread.
 *
 * @sa vtkHapticRegionFilter, vtkHapticDevice
 */
#ifndef vtkHapticRegionPlanner_h
#define vtkHapticRegionPlanner_h

#include "vtkObject.h"
#include "vtkVolumeHapticsModule.h" // for export macro

class vtkImageData;

class VTKVOLUMEHAPTICS_EXPORT vtkHapticRegionPlanner : public vtkObject
{
public:
  static vtkHapticRegionPlanner* New();
  vtkTypeMacro(vtkHapticRegionPlanner, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The extent of the whole volume. Default (0, -1, 0, -1, 0, -1): none. */
  vtkSetVector6Macro(WholeExtent, int);
  vtkGetVector6Macro(WholeExtent, int);
  ///@}

  ///@{
  /** The origin of the whole volume, as that of vtkImageData. Default (0, 0, 0). */
  vtkSetVector3Macro(Origin, double);
  vtkGetVector3Macro(Origin, double);
  ///@}

  ///@{
  /** The spacing of the whole volume (world units). Default (1, 1, 1). */
  vtkSetVector3Macro(Spacing, double);
  vtkGetVector3Macro(Spacing, double);
  ///@}

  ///@{
  /** The direction of the whole volume: nine numbers, row by row. Default: the identity. */
  void SetDirection(const double direction[9]) VTK_SIZEHINT(9);
  vtkGetVectorMacro(Direction, double, 9);
  ///@}

  /**
   * Set all of the above from an image: the whole itself, or a region of it that
   * vtkHapticRegionFilter has made. Returns false and reports an error if it is null or its field
   * arrays are malformed.
   */
  bool SetWhole(vtkImageData* image);

  ///@{
  /** The speed of the hand that the region allows for (m/s), 0 to 10. Default 0.5. */
  vtkSetClampMacro(MaximumSpeed, double, 0.0, 10.0);
  vtkGetMacro(MaximumSpeed, double);
  ///@}

  ///@{
  /** Metres per world unit, 1e-12 to 1e12. Default 0.001. */
  vtkSetClampMacro(MetersPerWorldUnit, double, 1e-12, 1e12);
  vtkGetMacro(MetersPerWorldUnit, double);
  ///@}

  ///@{
  /**
   * The largest distance by which the proxy lags behind the tip (world units), 0 to 1e12. Default
   * 4. See vtkVolumeHapticsFilter::ConfigurePlanner.
   */
  vtkSetClampMacro(SpringLength, double, 0.0, 1e12);
  vtkGetMacro(SpringLength, double);
  ///@}

  ///@{
  /**
   * How far from tip and proxy samples are read (world units), 0 to 1e12. Default 8. See
   * vtkVolumeHapticsFilter::ConfigurePlanner.
   */
  vtkSetClampMacro(Reach, double, 0.0, 1e12);
  vtkGetMacro(Reach, double);
  ///@}

  ///@{
  /**
   * The width of the band over which the force fades at the region's borders (world units), 0 to
   * 1e12. Default 4. See vtkVolumeHapticsFilter::ConfigurePlanner.
   */
  vtkSetClampMacro(Band, double, 0.0, 1e12);
  vtkGetMacro(Band, double);
  ///@}

  ///@{
  /** The most voxels of a region, 4096 to 134217728 (512^3). Default 2097152, that is, 128^3. */
  vtkSetClampMacro(MaximumVoxels, vtkIdType, 4096, 134217728);
  vtkGetMacro(MaximumVoxels, vtkIdType);
  ///@}

  ///@{
  /**
   * The latency (s) that is used for planning: the time from a plan to the moment at which the
   * region can be felt. AddLatency smooths measurements of it. The first measurement counts fully.
   * Of later ones, a longer one counts half, a shorter one a tenth. Numbers that are negative or
   * not finite are ignored. At most 10. Default 0.2, until there is a measurement. ResetLatency
   * discards all measurements.
   */
  void AddLatency(double seconds);
  void ResetLatency();
  vtkGetMacro(Latency, double);
  ///@}

  /** Get half the width of the wanted region (world units) before it is cut. */
  double GetHalfWidth();

  /**
   * Compute the wanted region (an extent) for a tip (world) with a velocity (world units per
   * second). Returns whether to fetch it now. `resident` is the extent of the region that is in
   * memory or ordered; if there is none, an empty extent such as (0, -1, 0, -1, 0, -1). The wanted
   * region is always within the whole, and is empty only if the whole is empty.
   */
  bool Plan(const double tip[3], const double velocity[3], const int resident[6], int wanted[6]);

  /**
   * Compute the room (world units) that a tip (world) has in a region (an extent), beyond the sum
   * of SpringLength, Reach and Band that its tick needs. If the result is negative, samples may be
   * missing there.
   */
  double FindRoom(const double tip[3], const int region[6]);

protected:
  vtkHapticRegionPlanner() = default;
  ~vtkHapticRegionPlanner() override = default;

  int WholeExtent[6] = { 0, -1, 0, -1, 0, -1 };
  double Origin[3] = { 0.0, 0.0, 0.0 };
  double Spacing[3] = { 1.0, 1.0, 1.0 };
  double Direction[9] = { 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0 };
  double MaximumSpeed = 0.5;
  double MetersPerWorldUnit = 0.001;
  double SpringLength = 4.0;
  double Reach = 8.0;
  double Band = 4.0;
  vtkIdType MaximumVoxels = 2097152;
  double Latency = 0.2;
  bool HasLatency = false;

private:
  vtkHapticRegionPlanner(const vtkHapticRegionPlanner&) = delete;
  void operator=(const vtkHapticRegionPlanner&) = delete;
};

#endif
