// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The materials of labels, baked for lookup in a tick.
 */
#ifndef LabelTable_h
#define LabelTable_h

#include "Core/Math/PiecewiseTable.h"

#include <cstdint>
#include <vector>

namespace VolumeHaptics
{

/** The material of a label. Values that are not set come from the functions of the scalar. */
struct LabelMaterial
{
  /** The channels of MaterialTable that a label may have: k, mu, T_N and R. */
  static constexpr int Channels = 4;

  std::array<double, Channels> Value{};
  std::array<bool, Channels> IsSet{};
  ///@{
  /** Friction tau in N per metre of a needle's shaft. */
  double ShaftFriction = 0.0;
  bool HasShaftFriction = false;
  ///@}
  ///@{
  /** Specific energy U (J/mm^3) that a burr needs to remove the tissue. */
  double SpecificEnergy = 0.0;
  bool HasSpecificEnergy = false;
  ///@}
  /** Whether the label is felt. If not, T_N, R and tau are 0, and the label makes no surface. */
  bool IsFelt = true;
  bool IsForbidden = false;
};

/** A label and its material. */
struct LabelledMaterial
{
  std::int64_t Label = 0;
  LabelMaterial Material;
};

/**
 * The place of a label in the order from soft to hard. The structure of a wall is on the side of
 * the harder label. Labels are ordered by Kind, then by T_N, then by k, then by number.
 */
struct LabelOrder
{
  int Kind = 0; ///< 0 if the label is not felt, 1 if it has no entry, 2 if it has one
  double Strength = 0.0;
  double Stiffness = 0.0;
  std::int64_t Label = 0;
};

inline bool operator<(const LabelOrder& a, const LabelOrder& b) noexcept
{
  return a.Kind != b.Kind        ? a.Kind < b.Kind
    : a.Strength != b.Strength   ? a.Strength < b.Strength
    : a.Stiffness != b.Stiffness ? a.Stiffness < b.Stiffness
                                 : a.Label < b.Label;
}

/**
 * Materials by label, in a hash table that is at most half full, so that a lookup takes one or two
 * probes however many labels there are.
 */
class LabelTable
{
public:
  LabelTable() = default;
  /**
   * Makes the table from entries, at most one per label. For labels that are not felt, sets the
   * channels that make surfaces to 0.
   */
  explicit LabelTable(const std::vector<LabelledMaterial>& entries);

  /** Sets the stiffness (N/m) of all labels whose own stiffness is above `floor` (N/m). */
  void SetOneStiffness(double stiffness, double floor);

  bool IsEmpty() const noexcept { return this->Entries.empty(); }
  /** Returns whether any label has a specific energy. */
  bool HasSpecificEnergy() const noexcept { return this->AnySpecificEnergy; }

  /** Returns the material of a label, or null if it has none. */
  const LabelMaterial* Find(std::int64_t label) const noexcept
  {
    if (this->Entries.empty())
    {
      return nullptr;
    }
    for (std::size_t at = this->Home(label);; at = (at + 1) & this->Mask)
    {
      const std::uint32_t entry = this->Places[at];
      if (entry == 0)
      {
        return nullptr;
      }
      if (this->Entries[entry - 1].Label == label)
      {
        return &this->Entries[entry - 1].Material;
      }
    }
  }

  LabelOrder OrderOf(std::int64_t label) const noexcept
  {
    constexpr int strength = 2; // channels of MaterialTable: T_N here, k below
    constexpr int stiffness = 0;
    constexpr double none = -1.0;
    const LabelMaterial* const material = this->Find(label);
    if (!material)
    {
      return { 1, none, none, label };
    }
    if (!material->IsFelt)
    {
      return {};
    }
    const auto value = [&](int channel)
    { return material->IsSet[channel] ? material->Value[channel] : none; };
    return { 2, value(strength), value(stiffness), label };
  }

  ///@{
  /** Return the address and the size (bytes) of the memory that a lookup reads. */
  const void* GetEntries() const noexcept { return this->Entries.data(); }
  std::size_t GetEntriesSize() const noexcept
  {
    return this->Entries.capacity() * sizeof(LabelledMaterial);
  }
  const void* GetPlaces() const noexcept { return this->Places.data(); }
  std::size_t GetPlacesSize() const noexcept
  {
    return this->Places.capacity() * sizeof(std::uint32_t);
  }
  ///@}

  std::size_t GetMemorySize() const noexcept
  {
    return this->GetEntriesSize() + this->GetPlacesSize();
  }

private:
  /**
   * Returns the slot where the search for a label begins: the highest bits of a product, because
   * these depend on all bits of the label.
   */
  std::size_t Home(std::int64_t label) const noexcept
  {
    constexpr std::uint64_t golden = 0x9E3779B97F4A7C15U; // odd number near 2^64 / golden ratio
    return static_cast<std::size_t>((static_cast<std::uint64_t>(label) * golden) >> this->Shift);
  }

  std::vector<LabelledMaterial> Entries;
  std::vector<std::uint32_t> Places; ///< 1 + index in Entries; 0 for a free slot
  std::size_t Mask = 0;
  int Shift = 63;
  bool AnySpecificEnergy = false;
};

} // namespace VolumeHaptics

#endif
