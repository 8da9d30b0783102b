// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/HandLabel.h"

#include "Applications/Explorer/View/PaintedItem.h"
#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkBrush.h"
#include "vtkCamera.h"
#include "vtkContext2D.h"
#include "vtkContextScene.h"
#include "vtkHapticTool.h"
#include "vtkMath.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
constexpr int LETTERS = 11;      // points
constexpr double TIP_GAP = 22.0; // points between the tip and its label
// smallest width of the scale, as a fraction of the view's width
constexpr double SCALE_SHARE = 0.15;

std::string Format(double value, const char* unit)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(value < 10.0 ? 1 : 0) << value << unit;
  return text.str();
}

/// Returns the smallest of 1, 2, 5, 10, 20 ... that is at least the length.
double RoundUp(double length)
{
  const double unit = std::pow(10.0, std::floor(std::log10(length)));
  for (const double factor : { 1.0, 2.0, 5.0 })
  {
    if (factor * unit >= length)
    {
      return factor * unit;
    }
  }
  return 10.0 * unit;
}
} // namespace

namespace Explore
{
HandLabel::HandLabel(TouchScene& touch, const Exploration& exploration)
  : Touch(touch)
  , Filter(exploration.Filter)
  , Image(exploration.Body)
  , OuterThreshold(exploration.Values.OuterThreshold)
  , IsDark(exploration.Values.IsDark)
  , MillimetersPerUnit(1000.0 * exploration.Input.MetersPerUnit)
{
  vtkNew<PaintedItem> item;
  item->Painter = [this](vtkContext2D* painter) { return this->Paint(painter); };
  this->Actor->GetScene()->AddItem(item);
  touch.Scene.Overlay->AddViewProp(this->Actor);
  touch.Commands.Add(this,
    { "Display", "tissue, force and depth at the hand; scale", "Ctrl+h",
      [this] { this->IsShown = !this->IsShown; }, [this] { return this->IsShown; }, nullptr });
}

HandLabel::~HandLabel()
{
  this->Touch.Commands.Remove(this);
  this->Touch.Scene.Overlay->RemoveViewProp(this->Actor);
}

double HandLabel::ComputeDepth(const double point[3]) const
{
  double towards[3]; // direction to the viewer, half a voxel long
  this->Touch.Scene.Renderer->GetActiveCamera()->GetDirectionOfProjection(towards);
  const double* const spacing = this->Image->GetSpacing();
  const double step = 0.5 * std::min({ spacing[0], spacing[1], spacing[2] });
  vtkMath::MultiplyScalar(towards, -step);
  const int* const size = this->Image->GetDimensions();
  const int* const extent = this->Image->GetExtent();
  const int most = 4 * (size[0] + size[1] + size[2]);
  double x[3] = { point[0], point[1], point[2] };
  int last = 0;
  for (int i = 0; i < most; ++i)
  {
    double index[3];
    this->Image->TransformPhysicalPointToContinuousIndex(x, index);
    int ijk[3];
    bool isInside = true;
    for (int axis = 0; axis < 3; ++axis)
    {
      ijk[axis] = static_cast<int>(std::lround(index[axis]));
      isInside = isInside && ijk[axis] >= extent[2 * axis] && ijk[axis] <= extent[2 * axis + 1];
    }
    if (!isInside)
    {
      break;
    }
    const double value = this->Image->GetScalarComponentAsDouble(ijk[0], ijk[1], ijk[2], 0);
    const bool isBody =
      this->IsDark ? value <= this->OuterThreshold : value >= this->OuterThreshold;
    last = isBody ? i : last;
    vtkMath::Add(x, towards, x);
  }
  return last * step * this->MillimetersPerUnit;
}

std::vector<std::string> HandLabel::Describe() const
{
  vtkHapticDevice* const device = this->Touch.Device;
  vtkHapticState* const state = device->GetState();
  std::vector<std::string> lines;
  vtkHapticTool* const tool = this->Filter->GetTool();
  if (tool)
  {
    lines.emplace_back(tool->GetText());
  }
  const bool isNeedleIn = state->GetNeedleDepth() > 0.0;
  if (state->GetContact() == 0 && !isNeedleIn)
  {
    return lines;
  }
  const std::string tissue = this->Touch.Display->GetTouchedTissue();
  if (!tissue.empty())
  {
    lines.push_back(tissue);
  }
  lines.push_back(Format(vtkMath::Norm(state->GetForce()), " N"));
  const double voxel = this->Image->GetSpacing()[0] * this->MillimetersPerUnit;
  const double depth = isNeedleIn ? state->GetNeedleDepth() * this->MillimetersPerUnit
                                  : this->ComputeDepth(state->GetProxyPosition());
  if (isNeedleIn || depth > 1.5 * voxel)
  {
    lines.push_back(Format(depth, isNeedleIn ? " mm inserted" : " mm below the surface"));
  }
  return lines;
}

void HandLabel::DrawLabel(vtkContext2D* painter) const
{
  vtkHapticDevice* const device = this->Touch.Device;
  const int status = device->GetStatus();
  const bool isTouching = this->Touch.Style->GetTouchMode() || status == vtkHapticDevice::ARMED ||
    status == vtkHapticDevice::ACTIVE;
  const std::vector<std::string> lines = isTouching ? this->Describe() : std::vector<std::string>();
  if (lines.empty())
  {
    return;
  }
  std::string text;
  for (const std::string& line : lines)
  {
    text += (text.empty() ? "" : "\n") + line;
  }
  vtkRenderer* const renderer = this->Touch.Scene.Overlay;
  const double scale = VolumeHaptics::PixelsPerPoint(renderer);
  double at[3];
  std::copy_n(device->GetState()->GetProxyPosition(), 3, at);
  renderer->WorldToView(at[0], at[1], at[2]);
  renderer->ViewToNormalizedViewport(at[0], at[1], at[2]);
  const int* const size = renderer->GetSize();
  const double gap = TIP_GAP * scale;
  float bounds[4];
  painter->ComputeStringBounds(text, bounds);
  const double padding = 5.0 * scale;
  const double width = bounds[2] + 2.0 * padding;
  const double height = bounds[3] + 2.0 * padding;
  const double x = at[0] * size[0];
  const double y = at[1] * size[1];
  // The tool leans to the upper right, so place the label on the left if there is room.
  const double left = x - gap - width >= 0.0 ? x - gap - width : x + gap;
  const double bottom = std::clamp(y - gap - height, 0.0, std::max(0.0, size[1] - height));
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(15, 18, 24, 190);
  painter->DrawRect(static_cast<float>(left), static_cast<float>(bottom), static_cast<float>(width),
    static_cast<float>(height));
  painter->DrawString(
    static_cast<float>(left + padding), static_cast<float>(bottom + 0.5 * height), text);
}

void HandLabel::DrawScale(vtkContext2D* painter) const
{
  vtkRenderer* const renderer = this->Touch.Scene.Overlay;
  const double scale = VolumeHaptics::PixelsPerPoint(renderer);
  vtkCamera* const camera = renderer->GetActiveCamera();
  const int* const size = renderer->GetSize();
  // The visible height at the focal point (world units).
  const double angle = vtkMath::RadiansFromDegrees(camera->GetViewAngle());
  const double high = camera->GetParallelProjection()
    ? 2.0 * camera->GetParallelScale()
    : 2.0 * camera->GetDistance() * std::tan(0.5 * angle);
  const double pixel = high / size[1] * this->MillimetersPerUnit; // mm per pixel
  const double length = RoundUp(SCALE_SHARE * size[0] * pixel);
  if (!std::isfinite(length) || size[0] < static_cast<int>(500 * scale))
  {
    return; // the label would cover too much of a small window
  }
  const auto width = static_cast<float>(std::lround(length / pixel));
  const auto right = static_cast<float>(size[0] - 16.0 * scale);
  const auto y = static_cast<float>(std::lround(44.0 * scale));
  const auto tick = static_cast<float>(std::lround(4.0 * scale));
  vtkPen* const pen = painter->GetPen();
  pen->SetLineType(vtkPen::SOLID_LINE);
  pen->SetColor(230, 235, 242, 255);
  pen->SetWidth(static_cast<float>(1.5 * scale));
  painter->DrawLine(right - width, y, right, y);
  painter->DrawLine(right - width, y - tick, right - width, y + tick);
  painter->DrawLine(right, y - tick, right, y + tick);
  std::ostringstream text;
  text << length << " mm";
  float bounds[4];
  painter->ComputeStringBounds(text.str(), bounds);
  painter->DrawString(right - 0.5f * (width + bounds[2]), y + 3.0f * tick, text.str());
}

bool HandLabel::Paint(vtkContext2D* painter)
{
  if (!this->IsShown)
  {
    return true;
  }
  vtkTextProperty* const look = painter->GetTextProp();
  look->SetFontSize(LETTERS);
  look->SetColor(0.93, 0.95, 0.98);
  look->BoldOff();
  look->ItalicOff();
  look->ShadowOff();
  look->SetOrientation(0.0);
  look->SetJustificationToLeft();
  look->SetVerticalJustificationToCentered();
  this->DrawScale(painter);
  this->DrawLabel(painter);
  return true;
}
} // namespace Explore
