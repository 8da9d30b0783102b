// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads and writes tables of labels as CSV (RFC 4180); the first line names the columns.
 *
 *   label,name,stiffness,friction,viscosity,strength,felt,forbidden,color
 *   5,liver,300,0.1,0.5,1.5,1,0,#dd8265
 *   52,aorta,,,,,1,1,
 *
 * Only the column label is required; the order of the columns is free. Columns with other names are
 * ignored, and an empty cell sets nothing. Cells are separated by commas, tabs or semicolons. If
 * they are separated by semicolons, numbers may have decimal commas.
 *
 * | column | also called | cells |
 * | --- | --- | --- |
 * | label | labelvalue, index, id, value | whole numbers |
 * | name | labelname, structure | texts |
 * | stiffness | | N/m |
 * | friction | | 0 or more |
 * | viscosity | | N |
 * | strength | surfacestrength | N |
 * | shaft | shaftfriction | N per metre of a needle's shaft |
 * | energy | specificenergy | J/mm^3, to remove the tissue |
 * | felt, forbidden | | 1 or 0, true or false, yes or no |
 * | color | colour | #rrggbb; or three numbers, from 0 to 1 or from 0 to 255, with blanks between |
 * | red, green, blue | r, g, b | the same numbers |
 *
 * Case, blanks and underscores in a column's name do not matter, nor does a unit in parentheses.
 */
#ifndef CsvLabels_h
#define CsvLabels_h

#include "VTK/Material/Labels/LabelEntry.h"

#include <string>
#include <string_view>

namespace VolumeHaptics
{

/**
 * Returns whether the first non-empty line has at least two cells, one of which is a title of the
 * label column.
 */
bool IsCsv(std::string_view text);

/**
 * Reads a table. If the text can't be read, returns false, with the reason and the cure in `error`,
 * and leaves the entries unchanged.
 */
bool ReadCsv(std::string_view text, LabelEntries& entries, std::string& error);

/** Writes a table that ReadCsv restores bit by bit. */
std::string WriteCsv(const LabelEntries& entries);

} // namespace VolumeHaptics

#endif
