// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The functions that the edges of an image suggest (vtkHapticProperty::ProposeFromImage).
 */
#ifndef HapticProposal_h
#define HapticProposal_h

#include "Core/Proposal/MaterialProposal.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/SearchPart.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkHapticProperty;

namespace VolumeHaptics
{

/** A component of an image, as a search looks at it, perhaps on another thread. */
struct ProposalInput
{
  vtkSmartPointer<vtkImageData> Image; ///< an own one, with the arrays of the other
  int Component = 0;
  HapticVolume Volume;
};

/** False, with the reason and the cure in `error`, if there is nothing to look at. */
bool ReadProposalInput(
  vtkImageData* image, int component, ProposalInput& input, std::string& error);

/**
 * Looks at a bounded number of an image's voxels. False, with the reason and the cure in `error`,
 * if there is nothing to propose, or the search was cancelled.
 */
bool ProposeFromVolume(const ProposalInput& input, const SearchPart& part,
  MaterialProposal& proposal, std::string& error);

/** Sets the five functions of a property, in place, its side and its table of boundaries. */
void FillFromProposal(const MaterialProposal& proposal, vtkHapticProperty* property);

/** Sets the same from a property that was filled before. */
void CopyProposal(vtkHapticProperty* proposed, vtkHapticProperty* property);

} // namespace VolumeHaptics

#endif
