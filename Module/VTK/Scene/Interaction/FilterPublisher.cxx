// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/FilterPublisher.h"

#include "VTK/Device/Playback/HapticChangeTime.h"
#include "VTK/Filter/HapticFilterSettings.h"
#include "VTK/Filter/HapticMethods.h"

#include "vtkInteractorStyleHaptic.h"
#include "vtkVolumeHapticsFilter.h"

#include <utility>

namespace VolumeHaptics
{

vtkMTimeType FilterPublisher::GetChangeTime() const
{
  return ComputeChangeTime(this->Scene.Device->GetVolumeHaptics());
}

void FilterPublisher::Reset()
{
  this->Published = 0;
  this->IsFirst = true;
  if (!this->Awaited.Wanted.empty())
  {
    this->Awaited = {};
    this->SetNotice("");
  }
}

void FilterPublisher::SetNotice(const std::string& notice)
{
  if (const vtkSmartPointer<vtkHapticHeadUpDisplay> display = this->Scene.Display)
  {
    display->SetNotice(notice.c_str());
  }
}

void FilterPublisher::Update(bool isPlaced)
{
  this->PollAwaited();
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const vtkMTimeType time = this->GetChangeTime();
  // If the device is already published, the application or another style has published the change.
  const bool hasChanged = time != this->Published && !device->IsPublished();
  // The first publication keeps a notice of the application, which refers to the application's own
  // setup.
  const bool isFirst = std::exchange(this->IsFirst, false);
  this->Published = time;
  if ((isPlaced || hasChanged) && device->Publish() && hasChanged && !isFirst &&
    this->Scene.Display)
  {
    this->Scene.Display->SetNotice("");
  }
}

bool FilterPublisher::Try(const std::function<void()>& change, const std::function<void()>& undo,
  const std::string& name, const std::function<void(const std::string&)>& notify)
{
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = device->GetVolumeHaptics();
  MethodChange method{ filter->GetMethod(), filter->GetSolver(), filter->GetMethodText(), {}, undo,
    name };
  const bool wasPublished = this->Published == this->GetChangeTime();
  change();
  method.Wanted = filter->GetMethodText();
  this->Unfelt.clear();
  this->Awaited = {};
  this->IsFirst = false;
  const bool isFelt = device->Publish();
  const bool isOurs = this->Scene.Device == device;
  if (!isFelt)
  {
    this->TakeBack(undo, name, isOurs && wasPublished, notify);
    return false;
  }
  this->Published = isOurs ? this->GetChangeTime() : this->Published;
  const bool isAwaited = isOurs && !device->IsPublished();
  if (isAwaited)
  {
    this->Awaited = method;
  }
  notify(isAwaited ? method.Wanted + " is being prepared ..." : "");
  return true;
}

//------------------------------------------------------------------------------
bool FilterPublisher::NextMethod(const std::function<void(const std::string&)>& notify)
{
  // Keep references, because observers of the following events may remove any of these objects.
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter =
    device ? device->GetVolumeHaptics() : nullptr;
  if (!filter)
  {
    vtkErrorWithObjectMacro(style,
      "There is no method to change: call SetDevice() with a device that has a filter "
      "(SetVolumeHaptics()).");
    return false;
  }
  MethodChange change{ filter->GetMethod(), filter->GetSolver(), filter->GetMethodText(), {} };
  const bool wasPublished = this->Published == this->GetChangeTime();
  if (!this->Unfelt.empty() && this->FeltInstead == change.Before)
  {
    filter->SetMethodByName(this->Unfelt.c_str());
  }
  filter->NextMethod();
  change.Wanted = filter->GetMethodText();
  const bool isPrepared = GetMethodChoice(filter->GetMethod(), filter->GetSolver()).IsPrepared;
  notify(isPrepared ? change.Wanted + " is being prepared ..." : "");
  this->Unfelt.clear();
  this->Awaited = {};
  this->IsFirst = false;
  const bool isFelt = device->Publish();
  const bool isOurs = this->Scene.Device == device;
  if (isFelt)
  {
    this->Published = isOurs ? this->GetChangeTime() : this->Published;
    if (isOurs && !device->IsPublished())
    {
      this->Awaited = change;
      return true;
    }
    notify("");
    return true;
  }
  this->GoBack(change, filter, isOurs && wasPublished, notify);
  return false;
}

void FilterPublisher::TakeBack(const std::function<void()>& undo, const std::string& name,
  bool wasPublished, const Notify& notify)
{
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  undo();
  // The servo still has the previous model, so nothing is left to publish, unless a change was due
  // before.
  this->Published = wasPublished ? this->GetChangeTime() : 0;
  vtkErrorWithObjectMacro(
    style, << "Settings " << name << " can't be felt here, for the reason given before.");
  notify("Settings " + name + " can't be felt here. The terminal says why.");
}

void FilterPublisher::GoBack(const MethodChange& change, vtkVolumeHapticsFilter* filter,
  bool wasPublished, const Notify& notify)
{
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  this->Unfelt = filter->GetMethodName();
  this->FeltInstead = change.Before;
  filter->SetMethod(change.Method);
  filter->SetSolver(change.Solver);
  // The servo still has the previous method, so nothing is left to publish, unless a change was due
  // before.
  this->Published = wasPublished ? this->GetChangeTime() : 0;
  vtkErrorWithObjectMacro(style, << change.Wanted
                                 << " can't be felt here, for the reason given before; "
                                 << change.Before << " goes on.");
  notify(
    change.Wanted + " can't be felt here. The terminal says why.\n" + change.Before + " goes on.");
}

void FilterPublisher::PollAwaited()
{
  const vtkSmartPointer<vtkHapticDevice> device = this->Scene.Device;
  if (this->Awaited.Wanted.empty() || !device->IsPublished())
  {
    return;
  }
  const MethodChange change = std::exchange(this->Awaited, {});
  const Notify notify = [this](const std::string& notice) { this->SetNotice(notice); };
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = device->GetVolumeHaptics();
  // The servo now has the latest possible model. If its method is not the wanted one, the change
  // has failed.
  const bool isWanted = filter && filter->GetMethodText() == change.Wanted;
  if (isWanted && device->GetMethodText() != change.Wanted)
  {
    const bool wasPublished = this->Published == this->GetChangeTime();
    if (change.Undo)
    {
      this->TakeBack(change.Undo, change.Name, wasPublished, notify);
      return;
    }
    this->GoBack(change, filter, wasPublished, notify);
    return;
  }
  notify("");
}

//------------------------------------------------------------------------------
ComparedSettings::ComparedSettings(TouchedScene& scene, FilterPublisher& publisher)
  : Scene(scene)
  , Publisher(publisher)
{
}

vtkVolumeHapticsFilter* ComparedSettings::GetFilter() const
{
  return this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
}

//------------------------------------------------------------------------------
bool ComparedSettings::Swap(const std::function<void(const std::string&)>& notify)
{
  // Keep references, because observers of the following events may remove these objects.
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->GetFilter();
  if (!filter)
  {
    vtkErrorWithObjectMacro(style,
      "There are no settings to compare: call SetDevice() with a device that has a filter "
      "(SetVolumeHaptics()).");
    return false;
  }
  if (!this->Other || this->Filter.GetPointer() != filter.GetPointer())
  {
    this->Filter = filter;
    this->Other = std::make_shared<const KeptSettings>(filter);
    this->IsB = true;
    this->Report();
    notify("A is kept. Change something: that is B. C switches.");
    return true;
  }
  const auto before = std::make_shared<const KeptSettings>(filter);
  const std::shared_ptr<const KeptSettings> tried = this->Other;
  const bool wasB = this->IsB;
  // Check that the new settings are still felt: this may be called later, if they were prepared in
  // the background.
  const auto undo = [this, before, tried, wasB]
  {
    const vtkSmartPointer<vtkVolumeHapticsFilter> felt = this->GetFilter();
    if (felt && felt.GetPointer() == this->Filter.GetPointer())
    {
      before->Apply(felt);
    }
    if (this->Other)
    {
      this->Other = tried;
      this->IsB = wasB;
      this->Report();
    }
  };
  const bool isFelt =
    this->Publisher.Try([&] { tried->Apply(filter); }, undo, wasB ? "A" : "B", notify);
  if (isFelt && this->Other)
  {
    this->Other = before;
    this->IsB = !wasB;
    this->Report();
  }
  return isFelt;
}

//------------------------------------------------------------------------------
std::string ComparedSettings::GetName() const
{
  const bool isCompared =
    this->Other && this->Filter && this->Filter.GetPointer() == this->GetFilter();
  return !isCompared ? "" : this->IsB ? "B" : "A";
}

//------------------------------------------------------------------------------
void ComparedSettings::End()
{
  this->Other.reset();
  this->Filter = nullptr;
  this->Report();
}

//------------------------------------------------------------------------------
void ComparedSettings::Report()
{
  const std::string name = this->GetName();
  // While no settings are compared, leave a name that the application has set.
  if (vtkHapticHeadUpDisplay* const display = this->Scene.Display;
      display && (!name.empty() || this->IsTold))
  {
    display->SetSettingsText(name.c_str());
    this->IsTold = !name.empty();
  }
}

//------------------------------------------------------------------------------
KeptSettings::KeptSettings(vtkVolumeHapticsFilter* filter)
{
  for (const FilterSetting& setting : FilterSettings)
  {
    this->Values.push_back(setting.Get(filter));
  }
  for (const FilterText& setting : FilterTexts)
  {
    this->Texts.push_back(setting.Get(filter));
  }
  this->Property->DeepCopy(filter->GetProperty());
  if (vtkHapticLabelTable* const table = filter->GetLabelTable())
  {
    this->Labels = vtkSmartPointer<vtkHapticLabelTable>::New();
    this->Labels->DeepCopy(table);
  }
}

//------------------------------------------------------------------------------
void KeptSettings::Apply(vtkVolumeHapticsFilter* filter) const
{
  std::size_t at = 0;
  for (const FilterSetting& setting : FilterSettings)
  {
    const double value = this->Values[at++];
    if (setting.Get(filter) != value)
    {
      setting.Set(filter, value);
    }
  }
  at = 0;
  for (const FilterText& setting : FilterTexts)
  {
    const std::string& text = this->Texts[at++];
    if (setting.Get(filter) != text)
    {
      setting.Set(filter, text);
    }
  }
  filter->GetProperty()->DeepCopy(this->Property);
  if (this->Labels && filter->GetLabelTable())
  {
    filter->GetLabelTable()->DeepCopy(this->Labels);
  }
}

} // namespace VolumeHaptics
