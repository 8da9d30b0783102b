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
  for (int corner = 0; corner < LabelCell::Corners;)
  {
    // Neighbours with one label at once.
    const std::int64_t label = cell.Label[corner];
    double whole = 0.0;
    for (; corner < LabelCell::Corners && cell.Label[corner] == label; ++corner)
    {
      whole += cell.Share[corner];
    }
    if (const LabelMaterial* const material = this->Table.Find(label))
    {
      for (int c = 0; c < channels; ++c)
      {
        const double part = material->IsSet[c] ? whole : 0.0;
        sum[c] += part * material->Value[c];
        share[c] += part;
      }
    }
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
