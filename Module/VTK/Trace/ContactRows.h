// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Converts contacts of a tool with a shape to plain numbers and back, for files.
 */
#ifndef ContactRows_h
#define ContactRows_h

#include "Core/Tools/PointShell/ShellContacts.h"

#include <array>
#include <vector>

namespace VolumeHaptics
{

/**
 * Ten numbers of a contact: the number of the point, the offset (3, m), depth (m), energy (J),
 * stretch (m), stiffness (N/m^3), strength (N/m^2), and the fraction of the energy that counts. All
 * contacts have the same fraction.
 */
using ContactRow = std::array<double, 10>;

std::vector<ContactRow> ToRows(const ShellContacts& contacts);
/**
 * Reads a row. Returns false for numbers that no tick produces, because a file may contain any
 * numbers.
 */
bool FromRow(const ContactRow& row, ShellContact& contact, double& fraction);

} // namespace VolumeHaptics

#endif
