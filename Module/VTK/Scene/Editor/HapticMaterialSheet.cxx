// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticMaterialSheet.h"

#include "VTK/Scene/Base/HapticChartText.h"

#include "vtkCommand.h"
#include "vtkContextMouseEvent.h"
#include "vtkContextScene.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** Distinguishable steps of a slider. */
constexpr double SliderSteps = 200.0;
constexpr double RowsPerTurn = 3.0;

} // namespace

HapticMaterialSheet::HapticMaterialSheet(HapticMaterialList& list)
  : List(list)
{
  MakePanel(this->Panel);
  this->Actor->GetScene()->AddItem(this->Panel);
  this->Actor->GetScene()->AddItem(this->Item);
}

//------------------------------------------------------------------------------
void HapticMaterialSheet::Place(const int rectangle[4], double scale)
{
  this->Scale = scale;
  std::copy_n(rectangle, 4, this->Rectangle);
  this->Panel->SetDimensions(static_cast<float>(rectangle[0]), static_cast<float>(rectangle[1]),
    static_cast<float>(rectangle[2]), static_cast<float>(rectangle[3]));
  this->List.SetVisibleRows(this->GetLayout().GetRoom());
  this->Item->Show(this->List, this->Rectangle, scale);
  if (this->Held.Kind != MaterialPart::Slider)
  {
    this->List.FitEnds();
  }
}

//------------------------------------------------------------------------------
void HapticMaterialSheet::Slide(int quantity, float x)
{
  const vtkRectf bar = this->GetLayout().GetSlider(quantity);
  const double share = std::clamp<double>((x - bar.GetLeft()) / bar.GetWidth(), 0.0, 1.0);
  this->List.SetValue(
    quantity, std::round(share * SliderSteps) / SliderSteps * this->List.GetEnd(quantity));
}

//------------------------------------------------------------------------------
void HapticMaterialSheet::SendMouse(int event, int button, int x, int y)
{
  if (!this->List.GetEdited() || button != vtkContextMouseEvent::LEFT_BUTTON)
  {
    return;
  }
  switch (event)
  {
    case vtkCommand::MouseMoveEvent:
      this->Move(x, y);
      break;
    case vtkCommand::LeftButtonReleaseEvent:
      this->Release();
      break;
    default:
      this->Press(x, y);
  }
}

//------------------------------------------------------------------------------
void HapticMaterialSheet::Press(int x, int y)
{
  const MaterialPart part = this->GetLayout().Find(static_cast<float>(x), static_cast<float>(y));
  this->Held = part;
  switch (part.Kind)
  {
    case MaterialPart::Nothing:
      break;
    case MaterialPart::Name:
      this->List.Select(this->List.GetKey(part.Row));
      break;
    case MaterialPart::Felt:
    case MaterialPart::Forbidden:
    {
      const int key = this->List.GetKey(part.Row);
      this->List.Select(key);
      part.Kind == MaterialPart::Felt ? this->List.ToggleFelt(key)
                                      : this->List.ToggleForbidden(key);
      break;
    }
    case MaterialPart::ByFunctions:
      this->List.RemoveMaterial(*this->List.GetSelected());
      break;
    case MaterialPart::ScrollBar:
    case MaterialPart::Slider:
      this->Move(x, y);
  }
}

//------------------------------------------------------------------------------
void HapticMaterialSheet::Move(int x, int y)
{
  if (this->Held.Kind == MaterialPart::ScrollBar)
  {
    this->List.ScrollTo(this->GetLayout().GetFirstRowAt(static_cast<float>(y)));
  }
  else if (this->Held.Kind == MaterialPart::Slider)
  {
    this->Slide(this->Held.Quantity, static_cast<float>(x));
  }
}

//------------------------------------------------------------------------------
void HapticMaterialSheet::Release()
{
  this->Held = {};
  this->List.FitEnds();
}

//------------------------------------------------------------------------------
void HapticMaterialSheet::Turn(int x, int y, double steps)
{
  const MaterialPart part = this->GetLayout().Find(static_cast<float>(x), static_cast<float>(y));
  if (part.Kind == MaterialPart::Slider)
  {
    const double end = this->List.GetEnd(part.Quantity);
    const double before = std::max(0.0, this->List.GetValue(part.Quantity));
    // A program may have set a value beyond the largest end.
    const double after = before + steps * end / SliderSteps;
    this->List.SetValue(part.Quantity, std::clamp(after, 0.0, std::max(end, before)));
  }
  else
  {
    this->List.ScrollTo(this->List.GetFirstRow() - std::llround(RowsPerTurn * steps));
  }
}

//------------------------------------------------------------------------------
bool HapticMaterialSheet::GetRowPosition(
  int key, MaterialPart::KindType part, double position[2]) const
{
  const vtkIdType row = this->List.FindRow(key);
  const vtkIdType first = this->List.GetFirstRow();
  if (!this->List.IsCounted() || row < first || row >= first + this->List.GetVisibleRows())
  {
    return false;
  }
  const HapticMaterialLayout layout = this->GetLayout();
  const vtkRectf place =
    part == MaterialPart::Name ? layout.GetName(row) : layout.GetBox(row, part);
  position[0] = place.GetLeft() + 0.5 * place.GetWidth();
  position[1] = place.GetBottom() + 0.5 * place.GetHeight();
  return true;
}

//------------------------------------------------------------------------------
bool HapticMaterialSheet::GetSliderPosition(int quantity, double value, double position[2]) const
{
  if (!this->List.IsCounted() || !this->List.GetSelected())
  {
    return false;
  }
  const vtkRectf place = this->GetLayout().GetSlider(quantity);
  position[0] = place.GetLeft() + place.GetWidth() * value / this->List.GetEnd(quantity);
  position[1] = place.GetBottom() + 0.5 * place.GetHeight();
  return true;
}

} // namespace VolumeHaptics
