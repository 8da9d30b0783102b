// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Model/BakedLabels.h"

#include <cmath>
#include <utility>

namespace VolumeHaptics
{

void BakedLabels::Refine(std::shared_ptr<const FineLabels> fine)
{
  if (fine)
  {
    const Vector3& steps = fine->GetSteps();
    this->Image = this->View;
    this->ImageToWorld = this->IndexToWorld;
    for (Vector3& row : this->IndexToWorld.Linear.Row)
    {
      row = { row.X / steps.X, row.Y / steps.Y, row.Z / steps.Z };
    }
    this->View = fine->GetView();
    this->Fine = std::move(fine);
  }
}

ForbiddenPlace BakedLabels::ComputeForbidden(const Vector3& labelIndex) const noexcept
{
  if (!this->Fine)
  {
    return this->Zone->Compute(labelIndex);
  }
  const Vector3& steps = this->Fine->GetSteps();
  const auto divide = [&steps](const Vector3& x) {
    return Vector3{ x.X / steps.X, x.Y / steps.Y, x.Z / steps.Z };
  };
  ForbiddenPlace place = this->Zone->Compute(divide(labelIndex));
  place.Gradient = divide(place.Gradient);
  return place;
}

void BakedLabels::Remember(std::int64_t label, const Vector3& labelIndex, std::uint64_t baked,
  MixMemory& memory) const noexcept
{
  const LabelMaterial* const material = this->Table.Find(label);
  // Do not store a cell in the memory if there is no label here: at the volume's border, other
  // voxels of the cell may have labels.
  memory.Baked = label == NoLabel ? 0 : baked;
  memory.Low = { std::floor(labelIndex.X), std::floor(labelIndex.Y), std::floor(labelIndex.Z) };
  memory.HasMaterial = material != nullptr;
  memory.Material = material ? *material : LabelMaterial{};
}

void BakedLabels::MixCell(const LabelCell& cell, MaterialTable::Values& values) const noexcept
{
  constexpr int channels = LabelMaterial::Channels;
  std::array<double, channels> sum{};
  std::array<double, channels> fraction{};
  const auto add = [&](std::int64_t label, double whole)
  {
    if (const LabelMaterial* const material = this->Table.Find(label))
    {
      for (int c = 0; c < channels; ++c)
      {
        const double part = material->IsSet[c] ? whole : 0.0;
        sum[c] += part * material->Value[c];
        fraction[c] += part;
      }
    }
  };
  // Usually a cell has two labels. Add up their fractions without a branch that depends on the
  // voxels.
  const std::int64_t first = cell.Label[0];
  std::int64_t second = first;
  double fractions[2] = { 0.0, 0.0 };
  for (int corner = 0; corner < LabelCell::Corners; ++corner)
  {
    const bool isFirst = cell.Label[corner] == first;
    second = isFirst ? second : cell.Label[corner];
    fractions[0] += isFirst ? cell.Fraction[corner] : 0.0;
    fractions[1] += isFirst ? 0.0 : cell.Fraction[corner];
  }
  bool areTwo = true;
  for (const std::int64_t label : cell.Label)
  {
    areTwo &= label == first || label == second;
  }
  if (areTwo)
  {
    add(first, fractions[0]);
    add(second, fractions[1]);
  }
  for (int corner = 0; corner < LabelCell::Corners && !areTwo; ++corner)
  {
    add(cell.Label[corner], cell.Fraction[corner]);
  }
  for (int c = 0; c < channels; ++c)
  {
    if (fraction[c] > 0.0)
    {
      // Rounding must not leave a fraction below 0.
      const double rest = fraction[c] < 1.0 ? 1.0 - fraction[c] : 0.0;
      values[c] = sum[c] + rest * values[c];
    }
  }
}

} // namespace VolumeHaptics
