// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Charts/HapticOverlays.h"

#include "VTK/Charts/HapticPixels.h"

#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{

constexpr int ScaleWidth = 100; // pixels at the lower right: "1 N = 10 mm"

bool ShowsSomething(vtkRenderer* renderer)
{
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* const prop = props->GetNextProp(at))
  {
    if (prop->GetVisibility())
    {
      return true;
    }
  }
  return false;
}

bool Overlaps(const ViewportBox& a, const ViewportBox& b)
{
  return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];
}

} // namespace

std::vector<ViewportBox> FindOverlays(vtkViewport* viewport)
{
  std::vector<ViewportBox> overlays;
  auto* const own = vtkRenderer::SafeDownCast(viewport);
  vtkRenderWindow* const window = own ? own->GetRenderWindow() : nullptr;
  if (!window)
  {
    return overlays;
  }
  const int* const origin = own->GetOrigin();
  const int* const size = own->GetSize();
  vtkCollectionSimpleIterator at;
  window->GetRenderers()->InitTraversal(at);
  while (vtkRenderer* const other = window->GetRenderers()->GetNextRenderer(at))
  {
    const int* const theirs = other->GetSize();
    const bool isSmaller = 2 * theirs[0] <= size[0] || 2 * theirs[1] <= size[1];
    // The layer 0 has scenes and what stands beside them.
    if (other != own && other->GetLayer() > 0 && other->GetDraw() && isSmaller &&
      ShowsSomething(other))
    {
      const double left = other->GetOrigin()[0] - origin[0];
      const double bottom = other->GetOrigin()[1] - origin[1];
      overlays.push_back({ left, left + theirs[0], bottom, bottom + theirs[1] });
    }
  }
  return overlays;
}

std::array<int, 2> FindFreeCorner(vtkViewport* viewport, int width, int height)
{
  double corner[2] = { 0.0, 0.0 };
  const int scaleWidth = ScalePixels(PixelsPerPoint(viewport), ScaleWidth);
  const std::vector<ViewportBox> overlays = FindOverlays(viewport);
  for (std::size_t tries = 0; tries <= overlays.size(); ++tries)
  {
    const ViewportBox box{ corner[0], corner[0] + width, corner[1], corner[1] + height };
    const auto covering = std::find_if(overlays.begin(), overlays.end(),
      [&box](const ViewportBox& overlay) { return Overlaps(overlay, box); });
    if (covering == overlays.end())
    {
      break;
    }
    const bool isRoom = (*covering)[1] + width + scaleWidth <= viewport->GetSize()[0];
    corner[0] = isRoom ? (*covering)[1] : 0.0;
    corner[1] = isRoom ? corner[1] : (*covering)[3];
  }
  // A box over something is better than none.
  if (corner[1] + height > viewport->GetSize()[1])
  {
    return { 0, 0 };
  }
  return { static_cast<int>(corner[0]), static_cast<int>(corner[1]) };
}

double FindTextRight(vtkViewport* viewport)
{
  const int* const size = viewport->GetSize();
  double right = size[0];
  for (const ViewportBox& overlay : FindOverlays(viewport))
  {
    const bool isAbove = overlay[3] > 0.6 * size[1];
    right = isAbove && overlay[0] > 0.5 * size[0] ? std::min(right, overlay[0]) : right;
  }
  return right;
}

} // namespace VolumeHaptics
