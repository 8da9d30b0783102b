// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * One label of a label table, as label files and field data describe it.
 */
#ifndef LabelEntry_h
#define LabelEntry_h

#include <array>
#include <map>
#include <optional>
#include <string>

namespace VolumeHaptics
{

/** Data of one label. A member without a value was never set. */
struct LabelEntry
{
  std::optional<std::string> Name; ///< UTF-8
  std::optional<std::array<double, 3>> Color;
  std::optional<double> Stiffness;       ///< stiffness k (N/m)
  std::optional<double> Friction;        ///< dimensionless
  std::optional<double> Viscosity;       ///< N
  std::optional<double> SurfaceStrength; ///< N
  std::optional<double> ShaftFriction;   ///< N per metre of a needle's shaft
  std::optional<double> SpecificEnergy;  ///< J/mm^3
  std::optional<bool> Felt;
  std::optional<bool> Forbidden;
};

inline bool operator==(const LabelEntry& a, const LabelEntry& b)
{
  return a.Name == b.Name && a.Color == b.Color && a.Stiffness == b.Stiffness &&
    a.Friction == b.Friction && a.Viscosity == b.Viscosity &&
    a.SurfaceStrength == b.SurfaceStrength && a.ShaftFriction == b.ShaftFriction &&
    a.SpecificEnergy == b.SpecificEnergy && a.Felt == b.Felt && a.Forbidden == b.Forbidden;
}

/** Label entries, sorted by label in ascending order. */
using LabelEntries = std::map<int, LabelEntry>;

} // namespace VolumeHaptics

#endif
