// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Finds the user who listens at a port of this computer, so that another user's program is not
 * mistaken for a vendor's service.
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
 * Returns the number of another user who listens at a port, read from a table in the format of
 * /proc/net/tcp (kernel documentation, proc_net_tcp). Ignores `own`, the system's users (numbers
 * below 1000), and users that a container hides.
 */
std::optional<unsigned> FindOtherListener(std::istream& table, std::uint16_t port, unsigned own);

/**
 * Returns false and writes the reason to `error` if another user's program listens at a port of
 * this computer. Can be detected only on Linux.
 */
bool IsOwnListener(std::uint16_t port, std::string& error);

/** Parses the number of a port, 1 to 65535. Returns false for any other text. */
bool ReadPort(const std::string& text, std::uint16_t& port);

} // namespace VolumeHaptics

#endif
