// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/MeasuredLabels.h"

#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <cstddef>

namespace VolumeHaptics
{
namespace
{

using Box = MeasuredLabels::Box;

constexpr int FontSize = 13;  // points
constexpr double Near = 12.0; ///< pixels from the point to the text
constexpr double Step = 18.0; ///< pixels to the next try
constexpr int Rounds = 4;
constexpr double Margin = 3.0;

bool Overlap(const Box& a, const Box& b)
{
  return a.Left < b.Right && b.Left < a.Right && a.Bottom < b.Top && b.Bottom < a.Top;
}

/** A box of a size at one of eight sides of a point. */
Box PutBeside(const double at[2], const double size[2], int side, double distance)
{
  // The right side is best to read; then the left, above and below.
  static const double sides[8][2] = { { 1, 0 }, { -1, 0 }, { 0, 1 }, { 0, -1 }, { 0.7, 0.7 },
    { 0.7, -0.7 }, { -0.7, 0.7 }, { -0.7, -0.7 } };
  const double* const to = sides[side];
  const auto share = [](double way) { return way > 0.0 ? 0.0 : (way < 0.0 ? -1.0 : -0.5); };
  const double left = at[0] + distance * to[0] + share(to[0]) * size[0];
  const double bottom = at[1] + distance * to[1] + share(to[1]) * size[1];
  return { left, left + size[0], bottom, bottom + size[1] };
}

} // namespace

int MeasuredLabels::Render(vtkRenderer* renderer, const std::vector<Label>& labels,
  const std::function<bool(const Box&)>& isTaken)
{
  while (this->Actors.size() < labels.size())
  {
    this->Actors.push_back(std::make_unique<vtkNew<vtkTextActor>>());
    vtkTextProperty* const text = (*this->Actors.back())->GetTextProperty();
    text->SetFontSize(FontSize);
    text->SetColor(0.93, 0.97, 0.98);
    text->SetBackgroundColor(0.05, 0.09, 0.11);
    text->SetBackgroundOpacity(0.7);
  }
  const int* const view = renderer->GetSize();
  const int* const origin = renderer->GetOrigin();
  std::vector<Box> taken;
  int drawn = 0;
  for (std::size_t i = 0; i < labels.size(); ++i)
  {
    const Vector3& place = labels[i].Place;
    double shown[3];
    renderer->SetWorldPoint(place.X, place.Y, place.Z, 1.0);
    renderer->WorldToDisplay();
    renderer->GetDisplayPoint(shown);
    const double at[2] = { shown[0] - origin[0], shown[1] - origin[1] };
    if (!(shown[2] > 0.0 && shown[2] < 1.0) || at[0] < 0.0 || at[0] > view[0] || at[1] < 0.0 ||
      at[1] > view[1])
    {
      continue;
    }
    vtkTextActor* const actor = *this->Actors[i];
    actor->SetInput(labels[i].Text.c_str());
    double size[2];
    actor->GetSize(renderer, size);
    bool isPlaced = false;
    for (int round = 0; round < Rounds * 8 && !isPlaced; ++round)
    {
      const Box box = PutBeside(at, size, round % 8, Near + Step * (round / 8));
      const Box wide{ box.Left - Margin, box.Right + Margin, box.Bottom - Margin,
        box.Top + Margin };
      isPlaced = wide.Left >= 0.0 && wide.Right <= view[0] && wide.Bottom >= 0.0 &&
        wide.Top <= view[1] && !isTaken(wide) &&
        std::none_of(
          taken.begin(), taken.end(), [&wide](const Box& other) { return Overlap(wide, other); });
      if (isPlaced)
      {
        taken.push_back(wide);
        actor->SetPosition(box.Left, box.Bottom);
      }
    }
    if (isPlaced)
    {
      actor->RenderOpaqueGeometry(renderer); // draws the letters into the texture shown next
      actor->RenderOverlay(renderer);
      ++drawn;
    }
  }
  return drawn;
}

void MeasuredLabels::Release(vtkWindow* window)
{
  for (auto& actor : this->Actors)
  {
    (*actor)->ReleaseGraphicsResources(window);
  }
}

} // namespace VolumeHaptics
