// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Materials of a segmentation that is touched itself: the functions of a property map its label
 * numbers to materials.
 */
#ifndef ScalarLabels_h
#define ScalarLabels_h

class vtkDataArray;
class vtkHapticLabelTable;
class vtkHapticProperty;

namespace VolumeHaptics
{

/** Largest span of labels that gets a table. */
constexpr int MostScalarLabels = 1 << 16;

/**
 * Fills a table with a material for each whole number between the least and the largest sample,
 * including the background. False, with the table empty, if the samples can't be labels: several
 * components, values that are not finite, or a span of more than MostScalarLabels.
 */
bool FillScalarLabels(
  vtkDataArray* scalars, vtkHapticProperty* property, vtkHapticLabelTable* table);

} // namespace VolumeHaptics

#endif
