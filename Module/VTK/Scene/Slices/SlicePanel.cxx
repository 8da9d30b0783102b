// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Slices/SlicePanel.h"

#include "VTK/Filter/HapticBaker.h"
#include "VTK/Scene/Base/HapticPixels.h"

#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkCellData.h"
#include "vtkCoordinate.h"
#include "vtkHapticDevice.h"
#include "vtkHapticProperty.h"
#include "vtkHapticRegionSource.h"
#include "vtkImageData.h"
#include "vtkImageProperty.h"
#include "vtkMath.h"
#include "vtkMatrix3x3.h"
#include "vtkPointData.h"
#include "vtkPoints.h"
#include "vtkPolyDataMapper.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty.h"
#include "vtkProperty2D.h"
#include "vtkTextProperty.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace VolumeHaptics
{
namespace
{

/** Assigns an index axis to each world axis, with directions as similar as possible. */
std::array<SignedAxis, 3> MatchWorldAxes(vtkMatrix3x3* direction)
{
  std::array<int, 3> order{ 0, 1, 2 };
  std::array<int, 3> best = order;
  double most = -1.0;
  do
  {
    double sum = 0.0;
    for (int world = 0; world < 3; ++world)
    {
      sum += std::abs(direction->GetElement(world, order[world]));
    }
    if (sum > most)
    {
      most = sum;
      best = order;
    }
  } while (std::next_permutation(order.begin(), order.end()));
  std::array<SignedAxis, 3> axes;
  for (int world = 0; world < 3; ++world)
  {
    axes[world] = { best[world], direction->GetElement(world, best[world]) < 0.0 ? -1 : 1 };
  }
  return axes;
}

SignedAxis Backwards(SignedAxis axis)
{
  return { axis.Axis, -axis.Sign };
}

struct FeltSamples
{
  vtkImageData* Image = nullptr;
  vtkDataArray* Array = nullptr;
};

FeltSamples GetSliceSamples(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  if (!filter || filter->GetNumberOfInputConnections(0) == 0)
  {
    return {};
  }
  vtkImageData* image =
    device->GetPlayback()->HasTimeSteps() ? device->GetPlayback()->GetTimeStepImage() : nullptr;
  if (auto* const large = vtkHapticRegionSource::SafeDownCast(filter->GetInputAlgorithm(0, 0)))
  {
    image = large->GetCoarseImage();
  }
  if (image)
  {
    return { image, image->GetPointData()->GetScalars() };
  }
  image = filter->GetTouchedImage();
  vtkDataArray* const array = image ? filter->GetBaker().GetReading().GetArray(image) : nullptr;
  return { image, array };
}

constexpr double CrossGap = 7.0;     ///< gap (pixels) in the crosshair around the tip
constexpr double SliceMargin = 1.03; ///< height of the viewport as a multiple of the slice's height
constexpr int LeastLettered = 120;   ///< pixels: a smaller viewport has no letters at its sides

void SetUpSliceText(vtkTextActor* actor, double grey)
{
  vtkTextProperty* const text = actor->GetTextProperty();
  text->SetColor(grey, grey + 0.02, grey + 0.05);
  text->SetShadow(1);
  text->SetLineSpacing(1.15);
  actor->GetPositionCoordinate()->SetCoordinateSystemToViewport();
}

/** Makes a line along the left and lower edges, which separates a panel from its neighbours. */
void SetUpSliceFrame(vtkActor2D* actor)
{
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(0.0, 1.0, 0.0);
  points->InsertNextPoint(0.0, 0.0, 0.0);
  points->InsertNextPoint(1.0, 0.0, 0.0);
  vtkNew<vtkCellArray> lines;
  const vtkIdType corner[] = { 0, 1, 2 };
  lines->InsertNextCell(3, corner);
  vtkNew<vtkPolyData> frame;
  frame->SetPoints(points);
  frame->SetLines(lines);
  vtkNew<vtkCoordinate> coordinate;
  coordinate->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetInputData(frame);
  mapper->SetTransformCoordinate(coordinate);
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.30, 0.35, 0.42);
}

void ShowSliceText(vtkTextActor* actor, const std::string& text)
{
  if (!actor->GetInput() || text != actor->GetInput())
  {
    actor->SetInput(text.c_str());
  }
  actor->SetVisibility(!text.empty());
}

} // namespace

