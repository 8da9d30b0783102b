// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticKeySheet.h"

#include "vtkBrush.h"
#include "vtkContext2D.h"
#include "vtkObjectFactory.h"
#include "vtkPen.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <sstream>

vtkStandardNewMacro(HapticKeySheet);

namespace
{
constexpr int LargestLetters = 14; // points
constexpr int SmallestLetters = 6;
constexpr int PartLetters = 9; ///< points, used when only a part of the list fits
constexpr double TextColour[3] = { 0.90, 0.92, 0.95 };
constexpr double TitleColour[3] = { 1.0, 0.78, 0.35 };
constexpr int MostColumns = 3;
constexpr float KeySheetMargin = 10.0f; // pixels around the panel

/** Lengths relative to the size of letters. */
constexpr float LineHeight = 1.55f;
constexpr float TitleGap = 0.7f; ///< above a title
constexpr float KeyGap = 1.2f;
constexpr float ColumnGap = 2.5f;
constexpr float Padding = 1.3f;
} // namespace

//------------------------------------------------------------------------------
HapticKeySheet::HapticKeySheet() = default;

//------------------------------------------------------------------------------
HapticKeySheet::~HapticKeySheet() = default;

//------------------------------------------------------------------------------
void HapticKeySheet::Show(const std::string& text, int width, int height, double scale)
{
  if (text == this->Text && width == this->Viewport[0] && height == this->Viewport[1] &&
    static_cast<float>(scale) == this->Scale)
  {
    return;
  }
  this->Text = text;
  this->Viewport[0] = width;
  this->Viewport[1] = height;
  this->Scale = static_cast<float>(scale);
  this->Letters = 0;
  this->First = 0;
  this->Lines.clear();
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    const std::size_t tab = line.find('\t');
    if (tab != std::string::npos)
    {
      this->Lines.push_back({ line.substr(0, tab), line.substr(tab + 1), false });
    }
    else if (!line.empty())
    {
      this->Lines.push_back({ line, "", true });
    }
  }
}

//------------------------------------------------------------------------------
std::vector<HapticKeySheet::Column> HapticKeySheet::Divide(std::size_t count) const
{
  // Split the list into columns before titles only, so that each group stays together.
  std::vector<Column> columns{ { 0, this->Lines.size(), 0.0f, 0.0f, 0.0f } };
  for (std::size_t i = 1; i < count; ++i)
  {
    const std::size_t even = i * this->Lines.size() / count;
    std::size_t best = 0;
    for (std::size_t at = columns.back().Begin + 1; at < this->Lines.size(); ++at)
    {
      const auto distance = [even](std::size_t k) { return k > even ? k - even : even - k; };
      if (this->Lines[at].IsTitle && (best == 0 || distance(at) < distance(best)))
      {
        best = at;
      }
    }
    if (best == 0)
    {
      break;
    }
    columns.back().End = best;
    columns.push_back({ best, this->Lines.size(), 0.0f, 0.0f, 0.0f });
  }
  return columns;
}

//------------------------------------------------------------------------------
void HapticKeySheet::SetLetters(vtkContext2D* painter, bool isBold) const
{
  vtkTextProperty* const look = painter->GetTextProp();
  look->SetFontSize(this->Letters);
  look->SetBold(isBold);
  look->ItalicOff();
  look->SetOrientation(0.0);
  look->SetJustificationToLeft();
  look->SetVerticalJustificationToTop();
}

//------------------------------------------------------------------------------
void HapticKeySheet::Measure(vtkContext2D* painter, Column& column) const
{
  const auto widthOf = [painter](const std::string& part)
  {
    float bounds[4]; // x and y of the lower left corner, width, height
    painter->ComputeStringBounds(part, bounds);
    return bounds[2];
  };
  const float size = this->GetLetterHeight();
  float title = 0.0f;
  float meaning = 0.0f;
  column.KeyWidth = 0.0f;
  column.Height = 0.0f;
  for (std::size_t i = column.Begin; i < column.End; ++i)
  {
    const Line& line = this->Lines[i];
    this->SetLetters(painter, true);
    float& width = line.IsTitle ? title : column.KeyWidth;
    width = std::max(width, widthOf(line.Key));
    this->SetLetters(painter, false);
    meaning = std::max(meaning, line.Meaning.empty() ? 0.0f : widthOf(line.Meaning));
    column.Height += LineHeight * size;
    column.Height += line.IsTitle && i > column.Begin ? TitleGap * size : 0.0f;
  }
  column.Width = std::max(title, column.KeyWidth + KeyGap * size + meaning);
}

//------------------------------------------------------------------------------
void HapticKeySheet::Fit(vtkContext2D* painter)
{
  this->IsPart = false;
  for (int letters = LargestLetters; letters >= SmallestLetters; --letters)
  {
    if (this->FitAll(painter, letters))
    {
      return;
    }
  }
  this->FitPart(painter);
}

