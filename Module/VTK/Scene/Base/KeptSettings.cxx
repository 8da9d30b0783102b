// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Base/KeptSettings.h"

#include "VTK/Filter/HapticFilterSettings.h"

#include "vtkVolumeHapticsFilter.h"

namespace VolumeHaptics
{

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
