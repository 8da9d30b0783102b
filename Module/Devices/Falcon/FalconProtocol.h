// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's run packets: 16 bytes to the device and 16 bytes back, about a thousand times
 * a second.
 *
 * Byte 0 is '<' and byte 15 is '>'. Each byte between them is 0x41 plus a payload. Bytes 1 to 12
 * are three 16-bit numbers of four nibbles each, the lowest nibble first: motor commands to the
 * device, and encoder counts back. Byte 13 is a bit field. Byte 14 has no known meaning: it is sent
 * as 'A', and any value is accepted.
 *
 * The functions are pure and safe in the servo loop: they neither allocate nor throw. Not verified
 * on hardware.
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
 * Bits that are sent to the device. Sources disagree on the colours, which are not verified on a
 * device.
 */
constexpr std::uint8_t FalconHome = 0x01; ///< find and keep the encoders' zero (FalconRunPacket)
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
  FalconCounts Encoders{};  ///< encoder counts, valid only for homed encoders
  std::uint8_t Buttons = 0; ///< FalconPlus ... FalconMinus
  std::uint8_t Homed = 0;   ///< one bit for each homed encoder
};

/** A fault in received bytes. */
enum class FalconFlaw : std::uint8_t
{
  None,
  Length, ///< the size is not 16 bytes
  Begin,  ///< the first byte is not '<'
  Nibble, ///< a byte of a number is not from 'A' to 'P'
  Bits,   ///< byte 13 is less than 0x41 or has more than seven payload bits
  End     ///< the last byte is not '>'
};

/** Returns a description of the fault. */
const char* FalconFlawText(FalconFlaw flaw) noexcept;

/** Returns the fault of a byte (0 to 255) at an index (0 to 15) of a packet, if any. */
FalconFlaw FalconCheck(std::size_t place, std::uint8_t byte) noexcept;

///@{
/** Encode packets of the host and of the device. The second function is for an emulated device. */
FalconPacket FalconEncode(const FalconOrder& order) noexcept;
FalconPacket FalconEncode(const FalconReport& report) noexcept;
///@}

/**
 * Encodes a packet for a running device. FalconHome is always set, because no source defines the
 * bits of homed encoders after a packet without it: libnifalcon's FalconFirmwareNovintSDK.h
 * describes them with "(If homing mode on)". In its homing mode, libnifalcon also sets FalconHome
 * in every packet (formatInput() in src/firmware/FalconFirmwareNovintSDK.cpp).
 */
FalconPacket FalconRunPacket(FalconOrder order) noexcept;

///@{
/** Decode a packet. Return the first fault, if any; the result is then unchanged. */
FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconReport& report) noexcept;
FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconOrder& order) noexcept;
///@}

} // namespace VolumeHaptics

#endif