//------------------------------------------------------------------------------
bool HapticKeySheet::FitAll(vtkContext2D* painter, int letters)
{
  this->Letters = letters;
  const float size = this->GetLetterHeight();
  for (int count = 1; count <= MostColumns; ++count)
  {
    this->Columns = this->Divide(static_cast<std::size_t>(count));
    float width = -ColumnGap * size;
    float height = 0.0f;
    for (Column& column : this->Columns)
    {
      this->Measure(painter, column);
      width += column.Width + ColumnGap * size;
      height = std::max(height, column.Height);
    }
    const float around = 2.0f * (KeySheetMargin + Padding * size);
    if (width + around <= static_cast<float>(this->Viewport[0]) &&
      height + around <= static_cast<float>(this->Viewport[1]))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void HapticKeySheet::FitPart(vtkContext2D* painter)
{
  this->IsPart = true;
  Column all{ 0, this->Lines.size(), 0.0f, 0.0f, 0.0f };
  for (this->Letters = PartLetters; this->Letters > SmallestLetters; --this->Letters)
  {
    this->Measure(painter, all);
    const float around = 2.0f * Padding * this->GetLetterHeight();
    if (all.Width + around <= static_cast<float>(this->Viewport[0]))
    {
      break;
    }
  }
  this->Measure(painter, all);
  const float size = this->GetLetterHeight();
  // Reserve the last line for the hint on how to see the other parts.
  const float room = static_cast<float>(this->Viewport[1]) - (2.0f * Padding + LineHeight) * size;
  const auto fits = [&](std::size_t first, std::size_t end)
  {
    Column part{ first, end, 0.0f, 0.0f, 0.0f };
    this->Measure(painter, part);
    return part.Height <= room;
  };
  std::size_t last = this->Lines.size() - 1; // index of the first line of the last part
  while (last > 0 && fits(last - 1, this->Lines.size()))
  {
    --last;
  }
  this->First = std::min(this->First, last);
  std::size_t end = this->First + 1;
  while (end < this->Lines.size() && fits(this->First, end + 1))
  {
    ++end;
  }
  Column part{ this->First, end, 0.0f, 0.0f, 0.0f };
  this->Measure(painter, part);
  // Keep the panel as wide as for all lines, so that it stays unchanged while scrolling.
  part.Width = all.Width;
  part.KeyWidth = all.KeyWidth;
  this->Columns = { part };
}

//------------------------------------------------------------------------------
bool HapticKeySheet::Scroll(int lines)
{
  if (!this->IsPart)
  {
    return false;
  }
  const auto first = static_cast<int>(this->First) + lines;
  this->First = static_cast<std::size_t>(std::max(0, first));
  this->Letters = 0; // makes the next painting compute the part
  return true;
}

//------------------------------------------------------------------------------
void HapticKeySheet::PaintColumn(
  vtkContext2D* painter, const Column& column, float left, float top) const
{
  const float size = this->GetLetterHeight();
  vtkTextProperty* const look = painter->GetTextProp();
  float y = top;
  for (std::size_t i = column.Begin; i < column.End; ++i)
  {
    const Line& line = this->Lines[i];
    y -= line.IsTitle && i > column.Begin ? TitleGap * size : 0.0f;
    const double(&colour)[3] = line.IsTitle ? TitleColour : TextColour;
    look->SetColor(colour[0], colour[1], colour[2]);
    this->SetLetters(painter, true);
    painter->DrawString(left, y, line.Key);
    this->SetLetters(painter, false);
    if (!line.Meaning.empty())
    {
      painter->DrawString(left + column.KeyWidth + KeyGap * size, y, line.Meaning);
    }
    y -= LineHeight * size;
  }
}

//------------------------------------------------------------------------------
bool HapticKeySheet::Paint(vtkContext2D* painter)
{
  if (this->Lines.empty())
  {
    return true;
  }
  if (this->Letters == 0)
  {
    this->Fit(painter);
  }
  const float size = this->GetLetterHeight();
  float width = -ColumnGap * size;
  float height = 0.0f;
  for (const Column& column : this->Columns)
  {
    width += column.Width + ColumnGap * size;
    height = std::max(height, column.Height);
  }
  width += 2.0f * Padding * size;
  height += (2.0f * Padding + (this->IsPart ? LineHeight : 0.0f)) * size;
  const float left = std::max(0.0f, 0.5f * (static_cast<float>(this->Viewport[0]) - width));
  const float bottom = std::max(0.0f, 0.5f * (static_cast<float>(this->Viewport[1]) - height));
  painter->GetPen()->SetLineType(vtkPen::NO_PEN);
  painter->GetBrush()->SetColor(15, 18, 24, 225);
  painter->DrawRect(left, bottom, width, height);
  float x = left + Padding * size;
  for (const Column& column : this->Columns)
  {
    this->PaintColumn(painter, column, x, bottom + height - Padding * size);
    x += column.Width + ColumnGap * size;
  }
  if (this->IsPart)
  {
    painter->GetTextProp()->SetColor(TitleColour[0], TitleColour[1], TitleColour[2]);
    this->SetLetters(painter, false);
    painter->DrawString(left + Padding * size, bottom + (Padding + LineHeight) * size,
      this->Columns.back().End < this->Lines.size() ? "The wheel shows more" : "The end");
  }
  return true;
}
