// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Fetches the region around the tip of a volume on a server, for a filter in the client.
 */
#ifndef HapticRegionLink_h
#define HapticRegionLink_h

#include "VTK/Regions/RegionPlanner.h"

#include "vtkSmartPointer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <string>

class vtkHapticDevice;
class vtkImageData;
class vtkSMHapticRegionProxy;
class vtkSMSourceProxy;
class vtkVolumeHapticsFilter;

namespace VolumeHapticsLive
{
class HapticTimeStepLink;

/**
 * Fetches regions. The first request returns a corner of the volume, and with it the position of
 * the whole. The servo can start with the corner, because a tip outside it feels nothing. The
 * planner determines all further requests.
 */
class HapticRegionLink
{
public:
  enum class Answer
  {
    Nothing, ///< nothing was fetched, because all required samples are present
    Region,  ///< a region was fetched
    /**
     * the server refused; GetProblem() returns the reason, and no new request is sent until
     * something changes
     */
    Refused,
    Lost ///< the server does not answer
  };

  /**
   * Fetch at most one region, if the planner requests it for the device's latest state. `time` is
   * the time at which the volume was updated. If the volume has several times, the region of the
   * next time is fetched as soon as the servo has reached the time of the last region. While the
   * servo moves between two times, regions of both are fetched.
   */
  Answer Poll(vtkSMSourceProxy* volume, unsigned int port, double time,
    vtkVolumeHapticsFilter* filter, vtkHapticDevice* device, HapticTimeStepLink& timeSteps);

  /**
   * Returns the time (s) from the need for a region until its arrival; 0 before the first region.
   */
  double GetLatency() const { return this->HasLatency ? this->Planner.GetLatency() : 0.0; }
  /** Returns the reason why the last region was refused. */
  const std::string& GetProblem() const { return this->Problem; }

  /**
   * Sets the largest number of voxels of a region. If the number is new, a refused region is
   * requested again.
   */
  void SetMaximumVoxels(vtkIdType voxels)
  {
    const vtkIdType before = this->Planner.GetMaximumVoxels(); // limited by the planner
    this->Planner.SetMaximumVoxels(voxels);
    this->IsRefused = this->IsRefused && this->Planner.GetMaximumVoxels() == before;
  }
  void Clear();

private:
  bool Update(vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter);
  Answer Fetch(const int region[6], double time, vtkImageData* image);
  Answer FetchFirst(const int region[6], double time, vtkVolumeHapticsFilter* filter,
    vtkHapticDevice* device, HapticTimeStepLink& timeSteps);
  Answer FetchTimeSteps(
    const int region[6], double time, vtkHapticDevice* device, HapticTimeStepLink& timeSteps);
  void RecordLatency(double start);
  void MeasureVelocity(vtkHapticDevice* device);

  VolumeHaptics::RegionPlanner Planner;
  vtkSmartPointer<vtkSMHapticRegionProxy> Proxy;
  vtkWeakPointer<vtkSMSourceProxy> Volume;
  unsigned int Port = 0;
  vtkWeakPointer<vtkVolumeHapticsFilter> Filter;
  std::string Array;
  std::string Problem;
  std::array<int, 6> Resident = { 0, -1, 0, -1, 0, -1 };
  std::array<double, 3> Tip = {};
  std::array<double, 3> Velocity = {};
  double Time = 0.0;
  double PollTime = 0.0; // time of the last Poll() (s), on this computer's clock
  double Interval = 0.0; // time between the last two calls of Poll() (s)
  vtkMTimeType SettingsTime = 0;
  bool IsSurveyed = false;
  bool HasImage = false;
  bool HasLatency = false;
  bool IsRefused = false;
  bool IsMoving = false;     // whether the volume has times
  bool HasTimeSteps = false; // whether time steps have begun since the position was last requested
  double ViewTime = 0.0;     // time of the view for which the server's volume was updated
};

} // namespace VolumeHapticsLive

#endif
