// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The tool of a filter, given as plain settings.
 */
#ifndef HapticToolChoice_h
#define HapticToolChoice_h

#include "vtkIndent.h"
#include "vtkType.h"
#include "vtkWeakPointer.h"

#include <iosfwd>
#include <string>

class vtkDataObject;
class vtkVolumeHapticsFilter;

/** See vtkPVVolumeHapticsFilter::SetToolKind. The shape of a shell comes from port 2. */
class HapticToolChoice
{
public:
  std::string Kind = "None";
  ///@{
  /** Settings of a needle. */
  std::string ShaftFriction;
  std::string CuttingForce;
  double LateralStrength = 1.0; ///< N
  ///@}
  ///@{
  /** Settings of a point shell. */
  int Points = 2000;
  double ContactArea = 25.0; ///< square world units
  ///@}
  ///@{
  /** Settings of a burr. */
  double BurrRadius = 2.0;    ///< world units
  double BurrSpeed = 60000.0; ///< 1/min
  std::string SpecificEnergy;
  ///@}

  /** Call after a setting has changed. */
  void Record() { this->IsDirty = true; }

  /** Makes the filter's tool if needed; returns the errors of a tool that can't be made. */
  std::string Fill(vtkVolumeHapticsFilter* filter);
  /** Whether the tool could be made. */
  bool IsGood() const { return this->IsMade; }

  void Print(std::ostream& os, vtkIndent indent) const;

private:
  void SetNeedle(vtkVolumeHapticsFilter* filter, std::string& error) const;
  void SetShell(vtkVolumeHapticsFilter* filter, std::string& error) const;
  void SetBurr(vtkVolumeHapticsFilter* filter, std::string& error) const;

  vtkWeakPointer<vtkDataObject> Shape; ///< shape of the last shell
  bool IsDirty = false;
  bool IsMade = true;
};

#endif
