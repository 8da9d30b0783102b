// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/ModelExchange.h"

#include "Core/Model/HapticModel.h"
#include "Core/State/ToolMemory.h"

#include <algorithm>
#include <iterator>

namespace VolumeHaptics
{

ModelExchange::ModelExchange()
{
  this->Kept.push_back(std::make_unique<const PublishedModel>());
  this->Next.store(this->Kept.back().get());
}

ModelExchange::~ModelExchange() = default;

std::uint64_t ModelExchange::Publish(std::shared_ptr<const HapticModel> model)
{
  auto published = std::make_unique<PublishedModel>();
  if (model)
  {
    published->Tool = ToolMemory::Provide(*model->Baked, this->LastTool);
    this->LastTool = published->Tool ? published->Tool : this->LastTool;
    std::vector<MemoryRange> tables = model->GetTables();
    if (published->Tool)
    {
      const std::vector<MemoryRange> more = published->Tool->GetTables();
      tables.insert(tables.end(), more.begin(), more.end());
    }
    for (const MemoryRange& table : tables)
    {
      if (!published->Lock.Add(table.Begin, table.Size))
      {
        this->LockRefused.store(true, std::memory_order_relaxed);
      }
    }
  }
  published->Model = std::move(model);
  published->Generation = ++this->Generation;
  this->Kept.push_back(std::move(published));
  this->Next.store(this->Kept.back().get());
  this->Collect();
  return this->Generation;
}

void ModelExchange::Collect()
{
  const std::uint64_t inUse = this->GetAcknowledged();
  // Read Held only after Next was written: a thread that already uses an older model has then
  // registered it in Held, and any other thread will read Next.
  const PublishedModel* held[Holders];
  std::copy(std::begin(this->Held), std::end(this->Held), held);
  const auto isFree = [&](const std::unique_ptr<const PublishedModel>& kept)
  {
    return kept->Generation < inUse &&
      std::find(std::begin(held), std::end(held), kept.get()) == std::end(held);
  };
  this->Kept.erase(std::remove_if(this->Kept.begin(), this->Kept.end(), isFree), this->Kept.end());
}

const HapticModel* ModelExchange::Hold(Holder holder) noexcept
{
  const PublishedModel* latest = nullptr;
  do
  {
    latest = this->Next.load();
    this->Held[holder].store(latest);
  } while (this->Next.load() != latest);
  return latest->Model.get();
}

} // namespace VolumeHaptics
