// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The chart of vtkHapticFunctionEditor: histogram, curve and control points.
 */
#ifndef HapticFunctionChart_h
#define HapticFunctionChart_h

#include "VTK/Base/BackgroundWork.h"
#include "VTK/Scene/Base/HapticHistogram.h"
#include "VTK/Scene/Editor/HapticChartBackground.h"
#include "VTK/Scene/Editor/HapticValueScale.h"

#include "vtkBlockItem.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkDataArray.h"
#include "vtkNew.h"
#include "vtkPlotBar.h"
#include "vtkPlotLine.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"
#include "vtkVector.h"

#include <map>
#include <string>

class HapticControlPointsItem;
class vtkHapticProperty;
class vtkImageData;
class vtkPiecewiseFunction;
class vtkTable;

namespace VolumeHaptics
{

/** The label and the scale of a function's chart. */
struct EditedQuantity
{
  const char* Title;
  double EmptyValue; // value of a function without points
  double Usual;      // top of the axis if all values are zero
  double Most;       // largest top of the axis; larger differences can't be felt
};

/** A scene that accepts mouse events from any caller, not only from vtkContextInteractorStyle. */
class OpenContextScene : public vtkContextScene
{
public:
  static OpenContextScene* New();
  vtkTypeMacro(OpenContextScene, vtkContextScene);
  using vtkContextScene::ButtonPressEvent;
  using vtkContextScene::ButtonReleaseEvent;
  using vtkContextScene::DoubleClickEvent;
  using vtkContextScene::MouseMoveEvent;
};

class HapticFunctionChart
{
public:
  HapticFunctionChart();
  ~HapticFunctionChart();

  vtkContextActor* GetActor() { return this->Actor; }

  /** Sets the rectangle in pixels of the viewport: x, y, width, height. */
  void Place(const int rectangle[4], double scale = 1.0);

  ///@{
  /**
   * Shows the histogram of a component and the name of its array; an image may be null. The
   * histogram of a large image shows spread samples at first, until PollCount() finds that all
   * values were counted in the background.
   */
  void ShowData(vtkImageData* image, int component);
  bool ShowsData(vtkImageData* image, int component) const;
  void PollCount();
  /** Ends the count of a previous image, which the program may delete. */
  void EndCountUnless(vtkImageData* image);
  /** Returns the fraction of the values that is counted, 0 to 1. */
  double GetCountedFraction() const;
  ///@}

  ///@{
  /**
   * Shows edges behind the function instead of the histogram of values, with the boundaries of a
   * proposed property, and the range of felt gradient magnitudes (scalar units per world unit).
   */
  void ShowEdges(const EdgeHistogram& histogram, vtkHapticProperty* proposed);
  void HideEdges();
  bool ShowsEdges() const { return this->HasEdges; }
  void ShowDistinctness(double start, double full);
  ///@}

  /** Shows a second, dashed function, or none. */
  void ShowProposed(vtkPiecewiseFunction* proposed) { this->ProposedFunction = proposed; }

  /** Shows the finished fraction of a search for functions or edges; 1: no search. */
  void ShowSearch(double fraction) { this->SearchedFraction = fraction; }

  /** Shows an error of the function; empty: no error. */
  void ShowWarning(const std::string& warning) { this->Warning = warning; }

  /** Returns the range of the data (scalar units). */
  const double* GetDataRange() const { return this->Data.Range; }

  /** Sets which values the axis shows for the scalars. */
  void ScaleValues(const ValueScale& scale);

  /** Shows a function, or none; while it is dragged the axes stay unchanged. */
  void ShowFunction(vtkPiecewiseFunction* function, const EditedQuantity& quantity, bool dragged);

  /** Shows the tissues of a property as bands; call it after ShowFunction. */
  void ShowTissues(vtkHapticProperty* property);

  /** Shows a text instead of a title. */
  void ShowNothing(const char* reason) { this->Chart->SetTitle(reason); }

  /**
   * Passes on a vtkCommand of the left button, or MouseMoveEvent, at a position in the viewport.
   * The left button drags the axes, too: it moves the axis of values, and stretches the axis of the
   * function; a double click on an axis fits both again.
   */
  void SendMouse(int event, int button, int x, int y);
  /**
   * Stretches by the wheel the axis of values about a position, or the axis of the function under
   * it.
   */
  void Turn(int x, int y, double steps);

  /** Computes the position in the viewport of a point of the curve. */
  void GetPosition(double x, double y, double position[2]);

private:
  void ShowCounts();
  void FitAxes(vtkPiecewiseFunction* function, const EditedQuantity& quantity);

  /** The axis under the mouse, beside the area of the curves. */
  enum class AxisKind
  {
    None,
    Values,
    Function
  };
  AxisKind FindAxis(int x, int y);
  /** Moves the axes by a mouse event. True if the event was for an axis. */
  bool MoveAxes(int event, int button, int x, int y);
  void ChooseValues(double from, double to);
  void ChooseTop(double top);
  void SetAxes(double from, double to, double scale);
  void DrawCurve(vtkPiecewiseFunction* function, const EditedQuantity& quantity, vtkTable* table,
    vtkPlotLine* curve);

  vtkNew<vtkContextActor> Actor;
  vtkNew<OpenContextScene> Scene;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkPlotBar> Bars;
  vtkNew<HapticEdgePlot> Edges;
  vtkNew<HapticTissueBands> Bands;
  vtkNew<vtkPlotLine> Proposed;
  vtkNew<vtkPlotLine> Curve;
  vtkNew<HapticControlPointsItem> Points;
  vtkNew<vtkTable> BarTable;
  vtkNew<vtkTable> ProposedTable;
  vtkNew<vtkTable> CurveTable;

  const EditedQuantity* Shown = nullptr;
  vtkImageData* ShownImage = nullptr; // never dereferenced, only compared
  int ShownComponent = 0;
  vtkTimeStamp DataTime;
  vtkSmartPointer<vtkDataArray> Counted; // counted array, while its values are counted
  KeyedWork<vtkMTimeType, ValueCounts> Counting;
  bool HasData = false;
  bool HasEdges = false;
  double SearchedFraction = 1.0;
  std::string Warning;
  vtkPiecewiseFunction* ProposedFunction = nullptr;
  ValueCounts Data;                   // counts of scalars
  double DataRange[2] = { 0.0, 1.0 }; // counts on the axis of values
  ValueScale ToValue;
  double Range[2] = { 0.0, 1.0 };
  double Scale = 1.0;
  int Letters = 8;              ///< points
  bool HasChosenValues = false; ///< whether the user has moved the axis of values, so that it stays
  std::map<const EditedQuantity*, double> ChosenTops; ///< functions' axes that the user has chosen
  AxisKind DraggedAxis = AxisKind::None;
  vtkVector2i LastMouse{ 0, 0 };
};

} // namespace VolumeHaptics

#endif
