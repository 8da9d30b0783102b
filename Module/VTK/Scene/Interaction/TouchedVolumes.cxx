// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/TouchedVolumes.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Base/HapticVolume.h"
#include "VTK/Scene/Base/WindowVolumes.h"
#include "VTK/Scene/Interaction/FilterPublisher.h"
#include "VTK/Scene/Volumes/CarvedImage.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkRendererCollection.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>

namespace VolumeHaptics
{
namespace
{

constexpr double Pause = 0.1; // s between two choices, because each one searches along a line
constexpr double SmallForce = 0.005; // N: a force up to this counts as zero

/** Surface of a volume ahead of the tip, by which volumes are compared. */
struct SurfaceAhead
{
  double Distance = HUGE_VAL; // distance (world units) along the line of sight
  double Force = 0.0;         // force of a press (N)
};

/** Returns whether each position in the world is at the same pixel in two renderers. */
bool IsSameView(vtkRenderer* a, vtkRenderer* b)
{
  return a == b ||
    (a->IsActiveCameraCreated() && b->IsActiveCameraCreated() &&
      a->GetActiveCamera() == b->GetActiveCamera() &&
      std::equal(a->GetViewport(), a->GetViewport() + 4, b->GetViewport()));
}

/**
 * Collects the volumes that are drawn where a style touches: in its default renderer, or, without
 * one, in its whole window. Returns false if the style has no window.
 */
bool CollectDrawn(vtkInteractorStyleHaptic* style, std::vector<DrawnVolume>& drawn)
{
  vtkRenderWindowInteractor* const interactor = style->GetInteractor();
  vtkRenderWindow* const window = interactor ? interactor->GetRenderWindow() : nullptr;
  vtkRendererCollection* const renderers = window ? window->GetRenderers() : nullptr;
  vtkRenderer* const touched = style->GetDefaultRenderer();
  vtkCollectionSimpleIterator it;
  if (renderers)
  {
    renderers->InitTraversal(it);
  }
  while (vtkRenderer* const renderer = renderers ? renderers->GetNextRenderer(it) : nullptr)
  {
    if (!touched || IsSameView(renderer, touched))
    {
      const std::vector<DrawnVolume> here = CollectDrawnVolumes(renderer);
      drawn.insert(drawn.end(), here.begin(), here.end());
    }
  }
  return renderers && renderers->GetNumberOfItems() > 0;
}

/** Returns the volumes at a vtkMultiVolume's ports, even if it is not drawn. */
std::vector<vtkVolume*> FindPorts(vtkVolume* multi)
{
  std::vector<DrawnVolume> parts;
  Detail::AppendDrawn(multi, multi->GetMatrix(), parts);
  std::vector<vtkVolume*> volumes;
  for (const DrawnVolume& part : parts)
  {
    if (part.Volume != multi && part.GetData())
    {
      volumes.push_back(part.Volume);
    }
  }
  return volumes;
}

bool IsBetter(const SurfaceAhead& a, const SurfaceAhead& b, int choice)
{
  // If forces are about equal, for example for two volumes of the same material, prefer the nearest
  // volume.
  constexpr double clearly = 1.05;
  const bool isStronger = a.Force > clearly * b.Force + SmallForce;
  const bool isWeaker = b.Force > clearly * a.Force + SmallForce;
  return choice == vtkInteractorStyleHaptic::STRONGEST && (isStronger || isWeaker)
    ? isStronger
    : a.Distance < b.Distance;
}

} // namespace

bool TouchedVolumes::CanTouch(vtkVolume* volume) const
{
  if (!this->Scene.Device)
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "There is no device to touch a volume with: call SetDevice() before TouchVolume().");
    return false;
  }
  if (!this->Scene.Device->GetVolumeHaptics())
  {
    // Set a filter even if the volume can't be touched, because callers set up the device's filter.
    this->Scene.Device->SetVolumeHaptics(vtkNew<vtkVolumeHapticsFilter>());
  }
  std::vector<DrawnVolume> drawn;
  CollectDrawn(this->Scene.Style, drawn);
  TouchedVolume touched;
  touched.Set(volume);
  touched.FindPlace(drawn);
  if (volume->IsA("vtkMultiVolume") ? FindPorts(volume).empty() : !touched.HasData())
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "The volume has no mapper that shows data: call vtkVolume::SetMapper(), for example with a "
      "vtkGPUVolumeRayCastMapper, and its SetInputData() or SetInputConnection(), before "
      "TouchVolume().");
    return false;
  }
  return true;
}

