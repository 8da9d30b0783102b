// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The functions that the edges of an image suggest (vtkHapticProperty::ProposeFromImage).
 */
#ifndef HapticProposal_h
#define HapticProposal_h

#include "Core/Proposal/MaterialProposal.h"

#include <string>

class vtkHapticProperty;
class vtkImageData;

namespace VolumeHaptics
{

/**
 * Looks at a bounded number of an image's voxels, on all cores. False, with the reason and the cure
 * in `error`, if there is nothing to propose.
 */
bool ProposeFromVolume(
  vtkImageData* image, int component, MaterialProposal& proposal, std::string& error);

/** Sets the five functions of a property, in place, its side and its table of boundaries. */
void FillFromProposal(const MaterialProposal& proposal, vtkHapticProperty* property);

/** Sets the same from a property that was filled before. */
void CopyProposal(vtkHapticProperty* proposed, vtkHapticProperty* property);

} // namespace VolumeHaptics

#endif
