// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticMaterialLayout.h"

#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr float Margin = 6.0f;
constexpr float BarWidth = 9.0f;
constexpr int FooterLines = 1 + HapticMaterialList::Quantities;

bool Holds(const vtkRectf& r, float x, float y)
{
  return x >= r.GetLeft() && x < r.GetRight() && y >= r.GetBottom() && y < r.GetTop();
}

} // namespace

//------------------------------------------------------------------------------
HapticMaterialLayout::HapticMaterialLayout(
  const int rectangle[4], const HapticMaterialList& list, double scale)
  : List(list)
  , Area(static_cast<float>(rectangle[0]), static_cast<float>(rectangle[1]),
      static_cast<float>(rectangle[2]), static_cast<float>(rectangle[3]))
  , Font(FitLetters(std::min(rectangle[2], rectangle[3]), 21, scale, 8, 14))
  , Letter(static_cast<float>(scale * Font))
  , Line(std::round(1.6f * Letter))
{
  const float lines = (this->Area.GetHeight() - 3.0f * Margin) / this->Line;
  this->Room = std::max<vtkIdType>(1, static_cast<vtkIdType>(lines) - 1 - FooterLines);
}

//------------------------------------------------------------------------------
float HapticMaterialLayout::GetLineTop(int line) const
{
  return this->Area.GetTop() - Margin - static_cast<float>(line) * this->Line;
}

float HapticMaterialLayout::GetFooterTop() const
{
  return this->GetLineTop(1 + static_cast<int>(this->Room)) - Margin;
}

float HapticMaterialLayout::GetNamesRight() const
{
  return this->List.HasBoxes() ? this->GetHead(MaterialPart::Felt).GetLeft()
                               : this->Area.GetRight() - Margin - BarWidth;
}

vtkRectf HapticMaterialLayout::GetTitle() const
{
  const float right = this->GetNamesRight();
  const float left = this->Area.GetLeft() + Margin;
  return { left, this->GetLineTop(1), std::max(0.0f, right - left), this->Line };
}

vtkRectf HapticMaterialLayout::GetHead(MaterialPart::KindType column) const
{
  const float width = 3.1f * this->Letter;
  const float fromRight = column == MaterialPart::Felt ? 2.0f : 1.0f;
  return { this->Area.GetRight() - Margin - BarWidth - fromRight * width, this->GetLineTop(1),
    width, this->Line };
}

//------------------------------------------------------------------------------
vtkRectf HapticMaterialLayout::GetRow(vtkIdType row) const
{
  const int line = static_cast<int>(row - this->List.GetFirstRow());
  return { this->Area.GetLeft() + Margin, this->GetLineTop(line + 2),
    this->Area.GetWidth() - 2.0f * Margin - BarWidth, this->Line };
}

vtkRectf HapticMaterialLayout::GetSwatch(vtkIdType row) const
{
  const vtkRectf r = this->GetRow(row);
  const float inset = 3.0f;
  return { r.GetLeft() + inset, r.GetBottom() + inset, this->Line - 2.0f * inset,
    this->Line - 2.0f * inset };
}

vtkRectf HapticMaterialLayout::GetName(vtkIdType row) const
{
  const vtkRectf r = this->GetRow(row);
  const float left = r.GetLeft() + this->Line + 2.0f;
  const float right = this->GetNamesRight();
  return { left, r.GetBottom(), std::max(0.0f, right - left), this->Line };
}

vtkRectf HapticMaterialLayout::GetBox(vtkIdType row, MaterialPart::KindType column) const
{
  const vtkRectf head = this->GetHead(column);
  const float size = this->Letter;
  const vtkRectf r = this->GetRow(row);
  return { std::round(head.GetLeft() + 0.5f * (head.GetWidth() - size)),
    std::round(r.GetBottom() + 0.5f * (this->Line - size)), size, size };
}

//------------------------------------------------------------------------------
vtkRectf HapticMaterialLayout::GetScrollBar() const
{
  const float bottom = this->GetLineTop(1 + static_cast<int>(this->Room));
  return { this->Area.GetRight() - Margin - BarWidth + 2.0f, bottom, BarWidth - 2.0f,
    this->GetLineTop(1) - bottom };
}

