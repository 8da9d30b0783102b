// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticFunctionChart.h"

#include "VTK/Scene/Base/HapticChartText.h"
#include "VTK/Scene/Base/HapticHistogram.h"
#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Editor/HapticValueScale.h"

#include "vtkAxis.h"
#include "vtkBrush.h"
#include "vtkCommand.h"
#include "vtkContextMouseEvent.h"
#include "vtkDataArray.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkPiecewiseControlPointsItem.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

namespace
{
constexpr double Farthest = VolumeHaptics::FarthestShown;
} // namespace

/**
 * VTK's control points, extended to functions whose values may exceed 1.
 *
 * vtkControlPointsItem shows and edits values from 0 to 1, so this class divides values by Scale. A
 * value above Scale is shown at the top, and stays unchanged until its point is dragged down. An
 * empty function is shown without points. When the first point is added, a point with the empty
 * function's value is added at each end of the range, too.
 */
class HapticControlPointsItem : public vtkPiecewiseControlPointsItem
{
public:
  static HapticControlPointsItem* New();
  vtkTypeMacro(HapticControlPointsItem, vtkPiecewiseControlPointsItem);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Sets the visible range: x from `from` to `to`, and values from 0 to `scale`, which is above 0.
   */
  void SetRange(double from, double to, double scale);

  /** Sets the value of an empty function, and deselects the current point. */
  void SetEmptyValue(double value);

  /**
   * Returns a text with the value and position of the current point, such as "800 at 70"; empty if
   * there is none.
   */
  std::string DescribeCurrentPoint();

  /** Returns a value divided by the scale, clamped to -1 to 1. */
  static double ToFraction(double value, double scale);

  vtkIdType AddPoint(double* newPos) override;

protected:
  HapticControlPointsItem();
  ~HapticControlPointsItem() override = default;

  void GetControlPoint(vtkIdType index, double* point) const override;
  void SetControlPoint(vtkIdType index, double* point) override;
  void DrawPoint(vtkContext2D* painter, vtkIdType index) override;

  double From = 0.0;
  double To = 1.0;
  double Scale = 1.0;
  double EmptyValue = 0.0;

private:
  HapticControlPointsItem(const HapticControlPointsItem&) = delete;
  void operator=(const HapticControlPointsItem&) = delete;
};

vtkStandardNewMacro(HapticControlPointsItem);

