// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Slices/SliceLayout.h"

#include "vtkRenderWindow.h"
#include "vtkRendererCollection.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

std::array<double, 4> ViewportOf(vtkRenderer* renderer)
{
  std::array<double, 4> viewport;
  renderer->GetViewport(viewport.data());
  return viewport;
}

} // namespace

void SliceLayout::Place(
  vtkRenderWindow* window, const std::array<vtkRenderer*, 3>& column, double share)
{
  const double left = 1.0 - share;
  for (int i = 0; i < 3; ++i)
  {
    const std::array<double, 4> wanted{ left, (2 - i) / 3.0, 1.0, (3 - i) / 3.0 };
    if (ViewportOf(column[i]) != wanted)
    {
      column[i]->SetViewport(wanted.data());
    }
  }
  vtkRendererCollection* const renderers = window->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* const renderer = renderers->GetNextRenderer(at))
  {
    if (std::find(column.begin(), column.end(), renderer) != column.end())
    {
      continue;
    }
    const auto known = std::find_if(this->All.begin(), this->All.end(),
      [renderer](const Narrowed& one) { return one.Renderer == renderer; });
    Narrowed& one = known != this->All.end() ? *known : this->All.emplace_back();
    const std::array<double, 4> viewport = ViewportOf(renderer);
    if (known == this->All.end() || viewport != one.Now)
    {
      one.Renderer = renderer;
      one.Before = viewport;
    }
    one.Now = { left * one.Before[0], one.Before[1], left * one.Before[2], one.Before[3] };
    if (viewport != one.Now)
    {
      renderer->SetViewport(one.Now.data());
    }
  }
}

void SliceLayout::GiveBack()
{
  for (Narrowed& one : this->All)
  {
    if (one.Renderer && ViewportOf(one.Renderer) == one.Now)
    {
      one.Renderer->SetViewport(one.Before.data());
    }
  }
  this->All.clear();
}

} // namespace VolumeHaptics
