// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/HostParts.h"

#include "VTK/Scene/Base/HapticOverlays.h"

#include "vtkCellPicker.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"

#include <algorithm>
#include <vector>

namespace VolumeHaptics
{
namespace
{

bool IsOverWidget(vtkRenderer* renderer, int x, int y)
{
  vtkNew<vtkPropCollection> actors;
  vtkCollectionSimpleIterator at;
  renderer->GetViewProps()->InitTraversal(at);
  while (vtkProp* const prop = renderer->GetViewProps()->GetNextProp(at))
  {
    // Compare by name, because the class is in a module of VTK that this library does not need
    // otherwise.
    if (prop->IsA("vtkWidgetRepresentation") && prop->GetVisibility())
    {
      prop->GetActors(actors);
    }
  }
  if (actors->GetNumberOfItems() == 0)
  {
    return false;
  }
  vtkNew<vtkCellPicker> picker;
  picker->SetTolerance(0.005); // the tolerance of VTK's widgets
  picker->PickFromListOn();
  actors->InitTraversal(at);
  while (vtkProp* const actor = actors->GetNextProp(at))
  {
    picker->AddPickList(actor);
  }
  return picker->Pick(x, y, 0.0, renderer) != 0;
}

} // namespace

bool IsOverPartOfHost(vtkRenderWindow* window, int x, int y)
{
  vtkRendererCollection* const renderers = window->GetRenderers();
  vtkCollectionSimpleIterator at;
  renderers->InitTraversal(at);
  while (vtkRenderer* const renderer = renderers->GetNextRenderer(at))
  {
    if (!renderer->GetDraw() || !renderer->IsInViewport(x, y))
    {
      continue;
    }
    const int* const origin = renderer->GetOrigin();
    const ViewportBox pixel{ static_cast<double>(x - origin[0]), static_cast<double>(x - origin[0]),
      static_cast<double>(y - origin[1]), static_cast<double>(y - origin[1]) };
    const std::vector<ViewportBox> boxes = CollectActorBoxes(renderer);
    if (std::any_of(boxes.begin(), boxes.end(),
          [&pixel](const ViewportBox& box) { return Overlaps(box, pixel); }) ||
      IsOverWidget(renderer, x, y))
    {
      return true;
    }
  }
  return false;
}

} // namespace VolumeHaptics
