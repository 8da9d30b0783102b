// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Usb/UsbEvents.h"

#include "Core/Realtime/ServoClock.h"

#include <algorithm>

namespace VolumeHaptics
{
namespace
{
constexpr std::int64_t Microsecond = 1000; // ns
} // namespace

UsbEvents::UsbEvents(UsbInterface& usb, HardwareExchange& exchange)
  : Usb(usb)
  , Exchange(exchange)
{
#if defined(__linux__)
  const libusb_pollfd** const all = libusb_get_pollfds(usb.GetContext());
  if (all == nullptr || exchange.GetWakeDescriptor() < 0)
  {
    libusb_free_pollfds(all);
    return;
  }
  this->Watched.push_back({ exchange.GetWakeDescriptor(), POLLIN, 0 });
  for (int i = 0; all[i] != nullptr; ++i)
  {
    this->Watched.push_back({ all[i]->fd, all[i]->events, 0 });
  }
  libusb_free_pollfds(all);
#endif
}

void UsbEvents::WaitForTransfers(std::int64_t time) noexcept
{
  timeval limit{};
  limit.tv_usec = static_cast<decltype(limit.tv_usec)>(time / Microsecond);
  libusb_handle_events_timeout_completed(this->Usb.GetContext(), &limit, nullptr);
}

bool UsbEvents::Wait(std::int64_t time) noexcept
{
  time = std::max<std::int64_t>(time, 0);
#if defined(__linux__)
  if (!this->Watched.empty())
  {
    const auto milliseconds =
      static_cast<int>((time + ServoClock::Millisecond - 1) / ServoClock::Millisecond);
    const auto isReady = [](const pollfd& watched) { return watched.revents != 0; };
    if (poll(this->Watched.data(), this->Watched.size(), milliseconds) <= 0)
    {
      return false;
    }
    if (std::any_of(this->Watched.begin() + 1, this->Watched.end(), isReady))
    {
      this->WaitForTransfers(0);
    }
    if (!isReady(this->Watched.front()))
    {
      return false;
    }
    this->Exchange.ClearWake();
    return true;
  }
#endif
  this->WaitForTransfers(std::min(time, ServoClock::Millisecond));
  return true;
}

} // namespace VolumeHaptics
