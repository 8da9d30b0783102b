// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The plot of the head-up display: forces against time on a dark panel.
 */
#ifndef HapticForceChart_h
#define HapticForceChart_h

#include "VTK/Charts/HapticForceHistory.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <string>

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

  /** Once; needs something to draw charts with. */
  void Build();
  /** Into the lower left corner of a viewport of this size (pixels). */
  void Fit(int width, int height);
  /** The corner of the viewport that it takes up (pixels). */
  const int* GetExtent() const { return this->Extent; }
  /**
   * The table of a HapticForceHistory, from -span (s) to 0 and from 0 to a force (N). After Fit.
   * Above it a title, where there is one. Returns whether the chart changes.
   */
  bool Show(vtkTable* table, double span, double force, const std::string& title);

  vtkContextActor* GetActor() { return this->Actor; }

private:
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkTable> Lines[HapticForceHistory::Curves]; ///< as few points as look the same
  int Viewport[2] = { 0, 0 };                         ///< pixels, as the next two
  int Extent[2] = { 0, 0 };
  double Height = 1.0;
  vtkTable* Shown = nullptr; ///< what the lines were made of
  vtkMTimeType ShownTime = 0;
  double ShownForce = 0.0;
  double ShownSpan = 0.0;
  std::string ShownTitle;
};

} // namespace VolumeHaptics

#endif
