// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Describes requests to an FTDI serial converter, and the status bytes that it adds, independently
 * of a transport.
 */
#ifndef FtdiSerial_h
#define FtdiSerial_h

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

/** A control transfer to the device, without data. */
struct FtdiRequest
{
  std::uint8_t RequestType; ///< bmRequestType
  std::uint8_t Request;     ///< bRequest
  std::uint16_t Value;      ///< wValue
  std::uint16_t Index;      ///< wIndex
};

constexpr std::uint8_t FtdiRequestType = 0x40; // vendor request, host to device

///@{
/**
 * "Receive" and "transmit" are from the host's view: purging the receive buffer discards what the
 * device has sent. These requests are libftdi's SIO_TCIFLUSH and SIO_TCOFLUSH (1.5, src/ftdi.h).
 */
constexpr FtdiRequest FtdiPurgeReceive = { FtdiRequestType, 0, 2, 0 };
constexpr FtdiRequest FtdiPurgeTransmit = { FtdiRequestType, 0, 1, 0 };
constexpr FtdiRequest FtdiDtrLow = { FtdiRequestType, 1, 0x0100, 0 };
constexpr FtdiRequest FtdiDtrHigh = { FtdiRequestType, 1, 0x0101, 0 };
constexpr FtdiRequest FtdiRtsLow = { FtdiRequestType, 1, 0x0200, 0 };
constexpr FtdiRequest FtdiNoFlowControl = { FtdiRequestType, 2, 0, 0 };
constexpr FtdiRequest Ftdi8N1 = { FtdiRequestType, 4, 8, 0 };
///@}

/** Returns the request that sets a baud rate. `divisor` is the rate's divisor. */
constexpr FtdiRequest FtdiBaud(std::uint16_t divisor) noexcept
{
  return { FtdiRequestType, 3, divisor, 0 };
}

/**
 * Returns the request that sets how long (ms, 1 to 255) the converter waits for more bytes before
 * it sends a packet.
 */
constexpr FtdiRequest FtdiLatency(std::uint8_t milliseconds) noexcept
{
  return { FtdiRequestType, 9, milliseconds, 0 };
}

constexpr std::size_t FtdiPacketSize = 64;
constexpr std::size_t FtdiStatusSize = 2;

struct FtdiPayload
{
  const std::uint8_t* Bytes = nullptr;
  std::size_t Size = 0;
};

/**
 * Removes the next packet from a bulk IN transfer. Returns the bytes after its two status bytes,
 * possibly none. Call repeatedly until `size` is zero.
 */
constexpr FtdiPayload DrainFtdiPacket(const std::uint8_t*& transfer, std::size_t& size) noexcept
{
  const std::uint8_t* const packet = transfer;
  const std::size_t length = size < FtdiPacketSize ? size : FtdiPacketSize;
  transfer += length;
  size -= length;
  if (length <= FtdiStatusSize)
  {
    return {};
  }
  return { packet + FtdiStatusSize, length - FtdiStatusSize };
}

} // namespace VolumeHaptics

#endif
