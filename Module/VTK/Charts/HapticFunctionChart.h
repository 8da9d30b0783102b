// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The chart of vtkHapticFunctionEditor: histogram, curve and control points.
 */
#ifndef HapticFunctionChart_h
#define HapticFunctionChart_h

#include "VTK/Charts/HapticControlPointsItem.h"

#include "vtkBlockItem.h"
#include "vtkChartXY.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkNew.h"
#include "vtkPlotBar.h"
#include "vtkPlotLine.h"
#include "vtkTable.h"
#include "vtkTimeStamp.h"
#include "vtkVector.h"

class vtkImageData;

namespace VolumeHaptics
{

/** How the chart of a function is labelled and scaled. */
struct EditedQuantity
{
  const char* Title;
  double EmptyValue; // that a function without points stands for
  double Usual;      // top of the axis where all values are zero
  double Most;       // top of the axis at most; beyond, differences can't be felt
};

/** A scene that takes events of the mouse from anybody, not only from vtkContextInteractorStyle. */
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

  vtkContextActor* GetActor() { return this->Actor; }

  /** In pixels of the viewport: x, y, width, height. */
  void Place(const int rectangle[4]);

  ///@{
  /** The histogram of a component and the name of its array; an image may be null. */
  void ShowData(vtkImageData* image, int component);
  bool ShowsData(vtkImageData* image, int component) const;
  ///@}

  /** A function, or null; while it is dragged the axes stay as they are. */
  void ShowFunction(vtkPiecewiseFunction* function, const EditedQuantity& quantity, bool dragged);

  /** A text instead of a title. */
  void ShowNothing(const char* reason) { this->Chart->SetTitle(reason); }

  /** A vtkCommand of the left button, or MouseMoveEvent, at a place in the viewport. */
  void SendMouse(int event, int button, int x, int y);

  /** Where a point of the curve is in the viewport. */
  void GetPosition(double x, double y, double position[2]);

private:
  void FitAxes(vtkPiecewiseFunction* function, const EditedQuantity& quantity);
  void DrawCurve(vtkPiecewiseFunction* function, const EditedQuantity& quantity);

  vtkNew<vtkContextActor> Actor;
  vtkNew<OpenContextScene> Scene;
  vtkNew<vtkBlockItem> Panel;
  vtkNew<vtkChartXY> Chart;
  vtkNew<vtkPlotBar> Bars;
  vtkNew<vtkPlotLine> Curve;
  vtkNew<HapticControlPointsItem> Points;
  vtkNew<vtkTable> BarTable;
  vtkNew<vtkTable> CurveTable;

  const EditedQuantity* Shown = nullptr;
  vtkImageData* ShownImage = nullptr; // only compared
  int ShownComponent = 0;
  vtkTimeStamp DataTime;
  bool HasData = false;
  double DataRange[2] = { 0.0, 1.0 };
  double Range[2] = { 0.0, 1.0 };
  double Scale = 1.0;
  vtkVector2i LastMouse{ 0, 0 };
};

} // namespace VolumeHaptics

#endif