bool TouchedVolumes::Set(vtkVolume* volume)
{
  if (volume && !this->CanTouch(volume))
  {
    return false;
  }
  if (volume && !this->All.empty())
  {
    // Make the first volume's filter the device's filter again: the new volume will use it.
    this->Feel(this->All.front().Filter);
  }
  this->All.clear();
  this->Multi = vtkMultiVolume::SafeDownCast(volume);
  if (!volume)
  {
    return true;
  }
  this->Append(this->Multi ? FindPorts(volume).front() : volume, nullptr);
  this->Update();
  return true;
}

void TouchedVolumes::Append(vtkVolume* volume, vtkVolumeHapticsFilter* filter)
{
  this->All.push_back({ std::make_unique<TouchedVolume>(), filter, true, false });
  this->All.back().Volume->Set(volume);
}

void TouchedVolumes::AddAlike(vtkVolume* volume)
{
  Entry& first = this->All.front();
  // Store the first volume's filter explicitly: so far it may be the device's filter, which will
  // change with the felt volume.
  first.Filter = this->FilterOf(first);
  this->Append(volume, vtkNew<vtkVolumeHapticsFilter>());
  this->All.back().IsAlike = true;
  this->CopiedTime = 0;
}

void TouchedVolumes::FollowPorts()
{
  for (vtkVolume* const port : this->Multi ? FindPorts(this->Multi) : std::vector<vtkVolume*>())
  {
    const auto isPort = [port](const Entry& entry) { return entry.Volume->Get() == port; };
    if (std::none_of(this->All.begin(), this->All.end(), isPort))
    {
      this->AddAlike(port);
    }
  }
}

void TouchedVolumes::CopySettings()
{
  vtkVolumeHapticsFilter* const first = this->FilterOf(this->All.front());
  const vtkMTimeType time = first ? first->GetMTime() : 0;
  const auto isAlike = [](const Entry& entry) { return entry.IsAlike; };
  if (!first || time == this->CopiedTime ||
    std::none_of(this->All.begin(), this->All.end(), isAlike))
  {
    return;
  }
  this->CopiedTime = time;
  KeptSettings settings(first);
  for (const Entry& entry : this->All)
  {
    if (entry.IsAlike)
    {
      // Keep the filter's own volume opacity, which decides what is felt of its volume.
      settings.Property->SetVisibilityFrom(entry.Filter->GetProperty()->GetVisibilityFrom());
      settings.Apply(entry.Filter);
    }
  }
}

bool TouchedVolumes::Add(vtkVolume* volume, vtkVolumeHapticsFilter* filter)
{
  if (!volume || !filter)
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "Another volume to be touched takes a vtkVolume and a vtkVolumeHapticsFilter of its own, and "
      "one of them is missing. Cure: AddTouchedVolume(volume, filter).");
    return false;
  }
  if (volume->IsA("vtkMultiVolume"))
  {
    vtkErrorWithObjectMacro(this->Scene.Style,
      "A vtkMultiVolume shows several volumes, and a filter feels one. Cure: TouchVolume() with "
      "the vtkMultiVolume, or AddTouchedVolume() with GetVolume(0) of it, and with that of each "
      "other port and another filter.");
    return false;
  }
  if (!this->CanTouch(volume))
  {
    return false;
  }
  for (Entry& entry : this->All)
  {
    // Store the first volume's filter explicitly: so far it may be the device's filter, which will
    // change with the felt volume.
    entry.Filter = entry.Filter ? entry.Filter.Get() : this->Scene.Device->GetVolumeHaptics();
    if (entry.Filter == filter)
    {
      vtkErrorWithObjectMacro(this->Scene.Style,
        "This filter feels another volume already. Cure: use one vtkVolumeHapticsFilter "
        "for each volume.");
      return false;
    }
  }
  if (this->All.empty())
  {
    this->Scene.Device->SetVolumeHaptics(filter);
  }
  this->Append(volume, filter);
  this->Update();
  return true;
}

