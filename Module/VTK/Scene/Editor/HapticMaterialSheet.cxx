// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/HapticMaterialSheet.h"

#include "VTK/Scene/Base/HapticChartText.h"
#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Editor/HapticMaterialList.h"

#include "vtkBrush.h"
#include "vtkCommand.h"
#include "vtkContext2D.h"
#include "vtkContextItem.h"
#include "vtkContextMouseEvent.h"
#include "vtkContextScene.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>
#include <string>

namespace
{
using VolumeHaptics::HapticMaterialLayout;
using VolumeHaptics::HapticMaterialList;
using VolumeHaptics::MaterialPart;

using SheetColour = unsigned char[3];
constexpr SheetColour SelectedColour = { 205, 222, 245 };
constexpr SheetColour FrameColour = { 120, 125, 135 };
constexpr SheetColour EmptyColour = { 255, 255, 255 };
constexpr SheetColour BarColour = { 150, 155, 165 };
constexpr SheetColour ValueColour = { 120, 170, 225 };
constexpr SheetColour FeltColour = { 0, 92, 175 };
constexpr SheetColour ForbiddenColour = { 190, 30, 30 };
constexpr double Ink[3] = { 0.12, 0.13, 0.15 };
constexpr double FaintInk[3] = { 0.45, 0.47, 0.5 };

void PaintBox(vtkContext2D* painter, const vtkRectf& box, const SheetColour& fill)
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

/** Shortens a UTF-8 text to a width (pixels). */
std::string Shorten(vtkContext2D* painter, const std::string& text, float width)
{
  const auto widthOf = [painter](const std::string& part)
  {
    float bounds[4]; // x and y of the lower left corner, width, height
    painter->ComputeStringBounds(part, bounds);
    return bounds[2];
  };
  if (widthOf(text) <= width)
  {
    return text;
  }
  constexpr const char* rest = "...";
  const auto isWithin = [](char byte) { return (static_cast<unsigned char>(byte) & 0xC0) == 0x80; };
  std::size_t fits = 0; // bytes of the text that fit
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
      break; // not even the first character fits
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

/** Formats a number with three digits, in any locale. */
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

/** Draws a list of materials, and the material of the selected row. */
class HapticMaterialItem : public vtkContextItem
{
public:
  static HapticMaterialItem* New();
  vtkTypeMacro(HapticMaterialItem, vtkContextItem);

  /**
   * Sets the list to draw, which must outlive the item, its rectangle, and the pixels per point.
   */
  void Show(
    const VolumeHaptics::HapticMaterialList& list, const int rectangle[4], double scale = 1.0);

  bool Paint(vtkContext2D* painter) override;

protected:
  HapticMaterialItem();
  ~HapticMaterialItem() override;

private:
  HapticMaterialItem(const HapticMaterialItem&) = delete;
  void operator=(const HapticMaterialItem&) = delete;

  void PaintRow(
    vtkContext2D* painter, const VolumeHaptics::HapticMaterialLayout& layout, vtkIdType row);
  void PaintMaterial(vtkContext2D* painter, const VolumeHaptics::HapticMaterialLayout& layout);
  void PaintSlider(
    vtkContext2D* painter, const VolumeHaptics::HapticMaterialLayout& layout, int quantity);

  const VolumeHaptics::HapticMaterialList* List = nullptr;
  int Rectangle[4] = { 0, 0, 1, 1 };
  double Scale = 1.0; ///< pixels per point
};

vtkStandardNewMacro(HapticMaterialItem);

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
  SheetColour shown;
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
    const double fraction = std::min(1.0, value / list.GetEnd(quantity));
    PaintBox(painter,
      { bar.GetX(), bar.GetY(), bar.GetWidth() * static_cast<float>(fraction), bar.GetHeight() },
      ValueColour);
    PaintText(painter, bar, WriteValue(value), Side::Middle, font - 1, Ink);
  }
  else
  {
    PaintText(painter, bar, "by functions", Side::Middle, font - 1, FaintInk);
  }
}

