// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Compares the materials that are proposed for real scans
 * (vtkHapticProperty::ProposeFromImage) with those that the scans' units imply.
 */
#ifndef Evaluation_Proposals_h
#define Evaluation_Proposals_h

#include "Figure.h"
#include "Table.h"

class vtkImageData;

namespace evaluation
{

/**
 * Adds the boundaries of a scan's proposal to a table of MakeProposalTable(). Returns false, with
 * VTK's error, if the proposal has none.
 */
bool AddProposal(const char* scan, vtkImageData* image, Table& table);

Table MakeProposalTable();

/**
 * Counts the boundaries of a head CT that are missing from its proposal: skin, from air (below -900
 * HU) to soft tissue (-50 to 100 HU), and skull, from soft tissue to bone (above 400 HU).
 */
Figure CountMissingBoundaries(vtkImageData* head);

} // namespace evaluation

#endif