vtkVolumeHapticsFilter* TouchedVolumes::GetFeltFilter() const
{
  const TouchedScene* const second = this->Scene.Second;
  vtkHapticDevice* const device =
    this->Scene.Device || !second ? this->Scene.Device : second->Device;
  return device ? device->GetVolumeHaptics() : nullptr;
}

const TouchedVolumes::Entry* TouchedVolumes::FindFelt() const
{
  vtkVolumeHapticsFilter* const felt = this->GetFeltFilter();
  for (const Entry& entry : this->All)
  {
    if (!entry.Filter || entry.Filter == felt)
    {
      return &entry;
    }
  }
  return nullptr;
}

vtkVolume* TouchedVolumes::Get() const
{
  const Entry* const felt = this->FindFelt();
  return felt ? felt->Volume->Get() : nullptr;
}

std::vector<CarvedArray> TouchedVolumes::CollectCarved() const
{
  std::vector<vtkVolumeHapticsFilter*> filters{ this->Scene.Device->GetVolumeHaptics() };
  for (const Entry& entry : this->All)
  {
    filters.push_back(this->FilterOf(entry));
  }
  std::vector<CarvedArray> found;
  for (vtkVolumeHapticsFilter* const filter : filters)
  {
    CarvedArray carved;
    const auto isThere = [&carved](const CarvedArray& one) { return one.IsSame(carved); };
    if (filter && VolumeHaptics::CollectCarved(filter, carved) &&
      std::none_of(found.begin(), found.end(), isThere))
    {
      found.push_back(carved);
    }
  }
  return found;
}

void TouchedVolumes::Update()
{
  this->Scene.Hidden.clear();
  if (this->All.empty())
  {
    return;
  }
  std::vector<DrawnVolume> drawn;
  const bool hasWindow = CollectDrawn(this->Scene.Style, drawn);
  this->FollowPorts();
  this->CopySettings();
  for (Entry& entry : this->All)
  {
    entry.IsShown = (entry.Volume->FindPlace(drawn) || !hasWindow) && entry.Volume->HasData();
    if (vtkVolumeHapticsFilter* const filter = this->FilterOf(entry))
    {
      entry.Volume->Update(filter, this->Pictures, this->Carved);
    }
  }
  const Entry* const felt = this->FindFelt();
  if (felt && !felt->IsShown)
  {
    const bool isVisible = felt->Volume->Get()->GetVisibility() != 0 &&
      (!this->Multi || this->Multi->GetVisibility() != 0);
    this->Scene.Hidden = !isVisible
      ? "What is touched is hidden, so that it is not felt. Cure: VisibilityOn() of the vtkVolume."
      : !felt->Volume->HasData() && !this->Multi
      ? "What is touched shows nothing, so that it is not felt: it has no mapper, or its mapper no "
        "input. Cure: SetMapper() of the vtkVolume, and SetInputData() or SetInputConnection() of "
        "the mapper."
      : "What is touched is not in the renderer that shows the hand, so that it is not felt. Cure: "
        "TouchVolume() of the interactor style with a vtkVolume that is there, AddVolume() of that "
        "renderer, VisibilityOn() of the assembly around the volume, DrawOn() of the renderer, or "
        "SetDefaultRenderer() of the style with the one that has the volume.";
  }
}

void TouchedVolumes::FeelShown()
{
  const auto shown = std::find_if(
    this->All.begin(), this->All.end(), [](const Entry& entry) { return entry.IsShown; });
  if (shown != this->All.end())
  {
    this->Scene.Hidden.clear();
    this->Feel(shown->Filter);
  }
}

