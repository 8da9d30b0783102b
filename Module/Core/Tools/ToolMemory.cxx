// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/ToolMemory.h"

#include <utility>

namespace VolumeHaptics
{

ToolMemory::ToolMemory(std::shared_ptr<const BakedTool> tool)
  : Tool(std::move(tool))
{
  if (this->Tool->Shell)
  {
    this->Shell.emplace(*this->Tool->Shell);
  }
  if (this->Tool->Burr)
  {
    this->Carver.emplace();
  }
}

std::shared_ptr<ToolMemory> ToolMemory::Provide(
  const BakedVolume& baked, const std::shared_ptr<ToolMemory>& last)
{
  if (!baked.HasShape())
  {
    return nullptr;
  }
  const bool isSame = last && last->Tool->Shell == baked.Tool->Shell &&
    last->Carver.has_value() == (baked.Tool->Burr != nullptr);
  return isSame ? last : std::make_shared<ToolMemory>(baked.Tool);
}

void ToolMemory::Keep() noexcept
{
  if (this->Shell)
  {
    this->Shell->Keep();
  }
}

bool ToolMemory::Restore(
  const BakedVolume& baked, const std::vector<ShellContact>& contacts, double share)
{
  const bool isSame = this->Shell && baked.Tool && this->Tool->Shell == baked.Tool->Shell;
  if (!isSame || !this->Shell->Restore(contacts, share))
  {
    return false;
  }
  this->Shell->Model = baked.Number;
  return true;
}

std::vector<HapticModel::MemoryRange> ToolMemory::GetTables() const
{
  std::vector<HapticModel::MemoryRange> tables{ { this, sizeof(*this) } };
  if (this->Shell)
  {
    this->Shell->AppendTables(tables);
  }
  if (this->Carver)
  {
    this->Carver->AppendTables(tables);
  }
  return tables;
}

} // namespace VolumeHaptics
