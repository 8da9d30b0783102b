// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The chart of vtkHapticFunctionEditor: histogram, curve and control points.
 */
#ifndef HapticFunctionChart_h
#define HapticFunctionChart_h

#include "Core/Realtime/BackgroundWork.h"
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

/** The title and the scale of a function's chart. */
struct EditedQuantity
{
  const char* Title;
  double EmptyValue; // value of a function without points
  double Usual;      // top of the axis if all values are zero
  double Most;       // largest top of the axis, because larger values feel the same
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
   * Shows the histogram of a component and the name of its array; `image` may be null. Of a large
   * image, the histogram shows spread samples at first, until PollCount() finds that a thread has
   * counted all values.
   */
  void ShowData(vtkImageData* image, int component);
  bool ShowsData(vtkImageData* image, int component) const;
  void PollCount();
  /** Ends the count of a previous image, because the program may delete it. */
  void EndCountUnless(vtkImageData* image);
  /** Returns the fraction of the values that have been counted, 0 to 1. */
  double GetCountedFraction() const;
  ///@}

  ///@{
  /**
   * Shows edges behind the function instead of the histogram, with the boundaries of a proposed
   * property. ShowDistinctness() sets the range of gradient magnitudes that are felt (scalar units
   * per world unit).
   */
  void ShowEdges(const EdgeHistogram& histogram, vtkHapticProperty* proposed);
  void HideEdges();
  bool ShowsEdges() const { return this->HasEdges; }
  void ShowDistinctness(double start, double full);
  ///@}

  /** Shows a second function, dashed; null shows none. */
  void ShowProposed(vtkPiecewiseFunction* proposed) { this->ProposedFunction = proposed; }

  /** Shows the finished fraction of a search for functions or edges. 1 stands for no search. */
  void ShowSearch(double fraction) { this->SearchedFraction = fraction; }

  /** Shows a warning about the function; empty shows none. */
  void ShowWarning(const std::string& warning) { this->Warning = warning; }

  /** Returns the range of the data (scalar units). */
  const double* GetDataRange() const { return this->Data.Range; }

  /** Sets the scale that converts scalars to the values of the axis. */
  void ScaleValues(const ValueScale& scale);

  /**
   * Shows a function; null shows none. While a point is dragged (`dragged`), the axes stay
   * unchanged.
   */
  void ShowFunction(vtkPiecewiseFunction* function, const EditedQuantity& quantity, bool dragged);

  /** Shows the tissues of a property as bands; call it after ShowFunction. */
  void ShowTissues(vtkHapticProperty* property);

  /** Shows a text in place of the title, because there is nothing to show. */
  void ShowNothing(const char* reason) { this->Chart->SetTitle(reason); }

  /**
   * Handles a vtkCommand of the left button, or MouseMoveEvent, at a position in the viewport. The
   * left button also drags the axes: it moves the axis of values, and stretches the axis of the
   * function. A double click on an axis fits both axes again.
   */
  void SendMouse(int event, int button, int x, int y);
  /**
   * Stretches an axis by turns of the wheel: the function's axis if the pointer is on it, otherwise
   * the axis of values about the pointer.
   */
  void Turn(int x, int y, double steps);

  /** Computes where a point of the curve is in the viewport. */
  void GetPosition(double x, double y, double position[2]);

private:
  void ShowCounts();
  void FitAxes(vtkPiecewiseFunction* function, const EditedQuantity& quantity);

  /** The axis under the mouse, next to the curves. */
  enum class AxisKind
  {
    None,
    Values,
    Function
  };
  AxisKind FindAxis(int x, int y);
  /** Moves or stretches an axis by a mouse event. Returns true if the event was for an axis. */
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
  vtkImageData* ShownImage = nullptr; // the image of the chart; only compared, never dereferenced
  int ShownComponent = 0;
  vtkTimeStamp DataTime;
  // the array whose values are being counted; null after the count
  vtkSmartPointer<vtkDataArray> Counted;
  KeyedWork<vtkMTimeType, ValueCounts> Counting;
  bool HasData = false;
  bool HasEdges = false;
  double SearchedFraction = 1.0;
  std::string Warning;
  vtkPiecewiseFunction* ProposedFunction = nullptr;
  ValueCounts Data;                   // the histogram of the scalars
  double DataRange[2] = { 0.0, 1.0 }; // range of the histogram on the axis of values
  ValueScale ToValue;
  double Range[2] = { 0.0, 1.0 };
  double Scale = 1.0;
  int Letters = 8; ///< size of letters (points)
  /** whether the user has moved the axis of values; then it is not fitted to the data */
  bool HasChosenValues = false;
  /** tops of the functions' axes that the user has chosen */
  std::map<const EditedQuantity*, double> ChosenTops;
  AxisKind DraggedAxis = AxisKind::None;
  vtkVector2i LastMouse{ 0, 0 };
};

} // namespace VolumeHaptics

#endif
