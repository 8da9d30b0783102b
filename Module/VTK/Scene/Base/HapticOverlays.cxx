// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/HapticOverlays.h"

#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkActor2D.h"
#include "vtkAxisActor2D.h"
#include "vtkCellPicker.h"
#include "vtkChart.h"
#include "vtkContextActor.h"
#include "vtkContextScene.h"
#include "vtkCoordinate.h"
#include "vtkCornerAnnotation.h"
#include "vtkImageData.h"
#include "vtkImageMapper.h"
#include "vtkLegendScaleActor.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropCollection.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTextActor.h"
#include "vtkTextMapper.h"
#include "vtkTextProperty.h"
// Use only inline functions of the header, since VTK's widgets module is not linked.
#if __has_include("vtkTexturedButtonRepresentation2D.h")
#include "vtkBalloonRepresentation.h"
#include "vtkTexturedActor2D.h"
#include "vtkTexturedButtonRepresentation2D.h"
#define VOLUMEHAPTICS_HAS_BUTTONS
#endif

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

constexpr int ScaleWidth = 100;     // pixels of the scale "1 N = 10 mm" at the lower right
constexpr double ActorMargin = 3.0; // pixels around a 2D actor
constexpr double LabelSpill = 15.0; // pixels by which labels may extend beyond the box of a scalar
                                    // bar
///@{
/**
 * Distances by which the labels and the title of an axis may extend beyond its box: in pixels, and
 * as a fraction of the viewport.
 */
constexpr double AxisSpill = 10.0;
constexpr double AxisSpillFraction = 0.05;
///@}

/**
 * Gives access to the texts of a vtkCornerAnnotation, which are protected in VTK, to compute their
 * boxes.
 */
struct CornerTexts : vtkCornerAnnotation
{
  static vtkActor2D* Get(vtkCornerAnnotation* annotation, int corner)
  {
    return (annotation->*(&CornerTexts::TextActor))[corner];
  }
};

#ifdef VOLUMEHAPTICS_HAS_BUTTONS
/**
 * Gives access to the picture of a button, such as PyVista's, which is private in VTK, to compute
 * its box.
 */
struct ButtonPicture : vtkBalloonRepresentation
{
  static vtkActor2D* Get(vtkTexturedButtonRepresentation2D* button)
  {
    return button->GetBalloon()->*(&ButtonPicture::TextureActor);
  }
};
#endif

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

/**
 * Computes the bounding box of an actor. Returns false if VTK does not report its position or if it
 * draws nothing.
 */
bool ComputeBox(vtkActor2D* actor, vtkRenderer* renderer, ViewportBox& box)
{
  // Copy the position, because VTK returns the same array for every coordinate.
  const int* const at = actor->GetActualPositionCoordinate()->GetComputedViewportValue(renderer);
  const double position[2] = { static_cast<double>(at[0]), static_cast<double>(at[1]) };
  if (auto* const text = vtkTextActor::SafeDownCast(actor))
  {
    text->GetBoundingBox(renderer, box.data());
  }
  else if (auto* const letters = vtkTextMapper::SafeDownCast(actor->GetMapper()))
  {
    int size[2] = { 0, 0 };
    letters->GetSize(renderer, size);
    vtkTextProperty* const look = letters->GetTextProperty();
    const double left = 0.5 * look->GetJustification() * size[0];
    const double below = 0.5 * look->GetVerticalJustification() * size[1];
    box = { -left, size[0] - left, -below, size[1] - below };
  }
  else if (auto* const shape = vtkPolyDataMapper2D::SafeDownCast(actor->GetMapper()))
  {
    vtkPolyData* const polygons = shape->GetInput();
    if (!polygons || polygons->GetNumberOfPoints() == 0)
    {
      return false;
    }
    double bounds[6];
    // Use only points of cells: VTK's borders also have unused points, with undefined positions.
    polygons->GetCellsBounds(bounds);
    box = { bounds[0], bounds[1], bounds[2], bounds[3] };
    if (vtkCoordinate* const system = shape->GetTransformCoordinate())
    {
      for (int side = 0; side < 2; ++side)
      {
        system->SetValue(bounds[side], bounds[2 + side], bounds[4 + side]);
        const int* const corner = system->GetComputedViewportValue(renderer);
        box[side] = corner[0];
        box[2 + side] = corner[1];
      }
    }
  }
  else if (auto* const picture = vtkImageMapper::SafeDownCast(actor->GetMapper()))
  {
    vtkImageData* const image = picture->GetInput();
    const int* const end = actor->GetPosition2Coordinate()->GetComputedViewportValue(renderer);
    const bool isScaled = picture->GetRenderToRectangle() != 0;
    box = { 0.0,
      isScaled  ? end[0] - position[0]
        : image ? image->GetDimensions()[0]
                : 0.0,
      0.0,
      isScaled  ? end[1] - position[1]
        : image ? image->GetDimensions()[1]
                : 0.0 };
  }
  else if (vtkAxisActor2D::SafeDownCast(actor))
  {
    const int* const end = actor->GetPosition2Coordinate()->GetComputedViewportValue(renderer);
    const int* const size = renderer->GetSize();
    const double spill = AxisSpill + AxisSpillFraction * std::max(size[0], size[1]);
    const double x = end[0] - position[0];
    const double y = end[1] - position[1];
    box = { std::min(0.0, x) - spill, std::max(0.0, x) + spill, std::min(0.0, y) - spill,
      std::max(0.0, y) + spill };
  }
  else if (actor->IsA("vtkScalarBarActor") || actor->IsA("vtkLegendBoxActor") ||
    actor->IsA("vtkXYPlotActor") || actor->IsA("vtkCaptionActor2D"))
  {
    const int* const end = actor->GetPosition2Coordinate()->GetComputedViewportValue(renderer);
    const double spill = actor->IsA("vtkScalarBarActor") ? LabelSpill : 0.0;
    box = { -spill, end[0] - position[0] + spill, -spill, end[1] - position[1] + spill };
  }
  else
  {
    return false;
  }
  box = { box[0] + position[0], box[1] + position[0], box[2] + position[1], box[3] + position[1] };
  return box[1] > box[0] && box[3] > box[2];
}

