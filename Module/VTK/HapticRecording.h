// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A recording of the servo loop: a trace with everything that replays it to the bit.
 *
 * Beyond the arrays of vtkVolumeHapticsFilter's output it has the point arrays `DeviceTip` (m),
 * `Command` (3; N, world axes: what the safety stage let through), `Tick`, `Enabled`, `Placement`,
 * `Buttons`, `Armed` and `Fault`, and the field arrays `DeviceToWorld` (16 a placement),
 * `InitialState`, `TickPeriod` (s), `Caps` (N/m and N s/m), `DeviceId`, `Settings`, `Units`, `VolumeHash` and `LostTicks`.
 */
#ifndef HapticRecording_h
#define HapticRecording_h

#include "ServoLoop.h"

#include "vtkSmartPointer.h"

#include <map>
#include <string>
#include <vector>

class vtkPolyData;

namespace VolumeHaptics
{

class HapticRecording
{
public:
  std::string DeviceId;
  std::string Settings;   ///< what the filter printed when the recording began
  std::string VolumeHash; ///< of the scalars that were touched
  std::uint64_t LostTicks = 0;

  /** The model of a generation that the loop may use from now on. */
  void AddModel(std::uint64_t generation, std::shared_ptr<const HapticModel> model);
  void Append(const ServoSnapshot& snapshot) { this->Ticks.push_back(snapshot); }
  std::size_t GetNumberOfTicks() const { return this->Ticks.size(); }

  /** Ticks without a model are left out: there was no world to be in. */
  vtkSmartPointer<vtkPolyData> MakeTrace() const;

private:
  std::vector<ServoSnapshot> Ticks;
  std::map<std::uint64_t, std::shared_ptr<const HapticModel>> Models;
};

} // namespace VolumeHaptics

#endif