namespace VolumeHaptics
{
namespace
{

constexpr float SheetMargin = 6.0f;
constexpr float BarWidth = 9.0f;
constexpr int FooterLines = 1 + HapticMaterialList::Quantities;

bool Holds(const vtkRectf& r, float x, float y)
{
  return x >= r.GetLeft() && x < r.GetRight() && y >= r.GetBottom() && y < r.GetTop();
}

/** Steps over the whole range of a slider, for the wheel and for the mouse. */
constexpr double SliderSteps = 200.0;
constexpr double RowsPerTurn = 3.0;

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
  const float lines = (this->Area.GetHeight() - 3.0f * SheetMargin) / this->Line;
  this->Room = std::max<vtkIdType>(1, static_cast<vtkIdType>(lines) - 1 - FooterLines);
}

//------------------------------------------------------------------------------
float HapticMaterialLayout::GetLineTop(int line) const
{
  return this->Area.GetTop() - SheetMargin - static_cast<float>(line) * this->Line;
}

float HapticMaterialLayout::GetFooterTop() const
{
  return this->GetLineTop(1 + static_cast<int>(this->Room)) - SheetMargin;
}

float HapticMaterialLayout::GetNamesRight() const
{
  return this->List.HasBoxes() ? this->GetHead(MaterialPart::Felt).GetLeft()
                               : this->Area.GetRight() - SheetMargin - BarWidth;
}

vtkRectf HapticMaterialLayout::GetTitle() const
{
  const float right = this->GetNamesRight();
  const float left = this->Area.GetLeft() + SheetMargin;
  return { left, this->GetLineTop(1), std::max(0.0f, right - left), this->Line };
}

vtkRectf HapticMaterialLayout::GetHead(MaterialPart::KindType column) const
{
  const float width = 3.1f * this->Letter;
  const float fromRight = column == MaterialPart::Felt ? 2.0f : 1.0f;
  return { this->Area.GetRight() - SheetMargin - BarWidth - fromRight * width, this->GetLineTop(1),
    width, this->Line };
}

//------------------------------------------------------------------------------
vtkRectf HapticMaterialLayout::GetRow(vtkIdType row) const
{
  const int line = static_cast<int>(row - this->List.GetFirstRow());
  return { this->Area.GetLeft() + SheetMargin, this->GetLineTop(line + 2),
    this->Area.GetWidth() - 2.0f * SheetMargin - BarWidth, this->Line };
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
  return { this->Area.GetRight() - SheetMargin - BarWidth + 2.0f, bottom, BarWidth - 2.0f,
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
  const float fraction =
    rows > room ? static_cast<float>(this->List.GetFirstRow()) / (rows - room) : 0.0f;
  return { bar.GetLeft(), bar.GetTop() - height - fraction * (bar.GetHeight() - height),
    bar.GetWidth(), height };
}

vtkIdType HapticMaterialLayout::GetFirstRowAt(float y) const
{
  const vtkRectf bar = this->GetScrollBar();
  const float height = this->GetThumb().GetHeight();
  const double way = std::max(1.0f, bar.GetHeight() - height);
  const double fraction = std::clamp((bar.GetTop() - 0.5f * height - y) / way, 0.0, 1.0);
  return std::llround(fraction *
    static_cast<double>(std::max<vtkIdType>(0, this->List.GetNumberOfRows() - this->Room)));
}

//------------------------------------------------------------------------------
vtkRectf HapticMaterialLayout::GetSelectedName() const
{
  const float left = this->Area.GetLeft() + SheetMargin;
  return { left, this->GetFooterTop() - this->Line,
    std::max(0.0f,
      (this->List.HasBoxes() ? this->GetByFunctions().GetLeft()
                             : this->Area.GetRight() - SheetMargin) -
        left),
    this->Line };
}

vtkRectf HapticMaterialLayout::GetByFunctions() const
{
  const float width = 7.0f * this->Letter;
  return { this->Area.GetRight() - SheetMargin - width, this->GetFooterTop() - this->Line + 1.0f,
    width, this->Line - 2.0f };
}

vtkRectf HapticMaterialLayout::GetQuantityTitle(int quantity) const
{
  return { this->Area.GetLeft() + SheetMargin,
    this->GetFooterTop() - static_cast<float>(quantity + 2) * this->Line, 8.5f * this->Letter,
    this->Line };
}

vtkRectf HapticMaterialLayout::GetSlider(int quantity) const
{
  const vtkRectf title = this->GetQuantityTitle(quantity);
  return { title.GetRight(), title.GetBottom() + 2.0f,
    std::max(1.0f, this->Area.GetRight() - SheetMargin - title.GetRight()), this->Line - 4.0f };
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

HapticMaterialSheet::HapticMaterialSheet(HapticMaterialList& list)
  : List(list)
{
  MakePanel(this->Panel);
  this->Actor->GetScene()->AddItem(this->Panel);
  this->Actor->GetScene()->AddItem(this->Item);
}

//------------------------------------------------------------------------------
HapticMaterialSheet::~HapticMaterialSheet() = default;

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
  const double fraction = std::clamp<double>((x - bar.GetLeft()) / bar.GetWidth(), 0.0, 1.0);
  this->List.SetValue(
    quantity, std::round(fraction * SliderSteps) / SliderSteps * this->List.GetEnd(quantity));
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
    // Keep a value that a program has set above the slider's largest end.
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
