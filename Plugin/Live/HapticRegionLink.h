// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The region of a server's volume that is around a tip, for a filter in the client.
 */
#ifndef HapticRegionLink_h
#define HapticRegionLink_h

#include "vtkHapticRegionPlanner.h"
#include "vtkNew.h"
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

/**
 * At first it asks for the position of the volume: a corner of it comes, with which the servo may
 * start, since a tip that is not in the corner feels nothing. From then on it asks for the regions
 * that vtkHapticRegionPlanner plans.
 */
class HapticRegionLink
{
public:
  enum class Answer
  {
    Nothing, ///< all that is needed is here
    Region,  ///< the filter has another image
    Refused, ///< the problem says why; it is not asked for again before something changes
    Lost     ///< the server does not answer
  };

  /** Fetch a region, one at most, if the planner wants it for the device's latest state. */
  Answer Poll(vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter,
    vtkHapticDevice* device);

  /** How long (s) it takes from when a region is wanted to when it is here; 0 before the first. */
  double GetLatency() const { return this->HasLatency ? this->Planner->GetLatency() : 0.0; }
  /** Why the last one was refused. */
  const std::string& GetProblem() const { return this->Problem; }

  void SetMaximumVoxels(vtkIdType voxels) { this->Planner->SetMaximumVoxels(voxels); }
  /** The volume may be another one. */
  void Forget();
  void Clear();

private:
  bool Follow(vtkSMSourceProxy* volume, unsigned int port, vtkVolumeHapticsFilter* filter);
  Answer Fetch(const int region[6], vtkVolumeHapticsFilter* filter);
  void MeasureVelocity(vtkHapticDevice* device);

  vtkNew<vtkHapticRegionPlanner> Planner;
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
  double PollTime = 0.0; // s, of this computer
  double Interval = 0.0; // s, from one call of Poll to the next
  vtkMTimeType SettingsTime = 0;
  bool IsSurveyed = false;
  bool HasImage = false;
  bool HasLatency = false;
  bool IsRefused = false;
};

} // namespace VolumeHapticsLive

#endif
