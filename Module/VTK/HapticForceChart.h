// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The plot of the head-up display: forces against time on a dark panel.
 */
#ifndef HapticForceChart_h
#define HapticForceChart_h

#include "vtkNew.h"

class vtkBlockItem;
class vtkChartXY;
class vtkContextActor;
class vtkTable;

namespace VolumeHaptics
{

class HapticForceChart
{
public:
  HapticForceChart();
  ~HapticForceChart();

  /** Once, with the table of a HapticForceHistory; needs something to draw charts with. */
  void Build(vtkTable* table);
  /** From -span (s) to 0, and from 0 to a force (N). */
  void SetRanges(double span, double force);
  /** Whether there is anything to draw: VTK complains of lines without points. */
  void ShowCurves(bool shown);
  /** Into the lower left corner of a viewport of this size (pixels). */
  void Fit(int width, int height);

  vtkContextActor* GetActor() { return this->Actor; }

private:
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkContextActor> Actor;
};

} // namespace VolumeHaptics

#endif
