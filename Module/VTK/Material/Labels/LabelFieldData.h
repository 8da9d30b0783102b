// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and writes a table of labels as arrays of a vtkFieldData, with a tuple for each
 * label.
 *
 * | array | type | where nothing is set |
 * | --- | --- | --- |
 * | Label | integer | - |
 * | LabelName | string | "" |
 * | LabelColor | 3 components, 0 to 1 | -1 |
 * | LabelStiffness (N/m), LabelFriction | number | -1 |
 * | LabelViscosity (N), LabelSurfaceStrength (N) | number | -1 |
 * | LabelShaftFriction (N per metre) | number | -1 |
 * | LabelSpecificEnergy (J/mm^3) | number | -1 |
 * | LabelFelt, LabelForbidden | 1 or 0 | -1 |
 * | LabelStandOff (world units) | number; one tuple in all | - |
 *
 * Only Label is needed. NaN means the same as -1.
 */
#ifndef LabelFieldData_h
#define LabelFieldData_h

#include "VTK/Material/Labels/LabelEntry.h"

#include <optional>
#include <string>

class vtkFieldData;

namespace VolumeHaptics
{

/**
 * Reads the arrays. On failure, returns false, with the reason and the cure in `error`, and leaves
 * the entries unchanged. If the data have no stand-off, `standOff` has no value.
 */
bool ReadLabelFieldData(
  vtkFieldData* data, LabelEntries& entries, std::optional<double>& standOff, std::string& error);

/** Adds the arrays, replacing existing arrays of the same names. */
void WriteLabelFieldData(const LabelEntries& entries, double standOff, vtkFieldData* data);

} // namespace VolumeHaptics

#endif
