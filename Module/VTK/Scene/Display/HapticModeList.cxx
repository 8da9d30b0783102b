// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticModeList.h"

#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Base/HapticTextLook.h"

#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkViewport.h"

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{
namespace
{

constexpr int LinePixels = 18;
constexpr double Inactive = 0.55; ///< grey level of inactive modes

} // namespace

HapticModeList::HapticModeList()
{
  for (Line& line : this->Lines)
  {
    vtkTextProperty* const look = line.Text->GetTextProperty();
    look->SetFontSize(14);
    look->SetVerticalJustificationToBottom();
  }
}

HapticModeList::~HapticModeList() = default;

int HapticModeList::Render(const std::vector<ModeLine>& lines, int top, vtkViewport* viewport)
{
  const int height = ScalePixels(PixelsPerPoint(viewport), LinePixels);
  this->Count = std::min(lines.size(), this->Lines.size());
  const int left = viewport->GetSize()[0] / 50; // same margin as the head-up display's text
  int drawn = 0;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    Line& line = this->Lines[i];
    const unsigned char* const c = ModeColors[i];
    const bool isActive = lines[i].IsActive;
    SetLook(line.Text->GetTextProperty(), isActive ? c[0] / 255.0 : Inactive,
      isActive ? c[1] / 255.0 : Inactive, isActive ? c[2] / 255.0 : Inactive, viewport);
    line.High = top - static_cast<int>(i) * height;
    line.Low = line.High - height;
    line.Text->SetInput(lines[i].Text.c_str());
    line.Text->SetPosition(left, line.Low);
    double size[2] = { 0.0, 0.0 };
    line.Text->GetSize(viewport, size);
    line.Width = left + static_cast<int>(size[0]);
    line.Text->RenderOpaqueGeometry(viewport);
    drawn += line.Text->RenderOverlay(viewport);
  }
  return drawn;
}

int HapticModeList::Find(int x, int y) const
{
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    const Line& line = this->Lines[i];
    if (x >= 0 && x < line.Width && y >= line.Low && y < line.High)
    {
      return static_cast<int>(i);
    }
  }
  return -1;
}

int HapticModeList::FindLow(int left) const
{
  int low = std::numeric_limits<int>::max();
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    low = this->Lines[i].Width >= left ? std::min(low, this->Lines[i].Low) : low;
  }
  return low;
}

void HapticModeList::Release(vtkWindow* window)
{
  for (Line& line : this->Lines)
  {
    line.Text->ReleaseGraphicsResources(window);
  }
}

} // namespace VolumeHaptics