std::array<SliceAxes, 3> ComputeSliceAxes(vtkImageData* image, bool anatomical)
{
  if (!anatomical)
  {
    const SignedAxis i{ 0, 1 };
    const SignedAxis j{ 1, 1 };
    const SignedAxis k{ 2, 1 };
    return { SliceAxes{ k, i, j, "k" }, SliceAxes{ j, i, k, "j" }, SliceAxes{ i, j, k, "i" } };
  }
  const auto [left, back, head] = MatchWorldAxes(image->GetDirectionMatrix());
  return { SliceAxes{ head, left, Backwards(back), "Axial", { "R", "L", "P", "A" } },
    SliceAxes{ back, left, head, "Coronal", { "R", "L", "I", "S" } },
    SliceAxes{ left, back, head, "Sagittal", { "A", "P", "I", "S" } } };
}

//------------------------------------------------------------------------------
bool SliceImage::Update(vtkHapticDevice* device, vtkImageData* chosen)
{
  FeltSamples felt =
    chosen ? FeltSamples{ chosen, chosen->GetPointData()->GetScalars() } : GetSliceSamples(device);
  if (!felt.Image || !felt.Array || felt.Array->GetNumberOfTuples() == 0 ||
    felt.Array->GetNumberOfTuples() != felt.Image->GetNumberOfPoints())
  {
    felt = {};
  }
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  const int components = felt.Array ? felt.Array->GetNumberOfComponents() : 1;
  const bool isMagnitude =
    components > 1 && filter && filter->GetMethod() == vtkVolumeHapticsFilter::PRIMITIVES;
  const int wanted = filter ? filter->GetProperty()->GetComponent() : 0;
  const int component = std::min(wanted, components - 1);
  const vtkMTimeType time =
    felt.Array ? std::max(felt.Image->GetMTime(), felt.Array->GetMTime()) : 0;
  if (felt.Image == this->Image && felt.Array == this->Samples && time == this->Time &&
    isMagnitude == this->IsMagnitude && component == this->Component)
  {
    return false;
  }
  this->Image = felt.Image;
  this->Samples = felt.Array;
  this->Time = time;
  this->IsMagnitude = isMagnitude;
  this->Component = component;
  this->Plain->Initialize();
  if (felt.Image)
  {
    this->Plain->SetExtent(felt.Image->GetExtent());
    this->Plain->SetSpacing(felt.Image->GetSpacing());
    this->Plain->GetPointData()->SetScalars(felt.Array);
  }
  this->Layers = {};
  return true;
}

//------------------------------------------------------------------------------
bool SliceImage::PollRemoval(vtkHapticDevice* device)
{
  vtkVolumeHapticsFilter* const filter = device ? device->GetVolumeHaptics() : nullptr;
  auto* const large = filter && filter->GetNumberOfInputConnections(0) > 0
    ? vtkHapticRegionSource::SafeDownCast(filter->GetInputAlgorithm(0, 0))
    : nullptr;
  const bool isCoarse = large && this->Image && this->Image == large->GetCoarseImage();
  // No tissue can be removed from a moving volume.
  const bool isFelt = filter && !device->GetPlayback()->HasTimeSteps() && this->Samples && !large &&
    filter->GetTouchedImage() && this->Samples == filter->GetBaker().GetTouched()[0].Array;
  RemovedTissue removed = isCoarse || isFelt ? GetRemoved(filter) : RemovedTissue();
  if (removed.IsSame(this->Removed))
  {
    return false;
  }
  this->Removed = std::move(removed);
  this->Cover = isCoarse ? CarvedCover::Voxel : CarvedCover::Nearest;
  this->Layers = {};
  return true;
}

