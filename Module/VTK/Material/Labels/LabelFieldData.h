// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and writes a label table as arrays of a vtkFieldData, with one tuple per label.
 *
 * | array | type | value if unset |
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
 * Only Label is required. NaN means the same as -1.
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
 * the entries unchanged. `standOff` stays empty if the data have none.
 */
bool ReadLabelFieldData(
  vtkFieldData* data, LabelEntries& entries, std::optional<double>& standOff, std::string& error);

/** Adds the arrays to `data`, and replaces existing arrays of the same names. */
void WriteLabelFieldData(const LabelEntries& entries, double standOff, vtkFieldData* data);

} // namespace VolumeHaptics

#endif
