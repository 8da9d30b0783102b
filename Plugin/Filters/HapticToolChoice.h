// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Makes the tool of a filter from plain settings.
 */
#ifndef HapticToolChoice_h
#define HapticToolChoice_h

#include "vtkIndent.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <iosfwd>
#include <map>
#include <string>

class vtkDataObject;
class vtkVolumeHapticsFilter;

/** See vtkPVVolumeHapticsFilter::SetToolKind. The shape of a point shell is on port 2. */
class HapticToolChoice
{
public:
  std::string Kind = "None";
  ///@{
  /** The settings of all kinds, by their names KIND.NAME: numbers, and functions as texts. */
  std::map<std::string, double> Numbers;
  std::map<std::string, std::string> Functions;
  ///@}

  /** Records that a setting has changed. */
  void Record() { this->IsDirty = true; }

  /**
   * Makes the filter's tool if anything has changed. Returns the error if the tool can't be made.
   */
  std::string Fill(vtkVolumeHapticsFilter* filter);
  /** Returns whether the tool could be made. */
  bool IsGood() const { return this->IsMade; }

  void Print(std::ostream& os, vtkIndent indent) const;

private:
  std::string Make(vtkVolumeHapticsFilter* filter) const;

  vtkWeakPointer<vtkDataObject> Shape; ///< shape of the point shell that was made last
  double Voxel = 0.0; ///< longest voxel edge for which the last burr was made; 0: no image
  bool IsDirty = false;
  bool IsMade = true;
};

#endif