//------------------------------------------------------------------------------
vtkImageData* SliceImage::GetLayer(int axis, int number)
{
  if (!this->IsCarved())
  {
    return this->Plain;
  }
  Layer& layer = this->Layers[axis];
  if (layer.Image && layer.Number == number)
  {
    return layer.Image;
  }
  int part[6];
  this->Image->GetExtent(part);
  number = std::clamp(number, part[2 * axis], part[2 * axis + 1]);
  part[2 * axis] = part[2 * axis + 1] = number;
  const auto left = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(this->Samples->GetDataType()));
  this->CopyLeftPart(part, left);
  layer.Number = number;
  layer.Image = vtkSmartPointer<vtkImageData>::New();
  layer.Image->SetExtent(part);
  layer.Image->SetSpacing(this->Image->GetSpacing());
  layer.Image->GetPointData()->SetScalars(left);
  return layer.Image;
}

//------------------------------------------------------------------------------
void SliceImage::CopyLeftPart(const int part[6], vtkDataArray* left) const
{
  vtkNew<vtkImageData> place;
  place->CopyStructure(this->Image);
  if (this->IsCarved() && this->Cover == CarvedCover::Nearest)
  {
    // Use the volume's position, because the image, which is the volume or a region of it, may have
    // been moved since.
    place->CopyStructure(this->Removed.Volume);
    place->SetExtent(this->Image->GetExtent());
  }
  CopyLeft(this->Removed, this->Cover, place, this->Samples, part, left);
}

//------------------------------------------------------------------------------
std::array<double, 3> SliceImage::Clamp(std::array<double, 3> index) const
{
  const int* const extent = this->Image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = std::clamp<double>(index[axis], extent[2 * axis], extent[2 * axis + 1]);
  }
  return index;
}

//------------------------------------------------------------------------------
std::array<double, 3> SliceImage::ComputeIndex(const double world[3]) const
{
  std::array<double, 3> index;
  this->Image->TransformPhysicalPointToContinuousIndex(world, index.data());
  return this->Clamp(index);
}

//------------------------------------------------------------------------------
void SliceImage::ComputeWorld(const std::array<double, 3>& index, double world[3]) const
{
  this->Image->TransformContinuousIndexToPhysicalPoint(index.data(), world);
}

//------------------------------------------------------------------------------
std::array<double, 3> SliceImage::GetCentre() const
{
  const int* const extent = this->Image->GetExtent();
  std::array<double, 3> centre;
  for (int axis = 0; axis < 3; ++axis)
  {
    centre[axis] = 0.5 * (extent[2 * axis] + extent[2 * axis + 1]);
  }
  return centre;
}

//------------------------------------------------------------------------------
double SliceImage::GetValue(const std::array<double, 3>& index) const
{
  int part[6];
  for (int axis = 0; axis < 3; ++axis)
  {
    part[2 * axis] = part[2 * axis + 1] = static_cast<int>(std::lround(index[axis]));
  }
  const auto left = vtkSmartPointer<vtkDataArray>::Take(
    vtkDataArray::CreateDataArray(this->Samples->GetDataType()));
  this->CopyLeftPart(part, left);
  return this->GetValueOf(left, 0);
}

//------------------------------------------------------------------------------
double SliceImage::GetValueOf(vtkDataArray* samples, vtkIdType id) const
{
  if (!this->IsMagnitude)
  {
    return samples->GetComponent(id, this->Component);
  }
  double sum = 0.0;
  for (int c = 0; c < samples->GetNumberOfComponents(); ++c)
  {
    const double part = samples->GetComponent(id, c);
    sum += part * part;
  }
  return std::sqrt(sum);
}

//------------------------------------------------------------------------------
std::string SliceImage::DescribeComponents() const
{
  const int count = this->Samples->GetNumberOfComponents();
  if (count == 1)
  {
    return {};
  }
  return this->IsMagnitude
    ? "magnitude "
    : "component " + std::to_string(this->Component + 1) + " of " + std::to_string(count) + ": ";
}