/** Collects the 2D actors in a prop and its parts. */
void FindActors(vtkProp* prop, vtkPropCollection* actors)
{
  prop->GetActors2D(actors);
  if (auto* const annotation = vtkCornerAnnotation::SafeDownCast(prop))
  {
    for (int corner = 0; corner < vtkCornerAnnotation::NumTextPositions; ++corner)
    {
      actors->AddItem(CornerTexts::Get(annotation, corner));
    }
  }
#ifdef VOLUMEHAPTICS_HAS_BUTTONS
  if (auto* const button = vtkTexturedButtonRepresentation2D::SafeDownCast(prop))
  {
    actors->AddItem(ButtonPicture::Get(button));
  }
#endif
  if (auto* const scale = vtkLegendScaleActor::SafeDownCast(prop))
  {
    const std::pair<vtkAxisActor2D*, bool> axes[] = { { scale->GetLeftAxis(),
                                                        scale->GetLeftAxisVisibility() != 0 },
      { scale->GetRightAxis(), scale->GetRightAxisVisibility() != 0 },
      { scale->GetBottomAxis(), scale->GetBottomAxisVisibility() != 0 },
      { scale->GetTopAxis(), scale->GetTopAxisVisibility() != 0 } };
    for (const auto& [axis, isShown] : axes)
    {
      if (isShown)
      {
        actors->AddItem(axis);
      }
    }
  }
}

/** Collects the boxes of the charts in a prop. PyVista adds charts as a vtkContextActor. */
void FindCharts(vtkProp* prop, std::vector<ViewportBox>& boxes)
{
  auto* const context = vtkContextActor::SafeDownCast(prop);
  vtkContextScene* const scene = context ? context->GetScene() : nullptr;
  for (unsigned int i = 0; scene && i < scene->GetNumberOfItems(); ++i)
  {
    auto* const chart = vtkChart::SafeDownCast(scene->GetItem(i));
    if (chart && chart->GetVisible())
    {
      // VTK adds the space for the labels at the left and below to the size, so the chart may
      // extend farther right and up.
      const vtkRectf size = chart->GetSize();
      const double right = chart->GetPoint1()[0] + chart->GetGeometry()[0];
      const double top = chart->GetPoint1()[1] + chart->GetGeometry()[1];
      boxes.push_back({ size.GetLeft(), std::max<double>(size.GetRight(), right), size.GetBottom(),
        std::max<double>(size.GetTop(), top) });
    }
  }
}

/** Moves a box past one overlay after another: see MoveOff. */
ViewportBox Avoid(const std::vector<ViewportBox>& overlays, double width, const ViewportBox& wanted,
  int across, int up, double margin)
{
  const double size[2] = { wanted[1] - wanted[0], wanted[3] - wanted[2] };
  ViewportBox box = wanted;
  for (std::size_t tries = 0; tries <= overlays.size(); ++tries)
  {
    const auto covering = std::find_if(overlays.begin(), overlays.end(),
      [&box](const ViewportBox& overlay) { return Overlaps(overlay, box); });
    if (covering == overlays.end())
    {
      break;
    }
    const double beside = across > 0 ? (*covering)[1] : (*covering)[0] - size[0];
    const bool isRoom =
      across > 0 ? beside + size[0] + margin <= width : across < 0 && beside >= margin;
    const double left = isRoom ? beside : wanted[0];
    const double bottom = isRoom ? box[2] : up > 0 ? (*covering)[3] : (*covering)[2] - size[1];
    box = { left, left + size[0], bottom, bottom + size[1] };
  }
  return box;
}

} // namespace

