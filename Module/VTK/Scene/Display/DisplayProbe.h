// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Gives tests access to what the displays have drawn.
 */
#ifndef DisplayProbe_h
#define DisplayProbe_h

#include "vtkSmartPointer.h"
#include "vtkType.h"
#include "vtkVolumeHapticsModule.h" // for export macro

#include <string>

class vtkHapticHeadUpDisplay;
class vtkHapticMeasurementRepresentation;
class vtkTable;

namespace VolumeHaptics
{

struct VTKVOLUMEHAPTICS_EXPORT DisplayProbe
{
  /** Returns the number of states in the plot. */
  static vtkIdType CountStates(vtkHapticHeadUpDisplay* display);
  /**
   * Returns a copy of the plotted columns: Time (s, up to 0), Normal, Friction, Drag and Whole (N),
   * and one for each mode of PRIMITIVES. Each has the smallest and the largest value in each of a
   * few hundred intervals.
   */
  static vtkSmartPointer<vtkTable> CopyPlot(vtkHapticHeadUpDisplay* display);
  /** Returns the upper end of the force axis (N). */
  static double GetForceRange(vtkHapticHeadUpDisplay* display);
  /** Returns the title of the plot, which is the method's name. */
  static std::string GetPlotTitle(vtkHapticHeadUpDisplay* display);

  /** Returns the number of labels that were drawn in the last frame. */
  static int CountLabels(vtkHapticMeasurementRepresentation* measurements);
};

} // namespace VolumeHaptics

#endif
