// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * What a device does and feels, in words.
 */
#ifndef DisplayText_h
#define DisplayText_h

#include <string>

class vtkHapticDevice;

namespace VolumeHaptics
{

/**
 * The first sentence of a running device's status, or of a fault and of a request to the hand two
 * lines. Empty for a virtual device that only runs.
 */
std::string DescribeStatus(vtkHapticDevice* device);

/**
 * Whether the hand has slid within the last 0.2 s. A mouse leads it by steps, between which it
 * rests for most of the time.
 */
class LateSlide
{
public:
  /** A tick at a time (s) with a contact as of vtkHapticDevice::GetContact(). */
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
 * Such as "Resting on skin, 0.62 N of at most 10 N"; empty while nothing is touched. The tissue may
 * be empty. A hand that rests now, but `slid` lately, slides. Of an inserted needle, such as
 * "Needle 12.3 deep in fat, 0.62 N of at most 10 N", and a second line: "20 degrees from upright,
 * 3 layers, forbidden tissue touched 1 time"; its depth is in world units, its angle that to the
 * normal of the surface. Of a tool with a shape, the torque follows: "turned by 3.1 N mm". Where
 * modes are felt, none of which is a surface, nothing is rested on: "Held, 0.62 N".
 */
std::string DescribeTouch(vtkHapticDevice* device, const std::string& tissue, bool slid);

/** Whether the faces of a cut hold; empty if nothing is cut away. */
std::string DescribeCut(vtkHapticDevice* device);

/** The value in the surface, as the functions of the touched property have it. */
double FindFeltValue(vtkHapticDevice* device);

/** The value in the surface, if there is one, and how the servo keeps time. */
std::string DescribeDetails(vtkHapticDevice* device);

} // namespace VolumeHaptics

#endif