bool Overlaps(const ViewportBox& a, const ViewportBox& b)
{
  return a[0] < b[1] && b[0] < a[1] && a[2] < b[3] && b[2] < a[3];
}

std::vector<ViewportBox> CollectActorBoxes(vtkRenderer* renderer)
{
  std::vector<ViewportBox> found;
  vtkNew<vtkPropCollection> actors;
  vtkPropCollection* const props = renderer->GetViewProps();
  vtkCollectionSimpleIterator at;
  props->InitTraversal(at);
  while (vtkProp* const prop = props->GetNextProp(at))
  {
    if (prop->GetVisibility())
    {
      FindActors(prop, actors);
      FindCharts(prop, found);
    }
  }
  actors->InitTraversal(at);
  while (vtkProp* const prop = actors->GetNextProp(at))
  {
    auto* const actor = vtkActor2D::SafeDownCast(prop);
    ViewportBox box;
    if (actor && actor->GetVisibility() && ComputeBox(actor, renderer, box))
    {
      found.push_back(box);
    }
  }
  const int* const size = renderer->GetSize();
  std::vector<ViewportBox> boxes;
  std::copy_if(found.begin(), found.end(), std::back_inserter(boxes),
    [size](const ViewportBox& box)
    { return 2.0 * (box[1] - box[0]) <= size[0] || 2.0 * (box[3] - box[2]) <= size[1]; });
  return boxes;
}

std::vector<ViewportBox> CollectOverlays(vtkViewport* viewport)
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
    const double left = other->GetOrigin()[0] - origin[0];
    const double bottom = other->GetOrigin()[1] - origin[1];
    const bool isSmaller = 2 * theirs[0] <= size[0] || 2 * theirs[1] <= size[1];
    // Ignore renderers of layer 0: they are scenes side by side, and cover nothing.
    if (other != own && other->GetLayer() > 0 && other->GetDraw() && isSmaller &&
      ShowsSomething(other))
    {
      overlays.push_back({ left, left + theirs[0], bottom, bottom + theirs[1] });
    }
    else if (other->GetDraw())
    {
      for (const ViewportBox& box : CollectActorBoxes(other))
      {
        overlays.push_back({ left + box[0] - ActorMargin, left + box[1] + ActorMargin,
          bottom + box[2] - ActorMargin, bottom + box[3] + ActorMargin });
      }
    }
  }
  return overlays;
}

ViewportBox MoveOff(
  vtkViewport* viewport, const ViewportBox& wanted, int across, int up, double margin)
{
  const std::vector<ViewportBox> overlays = CollectOverlays(viewport);
  const int* const view = viewport->GetSize();
  const ViewportBox beside = Avoid(overlays, view[0], wanted, across, up, margin);
  if (beside[2] == wanted[2])
  {
    return beside;
  }
  const ViewportBox above = Avoid(overlays, view[0], wanted, 0, up, margin);
  const auto way = [&wanted](const ViewportBox& box)
  { return std::abs(box[0] - wanted[0]) + std::abs(box[2] - wanted[2]); };
  const ViewportBox& nearest = way(above) < way(beside) ? above : beside;
  // Prefer a box over an overlay to no box.
  return nearest[2] < 0.0 || nearest[3] > view[1] ? wanted : nearest;
}

std::array<int, 2> FindFreeCorner(vtkViewport* viewport, int width, int height)
{
  const ViewportBox box{ 0.0, static_cast<double>(width), 0.0, static_cast<double>(height) };
  const ViewportBox free =
    MoveOff(viewport, box, 1, 1, ScalePixels(PixelsPerPoint(viewport), ScaleWidth));
  return { static_cast<int>(free[0]), static_cast<int>(free[2]) };
}

double ComputeTextRight(vtkViewport* viewport)
{
  const int* const size = viewport->GetSize();
  double right = size[0];
  for (const ViewportBox& overlay : CollectOverlays(viewport))
  {
    const bool isAbove = overlay[3] > 0.6 * size[1];
    right = isAbove && overlay[0] > 0.5 * size[0] ? std::min(right, overlay[0]) : right;
  }
  return right;
}

//------------------------------------------------------------------------------
namespace
{

bool IsOverWidget(vtkRenderer* renderer, int x, int y)
{
  vtkNew<vtkPropCollection> actors;
  vtkCollectionSimpleIterator at;
  renderer->GetViewProps()->InitTraversal(at);
  while (vtkProp* const prop = renderer->GetViewProps()->GetNextProp(at))
  {
    // Compare by name, because the class is in a module of VTK that this library does not link.
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
  picker->SetTolerance(0.005); // as in VTK's widgets
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
