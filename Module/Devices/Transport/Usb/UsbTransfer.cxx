// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Devices/Transport/Usb/UsbTransfer.h"

#include <new>

namespace VolumeHaptics
{
namespace
{

UsbOutcome OutcomeOf(libusb_transfer_status status) noexcept
{
  switch (status)
  {
    case LIBUSB_TRANSFER_COMPLETED:
      return UsbOutcome::Done;
    case LIBUSB_TRANSFER_CANCELLED:
    case LIBUSB_TRANSFER_TIMED_OUT:
      return UsbOutcome::Cancelled;
    case LIBUSB_TRANSFER_STALL:
      return UsbOutcome::Stalled;
    case LIBUSB_TRANSFER_NO_DEVICE:
      return UsbOutcome::Gone;
    default:
      return UsbOutcome::Failed;
  }
}

} // namespace

UsbTransfer::UsbTransfer(UsbInterface& usb, std::uint8_t endpoint, UsbTransferOwner& owner)
  : Owner(owner)
  , Transfer(libusb_alloc_transfer(0))
{
  if (this->Transfer == nullptr)
  {
    throw std::bad_alloc();
  }
  libusb_fill_bulk_transfer(this->Transfer, usb.GetHandle(), endpoint, this->Bytes.data(),
    static_cast<int>(Capacity), &UsbTransfer::Ended, this, 0);
}

UsbTransfer::~UsbTransfer()
{
  libusb_free_transfer(this->Transfer);
}

std::size_t UsbTransfer::GetSize() const noexcept
{
  return static_cast<std::size_t>(this->Transfer->actual_length);
}

std::uint8_t UsbTransfer::GetEndpoint() const noexcept
{
  return this->Transfer->endpoint;
}

UsbOutcome UsbTransfer::Submit(std::size_t size) noexcept
{
  this->Transfer->length = static_cast<int>(size);
  const int result = libusb_submit_transfer(this->Transfer);
  this->Flying = result == LIBUSB_SUCCESS;
  return this->Flying                  ? UsbOutcome::Done
    : result == LIBUSB_ERROR_NO_DEVICE ? UsbOutcome::Gone
                                       : UsbOutcome::Failed;
}

void UsbTransfer::Cancel() noexcept
{
  if (this->Flying)
  {
    libusb_cancel_transfer(this->Transfer);
  }
}

void LIBUSB_CALL UsbTransfer::Ended(libusb_transfer* transfer) noexcept
{
  auto& self = *static_cast<UsbTransfer*>(transfer->user_data);
  self.Flying = false;
  self.Owner.TransferEnded(self, OutcomeOf(transfer->status));
}

} // namespace VolumeHaptics
