// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Carving/TissueRemoval.h"

namespace VolumeHaptics
{

bool TissueRemoval::Request(RemovalRequest request) noexcept
{
  const std::size_t head = this->Head.load(std::memory_order_relaxed);
  if (head - this->Done.load(std::memory_order_acquire) == MostRequests)
  {
    return false;
  }
  this->Requests[head % MostRequests].store(request, std::memory_order_relaxed);
  this->Head.store(head + 1, std::memory_order_release);
  return true;
}

bool TissueRemoval::Serve(RemovalRequest* begun) noexcept
{
  const std::size_t done = this->Done.load(std::memory_order_relaxed);
  RemovalRequest request = RemovalRequest::None;
  if (!this->Journal.HasWork())
  {
    if (done == this->Head.load(std::memory_order_acquire))
    {
      return false;
    }
    request = this->Requests[done % MostRequests].load(std::memory_order_relaxed);
    switch (request)
    {
      case RemovalRequest::None:
        break;
      case RemovalRequest::Undo:
        this->Journal.StartUndo();
        break;
      case RemovalRequest::Redo:
        this->Journal.StartRedo();
        break;
      case RemovalRequest::Reset:
        this->Journal.StartReset();
        break;
    }
  }
  if (begun)
  {
    *begun = request;
  }
  this->SetUsedUp(false);
  this->Journal.Continue(BricksPerTick);
  if (!this->Journal.HasWork())
  {
    this->Done.store(done + 1, std::memory_order_release);
  }
  return true;
}

bool TissueRemoval::TakeSnapshot() noexcept
{
  if (!this->Snapshot || this->Journal.HasWork() || !this->Snapshot->Complete())
  {
    return false;
  }
  this->Journal.Forget();
  return true;
}

std::vector<BrickTissue> TissueRemoval::EndSnapshot()
{
  std::vector<BrickTissue> fractions;
  if (this->Snapshot)
  {
    fractions = this->Snapshot->Collect();
    this->Snapshot.reset();
  }
  return fractions;
}

} // namespace VolumeHaptics
