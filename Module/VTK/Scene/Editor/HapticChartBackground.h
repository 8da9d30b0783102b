// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Draws the background of a HapticFunctionChart: edges and tissues.
 */
#ifndef HapticChartBackground_h
#define HapticChartBackground_h

#include "VTK/Material/FunctionSearch.h"
#include "VTK/Scene/Editor/HapticValueScale.h"

#include "vtkNew.h"
#include "vtkPlot.h"

#include <array>
#include <string>
#include <vector>

class vtkContext2D;
class vtkHapticProperty;
class vtkImageData;
class vtkRectf;

/**
 * Draws the edges of a volume behind a function.
 *
 * The edges are a two-dimensional histogram of value (horizontal) and gradient magnitude
 * (vertical). Over it are the arc of each boundary, and lines at the gradient magnitudes where
 * distinctness begins and becomes full. The vertical axis runs from 0 to 1, as in the other plots
 * of HapticFunctionChart.
 */
class HapticEdgePlot : public vtkPlot
{
public:
  static HapticEdgePlot* New();
  vtkTypeMacro(HapticEdgePlot, vtkPlot);

  /** Shows a histogram, and the boundaries that a property has proposed. `proposed` may be null. */
  void ShowEdges(const VolumeHaptics::EdgeHistogram& histogram, vtkHapticProperty* proposed);

  /** Sets the conversion from scalars to values on the axis. */
  void ScaleValues(const VolumeHaptics::ValueScale& scale);

  /**
   * Shows the gradient magnitudes at which distinctness begins and becomes full (scalar units per
   * world unit).
   */
  void ShowDistinctness(double start, double full);

  ///@{
  /** Draw the plot or compute its bounds; called by the chart. */
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
    double Fraction; // gradient magnitude, as a fraction of the largest one shown
  };
  /**
   * Applies the plot's shift and scale to a scalar, so that single precision suffices for its
   * position.
   */
  float Scaled(double scalar);
  void DrawLine(vtkContext2D* painter, const std::vector<ArcPoint>& points);

  vtkNew<vtkImageData> Picture;
  std::vector<std::vector<ArcPoint>> Arcs;
  double Values[2] = { 0.0, 1.0 }; // range of the shown scalars
  VolumeHaptics::ValueScale ToValue;
  double MostSlope = 1.0;
  double Distinctness[2] = { 0.0, 0.0 };
};

/**
 * Draws the tissues of a property as named bands behind a function.
 *
 * The first tissue extends to the left end of the axis, and the last one to the right end, because
 * functions are constant beyond the tissues. In a narrow band, the name is vertical, or omitted if
 * there is no space for it.
 */
class HapticTissueBands : public vtkPlot
{
public:
  static HapticTissueBands* New();
  vtkTypeMacro(HapticTissueBands, vtkPlot);

  /**
   * Shows the tissues of a property; none if it is null. `toValue` converts scalars to values on
   * the axis. `range`: ends of the axis. `letters`: font size of the names.
   */
  void Show(vtkHapticProperty* property, const VolumeHaptics::ValueScale& toValue,
    const double range[2], int letters);

  ///@{
  /** Draw the bands or compute their bounds; called by the chart. */
  bool Paint(vtkContext2D* painter) override;
  void GetBounds(double bounds[4]) override;
  ///@}

protected:
  HapticTissueBands();
  ~HapticTissueBands() override;

private:
  HapticTissueBands(const HapticTissueBands&) = delete;
  void operator=(const HapticTissueBands&) = delete;

  struct Band
  {
    std::string Name;
    double Low;
    double High;
    std::array<double, 3> Color;
  };
  void PaintName(vtkContext2D* painter, const Band& band, const vtkRectf& place) const;

  std::vector<Band> Bands;
  double Range[2] = { 0.0, 1.0 };
  int Letters = 10;
};

#endif