//------------------------------------------------------------------------------
std::array<double, 2> SliceImage::EstimateUsualValues() const
{
  constexpr vtkIdType most = 20000;
  constexpr double below = 0.01;
  constexpr double above = 0.995;
  const vtkIdType count = this->Samples->GetNumberOfTuples();
  // Use an odd step: an even one could hit the same column of each row.
  const vtkIdType step = (count / most) | 1;
  std::vector<double> values;
  for (vtkIdType i = 0; i < count; i += step)
  {
    const double value = this->GetValueOf(this->Samples, i);
    if (std::isfinite(value))
    {
      values.push_back(value);
    }
  }
  if (values.empty())
  {
    return { 0.0, 1.0 };
  }
  std::sort(values.begin(), values.end());
  const auto last = static_cast<double>(values.size() - 1);
  return { values[static_cast<std::size_t>(below * last)],
    values[static_cast<std::size_t>(above * last)] };
}

//------------------------------------------------------------------------------
SlicePanel::SlicePanel()
{
  this->Renderer->SetBackground(0.045, 0.055, 0.07);
  this->Renderer->InteractiveOff();
  this->Renderer->GetActiveCamera()->ParallelProjectionOn();
  this->Mapper->BorderOn();
  this->Slice->SetMapper(this->Mapper);
  this->Slice->VisibilityOff();
  this->Renderer->AddViewProp(this->Slice);
  vtkNew<vtkPolyDataMapper> lines;
  lines->SetInputData(this->Cross);
  this->CrossActor->SetMapper(lines);
  this->CrossActor->GetProperty()->LightingOff();
  this->CrossActor->VisibilityOff();
  this->Renderer->AddViewProp(this->CrossActor);
  SetUpSliceFrame(this->Frame);
  this->Renderer->AddViewProp(this->Frame);
  for (vtkTextActor* const text : { this->Title.Get(), this->Facts.Get(), this->Below.Get() })
  {
    SetUpSliceText(text, text == this->Below.Get() ? 0.62 : 0.90);
    this->Renderer->AddViewProp(text);
  }
  this->Title->GetTextProperty()->BoldOn();
  this->Title->GetTextProperty()->SetVerticalJustificationToTop();
  this->Facts->GetTextProperty()->SetVerticalJustificationToTop();
  for (auto& side : this->Sides)
  {
    SetUpSliceText(side, 0.72);
    side->GetTextProperty()->SetJustificationToCentered();
    side->GetTextProperty()->SetVerticalJustificationToCentered();
    this->Renderer->AddViewProp(side);
  }
}

//------------------------------------------------------------------------------
void SlicePanel::SetImage(vtkImageData* plain, const SliceAxes& axes, vtkImageProperty* look)
{
  this->Axes = axes;
  std::copy_n(plain->GetSpacing(), 3, this->Spacing.begin());
  this->Mapper->SetInputData(plain);
  this->Mapper->SetOrientation(axes.Through.Axis);
  this->Slice->SetProperty(look);
  this->Slice->VisibilityOn();
  this->CrossActor->VisibilityOn();
  for (int side = 0; side < 4; ++side)
  {
    ShowSliceText(this->Sides[side], axes.Sides[side]);
  }
  this->IsFitted = false;
}

//------------------------------------------------------------------------------
void SlicePanel::SetLayer(vtkImageData* layer)
{
  if (this->Mapper->GetInput() != layer)
  {
    this->Mapper->SetInputData(layer);
  }
}

//------------------------------------------------------------------------------
void SlicePanel::Hide()
{
  this->Slice->VisibilityOff();
  this->CrossActor->VisibilityOff();
  for (auto& side : this->Sides)
  {
    side->VisibilityOff();
  }
  this->SetTexts("", "", "");
}

