// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The materials of a segmentation that is touched itself: those that the functions of a property
 * give to the numbers of its labels.
 */
#ifndef ScalarLabels_h
#define ScalarLabels_h

class vtkDataArray;
class vtkHapticLabelTable;
class vtkHapticProperty;

namespace VolumeHaptics
{

/** The largest span of labels that has a table. */
constexpr int MostScalarLabels = 1 << 16;

/**
 * Fills a table with a material for each whole number between the least and the largest sample, the
 * background included. False, with the table empty, if the samples can't be labels: several
 * components, values that are not finite, or that span more than MostScalarLabels.
 */
bool FillScalarLabels(
  vtkDataArray* scalars, vtkHapticProperty* property, vtkHapticLabelTable* table);

} // namespace VolumeHaptics

#endif
