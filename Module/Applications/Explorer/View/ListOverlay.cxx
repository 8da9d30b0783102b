// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/View/ListOverlay.h"

#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkTextProperty.h"

#include <algorithm>
#include <cmath>

namespace
{
constexpr int MOST_LINES = 16;          // visible lines
constexpr std::size_t WIDEST_LINE = 68; // characters in a line
constexpr int LINES_BEFORE = 2;         // the title, and an empty line
constexpr int LINES_AFTER = 2;          // an empty line, and the keys
constexpr double LIST_LEFT = 0.08;      // left margin, as a fraction of the viewport
constexpr int LEAST_LETTERS = 6;        // smallest font size (points)
constexpr double LIST_OPACITY = 0.85;   // opacity of the background behind the text

/// Shortens a long line by removing its middle, which is the least informative part.
std::string Shorten(const std::string& line)
{
  if (line.size() <= WIDEST_LINE)
  {
    return line;
  }
  constexpr std::size_t end = WIDEST_LINE / 2;
  return line.substr(0, WIDEST_LINE - end - 3) + "..." + line.substr(line.size() - end);
}
} // namespace

namespace Explore
{
ListOverlay::ListOverlay(vtkRenderer* overlay)
  : Overlay(overlay)
{
  vtkTextProperty* const look = this->Text->GetTextProperty();
  look->SetColor(0.93, 0.95, 0.98);
  look->SetBackgroundColor(0.05, 0.07, 0.10);
  look->SetBackgroundOpacity(LIST_OPACITY);
  look->SetVerticalJustificationToCentered();
  this->Text->VisibilityOff();
  overlay->AddViewProp(this->Text);
}

ListOverlay::~ListOverlay()
{
  this->Overlay->RemoveViewProp(this->Text);
}

void ListOverlay::Show(const std::string& title, const std::vector<std::string>& lines, int marked)
{
  this->Title = title;
  this->Lines = lines;
  this->Marked = std::clamp(marked, 0, std::max(0, static_cast<int>(lines.size()) - 1));
  this->First = 0;
  this->Text->VisibilityOn();
  this->Write();
}

void ListOverlay::Hide()
{
  this->Text->VisibilityOff();
}

bool ListOverlay::IsShown() const
{
  return this->Text->GetVisibility() != 0;
}

void ListOverlay::Move(int lines)
{
  this->Marked =
    std::clamp(this->Marked + lines, 0, std::max(0, static_cast<int>(this->Lines.size()) - 1));
  this->Write();
}

int ListOverlay::Find(int x, int y) const
{
  const int* const origin = this->Overlay->GetOrigin();
  x -= origin[0];
  y -= origin[1];
  double box[4];
  this->Text->GetBoundingBox(this->Overlay, box);
  const double* const place = this->Text->GetPosition();
  const double bottom = place[1] + box[2];
  const double height = box[3] - box[2];
  const int count = LINES_BEFORE + this->Seen + LINES_AFTER;
  if (!this->IsShown() || height <= 0.0 || x < place[0] + box[0] || x > place[0] + box[1])
  {
    return -1;
  }
  const int row = static_cast<int>(std::floor((bottom + height - y) * count / height));
  const int line = row - LINES_BEFORE;
  return line >= 0 && line < this->Seen ? this->First + line : -1;
}

void ListOverlay::Write()
{
  const int count = static_cast<int>(this->Lines.size());
  this->Seen = std::min(count, MOST_LINES);
  this->First = std::clamp(this->First, this->Marked - this->Seen + 1, this->Marked);
  std::string text = Shorten(this->Title) + "\n";
  for (int i = this->First; i < this->First + this->Seen; ++i)
  {
    text += (i == this->Marked ? "\n >  " : "\n     ") + Shorten(this->Lines[i]);
  }
  text += "\n\nUp, Down and Return, or a click; Escape: back to the scene";
  const int* const size = this->Overlay->GetSize();
  vtkTextProperty* const look = this->Text->GetTextProperty();
  look->SetFontSize(
    VolumeHaptics::FitLetters(size[1], 34, VolumeHaptics::PixelsPerPoint(this->Overlay), 11, 18));
  this->Text->SetInput(text.c_str());
  // The position is relative to the viewport, which is smaller than the window beside docks.
  this->Text->SetPosition(LIST_LEFT * size[0], 0.5 * size[1]);
  double shown[2];
  this->Text->GetSize(this->Overlay, shown);
  const double scale =
    std::min((1.0 - 2.0 * LIST_LEFT) * size[0] / shown[0], (1.0 - LIST_LEFT) * size[1] / shown[1]);
  if (scale < 1.0)
  {
    look->SetFontSize(std::max(LEAST_LETTERS, static_cast<int>(scale * look->GetFontSize())));
  }
}
} // namespace Explore
