// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Trace/ContactRows.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace VolumeHaptics
{

std::vector<ContactRow> ToRows(const ShellContacts& contacts)
{
  std::vector<ContactRow> rows;
  rows.reserve(contacts.Count);
  for (std::size_t i = 0; i < contacts.Count; ++i)
  {
    const ShellContact& c = contacts.List[i];
    rows.push_back({ static_cast<double>(c.Point), c.Offset.X, c.Offset.Y, c.Offset.Z, c.Depth,
      c.Energy, c.Stretch, c.Stiffness, c.Strength, contacts.Fraction });
  }
  return rows;
}

bool FromRow(const ContactRow& row, ShellContact& contact, double& fraction)
{
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  const double point = row[0];
  const bool isPoint = point >= 0.0 && point <= most && point == std::floor(point);
  const bool areFinite =
    std::all_of(row.begin(), row.end(), [](double number) { return std::isfinite(number); });
  const bool areAmounts =
    std::all_of(row.begin() + 4, row.end(), [](double number) { return number >= 0.0; });
  contact = { { row[1], row[2], row[3] }, row[4], row[5], row[6], row[7], row[8],
    isPoint ? static_cast<std::uint32_t>(point) : 0 };
  fraction = row[9];
  return isPoint && areFinite && areAmounts && fraction <= 1.0;
}

} // namespace VolumeHaptics
