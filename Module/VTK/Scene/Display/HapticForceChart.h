// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws forces against time: the last seconds over a scene, or a whole trace on a page.
 */
#ifndef HapticForceChart_h
#define HapticForceChart_h

#include "VTK/Scene/Display/HapticForceTable.h"

#include "vtkNew.h"
#include "vtkType.h"

#include <array>
#include <string>
#include <vector>

class HapticCurveNames;
class vtkBlockItem;
class vtkChartXY;
class vtkContextActor;
class vtkPlot;
class vtkTable;

namespace VolumeHaptics
{

class HapticForceChart
{
public:
  enum class Ground
  {
    Panel, ///< small and dark, at the bottom of a viewport
    Page   ///< white, fills a viewport, with letters that grow with the viewport
  };

  /** Range of the axes. */
  struct Extent
  {
    double From = 0.0; ///< start of the shown time span (s)
    double To = 0.0;
    double Force = 0.0; ///< upper end of the force axis (N), which begins at 0
  };

  /** A time span (s) with the name of the action in it. */
  struct Phase
  {
    std::string Name;
    double From;
    double To;
  };

  explicit HapticForceChart(Ground ground);
  ~HapticForceChart();

  /** Makes the chart. Call this once, when charts can be drawn. */
  void Build();
  /**
   * Adds curves of modes, which replace the parts of the force. Call this after Build with the
   * names of HapticForceTable::SetModes. A mode with an empty name gets no curve.
   */
  void SetModes(const std::vector<std::string>& names);
  /**
   * Returns the width and height of a panel, including its left and lower margins, in a viewport of
   * this size.
   */
  static std::array<int, 2> PanelSize(int width, int height, double scale = 1.0);
  /**
   * Fits the chart into a viewport of this size (pixels). `from` is the lower left corner of a
   * panel with its margins. Returns whether the chart has changed.
   */
  bool Fit(int width, int height, const std::array<int, 2>& from = { 0, 0 }, double scale = 1.0);
  /**
   * Adapts the colours to the background; on a light one, the panel is more opaque. Returns whether
   * the chart has changed.
   */
  bool SetOnLight(bool isOnLight);
  /** Returns the upper right corner of the chart (pixels). */
  const int* GetCorner() const { return this->Corner; }
  /**
   * Draws a HapticForceTable, with a title above it unless that is empty. Call Fit first. Returns
   * whether the chart has changed.
   */
  bool Show(vtkTable* table, const Extent& extent, const std::string& title);
  /**
   * Draws the names of the phases above the chart, and lines between them. Call this once, after
   * Show.
   */
  void ShowPhases(const std::vector<Phase>& phases);

  vtkContextActor* GetActor() { return this->Actor; }

private:
  void SetLetters(int size);
  void SetTitle(const std::string& title);
  /** Sets the names that are drawn above a panel to those of the shown curves. */
  void NameCurves();
  vtkPlot* AddLine(int curve);

  const Ground On;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  /** Names above the curves of a panel; a page has a title and a legend instead. */
  vtkNew<HapticCurveNames> Names;
  vtkNew<vtkContextActor> Actor;
  /** Curves reduced to the fewest points that look the same. */
  vtkNew<vtkTable> Lines[HapticForceTable::MostCurves];
  vtkPlot* Plots[HapticForceTable::MostCurves] = {}; ///< null before SetModes
  std::vector<std::string> Modes;
  double Scale = 1.0; ///< pixels per point
  bool IsOnLight = false;
  int Viewport[2] = { 0, 0 }; ///< pixels, like the next three members
  std::array<int, 2> From{ 0, 0 };
  int Corner[2] = { 0, 0 };
  double Height = 1.0;
  vtkTable* Shown = nullptr; ///< last table drawn
  vtkMTimeType ShownTime = 0;
  Extent ShownExtent;
  std::string ShownTitle;
};

} // namespace VolumeHaptics

#endif
