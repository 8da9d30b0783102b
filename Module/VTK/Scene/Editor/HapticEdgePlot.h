// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   HapticEdgePlot
 * @brief   the edges of a volume behind a function
 *
 * A two-dimensional histogram, value to the right and gradient magnitude upwards, with the arc of
 * each boundary in it and a line where distinctness begins and is full. Its vertical axis runs from
 * 0 to 1, as in the other plots of HapticFunctionChart.
 */
#ifndef HapticEdgePlot_h
#define HapticEdgePlot_h

#include "VTK/Material/EdgeHistogram.h"
#include "VTK/Scene/Editor/HapticValueScale.h"

#include "vtkNew.h"
#include "vtkPlot.h"

#include <vector>

class vtkContext2D;
class vtkHapticProperty;
class vtkImageData;

class HapticEdgePlot : public vtkPlot
{
public:
  static HapticEdgePlot* New();
  vtkTypeMacro(HapticEdgePlot, vtkPlot);

  /**
   * Shows a histogram, with the boundaries that a property has proposed; `proposed` may be null.
   */
  void ShowEdges(const VolumeHaptics::EdgeHistogram& histogram, vtkHapticProperty* proposed);

  /** Sets which values the axis shows for the scalars. */
  void ScaleValues(const VolumeHaptics::ValueScale& scale);

  /**
   * The gradient magnitudes at which distinctness begins and becomes full (scalar units per world
   * unit).
   */
  void ShowDistinctness(double start, double full);

  ///@{
  /** Called by the chart. */
  bool Paint(vtkContext2D* painter) override;
  void GetBounds(double bounds[4]) override;
  ///@}

protected:
  HapticEdgePlot();
  ~HapticEdgePlot() override;

private:
  HapticEdgePlot(const HapticEdgePlot&) = delete;
  void operator=(const HapticEdgePlot&) = delete;

  struct ArcPoint
  {
    double Value;
    double Share; // relative to the largest shown gradient magnitude
  };
  /** A scalar in VTK's scale for single precision. */
  float Scaled(double scalar);
  void DrawLine(vtkContext2D* painter, const std::vector<ArcPoint>& points);

  vtkNew<vtkImageData> Picture;
  std::vector<std::vector<ArcPoint>> Arcs;
  double Values[2] = { 0.0, 1.0 }; // scalars
  VolumeHaptics::ValueScale ToValue;
  double MostSlope = 1.0;
  double Distinctness[2] = { 0.0, 0.0 };
};

#endif
