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
 * The number of the point, the offset (3, m), depth (m), energy (J), stretch (m), stiffness
 * (N/m^3), strength (N/m^2), and the fraction of the energy that counts, which all contacts have in
 * common.
 */
using ContactRow = std::array<double, 10>;

std::vector<ContactRow> ToRows(const ShellContacts& contacts);
/** Reads a row. False for numbers that no tick produces, but a file may contain. */
bool FromRow(const ContactRow& row, ShellContact& contact, double& fraction);

} // namespace VolumeHaptics

#endif
