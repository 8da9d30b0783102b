// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/TracePipe.h"

#include <algorithm>
#include <utility>

namespace VolumeHaptics
{

TracePipe::TracePipe(
  const HapticTrace& trace, std::shared_ptr<const HapticModel> model, vtkIdType firstRow)
  : Trace(trace)
  , Model(std::move(model))
  , Next(firstRow)
{
  for (std::unique_ptr<Block>& block : this->Ring)
  {
    block = std::make_unique<Block>();
  }
  this->Filling = this->Ring.front().get();
  this->Thread = std::thread([this] { this->WriteBlocks(); });
}

TracePipe::~TracePipe()
{
  this->Finish();
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->IsEnding = true;
  }
  this->HasPassed.notify_one();
  this->Thread.join();
}

void TracePipe::PassOn()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  ++this->Passed;
  this->HasPassed.notify_one();
  this->HasWritten.wait(lock, [this] { return this->Passed - this->Written < Blocks; });
  this->Filling = this->Ring[this->Passed % Blocks].get();
  this->Filling->Count = 0;
}

void TracePipe::Finish()
{
  if (this->Filling->Count > 0)
  {
    this->PassOn();
  }
  std::unique_lock<std::mutex> lock(this->Mutex);
  this->HasWritten.wait(lock, [this] { return this->Written == this->Passed; });
}

void TracePipe::WriteBlocks()
{
  std::unique_lock<std::mutex> lock(this->Mutex);
  while (true)
  {
    this->HasPassed.wait(lock, [this] { return this->IsEnding || this->Written < this->Passed; });
    if (this->Written == this->Passed)
    {
      return;
    }
    const Block& block = *this->Ring[this->Written % Blocks];
    lock.unlock();
    this->Write(block);
    lock.lock();
    ++this->Written;
    this->HasWritten.notify_one();
  }
}

void TracePipe::Write(const Block& block)
{
  for (std::size_t i = 0; i < block.Count; i += FewRecords)
  {
    const std::size_t count = std::min(FewRecords, block.Count - i);
    WriteRecords(
      this->Trace, *this->Model, &block.Records[i], &block.Times[i], count, this->Next, this->Work);
    this->Next += static_cast<vtkIdType>(count);
  }
}

} // namespace VolumeHaptics