void TouchedVolumes::Feel(vtkVolumeHapticsFilter* filter)
{
  if (filter && this->Scene.Device->GetVolumeHaptics() != filter)
  {
    const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
    device->SetVolumeHaptics(filter);
    device->Publish();
  }
}

Press TouchedVolumes::ComputePress() const
{
  if (this->Scene.Style->GetFeltVolume() != vtkInteractorStyleHaptic::STRONGEST)
  {
    return {}; // no press is needed to find the nearest volume
  }
  constexpr double voxels = 4.0;
  double least = HUGE_VAL;
  for (const Entry& entry : this->All)
  {
    vtkVolumeHapticsFilter* const filter = this->FilterOf(entry);
    vtkImageData* const image = filter ? filter->GetTouchedImage() : nullptr;
    least = image ? std::fmin(least, SmallestSpacing(image)) : least;
  }
  return { least < HUGE_VAL ? voxels * least : 0.0, 0.0 };
}

void TouchedVolumes::ChooseAt(vtkRenderer* renderer, const Vector3& through)
{
  if (this->All.size() < 2)
  {
    return;
  }
  const int choice = this->Scene.Style->GetFeltVolume();
  const Press wanted = this->ComputePress();
  vtkVolumeHapticsFilter* chosen = nullptr;
  SurfaceAhead best;
  for (const Entry& entry : this->All)
  {
    Vector3 landing;
    Press press = wanted;
    if (entry.IsShown && FindFirstContact(renderer, through, entry.Filter, landing, &press))
    {
      const SurfaceAhead ahead{ Dot(landing - through, LineOfSight(renderer, through)),
        press.Force };
      if (IsBetter(ahead, best, choice))
      {
        chosen = entry.Filter;
        best = ahead;
      }
    }
  }
  this->Feel(chosen);
}

void TouchedVolumes::ChooseAhead(vtkRenderer* renderer)
{
  const double now = vtkTimerLog::GetUniversalTime();
  // Check the force, too, because FORCE_FIELD has no contact.
  if (this->All.size() < 2 || !renderer || this->Scene.Device->GetState()->GetContact() != 0 ||
    Norm(FromArray(this->Scene.Device->GetState()->GetComputedForce())) > SmallForce ||
    now - this->ChosenTime < Pause)
  {
    return;
  }
  vtkVolumeHapticsFilter* const felt = this->Scene.Device->GetVolumeHaptics();
  vtkImageData* const image = felt ? felt->GetTouchedImage() : nullptr;
  const double voxel = image ? SmallestSpacing(image) : 0.0;
  const Vector3 tip = this->Scene.GetTip();
  if (Norm(tip - this->ChosenTip) < 0.5 * voxel)
  {
    return;
  }
  this->ChosenTip = tip;
  this->ChosenTime = now;
  const int choice = this->Scene.Style->GetFeltVolume();
  const Press wanted = this->ComputePress();
  vtkVolumeHapticsFilter* chosen = nullptr;
  SurfaceAhead best;
  SurfaceAhead own;
  double least = HUGE_VAL;
  for (const Entry& entry : this->All)
  {
    Vector3 contact;
    Vector3 normal;
    Press press = wanted;
    if (!entry.IsShown || !FindContactAhead(renderer, tip, entry.Filter, contact, normal, &press))
    {
      continue;
    }
    const SurfaceAhead ahead{ Norm(contact - tip), press.Force };
    own = entry.Filter == felt ? ahead : own;
    least = std::fmin(ahead.Distance, least);
    if (IsBetter(ahead, best, choice))
    {
      chosen = entry.Filter;
      best = ahead;
    }
  }
  // Near a surface, keep the volume, because the hand may have touched it since the last state.
  // Require the best volume to be clearly better, so that the choice does not alternate.
  const SurfaceAhead demanded{ own.Distance - voxel, own.Force };
  if (least > voxel && IsBetter(best, demanded, choice))
  {
    this->Feel(chosen);
  }
}

} // namespace VolumeHaptics
