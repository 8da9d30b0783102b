// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Interprets any bytes as a HID device's descriptor and packets.
 */
#ifndef TouchDescriptor_h
#define TouchDescriptor_h

#include <cstddef>
#include <cstdint>

/**
 * Uses the first byte as the length of a packet, which follows, and the rest as a descriptor.
 * Passes the packet to every codec. Aborts if a field is outside its report, if a written value is
 * read back differently, if an axis or a current is out of its range, or if a dialogue does not
 * end.
 */
void TouchDescriptor(const std::uint8_t* bytes, std::size_t size);

#endif
