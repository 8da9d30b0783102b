// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The rows of the paper's table 1 as charts: visual on the left, haptic on the right.
 */
#ifndef Evaluation_TransferCharts_h
#define Evaluation_TransferCharts_h

class vtkContextScene;
class vtkHapticProperty;
class vtkVolumeProperty;

namespace evaluation
{

/** Adds three rows of two charts that fill a scene of a given size in pixels. */
void AddTransferCharts(vtkContextScene* scene, vtkVolumeProperty* look, vtkHapticProperty* feel,
  double width, double height);

} // namespace evaluation

#endif