vtkRectf HapticMaterialLayout::GetThumb() const
{
  constexpr float least = 8.0f;
  const vtkRectf bar = this->GetScrollBar();
  const auto rows = static_cast<float>(std::max<vtkIdType>(1, this->List.GetNumberOfRows()));
  const auto room = static_cast<float>(this->Room);
  const float height =
    std::clamp(bar.GetHeight() * room / rows, std::min(least, bar.GetHeight()), bar.GetHeight());
  const float share =
    rows > room ? static_cast<float>(this->List.GetFirstRow()) / (rows - room) : 0.0f;
  return { bar.GetLeft(), bar.GetTop() - height - share * (bar.GetHeight() - height),
    bar.GetWidth(), height };
}

vtkIdType HapticMaterialLayout::GetFirstRowAt(float y) const
{
  const vtkRectf bar = this->GetScrollBar();
  const float height = this->GetThumb().GetHeight();
  const double way = std::max(1.0f, bar.GetHeight() - height);
  const double share = std::clamp((bar.GetTop() - 0.5f * height - y) / way, 0.0, 1.0);
  return std::llround(
    share * static_cast<double>(std::max<vtkIdType>(0, this->List.GetNumberOfRows() - this->Room)));
}

//------------------------------------------------------------------------------
vtkRectf HapticMaterialLayout::GetSelectedName() const
{
  const float left = this->Area.GetLeft() + Margin;
  return { left, this->GetFooterTop() - this->Line,
    std::max(0.0f,
      (this->List.HasBoxes() ? this->GetByFunctions().GetLeft() : this->Area.GetRight() - Margin) -
        left),
    this->Line };
}

vtkRectf HapticMaterialLayout::GetByFunctions() const
{
  const float width = 7.0f * this->Letter;
  return { this->Area.GetRight() - Margin - width, this->GetFooterTop() - this->Line + 1.0f, width,
    this->Line - 2.0f };
}

vtkRectf HapticMaterialLayout::GetQuantityTitle(int quantity) const
{
  return { this->Area.GetLeft() + Margin,
    this->GetFooterTop() - static_cast<float>(quantity + 2) * this->Line, 8.5f * this->Letter,
    this->Line };
}

vtkRectf HapticMaterialLayout::GetSlider(int quantity) const
{
  const vtkRectf title = this->GetQuantityTitle(quantity);
  return { title.GetRight(), title.GetBottom() + 2.0f,
    std::max(1.0f, this->Area.GetRight() - Margin - title.GetRight()), this->Line - 4.0f };
}

//------------------------------------------------------------------------------
MaterialPart HapticMaterialLayout::Find(float x, float y) const
{
  if (Holds(this->GetScrollBar(), x, y))
  {
    return { MaterialPart::ScrollBar };
  }
  const vtkIdType first = this->List.GetFirstRow();
  const vtkIdType end = std::min(this->List.GetNumberOfRows(), first + this->Room);
  for (vtkIdType row = first; row < end; ++row)
  {
    if (Holds(this->GetRow(row), x, y))
    {
      const MaterialPart::KindType kind = !this->List.HasBoxes() ? MaterialPart::Name
        : x >= this->GetHead(MaterialPart::Forbidden).GetLeft()  ? MaterialPart::Forbidden
        : x >= this->GetHead(MaterialPart::Felt).GetLeft()       ? MaterialPart::Felt
                                                                 : MaterialPart::Name;
      return { kind, row };
    }
  }
  if (this->List.GetSelected())
  {
    for (int quantity = 0; quantity < HapticMaterialList::Quantities; ++quantity)
    {
      if (Holds(this->GetSlider(quantity), x, y))
      {
        return { MaterialPart::Slider, 0, quantity };
      }
    }
    if (this->List.HasBoxes() && Holds(this->GetByFunctions(), x, y))
    {
      return { MaterialPart::ByFunctions };
    }
  }
  return {};
}

} // namespace VolumeHaptics
