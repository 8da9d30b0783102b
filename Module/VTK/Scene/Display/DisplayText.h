// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes in words the state of a device and what the hand feels.
 */
#ifndef DisplayText_h
#define DisplayText_h

#include "VTK/Scene/Display/HapticModeList.h"

#include <string>
#include <vector>

class vtkHapticDevice;
class vtkHapticMeasurements;
class vtkHapticProperty;
class vtkVolumeHapticsFilter;

namespace VolumeHaptics
{

/**
 * Returns the first sentence of a running device's status. A fault or a request to the hand adds a
 * second line. Empty while a virtual device runs normally.
 */
std::string DescribeStatus(vtkHapticDevice* device);

/**
 * Detects whether the hand has slid within the last 0.2 s. The time is needed because a mouse moves
 * the hand in steps, between which the hand mostly rests.
 */
class LateSlide
{
public:
  /**
   * Records a tick: its time (s), its contact as from vtkHapticState::GetContact(), and the
   * distance (m) that the hand moved since the previous tick. The distance is needed because a
   * contact at the limit of its friction may also rest.
   */
  void Add(double time, int contact, double moved)
  {
    constexpr double least = 0.0005;                       // m/s
    this->Last = time < this->Now ? -1.0e300 : this->Last; // a new session has begun
    const bool slides = contact == 2 && moved >= least * (time - this->Now);
    this->Now = time;
    this->Last = slides ? time : this->Last;
    this->IsKnown = true;
  }
  /**
   * Returns whether the hand slid within the last 0.2 s. Before the first tick, returns whether
   * `contact`, the current contact, is at the limit of its friction.
   */
  bool Is(int contact) const { return this->IsKnown ? this->Now - this->Last < 0.2 : contact == 2; }
  void Clear() { *this = LateSlide(); }

private:
  bool IsKnown = false;
  double Now = 0.0;
  double Last = -1.0e300;
};

/**
 * Returns a text such as "Resting on skin, 0.62 N of at most 10 N"; empty while nothing is touched.
 * `tissue` may be empty. `slides`: whether a hand in contact slides instead of resting. For an
 * inserted needle, the text is a line such as "Needle 12.3 mm deep in fat, 0.62 N of at most 10 N",
 * and a second line: "20 degrees from upright, 3 layers, forbidden tissue touched 1 time". The
 * angle is measured from the normal of the surface. For a tool with a shape, the torque follows:
 * "turned by 3.1 N mm". Modes have no surface to rest on, so the text is "Held, 0.62 N".
 */
std::string DescribeTouch(vtkHapticDevice* device, const std::string& tissue, bool slides);

/** Returns a text on whether the faces of a cut are felt; empty if nothing is cut away. */
std::string DescribeCut(vtkHapticDevice* device);

/** Returns the volume's value at the surface, on the scale of the touched property's functions. */
double ComputeFeltValue(vtkHapticDevice* device);

/**
 * Returns the value that identifies the touched tissue, on the scale of ComputeFeltValue(). It is
 * read two voxels below the surface, because values at the surface are blends of both sides.
 */
double ComputeTissueValue(vtkHapticDevice* device);

/**
 * Returns the name of the property's tissue that contains a value or is nearest to it. Empty if the
 * property has no tissues.
 */
std::string NameTissue(vtkHapticProperty* property, double value);

/** Returns a text with the value at a touched surface and the timing of the servo. */
std::string DescribeDetails(vtkHapticDevice* device);

/** Returns the filter whose modes are felt; null for methods without modes. */
vtkVolumeHapticsFilter* GetModesFilter(vtkHapticDevice* device);
/** Returns the names of all modes, made unique. */
std::vector<std::string> NameModes(vtkHapticDevice* device);
/** Returns the names of all modes, with empty names for inactive modes. */
std::vector<std::string> NameActiveModes(vtkHapticDevice* device);
/** Returns one line per mode, with its force. */
std::vector<ModeLine> DescribeModeForces(vtkHapticDevice* device);
/**
 * Returns the names and values of measurements, one per line, and a line for the measurement in
 * progress.
 */
std::string ListMeasurements(vtkHapticMeasurements* measurements);
/** Returns a line on the current time of a moving volume; empty for other volumes. */
std::string DescribeTime(vtkHapticDevice* device);

/**
 * Returns the name of the label at a position (world) from the filter's label table, or "label 5"
 * if the table has no name for it. Empty without a label image, outside of it, or if the label is
 * not in the table.
 */
std::string NameLabelAt(vtkVolumeHapticsFilter* filter, const double position[3]);

} // namespace VolumeHaptics

#endif
