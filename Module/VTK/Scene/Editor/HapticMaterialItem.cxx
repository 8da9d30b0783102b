// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticMaterialItem.h"

#include "VTK/Scene/Base/HapticChartText.h"
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

vtkStandardNewMacro(HapticMaterialItem);

namespace
{
using VolumeHaptics::HapticMaterialLayout;
using VolumeHaptics::HapticMaterialList;
using VolumeHaptics::MaterialPart;

using Colour = unsigned char[3];
constexpr Colour SelectedColour = { 205, 222, 245 };
constexpr Colour FrameColour = { 120, 125, 135 };
constexpr Colour EmptyColour = { 255, 255, 255 };
constexpr Colour BarColour = { 150, 155, 165 };
constexpr Colour ValueColour = { 120, 170, 225 };
constexpr Colour FeltColour = { 0, 92, 175 };
constexpr Colour ForbiddenColour = { 190, 30, 30 };
constexpr double Ink[3] = { 0.12, 0.13, 0.15 };
constexpr double FaintInk[3] = { 0.45, 0.47, 0.5 };

void PaintBox(vtkContext2D* painter, const vtkRectf& box, const Colour& fill)
{
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(fill[0], fill[1], fill[2], 255);
  painter->DrawRect(box.GetX(), box.GetY(), box.GetWidth(), box.GetHeight());
}

void PaintFrame(vtkContext2D* painter, const vtkRectf& box)
{
  PaintBox(painter, box, FrameColour);
  PaintBox(painter,
    { box.GetX() + 1.0f, box.GetY() + 1.0f, box.GetWidth() - 2.0f, box.GetHeight() - 2.0f },
    EmptyColour);
}

/** The longest beginning of a UTF-8 text that fits into a width (pixels). */
std::string Shorten(vtkContext2D* painter, const std::string& text, float width)
{
  const auto widthOf = [painter](const std::string& part)
  {
    float bounds[4]; // lower left corner, width and height
    painter->ComputeStringBounds(part, bounds);
    return bounds[2];
  };
  if (widthOf(text) <= width)
  {
    return text;
  }
  constexpr const char* rest = "...";
  const auto isWithin = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; };
  std::size_t fits = 0; // bytes
  std::size_t tooLong = text.size();
  while (fits + 1 < tooLong)
  {
    std::size_t middle = (fits + tooLong) / 2;
    while (middle > fits && isWithin(text[middle]))
    {
      --middle;
    }
    if (middle == fits)
    {
      break; // keeps at least one character
    }
    (widthOf(text.substr(0, middle) + rest) <= width ? fits : tooLong) = middle;
  }
  return fits == 0 ? std::string() : text.substr(0, fits) + rest;
}

enum class Side
{
  Left,
  Middle
};

void PaintText(vtkContext2D* painter, const vtkRectf& box, const std::string& text, Side side,
  int size, const double (&ink)[3])
{
  vtkTextProperty* const property = painter->GetTextProp();
  VolumeHaptics::SetChartText(property, size, ink);
  property->SetJustification(side == Side::Left ? VTK_TEXT_LEFT : VTK_TEXT_CENTERED);
  property->SetVerticalJustificationToCentered();
  const std::string fitting = Shorten(painter, text, box.GetWidth());
  if (!fitting.empty())
  {
    const float x = side == Side::Left ? box.GetLeft() : box.GetLeft() + 0.5f * box.GetWidth();
    painter->DrawString(
      std::round(x), std::round(box.GetBottom() + 0.5f * box.GetHeight()), fitting);
  }
}

/** A number with three digits, in any locale. */
std::string WriteValue(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  if (value >= 1000.0)
  {
    text << std::fixed << std::setprecision(0);
  }
  text << value;
  return text.str();
}

} // namespace

//------------------------------------------------------------------------------
HapticMaterialItem::HapticMaterialItem()
{
  this->SetInteractive(false);
}

HapticMaterialItem::~HapticMaterialItem() = default;

//------------------------------------------------------------------------------
void HapticMaterialItem::Show(const HapticMaterialList& list, const int rectangle[4], double scale)
{
  this->Scale = scale;
  this->List = &list;
  std::copy_n(rectangle, 4, this->Rectangle);
}

