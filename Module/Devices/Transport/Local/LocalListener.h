// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds who listens at a port of this computer, so that no other user's program is taken for a
 * vendor's service.
 */
#ifndef LocalListener_h
#define LocalListener_h

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>

namespace VolumeHaptics
{

/**
 * Returns the number of the user who listens at a port, from a table as in /proc/net/tcp (kernel
 * documentation, proc_net_tcp), if that is a person's other than `own`: not the system's, whose
 * services have numbers below 1000, nor one that a container hides.
 */
std::optional<unsigned> FindOtherListener(std::istream& table, std::uint16_t port, unsigned own);

/**
 * Returns false and writes the reason to `error` if another user's program listens at a port of
 * this computer. Only Linux reports this.
 */
bool IsOwnListener(std::uint16_t port, std::string& error);

/** Reads the number of a port, 1 to 65535. Returns false if the text is no such number. */
bool ReadPort(const std::string& text, std::uint16_t& port);

} // namespace VolumeHaptics

#endif