//------------------------------------------------------------------------------
void SlicePanel::SetColor(const std::array<unsigned char, 3>& color)
{
  this->Title->GetTextProperty()->SetColor(color[0] / 255.0, color[1] / 255.0, color[2] / 255.0);
}

//------------------------------------------------------------------------------
void SlicePanel::SetTexts(
  const std::string& title, const std::string& facts, const std::string& below)
{
  ShowSliceText(this->Title, title);
  ShowSliceText(this->Facts, facts);
  ShowSliceText(this->Below, below);
}

//------------------------------------------------------------------------------
void SlicePanel::Show(
  const std::array<double, 3>& index, const std::array<std::array<unsigned char, 3>, 3>& colors)
{
  const int through = this->Axes.Through.Axis;
  const auto slice = static_cast<int>(std::lround(index[through]));
  const bool isOther = slice != this->Mapper->GetSliceNumber();
  this->Index = index;
  this->Colors = colors;
  if (isOther)
  {
    this->Mapper->SetSliceNumber(slice);
    this->IsFitted = false;
  }
  if (this->IsFitted)
  {
    this->PlaceCrosshair();
  }
}

//------------------------------------------------------------------------------
void SlicePanel::Fit()
{
  const int* const size = this->Renderer->GetSize();
  auto* const plain = vtkImageData::SafeDownCast(this->Mapper->GetInput());
  if (!plain || size[0] <= 0 || size[1] <= 0 ||
    (this->IsFitted && size[0] == this->FittedSize[0] && size[1] == this->FittedSize[1]))
  {
    return;
  }
  const SliceAxes& axes = this->Axes;
  const int* const extent = plain->GetExtent();
  double focus[3];
  double length[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double middle = 0.5 * (extent[2 * axis] + extent[2 * axis + 1]);
    focus[axis] =
      this->Spacing[axis] * (axis == axes.Through.Axis ? this->Mapper->GetSliceNumber() : middle);
    length[axis] = this->Spacing[axis] * (extent[2 * axis + 1] - extent[2 * axis] + 1);
  }
  double right[3] = {};
  double up[3] = {};
  right[axes.Right.Axis] = axes.Right.Sign;
  up[axes.Up.Axis] = axes.Up.Sign;
  double back[3]; // vector towards the viewer
  vtkMath::Cross(right, up, back);
  const double distance = vtkMath::Norm(length);
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  camera->SetFocalPoint(focus);
  camera->SetPosition(
    focus[0] + distance * back[0], focus[1] + distance * back[1], focus[2] + distance * back[2]);
  camera->SetViewUp(up);
  camera->SetClippingRange(0.5 * distance, 1.5 * distance);
  const double aspect = static_cast<double>(size[0]) / size[1];
  camera->SetParallelScale(
    0.5 * SliceMargin * std::max(length[axes.Up.Axis], length[axes.Right.Axis] / aspect));
  this->IsFitted = true;
  this->FittedSize = { size[0], size[1] };
  this->PlaceCrosshair();
  this->PlaceTexts(size);
}

//------------------------------------------------------------------------------
void SlicePanel::PlaceCrosshair()
{
  auto* const plain = vtkImageData::SafeDownCast(this->Mapper->GetInput());
  const int* const extent = plain->GetExtent();
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  const double pixel = 2.0 * camera->GetParallelScale() / this->FittedSize[1];
  double back[3];
  camera->GetDirectionOfProjection(back);
  double centre[3];
  for (int axis = 0; axis < 3; ++axis)
  {
    const double shown =
      axis == this->Axes.Through.Axis ? this->Mapper->GetSliceNumber() : this->Index[axis];
    // Put the crosshair slightly in front of the slice, which would otherwise hide it.
    centre[axis] = this->Spacing[axis] * shown - 0.01 * camera->GetDistance() * back[axis];
  }
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const auto add = [&](int along, int across, double from, double to)
  {
    if (from >= to)
    {
      return;
    }
    double end[3] = { centre[0], centre[1], centre[2] };
    end[along] = from;
    const vtkIdType first = points->InsertNextPoint(end);
    end[along] = to;
    const vtkIdType line[] = { first, points->InsertNextPoint(end) };
    lines->InsertNextCell(2, line);
    colors->InsertNextTypedTuple(this->Colors[across].data());
  };
  const int axes[] = { this->Axes.Right.Axis, this->Axes.Up.Axis };
  for (int a = 0; a < 2; ++a)
  {
    const int along = axes[a];
    const double begin = this->Spacing[along] * (extent[2 * along] - 0.5);
    const double end = this->Spacing[along] * (extent[2 * along + 1] + 0.5);
    add(along, axes[1 - a], begin, centre[along] - CrossGap * pixel);
    add(along, axes[1 - a], centre[along] + CrossGap * pixel, end);
  }
  this->Cross->SetPoints(points);
  this->Cross->SetLines(lines);
  this->Cross->GetCellData()->SetScalars(colors);
}

