// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Draws the chart of vtkHapticFunctionEditor: histogram, curve and control points.
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

/** Title and scale of the chart of a function. */
struct EditedQuantity
{
  const char* Title;
  double EmptyValue; // value of a function without points
  double Usual;      // top of the axis of a function whose values are all zero
  double Most;       // largest top of the axis; larger values feel the same
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
   * Shows the histogram of a component and the name of its array; `image` may be null. For a large
   * image, the histogram is first that of a subset of the samples, until PollCount() receives the
   * result of a worker that has counted all values.
   */
  void ShowData(vtkImageData* image, int component);
  bool ShowsData(vtkImageData* image, int component) const;
  void PollCount();
  /** Cancels the count of a previous image, because the program may delete it. */
  void EndCountUnless(vtkImageData* image);
  /** Returns the fraction of values that have been counted, 0 to 1. */
  double GetCountedFraction() const;
  ///@}

  ///@{
  /**
   * Shows edges behind the function instead of the histogram, with the boundaries from a proposed
   * property. ShowDistinctness() marks the gradient magnitudes (scalar units per world unit) where
   * distinctness begins and becomes full.
   */
  void ShowEdges(const EdgeHistogram& histogram, vtkHapticProperty* proposed);
  void HideEdges();
  bool ShowsEdges() const { return this->HasEdges; }
  void ShowDistinctness(double start, double full);
  ///@}

  /** Shows a second function as a dashed curve; null hides it. */
  void ShowProposed(vtkPiecewiseFunction* proposed) { this->ProposedFunction = proposed; }

  /** Shows the progress of a search for functions or edges, 0 to 1; 1 hides it. */
  void ShowSearch(double fraction) { this->SearchedFraction = fraction; }

  /** Shows a warning about the function; an empty text hides it. */
  void ShowWarning(const std::string& warning) { this->Warning = warning; }

  /** Returns the range of the histogram's data (scalar units). */
  const double* GetDataRange() const { return this->Data.Range; }

  /** Sets the conversion from scalars to values on the axis. */
  void ScaleValues(const ValueScale& scale);

  /** Shows a function; null hides it. The axes stay unchanged while a point is `dragged`. */
  void ShowFunction(vtkPiecewiseFunction* function, const EditedQuantity& quantity, bool dragged);

  /** Shows the tissues of a property as bands. Call this after ShowFunction. */
  void ShowTissues(vtkHapticProperty* property);

  /** Shows the reason why nothing is shown, in place of the title. */
  void ShowNothing(const char* reason) { this->Chart->SetTitle(reason); }

  /**
   * Handles a vtkCommand of the left button, or MouseMoveEvent, at a position in the viewport. The
   * left button also drags the axes: it moves the value axis and stretches the function's axis. A
   * double click on an axis fits both axes again.
   */
  void SendMouse(int event, int button, int x, int y);
  /**
   * Stretches an axis by turns of the wheel: the function's axis if the pointer is on it, otherwise
   * the value axis about the pointer.
   */
  void Turn(int x, int y, double steps);

  /** Computes the position of a point of the curve in the viewport. */
  void GetPosition(double x, double y, double position[2]);

private:
  void ShowCounts();
  void FitAxes(vtkPiecewiseFunction* function, const EditedQuantity& quantity);

  /** Axis under the mouse. */
  enum class AxisKind
  {
    None,
    Values,
    Function
  };
  AxisKind FindAxis(int x, int y);
  /**
   * Moves or stretches an axis by a mouse event. Returns false if the event does not concern an
   * axis.
   */
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
  vtkImageData* ShownImage = nullptr; // image on the chart; only compared, never dereferenced
  int ShownComponent = 0;
  vtkTimeStamp DataTime;
  // Array whose values are being counted; null when no count is running.
  vtkSmartPointer<vtkDataArray> Counted;
  KeyedWork<vtkMTimeType, ValueCounts> Counting;
  bool HasData = false;
  bool HasEdges = false;
  double SearchedFraction = 1.0;
  std::string Warning;
  vtkPiecewiseFunction* ProposedFunction = nullptr;
  ValueCounts Data;                   // histogram of the scalars
  double DataRange[2] = { 0.0, 1.0 }; // range of the histogram on the value axis
  ValueScale ToValue;
  double Range[2] = { 0.0, 1.0 };
  double Scale = 1.0;
  int Letters = 8; ///< font size (points)
  /** Whether the user has moved the value axis, which is then no longer fitted to the data. */
  bool HasChosenValues = false;
  /** Tops of the functions' axes that the user has chosen. */
  std::map<const EditedQuantity*, double> ChosenTops;
  AxisKind DraggedAxis = AxisKind::None;
  vtkVector2i LastMouse{ 0, 0 };
};

} // namespace VolumeHaptics

#endif
