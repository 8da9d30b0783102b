// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Charts/HapticLabelSheet.h"

#include "VTK/Charts/HapticChartText.h"

#include "vtkCommand.h"
#include "vtkContextMouseEvent.h"
#include "vtkContextScene.h"
#include "vtkHapticLabelTable.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

/** The parts of a slider that can be told apart. */
constexpr double SliderSteps = 200.0;
constexpr double RowsPerTurn = 3.0;

} // namespace

HapticLabelSheet::HapticLabelSheet()
{
  MakePanel(this->Panel);
  this->Actor->GetScene()->AddItem(this->Panel);
  this->Actor->GetScene()->AddItem(this->Item);
}

//------------------------------------------------------------------------------
void HapticLabelSheet::Place(const int rectangle[4])
{
  std::copy_n(rectangle, 4, this->Rectangle);
  this->Panel->SetDimensions(static_cast<float>(rectangle[0]), static_cast<float>(rectangle[1]),
    static_cast<float>(rectangle[2]), static_cast<float>(rectangle[3]));
  this->List.SetVisibleRows(this->GetLayout().GetRoom());
  this->Item->Show(this->List, this->Rectangle);
  if (this->Held.Kind != LabelPart::Slider)
  {
    this->List.FitEnds();
  }
}

//------------------------------------------------------------------------------
void HapticLabelSheet::Slide(int quantity, float x)
{
  const vtkRectf bar = this->GetLayout().GetSlider(quantity);
  const double share = std::clamp<double>((x - bar.GetLeft()) / bar.GetWidth(), 0.0, 1.0);
  this->List.SetValue(
    quantity, std::round(share * SliderSteps) / SliderSteps * this->List.GetEnd(quantity));
}

//------------------------------------------------------------------------------
void HapticLabelSheet::SendMouse(int event, int button, int x, int y)
{
  if (!this->List.Table || button != vtkContextMouseEvent::LEFT_BUTTON)
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
void HapticLabelSheet::Press(int x, int y)
{
  const LabelPart part = this->GetLayout().Find(static_cast<float>(x), static_cast<float>(y));
  this->Held = part;
  vtkHapticLabelTable* const table = this->List.Table;
  switch (part.Kind)
  {
    case LabelPart::Nothing:
      break;
    case LabelPart::Name:
      this->List.Select(this->List.GetLabel(part.Row));
      break;
    case LabelPart::Felt:
    case LabelPart::Forbidden:
    {
      const int label = this->List.GetLabel(part.Row);
      this->List.Select(label);
      part.Kind == LabelPart::Felt ? table->SetFelt(label, !table->GetFelt(label))
                                   : table->SetForbidden(label, !table->GetForbidden(label));
      break;
    }
    case LabelPart::ByFunctions:
      table->RemoveMaterial(*this->List.GetSelected());
      break;
    case LabelPart::ScrollBar:
    case LabelPart::Slider:
      this->Move(x, y);
  }
}

//------------------------------------------------------------------------------
void HapticLabelSheet::Move(int x, int y)
{
  if (this->Held.Kind == LabelPart::ScrollBar)
  {
    this->List.ScrollTo(this->GetLayout().GetFirstRowAt(static_cast<float>(y)));
  }
  else if (this->Held.Kind == LabelPart::Slider)
  {
    this->Slide(this->Held.Quantity, static_cast<float>(x));
  }
}

//------------------------------------------------------------------------------
void HapticLabelSheet::Release()
{
  this->Held = {};
  this->List.FitEnds();
}

//------------------------------------------------------------------------------
void HapticLabelSheet::Turn(int x, int y, double steps)
{
  const LabelPart part = this->GetLayout().Find(static_cast<float>(x), static_cast<float>(y));
  if (part.Kind == LabelPart::Slider)
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
bool HapticLabelSheet::GetLabelPosition(
  int label, LabelPart::KindType part, double position[2]) const
{
  const vtkIdType row = this->List.FindRow(label);
  const vtkIdType first = this->List.GetFirstRow();
  if (!this->List.IsCounted() || row < first || row >= first + this->List.GetVisibleRows())
  {
    return false;
  }
  const HapticLabelLayout layout = this->GetLayout();
  const vtkRectf place = part == LabelPart::Name ? layout.GetName(row) : layout.GetBox(row, part);
  position[0] = place.GetLeft() + 0.5 * place.GetWidth();
  position[1] = place.GetBottom() + 0.5 * place.GetHeight();
  return true;
}

//------------------------------------------------------------------------------
bool HapticLabelSheet::GetSliderPosition(int quantity, double value, double position[2]) const
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
