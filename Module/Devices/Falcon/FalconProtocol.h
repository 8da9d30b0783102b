// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The Novint Falcon's run packets: 16 bytes to the device, 16 back, about a thousand times a
 * second.
 *
 * Byte 0 is '<' and byte 15 is '>'. Each byte between them is 0x41 plus a payload. Bytes 1 to 12
 * are three 16-bit numbers of four nibbles each, the low nibble first: motor commands to the
 * device, encoder counts back. Byte 13 carries bits. Byte 14 has no known meaning: 'A' is sent, and
 * any value is accepted.
 *
 * Pure functions for the servo loop: no allocation, no exception. Not verified on hardware.
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
 * The bits that are sent. Sources disagree on the colours, and no device was available to find out.
 */
constexpr std::uint8_t FalconHome =
  0x01; ///< find the encoders' zero, and keep it: see FalconRunPacket
constexpr std::uint8_t FalconGreen = 0x02;
constexpr std::uint8_t FalconBlue = 0x04;
constexpr std::uint8_t FalconRed = 0x08;
///@}

///@{
/** The grip's buttons. */
constexpr std::uint8_t FalconPlus = 0x01;
constexpr std::uint8_t FalconForwardButton = 0x02;
constexpr std::uint8_t FalconCenter = 0x04;
constexpr std::uint8_t FalconMinus = 0x08;
///@}

/** The bits of FalconReport::Homed if every encoder is homed. */
constexpr std::uint8_t FalconAllHomed = 0x07;

/** A packet to the device. */
struct FalconOrder
{
  FalconCounts Motors{};   ///< commands, see FalconCommandsOf
  std::uint8_t Lights = 0; ///< FalconHome and colours; other bits are not sent
};

/** The device's answer. */
struct FalconReport
{
  FalconCounts Encoders{};  ///< counts; meaningless before the encoders are homed
  std::uint8_t Buttons = 0; ///< FalconPlus ... FalconMinus
  std::uint8_t Homed = 0;   ///< a bit for each encoder
};

/** The fault in bytes that should form a packet. */
enum class FalconFlaw : std::uint8_t
{
  None,
  Length, ///< not 16 bytes
  Begin,  ///< no '<' at the beginning
  Nibble, ///< a number's byte is not within 'A' to 'P'
  Bits,   ///< byte 13 is more than seven bits, or less than 0x41
  End     ///< no '>' at the end
};

/** Returns the fault in words. */
const char* FalconFlawText(FalconFlaw flaw) noexcept;

/** Returns the fault in a byte (0 to 255) at an index (0 to 15) in a packet. */
FalconFlaw FalconCheck(std::size_t place, std::uint8_t byte) noexcept;

///@{
/**
 * Encode and decode the packets of the host and of the device; an emulated device needs the other
 * half.
 */
FalconPacket FalconEncode(const FalconOrder& order) noexcept;
FalconPacket FalconEncode(const FalconReport& report) noexcept;
///@}

/**
 * Encodes an order for a running device, always with FalconHome. libnifalcon also sets that bit in
 * every packet while its homing mode is on (formatInput() in
 * src/firmware/FalconFirmwareNovintSDK.cpp). Its FalconFirmwareNovintSDK.h describes the bits of
 * homed encoders with "(If homing mode on)": no source says what they mean after a packet without
 * FalconHome.
 */
FalconPacket FalconRunPacket(FalconOrder order) noexcept;

///@{
/**
 * Decodes a packet to the result. Returns the first fault; the result is unchanged if there is a
 * fault.
 */
FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconReport& report) noexcept;
FalconFlaw FalconDecode(const std::uint8_t* bytes, std::size_t size, FalconOrder& order) noexcept;
///@}

} // namespace VolumeHaptics

#endif
