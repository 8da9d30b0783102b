// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/ComparedSettings.h"

#include "VTK/Baking/HapticSettingLists.h"
#include "VTK/Scene/FilterPublisher.h"

#include "vtkHapticLabelTable.h"
#include "vtkHapticProperty.h"
#include "vtkInteractorStyleHaptic.h"
#include "vtkNew.h"
#include "vtkVolumeHapticsFilter.h"

#include <utility>
#include <vector>

namespace VolumeHaptics
{

/** What the filter's settings, its property and its label table are at a time. */
struct ComparedSettings::Settings
{
  explicit Settings(vtkVolumeHapticsFilter* filter)
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

  /** In place, so that an editor goes on with the same functions. */
  void Apply(vtkVolumeHapticsFilter* filter) const
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

  std::vector<double> Values;
  std::vector<std::string> Texts;
  vtkNew<vtkHapticProperty> Property;
  vtkSmartPointer<vtkHapticLabelTable> Labels;
};

//------------------------------------------------------------------------------
ComparedSettings::ComparedSettings(TouchedScene& scene, FilterPublisher& publisher)
  : Scene(scene)
  , Publisher(publisher)
{
}

ComparedSettings::~ComparedSettings() = default;

//------------------------------------------------------------------------------
vtkVolumeHapticsFilter* ComparedSettings::FindFilter() const
{
  return this->Scene.Device ? this->Scene.Device->GetVolumeHaptics() : nullptr;
}

//------------------------------------------------------------------------------
bool ComparedSettings::Swap(const std::function<void(const std::string&)>& notify)
{
  // Observers of the following events may take the device away.
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
    this->Other = std::make_shared<const Settings>(filter);
    this->IsB = true;
    this->Tell();
    notify("These settings are A. Change the method or a material for B.");
    return true;
  }
  const auto before = std::make_shared<const Settings>(filter);
  const std::shared_ptr<const Settings> tried = this->Other;
  const bool wasB = this->IsB;
  // Also if it turns out later, when the other method was made ready in the background.
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
  // A name that the application has set stays while nothing is compared.
  if (vtkHapticHeadUpDisplay* const display = this->Scene.Display;
      display && (!name.empty() || this->IsTold))
  {
    display->SetSettingsText(name.c_str());
    this->IsTold = !name.empty();
  }
}

} // namespace VolumeHaptics
