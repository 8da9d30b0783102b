// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The device that the tool uses, and the streams between the tool and its user.
 */
#ifndef ToolDevice_h
#define ToolDevice_h

#include <vtkHapticDevice.h>
#include <vtkNew.h>
#include <vtkVolumeHapticsFilter.h>

#include <iosfwd>

struct ToolStreams
{
  std::istream& In;
  std::ostream& Out;
  std::ostream& Errors;

  /// Shows a request to the user, and waits for Enter. Returns false and reports an error if the
  /// input ends first.
  bool AskForEnter(const char* wish);
};

/// A device that writes its errors to a stream, in readable form.
class ToolDevice
{
public:
  explicit ToolDevice(std::ostream& errors);
  vtkHapticDevice* operator->() { return this->Device; }
  vtkHapticDevice* Get() { return this->Device; }
  vtkVolumeHapticsFilter* GetVolume() { return this->Volume; }
  /// Returns the number of errors and warnings so far.
  int CountComplaints() const { return this->Complaints; }

private:
  std::ostream& Errors;
  int Complaints = 0;
  vtkNew<vtkVolumeHapticsFilter> Volume;
  vtkNew<vtkHapticDevice> Device;
};

/// Pushes gently along each axis, until it is clear whether the device moves in the direction of
/// the force.
bool ConfirmSigns(ToolDevice& device, const char* id, ToolStreams streams);
/** Describes whether the user's device file stores facts about the open device. */
const char* DescribeMemory(ToolDevice& device);

#endif
