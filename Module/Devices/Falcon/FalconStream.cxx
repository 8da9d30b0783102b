// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Falcon/FalconStream.h"

#include "Devices/Transport/Usb/FtdiSerial.h"

#include <algorithm>
#include <limits>

namespace VolumeHaptics
{

bool FalconStream::IsPlausible() noexcept
{
  for (std::size_t place = 0; place < this->Count; ++place)
  {
    const FalconFlaw flaw = FalconCheck(place, this->Waiting[place]);
    if (flaw != FalconFlaw::None)
    {
      this->Flaw = flaw;
      return false;
    }
  }
  return true;
}

void FalconStream::DropToNextBegin() noexcept
{
  const auto begin = this->Waiting.begin();
  const auto end = begin + this->Count;
  const auto next = std::find(begin + 1, end, static_cast<std::uint8_t>('<'));
  const auto dropped = static_cast<std::uint32_t>(next - begin);
  std::copy(next, end, begin);
  this->Count -= dropped;
  constexpr std::uint32_t most = std::numeric_limits<std::uint32_t>::max();
  this->Dropped = this->Dropped > most - dropped ? most : this->Dropped + dropped;
}

bool FalconStream::Put(std::uint8_t byte) noexcept
{
  this->Waiting[this->Count++] = byte;
  while (this->Count > 0 && !this->IsPlausible())
  {
    this->DropToNextBegin();
  }
  return this->Count == FalconPacketSize;
}

int FalconStream::Receive(
  const std::uint8_t* transfer, std::size_t size, FalconReport& report) noexcept
{
  int reports = 0;
  while (size > 0)
  {
    const FtdiPayload payload = DrainFtdiPacket(transfer, size);
    for (std::size_t i = 0; i < payload.Size; ++i)
    {
      if (this->Put(payload.Bytes[i]))
      {
        FalconDecode(this->Waiting.data(), this->Count, report);
        this->Count = 0;
        ++reports;
      }
    }
  }
  return reports;
}

} // namespace VolumeHaptics
