// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/LabelTable.h"

namespace VolumeHaptics
{

LabelTable::LabelTable(const std::vector<LabelledMaterial>& entries)
  : Entries(entries)
{
  std::size_t size = 2;
  while (size < 2 * entries.size())
  {
    size *= 2;
    --this->Shift;
  }
  this->Mask = size - 1;
  this->Places.assign(size, 0);
  std::uint32_t number = 0;
  for (LabelledMaterial& entry : this->Entries)
  {
    LabelMaterial& material = entry.Material;
    for (const int channel : { 2, 3 }) // the channels of T_N and R
    {
      if (!material.IsFelt)
      {
        material.Value[channel] = 0.0;
        material.IsSet[channel] = true;
      }
    }
    if (!material.IsFelt)
    {
      material.ShaftFriction = 0.0;
      material.HasShaftFriction = true;
    }
    this->AnySpecificEnergy = this->AnySpecificEnergy || material.HasSpecificEnergy;
    std::size_t at = this->Home(entry.Label);
    while (this->Places[at] != 0)
    {
      at = (at + 1) & this->Mask;
    }
    this->Places[at] = ++number;
  }
}

void LabelTable::SetOneStiffness(double stiffness, double floor)
{
  for (LabelledMaterial& entry : this->Entries)
  {
    double& own = entry.Material.Value[0];
    own = own > floor ? stiffness : own;
  }
}

} // namespace VolumeHaptics
