// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes the state of a device, and what the hand feels, in words.
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
 * Returns the first sentence of a running device's status; for faults and requests to the hand,
 * also a second line. Empty while a virtual device runs normally.
 */
std::string DescribeStatus(vtkHapticDevice* device);

/**
 * Whether the hand has slid within the last 0.2 s. The time is needed because a mouse moves the
 * hand in steps, between which the hand mostly rests.
 */
class LateSlide
{
public:
  /**
   * Records a tick: its time (s), its contact as vtkHapticState::GetContact() returns it, and the
   * distance (m) of the hand from where it was in the tick before. A contact at the limit of its
   * friction may rest, too.
   */
  void Add(double time, int contact, double moved)
  {
    constexpr double least = 0.0005;                       // m/s
    this->Last = time < this->Now ? -1.0e300 : this->Last; // a new session began
    const bool slides = contact == 2 && moved >= least * (time - this->Now);
    this->Now = time;
    this->Last = slides ? time : this->Last;
    this->IsKnown = true;
  }
  /**
   * Returns whether the hand slid within the last 0.2 s. Before the first tick was added, returns
   * whether `contact`, the current one, is at the limit of its friction.
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
 * `tissue` may be empty. `slides` says whether a hand in contact slides or rests.
 * For an inserted needle, the text is a line such as "Needle 12.3 mm deep in fat, 0.62 N of at most
 * 10 N", and a second line: "20 degrees from upright, 3 layers, forbidden tissue touched 1 time".
 * The angle is measured from the normal of the surface.
 * For a tool with a shape, the torque follows: "turned by 3.1 N mm". Modes have no surface to rest
 * on, so the text is "Held, 0.62 N".
 */
std::string DescribeTouch(vtkHapticDevice* device, const std::string& tissue, bool slides);

/** Says in words whether the faces of a cut are felt; empty if nothing is cut away. */
std::string DescribeCut(vtkHapticDevice* device);

/**
 * Returns the value of the volume at the surface, on the scale of the functions of the touched
 * property.
 */
double ComputeFeltValue(vtkHapticDevice* device);

/**
 * Returns the value that names the touched tissue: two voxels below the surface, because the values
 * of the surface itself are blends of both sides. On the scale of ComputeFeltValue().
 */
double ComputeTissueValue(vtkHapticDevice* device);

/**
 * Returns the name of a value in the tissues of a property: of the range that contains it, or else
 * of the nearest one. Empty if the property has none.
 */
std::string NameTissue(vtkHapticProperty* property, double value);

/** Returns the value at the surface, if a surface is touched, and the timing of the servo. */
std::string DescribeDetails(vtkHapticDevice* device);

/** Returns the filter whose modes are felt; null for other methods. */
vtkVolumeHapticsFilter* GetModesFilter(vtkHapticDevice* device);
/** Returns unique names of all modes. */
std::vector<std::string> NameModes(vtkHapticDevice* device);
/** Returns the names of active modes; the names of inactive modes are empty. */
std::vector<std::string> NameActiveModes(vtkHapticDevice* device);
/** Returns a line for each mode, with its force. */
std::vector<ModeLine> DescribeModeForces(vtkHapticDevice* device);
/**
 * Returns the names and values of measurements, one per line, and a line for the measurement in
 * progress.
 */
std::string ListMeasurements(vtkHapticMeasurements* measurements);
/** Describes the current time of a moving volume in a line; empty for other volumes. */
std::string DescribeTime(vtkHapticDevice* device);

/**
 * Returns the name of the label at a position (world): from the filter's label table, or "label 5"
 * if the table has no name for the label. Empty if there is no label image, if the position is
 * outside of it, or if the table does not know the label.
 */
std::string NameLabelAt(vtkVolumeHapticsFilter* filter, const double position[3]);

} // namespace VolumeHaptics

#endif
