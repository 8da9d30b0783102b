// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's run packets: 16 bytes to the device and 16 bytes back, about a thousand times
 * a second.
 *
 * Byte 0 is '<' and byte 15 is '>'. Each byte between them is 0x41 plus a payload. Bytes 1 to 12
 * are three 16-bit numbers of four nibbles each, the lowest nibble first: motor commands to the
 * device, and encoder counts back. Byte 13 has bits. Byte 14 has no known meaning: it is sent as
 * 'A', and any value is accepted.
 *
 * These are pure functions for the servo loop: no allocation, no exception. Not verified on
 * hardware.
 */
#ifndef FalconProtocol_h
#define FalconProtocol_h

#include "Devices/Falcon/FalconKinematics.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

constexpr std::size_t FalconPacketSize = 16;
using FalconPacket = std::array<std::uint8_t, FalconPacketSize>;

///@{
/**
 * Bits that are sent to the device. Sources disagree on the colours, and there was no device to
 * check them.
 */
constexpr std::uint8_t FalconHome = 0x01; ///< find the encoders' zero and keep it (FalconRunPacket)
constexpr std::uint8_t FalconGreen = 0x02;
constexpr std::uint8_t FalconBlue = 0x04;
constexpr std::uint8_t FalconRed = 0x08;
///@}

///@{
/** Bits of the grip's buttons. */
constexpr std::uint8_t FalconPlus = 0x01;
constexpr std::uint8_t FalconForwardButton = 0x02;
constexpr std::uint8_t FalconCenter = 0x04;
constexpr std::uint8_t FalconMinus = 0x08;
///@}

/** The value of FalconReport::Homed when all encoders are homed. */
constexpr std::uint8_t FalconAllHomed = 0x07;

/** The contents of a packet to the device. */
struct FalconOrder
{
  FalconCounts Motors{};   ///< motor commands (FalconCommandsOf)
  std::uint8_t Lights = 0; ///< FalconHome and the colours; other bits are not sent
};

/** The contents of the device's answer. */
struct FalconReport
{
  FalconCounts Encoders{};  ///< encoder counts, which are only valid when the encoders are homed
  std::uint8_t Buttons = 0; ///< FalconPlus ... FalconMinus
  std::uint8_t Homed = 0;   ///< one bit for each homed encoder
};

/** The fault in bytes that should be a packet. */
enum class FalconFlaw : std::uint8_t
{
  None,
  Length, ///< there are not 16 bytes
  Begin,  ///< there is no '<' at the beginning
  Nibble, ///< a byte of a number is not from 'A' to 'P'
  Bits,   ///< byte 13 has more than seven bits, or is less than 0x41
  End     ///< there is no '>' at the end
};

/** Returns the fault in words. */
const char* FalconFlawText(FalconFlaw flaw) noexcept;

/** Returns the fault of a byte (0 to 255) at an index (0 to 15) of a packet. */
FalconFlaw FalconCheck(std::size_t place, std::uint8_t byte) noexcept;

///@{
/** Encode packets of the host and of the device. An emulated device needs the latter. */
FalconPacket FalconEncode(const FalconOrder& order) noexcept;
FalconPacket FalconEncode(const FalconReport& report) noexcept;
///@}

/**
 * Encodes a packet for a running device. FalconHome is always set, because no source says what the
 * bits of homed encoders mean after a packet without it: libnifalcon's FalconFirmwareNovintSDK.h
 * describes these bits with "(If homing mode on)". While its homing mode is on, libnifalcon also
 * sets FalconHome in every packet (formatInput() in src/firmware/FalconFirmwareNovintSDK.cpp).
 */
FalconPacket FalconRunPacket(FalconOrder order) noexcept;

///@{
/** Decode a packet. Return the first fault. If there is a fault, the result does not change. */
FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconReport& report) noexcept;
FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconOrder& order) noexcept;
///@}

} // namespace VolumeHaptics

#endif