//------------------------------------------------------------------------------
void SlicePanel::PlaceTexts(const int size[2])
{
  const double scale = PixelsPerPoint(this->Renderer);
  const int edge = ScalePixels(scale, 7);
  const int letters = FitLetters(std::min(size[0], size[1]), 15, scale, 9, 14);
  for (vtkTextActor* const text : { this->Title.Get(), this->Facts.Get(), this->Below.Get() })
  {
    text->GetTextProperty()->SetFontSize(letters);
  }
  this->Title->SetPosition(edge, size[1] - edge + 2);
  this->Facts->SetPosition(edge, size[1] - edge + 2 - 1.45 * scale * letters);
  this->Below->SetPosition(edge, edge);
  const bool hasRoom = size[0] >= LeastLettered && size[1] >= LeastLettered;
  const double inset = 0.8 * scale * letters;
  const double places[4][2] = { { inset, 0.5 * size[1] }, { size[0] - inset, 0.5 * size[1] },
    { 0.5 * size[0], inset }, { 0.5 * size[0], size[1] - inset } };
  for (int side = 0; side < 4; ++side)
  {
    this->Sides[side]->GetTextProperty()->SetFontSize(letters);
    this->Sides[side]->SetPosition(places[side][0], places[side][1]);
    this->Sides[side]->SetVisibility(hasRoom && this->Axes.Sides[side][0] != '\0');
  }
  this->Below->SetVisibility(hasRoom && this->Below->GetInput() && *this->Below->GetInput());
}

//------------------------------------------------------------------------------
bool SlicePanel::Contains(int x, int y) const
{
  const int* const origin = this->Renderer->GetOrigin();
  const int* const size = this->Renderer->GetSize();
  return x >= origin[0] && x < origin[0] + size[0] && y >= origin[1] && y < origin[1] + size[1];
}

//------------------------------------------------------------------------------
std::array<double, 3> SlicePanel::ComputeIndex(int x, int y) const
{
  const int* const origin = this->Renderer->GetOrigin();
  const int* const size = this->Renderer->GetSize();
  vtkCamera* const camera = this->Renderer->GetActiveCamera();
  const double pixel = 2.0 * camera->GetParallelScale() / size[1];
  // Use the centre of the pixel, relative to the centre of the viewport.
  const double across = pixel * (x + 0.5 - origin[0] - 0.5 * size[0]);
  const double upwards = pixel * (y + 0.5 - origin[1] - 0.5 * size[1]);
  const SliceAxes& axes = this->Axes;
  double at[3];
  camera->GetFocalPoint(at);
  at[axes.Right.Axis] += axes.Right.Sign * across;
  at[axes.Up.Axis] += axes.Up.Sign * upwards;
  std::array<double, 3> index;
  for (int axis = 0; axis < 3; ++axis)
  {
    index[axis] = at[axis] / this->Spacing[axis];
  }
  // Perpendicular to the slice, use the crosshair's own position.
  index[axes.Through.Axis] = this->Index[axes.Through.Axis];
  return index;
}

} // namespace VolumeHaptics
