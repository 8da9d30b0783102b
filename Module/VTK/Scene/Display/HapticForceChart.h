// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Forces against time: the last seconds over a scene, or a whole trace on a page.
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
    Panel, ///< small and dark, in the lower left corner of a viewport
    Page   ///< white, all of a viewport, with letters that grow with it
  };

  /** The ends of the axes. */
  struct Extent
  {
    double From = 0.0; ///< s
    double To = 0.0;
    double Force = 0.0; ///< N, from 0 on
  };

  /** A stretch of time (s), and the name of the action in it. */
  struct Phase
  {
    std::string Name;
    double From;
    double To;
  };

  explicit HapticForceChart(Ground ground);
  ~HapticForceChart();

  /** Makes the chart. Call it once, as soon as charts can be drawn. */
  void Build();
  /**
   * Draws the curves of modes, too, which then replace all parts of the force. Call it after Build,
   * with the names of HapticForceTable::SetModes; an empty name leaves its curve out.
   */
  void SetModes(const std::vector<std::string>& names);
  /** Returns the size of a panel in a viewport of this size, with its left and lower margins. */
  static std::array<int, 2> PanelSize(int width, int height, double scale = 1.0);
  /**
   * Fits the chart into a viewport of this size (pixels); `from` is the lower left corner of a
   * panel with its margins. Returns whether the chart changes.
   */
  bool Fit(int width, int height, const std::array<int, 2>& from = { 0, 0 }, double scale = 1.0);
  /**
   * Adapts the look to a light background, on which a panel covers more. Returns whether the chart
   * changes.
   */
  bool SetOnLight(bool isOnLight);
  /** Returns the upper right corner of the chart (pixels). */
  const int* GetCorner() const { return this->Corner; }
  /**
   * Draws a HapticForceTable, and above it a title, if there is one. Call Fit first. Returns
   * whether the chart changes.
   */
  bool Show(vtkTable* table, const Extent& extent, const std::string& title);
  /** Names the phases above the chart and draws lines between them. Call it once, after Show. */
  void ShowPhases(const std::vector<Phase>& phases);

  vtkContextActor* GetActor() { return this->Actor; }

private:
  void SetLetters(int size);
  void SetTitle(const std::string& title);
  /** Writes the names of the shown curves above a panel. */
  void NameCurves();
  vtkPlot* AddLine(int curve);

  const Ground On;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  vtkNew<HapticCurveNames> Names; ///< labels above a panel; a page has a title and a legend
  vtkNew<vtkContextActor> Actor;
  vtkNew<vtkTable> Lines[HapticForceTable::MostCurves]; ///< the fewest points that give the same
                                                        ///< picture
  vtkPlot* Plots[HapticForceTable::MostCurves] = {};    ///< null before SetModes
  std::vector<std::string> Modes;
  double Scale = 1.0; ///< pixels for each point
  bool IsOnLight = false;
  int Viewport[2] = { 0, 0 }; ///< pixels, like the next three members
  std::array<int, 2> From{ 0, 0 };
  int Corner[2] = { 0, 0 };
  double Height = 1.0;
  vtkTable* Shown = nullptr; ///< the drawn table
  vtkMTimeType ShownTime = 0;
  Extent ShownExtent;
  std::string ShownTitle;
};

} // namespace VolumeHaptics

#endif
