// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Proposes functions from the edges of an image (vtkHapticProperty::ProposeFromImage).
 */
#ifndef HapticProposal_h
#define HapticProposal_h

#include "Core/Proposal/MaterialProposal.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Material/EdgeSearch.h"

#include "vtkImageData.h"
#include "vtkSmartPointer.h"

#include <string>

class vtkHapticProperty;

namespace VolumeHaptics
{

/** A component of an image, in the form that a search reads, perhaps on another thread. */
struct ProposalInput
{
  vtkSmartPointer<vtkImageData> Image; ///< a new image that shares the arrays of the user's image
  int Component = 0;
  HapticVolume Volume;
};

/**
 * Reads the input. Returns false, with the reason and the cure in `error`, if there is nothing to
 * search.
 */
bool ReadProposalInput(
  vtkImageData* image, int component, ProposalInput& input, std::string& error);

/**
 * Examines a limited number of an image's voxels. Returns false, with the reason and the cure in
 * `error`, if there is nothing to propose, or if the search was cancelled.
 */
bool ProposeFromVolume(const ProposalInput& input, const SearchPart& part,
  MaterialProposal& proposal, std::string& error);

/** Sets the five functions of a property in place, its side, and its table of boundaries. */
void FillFromProposal(const MaterialProposal& proposal, vtkHapticProperty* property);

/** Copies to a property what FillFromProposal() has set in `proposed`. */
void CopyProposal(vtkHapticProperty* proposed, vtkHapticProperty* property);

} // namespace VolumeHaptics

#endif
