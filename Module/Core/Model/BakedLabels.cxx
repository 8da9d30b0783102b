// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/BakedLabels.h"

namespace VolumeHaptics
{

void BakedLabels::Mix(const Vector3& labelIndex, MaterialTable::Values& values) const noexcept
{
  if (this->Table.IsEmpty())
  {
    return;
  }
  constexpr int channels = LabelMaterial::Channels;
  const LabelCell cell = this->View.Cell(labelIndex);
  if (cell.IsUniform)
  {
    if (const LabelMaterial* const material = this->Table.Find(cell.Label[0]))
    {
      for (int c = 0; c < channels; ++c)
      {
        values[c] = material->IsSet[c] ? material->Value[c] : values[c];
      }
    }
    return;
  }
  std::array<double, channels> sum{};
  std::array<double, channels> share{};
  const auto add = [&](std::int64_t label, double whole)
  {
    if (const LabelMaterial* const material = this->Table.Find(label))
    {
      for (int c = 0; c < channels; ++c)
      {
        const double part = material->IsSet[c] ? whole : 0.0;
        sum[c] += part * material->Value[c];
        share[c] += part;
      }
    }
  };
  // Mostly there are two labels: no branch depends on where they are.
  const std::int64_t first = cell.Label[0];
  std::int64_t second = first;
  double shares[2] = { 0.0, 0.0 };
  for (int corner = 0; corner < LabelCell::Corners; ++corner)
  {
    const bool isFirst = cell.Label[corner] == first;
    second = isFirst ? second : cell.Label[corner];
    shares[0] += isFirst ? cell.Share[corner] : 0.0;
    shares[1] += isFirst ? 0.0 : cell.Share[corner];
  }
  bool areTwo = true;
  for (const std::int64_t label : cell.Label)
  {
    areTwo &= label == first || label == second;
  }
  if (areTwo)
  {
    add(first, shares[0]);
    add(second, shares[1]);
  }
  for (int corner = 0; corner < LabelCell::Corners && !areTwo; ++corner)
  {
    add(cell.Label[corner], cell.Share[corner]);
  }
  for (int c = 0; c < channels; ++c)
  {
    if (share[c] > 0.0)
    {
      // Rounding must not leave a share below 0.
      const double rest = share[c] < 1.0 ? 1.0 - share[c] : 0.0;
      values[c] = sum[c] + rest * values[c];
    }
  }
}

} // namespace VolumeHaptics
