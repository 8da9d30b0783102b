// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Interaction/ComparedSettings.h"

#include "VTK/Scene/Base/KeptSettings.h"
#include "VTK/Scene/Interaction/FilterPublisher.h"

#include "vtkInteractorStyleHaptic.h"
#include "vtkVolumeHapticsFilter.h"

#include <utility>

namespace VolumeHaptics
{

//------------------------------------------------------------------------------
ComparedSettings::ComparedSettings(TouchedScene& scene, FilterPublisher& publisher)
  : Scene(scene)
  , Publisher(publisher)
{
}

vtkVolumeHapticsFilter* ComparedSettings::FindFilter() const
{
  return this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
}

//------------------------------------------------------------------------------
bool ComparedSettings::Swap(const std::function<void(const std::string&)>& notify)
{
  // Keep the device: observers of the following events may remove it.
  const vtkSmartPointer<vtkInteractorStyleHaptic> style = this->Scene.Style;
  const vtkSmartPointer<vtkVolumeHapticsFilter> filter = this->FindFilter();
  if (!filter)
  {
    vtkErrorWithObjectMacro(style,
      "There are no settings to compare: SetDevice() one that SetVolumeHaptics() was called on.");
    return false;
  }
  if (!this->Other || this->Filter.GetPointer() != filter.GetPointer())
  {
    this->Filter = filter;
    this->Other = std::make_shared<const KeptSettings>(filter);
    this->IsB = true;
    this->Tell();
    notify("These settings are A. Change the method or a material for B.");
    return true;
  }
  const auto before = std::make_shared<const KeptSettings>(filter);
  const std::shared_ptr<const KeptSettings> tried = this->Other;
  const bool wasB = this->IsB;
  // Notice this later, too, when the other method was made ready in the background.
  const auto undo = [this, before, tried, wasB]
  {
    const vtkSmartPointer<vtkVolumeHapticsFilter> felt = this->FindFilter();
    if (felt && felt.GetPointer() == this->Filter.GetPointer())
    {
      before->Apply(felt);
    }
    if (this->Other)
    {
      this->Other = tried;
      this->IsB = wasB;
      this->Tell();
    }
  };
  const bool isFelt =
    this->Publisher.Try([&] { tried->Apply(filter); }, undo, wasB ? "A" : "B", notify);
  if (isFelt && this->Other)
  {
    this->Other = before;
    this->IsB = !wasB;
    this->Tell();
  }
  return isFelt;
}

//------------------------------------------------------------------------------
std::string ComparedSettings::GetName() const
{
  const bool isCompared =
    this->Other && this->Filter && this->Filter.GetPointer() == this->FindFilter();
  return !isCompared ? "" : this->IsB ? "B" : "A";
}

//------------------------------------------------------------------------------
void ComparedSettings::End()
{
  this->Other.reset();
  this->Filter = nullptr;
  this->Tell();
}

//------------------------------------------------------------------------------
void ComparedSettings::Tell()
{
  const std::string name = this->GetName();
  // While nothing is compared, keep a name that the application has set.
  if (vtkHapticHeadUpDisplay* const display = this->Scene.Display;
      display && (!name.empty() || this->IsTold))
  {
    display->SetSettingsText(name.c_str());
    this->IsTold = !name.empty();
  }
}

} // namespace VolumeHaptics