//------------------------------------------------------------------------------
bool HapticMaterialItem::Paint(vtkContext2D* painter)
{
  if (!this->List)
  {
    return true;
  }
  const HapticMaterialList& list = *this->List;
  const HapticMaterialLayout layout(this->Rectangle, list, this->Scale);
  const int font = layout.GetFontSize();
  const vtkIdType rows = list.GetNumberOfRows();
  PaintText(painter, layout.GetTitle(), list.GetTitle(), Side::Left, font, Ink);
  if (rows == 0)
  {
    return true;
  }
  if (list.HasBoxes())
  {
    PaintText(painter, layout.GetHead(MaterialPart::Felt), "felt", Side::Middle, font - 1, Ink);
    PaintText(
      painter, layout.GetHead(MaterialPart::Forbidden), "forbid", Side::Middle, font - 1, Ink);
  }
  const vtkIdType end = std::min(rows, list.GetFirstRow() + layout.GetRoom());
  for (vtkIdType row = list.GetFirstRow(); row < end; ++row)
  {
    this->PaintRow(painter, layout, row);
  }
  if (rows > layout.GetRoom())
  {
    PaintBox(painter, layout.GetScrollBar(), EmptyColour);
    PaintBox(painter, layout.GetThumb(), BarColour);
  }
  this->PaintMaterial(painter, layout);
  return true;
}

//------------------------------------------------------------------------------
void HapticMaterialItem::PaintRow(
  vtkContext2D* painter, const HapticMaterialLayout& layout, vtkIdType row)
{
  const HapticMaterialList& list = *this->List;
  const int key = list.GetKey(row);
  if (list.GetSelected() == key)
  {
    PaintBox(painter, layout.GetRow(row), SelectedColour);
  }
  PaintFrame(painter, layout.GetSwatch(row));
  const std::array<double, 3> color = list.GetColor(key);
  constexpr double most = 255.0;
  Colour shown;
  for (int i = 0; i < 3; ++i)
  {
    shown[i] = static_cast<unsigned char>(std::lround(most * color[i]));
  }
  const auto inner = [](const vtkRectf& r, float inset)
  {
    return vtkRectf(r.GetX() + inset, r.GetY() + inset, r.GetWidth() - 2.0f * inset,
      r.GetHeight() - 2.0f * inset);
  };
  PaintBox(painter, inner(layout.GetSwatch(row), 1.0f), shown);
  const bool isFelt = list.IsFelt(key);
  PaintText(painter, layout.GetName(row), list.Describe(key), Side::Left, layout.GetFontSize(),
    isFelt ? Ink : FaintInk);
  if (!list.HasBoxes())
  {
    return;
  }
  const vtkRectf felt = layout.GetBox(row, MaterialPart::Felt);
  PaintFrame(painter, felt);
  if (isFelt)
  {
    PaintBox(painter, inner(felt, 3.0f), FeltColour);
  }
  const vtkRectf forbidden = layout.GetBox(row, MaterialPart::Forbidden);
  PaintFrame(painter, forbidden);
  if (list.IsForbidden(key))
  {
    PaintBox(painter, inner(forbidden, 3.0f), ForbiddenColour);
  }
}

//------------------------------------------------------------------------------
void HapticMaterialItem::PaintMaterial(vtkContext2D* painter, const HapticMaterialLayout& layout)
{
  const auto selected = this->List->GetSelected();
  if (!selected)
  {
    const vtkRectf name = layout.GetSelectedName();
    const float right = layout.GetByFunctions().GetRight();
    PaintText(painter,
      { name.GetLeft(), name.GetBottom(), right - name.GetLeft(), name.GetHeight() },
      this->List->GetHint(), Side::Left, layout.GetFontSize(), FaintInk);
    return;
  }
  PaintText(painter, layout.GetSelectedName(), this->List->Describe(*selected), Side::Left,
    layout.GetFontSize(), Ink);
  if (this->List->HasBoxes())
  {
    PaintFrame(painter, layout.GetByFunctions());
    PaintText(painter, layout.GetByFunctions(), "by functions", Side::Middle,
      layout.GetFontSize() - 1, this->List->HasMaterial(*selected) ? Ink : FaintInk);
  }
  for (int quantity = 0; quantity < HapticMaterialList::Quantities; ++quantity)
  {
    this->PaintSlider(painter, layout, quantity);
  }
}

//------------------------------------------------------------------------------
void HapticMaterialItem::PaintSlider(
  vtkContext2D* painter, const HapticMaterialLayout& layout, int quantity)
{
  const HapticMaterialList& list = *this->List;
  const int font = layout.GetFontSize();
  PaintText(painter, layout.GetQuantityTitle(quantity),
    HapticMaterialList::GetQuantity(quantity).Title, Side::Left, font - 1, Ink);
  const vtkRectf bar = layout.GetSlider(quantity);
  PaintBox(painter, bar, EmptyColour);
  const double value = list.GetValue(quantity);
  if (value >= 0.0)
  {
    const double share = std::min(1.0, value / list.GetEnd(quantity));
    PaintBox(painter,
      { bar.GetX(), bar.GetY(), bar.GetWidth() * static_cast<float>(share), bar.GetHeight() },
      ValueColour);
    PaintText(painter, bar, WriteValue(value), Side::Middle, font - 1, Ink);
  }
  else
  {
    PaintText(painter, bar, "by functions", Side::Middle, font - 1, FaintInk);
  }
}
