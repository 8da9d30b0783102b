// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Any bytes as what a HID device says: its descriptor and its packets.
 */
#ifndef TouchDescriptor_h
#define TouchDescriptor_h

#include <cstddef>
#include <cstdint>

/**
 * The first byte is the length of a packet, which follows; the rest is a descriptor. The packet
 * goes to every codec. Aborts if a field lies outside its report, a value does not come back as it
 * was written, an axis or a current is out of its range, or a dialogue does not end.
 */
void TouchDescriptor(const std::uint8_t* bytes, std::size_t size);

#endif
