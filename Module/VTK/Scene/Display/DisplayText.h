// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state and the feel of a device, in words.
 */
#ifndef DisplayText_h
#define DisplayText_h

#include "VTK/Scene/Display/HapticModeList.h"

#include <string>
#include <vector>

class vtkHapticDevice;
class vtkHapticMeasurements;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Returns the first sentence of a running device's status; for faults and requests to the hand, two
 * lines. Empty for a virtual device that only runs.
 */
std::string DescribeStatus(vtkHapticDevice* device);

/**
 * Whether the hand has slid within the last 0.2 s. A mouse leads the hand by steps, and the hand
 * rests between them for most of the time.
 */
class LateSlide
{
public:
  /** Records a tick at a time (s) with a contact as in vtkHapticState::GetContact(). */
  void Add(double time, int contact)
  {
    this->Last = time < this->Now ? -1.0e300 : this->Last; // another session
    this->Now = time;
    this->Last = contact == 2 ? time : this->Last;
  }
  bool Is() const { return this->Now - this->Last < 0.2; }
  void Clear() { *this = LateSlide(); }

private:
  double Now = 0.0;
  double Last = -1.0e300;
};

/**
 * Returns a text such as "Resting on skin, 0.62 N of at most 10 N"; empty while nothing is touched.
 * The tissue may be empty. If the hand `slid` in the last moments, a rest counts as sliding. For an
 * inserted needle, a line such as "Needle 12.3 deep in fat, 0.62 N of at most 10 N", and a second
 * line: "20 degrees from upright, 3 layers, forbidden tissue touched 1 time"; the depth is in world
 * units, the angle is measured from the normal of the surface. For a tool with a shape, the torque
 * follows: "turned by 3.1 N mm". Modes have no surface to rest on: "Held, 0.62 N".
 */
std::string DescribeTouch(vtkHapticDevice* device, const std::string& tissue, bool slid);

/** Returns whether the faces of a cut are felt, in words; empty if nothing is cut away. */
std::string DescribeCut(vtkHapticDevice* device);

/** Returns the value in the surface, on the scale of the functions of the touched property. */
double ComputeFeltValue(vtkHapticDevice* device);

/** Returns the value in the surface, if there is one, and the timing of the servo. */
std::string DescribeDetails(vtkHapticDevice* device);

/** Returns the filter whose modes are felt; null for other methods. */
vtkVolumeHapticsFilter* GetModesFilter(vtkHapticDevice* device);
/** Returns the names of all modes, each one unique. */
std::vector<std::string> NameModes(vtkHapticDevice* device);
/** Returns the names of active modes; the names of inactive modes are empty. */
std::vector<std::string> NameActiveModes(vtkHapticDevice* device);
/** Returns a line for each mode, with its force. */
std::vector<ModeLine> DescribeModeForces(vtkHapticDevice* device);
/** Returns the names and values of measurements, one a line, and what is being measured. */
std::string ListMeasurements(vtkHapticMeasurements* measurements);
/** Returns a line on the time of a moving volume; empty for other volumes. */
std::string DescribeTime(vtkHapticDevice* device);

} // namespace VolumeHaptics

#endif