//------------------------------------------------------------------------------
HapticControlPointsItem::HapticControlPointsItem()
{
  this->SetScreenPointRadius(4.0f);
  this->SetEndPointsXMovable(false);
  this->GetPen()->SetColor(0, 92, 175, 255);
  this->GetBrush()->SetColor(255, 255, 255, 255);
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::SetRange(double from, double to, double scale)
{
  this->From = from;
  this->To = to;
  this->Scale = scale;
  this->SetUserBounds(from, to, 0.0, 1.0);
  this->SetValidBounds(from, to, 0.0, 1.0);
  this->ComputePoints();
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::SetEmptyValue(double value)
{
  this->EmptyValue = value;
  this->SetCurrentPoint(-1);
  this->DeselectAllPoints();
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::GetControlPoint(vtkIdType index, double* point) const
{
  this->Superclass::GetControlPoint(index, point);
  point[0] = std::isnan(point[0]) ? Farthest : std::clamp(point[0], -Farthest, Farthest);
  point[1] = ToFraction(point[1], this->Scale);
}

//------------------------------------------------------------------------------
double HapticControlPointsItem::ToFraction(double value, double scale)
{
  return std::isnan(value) ? 0.0 : std::clamp(value / scale, -1.0, 1.0);
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::SetControlPoint(vtkIdType index, double* point)
{
  double node[4];
  this->Superclass::GetControlPoint(index, node);
  const bool staysAbove = point[1] >= 1.0 && node[1] > this->Scale;
  const bool staysAway = !(std::abs(node[0]) <= Farthest);
  node[0] = staysAway ? node[0] : point[0];
  node[1] = staysAbove ? node[1] : point[1] * this->Scale;
  this->Superclass::SetControlPoint(index, node);
}

//------------------------------------------------------------------------------
vtkIdType HapticControlPointsItem::AddPoint(double* newPos)
{
  if (!this->PiecewiseFunction)
  {
    return -1;
  }
  this->StartChanges();
  if (this->PiecewiseFunction->GetSize() == 0)
  {
    this->PiecewiseFunction->AddPoint(this->From, this->EmptyValue);
    this->PiecewiseFunction->AddPoint(this->To, this->EmptyValue);
  }
  double point[2] = { newPos[0], newPos[1] * this->Scale };
  const vtkIdType added = this->Superclass::AddPoint(point);
  this->EndChanges();
  return added;
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::DrawPoint(vtkContext2D* painter, vtkIdType index)
{
  double point[4];
  this->GetControlPoint(index, point);
  if (point[0] >= this->From && point[0] <= this->To)
  {
    this->Superclass::DrawPoint(painter, index);
  }
}

//------------------------------------------------------------------------------
std::string HapticControlPointsItem::DescribeCurrentPoint()
{
  const vtkIdType current = this->GetCurrentPoint();
  if (current < 0 || current >= this->GetNumberOfPoints())
  {
    return {};
  }
  double node[4];
  this->Superclass::GetControlPoint(current, node);
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << std::setprecision(3) << node[1] << " at " << std::setprecision(5) << node[0];
  return text.str();
}

//------------------------------------------------------------------------------
void HapticControlPointsItem::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "From: " << this->From << "\n";
  os << indent << "To: " << this->To << "\n";
  os << indent << "Scale: " << this->Scale << "\n";
  os << indent << "EmptyValue: " << this->EmptyValue << "\n";
}

namespace VolumeHaptics
{
namespace
{

constexpr int RightBottom = 1; // vtkChartXY's index of the corner with the right and the bottom
                               // axis

constexpr double DarkText[3] = { 0.12, 0.13, 0.15 };

} // namespace

vtkStandardNewMacro(OpenContextScene);

//------------------------------------------------------------------------------
HapticFunctionChart::HapticFunctionChart()
{
  this->Actor->SetScene(this->Scene);
  MakePanel(this->Panel);
  this->Scene->AddItem(this->Panel);
  this->Scene->AddItem(this->Chart);

  this->Chart->SetAutoSize(false);
  this->Chart->SetRenderEmpty(true);
  this->Chart->SetAutoAxes(false);
  this->Chart->SetHiddenAxisBorder(10);
  this->Chart->SetTooltip(nullptr);
  this->Chart->SetZoomWithMouseWheel(false);
  this->Chart->SetBarWidthFraction(1.0f);
  for (const int action : { vtkChart::PAN, vtkChart::ZOOM, vtkChart::ZOOM_AXIS, vtkChart::SELECT,
         vtkChart::SELECT_RECTANGLE })
  {
    this->Chart->SetActionToButton(action, -1);
  }
  for (const int side : { vtkAxis::LEFT, vtkAxis::BOTTOM, vtkAxis::RIGHT, vtkAxis::TOP })
  {
    vtkAxis* const axis = this->Chart->GetAxis(side);
    axis->SetVisible(side == vtkAxis::LEFT || side == vtkAxis::BOTTOM);
    axis->SetBehavior(vtkAxis::FIXED);
    axis->SetRange(0.0, 1.0);
    axis->SetTitle("");
    axis->GetGridPen()->SetColor(228, 231, 236);
    axis->GetPen()->SetColor(90, 95, 105);
    axis->SetNotation(vtkAxis::STANDARD_NOTATION);
  }
  this->Chart->GetAxis(vtkAxis::RIGHT)->SetGridVisible(false);
  this->Chart->GetAxis(vtkAxis::TOP)->SetGridVisible(false);

  // Put all plots on the right axis, which is invisible and runs from 0 to 1. The control points
  // need it, and plots on different axes would not be painted in the order of this list. The left
  // axis, from 0 to the scale, only shows the numbers.
  for (vtkPlot* plot : std::initializer_list<vtkPlot*>{
         this->Bars, this->Edges, this->Bands, this->Proposed, this->Curve, this->Points })
  {
    this->Chart->AddPlot(plot);
    this->Chart->SetPlotCorner(plot, RightBottom);
  }
  this->Bars->SetColor(196, 202, 212, 255);
  this->Bars->GetPen()->SetOpacity(0);
  this->Edges->SetVisible(false);
  this->Bands->SetVisible(false);
  this->Proposed->SetColor(0, 130, 75, 255);
  this->Proposed->SetWidth(2.0f);
  this->Proposed->GetPen()->SetLineType(vtkPen::DASH_LINE);
  this->Curve->SetColor(0, 92, 175, 255);
  this->Curve->SetWidth(2.0f);
  for (vtkPlot* plot : std::initializer_list<vtkPlot*>{ this->Bars, this->Proposed, this->Curve })
  {
    plot->SetInteractive(false);
    plot->SetSelectable(false);
  }
}

//------------------------------------------------------------------------------
HapticFunctionChart::~HapticFunctionChart() = default;

//------------------------------------------------------------------------------
void HapticFunctionChart::Place(const int rectangle[4], double scale)
{
  const vtkRectf area(rectangle[0], rectangle[1], rectangle[2], rectangle[3]);
  this->Panel->SetDimensions(area[0], area[1], area[2], area[3]);
  this->Chart->SetSize(area);
  const int font = FitLetters(rectangle[3], 18, scale, 8, 16);
  this->Letters = font;
  SetChartText(this->Chart->GetTitleProperties(), font + 2, DarkText);
  for (const int side : { vtkAxis::LEFT, vtkAxis::BOTTOM })
  {
    SetChartText(this->Chart->GetAxis(side)->GetTitleProperties(), font, DarkText);
    SetChartText(this->Chart->GetAxis(side)->GetLabelProperties(), font, DarkText);
  }
}

//------------------------------------------------------------------------------
bool HapticFunctionChart::ShowsData(vtkImageData* image, int component) const
{
  return image == this->ShownImage && component == this->ShownComponent &&
    (!image || image->GetMTime() < this->DataTime);
}

//------------------------------------------------------------------------------
void HapticFunctionChart::ShowData(vtkImageData* image, int component)
{
  if (this->ShowsData(image, component))
  {
    return;
  }
  this->HasChosenValues = this->HasChosenValues && image == this->ShownImage;
  this->ShownImage = image;
  this->ShownComponent = component;
  this->DataTime.Modified();
  this->Counting.Forget();
  this->Counted = image ? image->GetPointData()->GetScalars() : nullptr;
  this->Data = {};
  if (this->Counted && this->Counted->GetNumberOfTuples() == 0)
  {
    this->Counted = nullptr;
  }
  this->Chart->GetAxis(vtkAxis::BOTTOM)->SetTitle(NameValues(this->Counted));
  if (this->Counted && IsQuicklySwept(this->Counted))
  {
    this->Data = *CountAllValues(this->Counted, component, [](double) { return true; });
    this->Counted = nullptr;
  }
  else if (this->Counted)
  {
    this->Data = CountSpreadValues(this->Counted, component);
  }
  this->ShowCounts();
  this->PollCount();
}

//------------------------------------------------------------------------------
void HapticFunctionChart::ScaleValues(const ValueScale& scale)
{
  if (!(scale == this->ToValue))
  {
    this->ToValue = scale;
    this->Edges->ScaleValues(scale);
    this->HasChosenValues = false;
    this->ShowCounts();
  }
}

//------------------------------------------------------------------------------
void HapticFunctionChart::ShowCounts()
{
  ValueCounts counts = this->Data;
  counts.Origin = this->ToValue(counts.Origin);
  counts.Width *= this->ToValue.Scale;
  std::transform(counts.Range, counts.Range + 2, counts.Range, this->ToValue);
  FillHistogram(counts, this->BarTable);
  std::copy(counts.Range, counts.Range + 2, this->DataRange);
  this->HasData = !counts.Counts.empty();
  this->Bars->SetVisible(this->HasData && !this->HasEdges);
  if (this->HasData)
  {
    this->Bars->SetInputData(this->BarTable, 0, 1);
  }
}

//------------------------------------------------------------------------------
void HapticFunctionChart::PollCount()
{
  if (!this->Counted)
  {
    return;
  }
  const vtkSmartPointer<vtkDataArray> scalars = this->Counted;
  const int component = this->ShownComponent;
  const ValueCounts* const counts = this->Counting.Poll(this->DataTime.GetMTime(),
    [scalars, component](WorkMonitor& monitor)
    {
      return CountAllValues(
        scalars, component, [&monitor](double fraction) { return monitor.GoesOn(fraction); });
    });
  if (counts)
  {
    this->Data = *counts;
    this->ShowCounts();
  }
  if (!this->Counting.IsUnderWay())
  {
    this->Counted = nullptr;
    this->Counting.Forget();
  }
}

//------------------------------------------------------------------------------
void HapticFunctionChart::EndCountUnless(vtkImageData* image)
{
  if (image != this->ShownImage)
  {
    this->Counting.Forget();
    this->Counted = nullptr;
  }
}

//------------------------------------------------------------------------------
double HapticFunctionChart::GetCountedFraction() const
{
  return this->Counted ? this->Counting.GetProgress() : 1.0;
}

//------------------------------------------------------------------------------
void HapticFunctionChart::ShowEdges(const EdgeHistogram& histogram, vtkHapticProperty* proposed)
{
  this->Edges->ShowEdges(histogram, proposed);
  this->HasEdges = true;
  this->Edges->SetVisible(true);
  this->Bars->SetVisible(false);
}

void HapticFunctionChart::HideEdges()
{
  this->HasEdges = false;
  this->Edges->SetVisible(false);
  this->Bars->SetVisible(this->HasData);
}

void HapticFunctionChart::ShowDistinctness(double start, double full)
{
  this->Edges->ShowDistinctness(start, full);
}

//------------------------------------------------------------------------------
void HapticFunctionChart::ShowFunction(
  vtkPiecewiseFunction* function, const EditedQuantity& quantity, bool dragged)
{
  if (function != this->Points->GetPiecewiseFunction() || &quantity != this->Shown)
  {
    this->Points->SetPiecewiseFunction(function);
    this->Points->SetEmptyValue(quantity.EmptyValue);
    this->Shown = &quantity;
  }
  this->Curve->SetVisible(function != nullptr);
  this->Points->SetVisible(function != nullptr);
  const std::string touched = function ? this->Points->DescribeCurrentPoint() : std::string();
  const std::string note = (this->Warning.empty() ? "" : ": " + this->Warning) +
    (this->ProposedFunction ? std::string(", dashed: proposed") : "") +
    DescribeFraction(this->GetCountedFraction(), "counted") +
    DescribeFraction(this->SearchedFraction, "searched");
  this->Chart->SetTitle(quantity.Title + (touched.empty() ? note : ": " + touched));
  if (function && !dragged)
  {
    this->FitAxes(function, quantity);
  }
  if (function)
  {
    this->DrawCurve(function, quantity, this->CurveTable, this->Curve);
  }
  this->Proposed->SetVisible(function && this->ProposedFunction);
  if (function && this->ProposedFunction)
  {
    this->DrawCurve(this->ProposedFunction, quantity, this->ProposedTable, this->Proposed);
  }
}

//------------------------------------------------------------------------------
void HapticFunctionChart::FitAxes(vtkPiecewiseFunction* function, const EditedQuantity& quantity)
{
  double from = this->DataRange[0];
  double to = this->DataRange[1];
  double highest = function->GetSize() == 0 ? quantity.EmptyValue : 0.0;
  double ends[2] = { VTK_DOUBLE_MAX, -VTK_DOUBLE_MAX };
  for (int i = 0; this->ProposedFunction && i < this->ProposedFunction->GetSize(); ++i)
  {
    double node[4];
    this->ProposedFunction->GetNodeValue(i, node);
    highest = node[1] <= quantity.Most ? std::max(highest, node[1]) : highest;
  }
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    if (std::abs(node[0]) <= FarthestShown) // also skips NaN
    {
      ends[0] = std::min(ends[0], node[0]);
      ends[1] = std::max(ends[1], node[0]);
    }
    highest = node[1] <= quantity.Most ? std::max(highest, node[1]) : highest;
  }
  if (ends[0] <= ends[1])
  {
    // Include points beyond the data, as long as the data fill at least half of the axis.
    const double margin = this->HasData ? 0.5 * (to - from) : VTK_DOUBLE_MAX;
    from = this->HasData ? std::min(from, std::max(ends[0], from - margin)) : ends[0];
    to = this->HasData ? std::max(to, std::min(ends[1], to + margin)) : ends[1];
  }
  // Limit how narrow the axis becomes: otherwise single precision would give all ticks the same
  // number.
  constexpr double precision = 1e-5;
  const double least =
    std::max(1.0 / FarthestShown, precision * std::max(std::abs(from), std::abs(to)));
  if (!(to - from >= least))
  {
    from -= std::max(0.5, least);
    to = from + 2.0 * std::max(0.5, least);
  }
  const bool fraction = quantity.Most == 1.0;
  const double room = 1.1;
  const double scale = fraction || !(highest > 1.0 / FarthestShown)
    ? quantity.Usual
    : std::min(RoundUp(room * highest), quantity.Most);
  const auto top = this->ChosenTops.find(&quantity);
  this->HasChosenValues
    ? this->SetAxes(
        this->Range[0], this->Range[1], top == this->ChosenTops.end() ? scale : top->second)
    : this->SetAxes(from, to, top == this->ChosenTops.end() ? scale : top->second);
}

//------------------------------------------------------------------------------
void HapticFunctionChart::SetAxes(double from, double to, double scale)
{
  if (from != this->Range[0] || to != this->Range[1] || scale != this->Scale)
  {
    this->Range[0] = from;
    this->Range[1] = to;
    this->Scale = scale;
    this->Points->SetRange(from, to, scale);
    this->Chart->GetAxis(vtkAxis::BOTTOM)->SetRange(from, to);
    this->Chart->GetAxis(vtkAxis::LEFT)->SetRange(0.0, scale);
  }
}

//------------------------------------------------------------------------------
void HapticFunctionChart::ShowTissues(vtkHapticProperty* property)
{
  this->Bands->Show(property, this->ToValue, this->Range, std::max(8, this->Letters - 1));
}

//------------------------------------------------------------------------------
HapticFunctionChart::AxisKind HapticFunctionChart::FindAxis(int x, int y)
{
  const float* const corner = this->Chart->GetAxis(vtkAxis::BOTTOM)->GetPoint1();
  const float* const end = this->Chart->GetAxis(vtkAxis::BOTTOM)->GetPoint2();
  const float* const top = this->Chart->GetAxis(vtkAxis::LEFT)->GetPoint2();
  const auto right = static_cast<float>(x);
  const auto up = static_cast<float>(y);
  // Near the end of an axis, prefer control points to the axis, because their symbols extend beyond
  // it.
  constexpr float reach = 4.0f; // pixels by which a symbol extends beyond the axis
  if (up < corner[1] - reach && right >= corner[0] && right <= end[0])
  {
    return AxisKind::Values;
  }
  return right < corner[0] - reach && up >= corner[1] && up <= top[1] ? AxisKind::Function
                                                                      : AxisKind::None;
}

//------------------------------------------------------------------------------
void HapticFunctionChart::ChooseValues(double from, double to)
{
  // Limit how far the axis is stretched: otherwise single precision could not separate its ticks.
  constexpr double precision = 1e-5;
  const double least =
    std::max(1.0 / FarthestShown, precision * std::max(std::abs(from), std::abs(to)));
  if (to - from >= least && std::abs(from) <= FarthestShown && std::abs(to) <= FarthestShown)
  {
    this->HasChosenValues = true;
    this->SetAxes(from, to, this->Scale);
  }
}

void HapticFunctionChart::ChooseTop(double top)
{
  if (this->Shown)
  {
    constexpr double smallest = 1e-4; // smallest top, as a fraction of the usual one
    const double chosen = std::clamp(top, smallest * this->Shown->Usual, this->Shown->Most);
    this->ChosenTops[this->Shown] = chosen;
    this->SetAxes(this->Range[0], this->Range[1], chosen);
  }
}

//------------------------------------------------------------------------------
bool HapticFunctionChart::MoveAxes(int event, int button, int x, int y)
{
  vtkAxis* const bottom = this->Chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* const left = this->Chart->GetAxis(vtkAxis::LEFT);
  if (event == vtkCommand::LeftButtonPressEvent || event == vtkCommand::LeftButtonDoubleClickEvent)
  {
    const AxisKind axis = this->FindAxis(x, y);
    this->DraggedAxis = button == vtkContextMouseEvent::LEFT_BUTTON ? axis : AxisKind::None;
    if (event == vtkCommand::LeftButtonDoubleClickEvent && axis != AxisKind::None)
    {
      this->HasChosenValues = false;
      this->ChosenTops.erase(this->Shown);
      this->DraggedAxis = AxisKind::None;
    }
    return axis != AxisKind::None;
  }
  if (this->DraggedAxis == AxisKind::None)
  {
    return false;
  }
  if (event == vtkCommand::LeftButtonReleaseEvent)
  {
    this->DraggedAxis = AxisKind::None;
    return true;
  }
  if (this->DraggedAxis == AxisKind::Values)
  {
    const double pixels = bottom->GetPoint2()[0] - bottom->GetPoint1()[0];
    const double shift =
      (this->LastMouse[0] - x) * (this->Range[1] - this->Range[0]) / std::max(1.0, pixels);
    this->ChooseValues(this->Range[0] + shift, this->Range[1] + shift);
  }
  else
  {
    // Keep the value that was under the mouse at the mouse's position.
    const double foot = left->GetPoint1()[1];
    this->ChooseTop(
      this->Scale * std::max(1.0, this->LastMouse[1] - foot) / std::max(1.0, y - foot));
  }
  return true;
}

//------------------------------------------------------------------------------
void HapticFunctionChart::Turn(int x, int y, double steps)
{
  constexpr double stretch = 1.25; // factor per step of the wheel
  const double factor = std::pow(stretch, -steps);
  if (this->FindAxis(x, y) == AxisKind::Function)
  {
    this->ChooseTop(this->Scale * factor);
    return;
  }
  vtkAxis* const bottom = this->Chart->GetAxis(vtkAxis::BOTTOM);
  const double pixels = std::max(1.0f, bottom->GetPoint2()[0] - bottom->GetPoint1()[0]);
  const double fraction = std::clamp((x - bottom->GetPoint1()[0]) / pixels, 0.0, 1.0);
  const double width = this->Range[1] - this->Range[0];
  const double at = this->Range[0] + fraction * width;
  this->ChooseValues(at - fraction * factor * width, at + (1.0 - fraction) * factor * width);
}

//------------------------------------------------------------------------------
void HapticFunctionChart::DrawCurve(vtkPiecewiseFunction* function, const EditedQuantity& quantity,
  vtkTable* table, vtkPlotLine* curve)
{
  const double from = this->Range[0];
  const double to = this->Range[1];
  std::vector<double> places;
  constexpr int steps = 256;
  for (int i = 0; i <= steps; ++i)
  {
    places.push_back(from + i * (to - from) / steps);
  }
  for (int i = 0; i < function->GetSize(); ++i)
  {
    double node[4];
    function->GetNodeValue(i, node);
    if (node[0] > from && node[0] < to)
    {
      places.push_back(node[0]);
    }
  }
  std::sort(places.begin(), places.end());
  vtkNew<vtkDoubleArray> x, y;
  x->SetName("value");
  y->SetName("function");
  for (const double place : places)
  {
    const double value = function->GetSize() == 0 ? quantity.EmptyValue : function->GetValue(place);
    x->InsertNextValue(place);
    y->InsertNextValue(HapticControlPointsItem::ToFraction(value, this->Scale));
  }
  table->Initialize();
  table->AddColumn(x);
  table->AddColumn(y);
  curve->SetInputData(table, 0, 1);
}

//------------------------------------------------------------------------------
void HapticFunctionChart::SendMouse(int event, int button, int x, int y)
{
  const vtkVector2i place(x, y);
  if (this->MoveAxes(event, button, x, y))
  {
    this->LastMouse = place;
    return;
  }
  vtkContextMouseEvent mouse;
  mouse.SetInteractor(nullptr);
  mouse.SetButton(button);
  mouse.SetPos(place.Cast<float>());
  mouse.SetScenePos(place.Cast<float>());
  mouse.SetScreenPos(place);
  mouse.SetLastPos(this->LastMouse.Cast<float>());
  mouse.SetLastScenePos(this->LastMouse.Cast<float>());
  mouse.SetLastScreenPos(this->LastMouse);
  this->LastMouse = place;
  switch (event)
  {
    case vtkCommand::LeftButtonPressEvent:
      this->Scene->ButtonPressEvent(mouse);
      break;
    case vtkCommand::LeftButtonReleaseEvent:
      this->Scene->ButtonReleaseEvent(mouse);
      break;
    case vtkCommand::LeftButtonDoubleClickEvent:
      this->Scene->DoubleClickEvent(mouse);
      break;
    default:
      this->Scene->MouseMoveEvent(mouse);
  }
}

//------------------------------------------------------------------------------
void HapticFunctionChart::GetPosition(double x, double y, double position[2])
{
  vtkAxis* const bottom = this->Chart->GetAxis(vtkAxis::BOTTOM);
  vtkAxis* const left = this->Chart->GetAxis(vtkAxis::LEFT);
  const double right = (x - this->Range[0]) / (this->Range[1] - this->Range[0]);
  const double up = y / this->Scale;
  position[0] = bottom->GetPoint1()[0] + right * (bottom->GetPoint2()[0] - bottom->GetPoint1()[0]);
  position[1] = left->GetPoint1()[1] + up * (left->GetPoint2()[1] - left->GetPoint1()[1]);
}

} // namespace VolumeHaptics
