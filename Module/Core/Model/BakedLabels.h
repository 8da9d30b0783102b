// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A label image with the materials of its labels, baked for the servo tick.
 */
#ifndef BakedLabels_h
#define BakedLabels_h

#include "Core/Field/FineLabels.h"
#include "Core/Field/LabelView.h"
#include "Core/Math/Vector3.h"
#include "Core/Model/ForbiddenZone.h"
#include "Core/Model/LabelTable.h"

#include <memory>

namespace VolumeHaptics
{

/**
 * The material of the last cell whose eight voxels have one label. The next position mostly lies in
 * the same cell. The memory saves time and changes no result.
 */
struct MixMemory
{
  std::uint64_t Baked = 0; ///< the number of the BakedVolume that used it; 0: none
  Vector3 Low;             ///< the cell's smallest indices
  bool HasMaterial = false;
  LabelMaterial Material;

  bool Knows(std::uint64_t baked, const Vector3& labelIndex) const noexcept
  {
    const Vector3 inside = labelIndex - this->Low;
    return this->Baked == baked && inside.X >= 0.0 && inside.X < 1.0 && inside.Y >= 0.0 &&
      inside.Y < 1.0 && inside.Z >= 0.0 && inside.Z < 1.0;
  }
};

/** A label image with its materials. Immutable. The label image has its own geometry. */
struct BakedLabels
{
  LabelView View;
  Affine3 IndexToWorld;                ///< maps View's indices to the world; not singular
  std::shared_ptr<const void> Samples; ///< keeps the memory of the label image alive
  LabelTable Table;
  std::shared_ptr<const ForbiddenZone> Zone; ///< null if no label is forbidden
  /**
   * If not null, View is its finer grid, and "label image" stands for this grid everywhere here.
   * The zone belongs to the image itself.
   */
  std::shared_ptr<const FineLabels> Fine;
  ///@{
  /** The label image itself, if View is a finer grid. */
  LabelView Image;
  Affine3 ImageToWorld;
  ///@}

  /** Replaces the view by a finer grid of the image; null changes nothing. */
  void Refine(std::shared_ptr<const FineLabels> fine);

  /** Computes the distance to forbidden labels, as in ForbiddenZone. There must be a zone. */
  ForbiddenPlace ComputeForbidden(const Vector3& labelIndex) const noexcept;

  /**
   * Replaces the functions' values at a position by the materials of the labels there, mixed by the
   * trilinear fractions of the eight voxels around it. The fraction of labels without a value keeps
   * the functions' value; if no label has one, the values stay the same to the bit. `baked` is the
   * number of the volume with these labels.
   */
  void Mix(const Vector3& labelIndex, std::uint64_t baked, MixMemory& memory,
    MaterialTable::Values& values) const noexcept
  {
    if (this->Table.IsEmpty())
    {
      return;
    }
    if (!memory.Knows(baked, labelIndex))
    {
      const LabelCell cell = this->View.Cell(labelIndex);
      if (!cell.IsUniform)
      {
        this->MixCell(cell, values);
        return;
      }
      this->Remember(cell.Label[0], labelIndex, baked, memory);
    }
    for (int c = 0; c < LabelMaterial::Channels && memory.HasMaterial; ++c)
    {
      values[c] = memory.Material.IsSet[c] ? memory.Material.Value[c] : values[c];
    }
  }

private:
  void MixCell(const LabelCell& cell, MaterialTable::Values& values) const noexcept;
  void Remember(std::int64_t label, const Vector3& labelIndex, std::uint64_t baked,
    MixMemory& memory) const noexcept;
};

} // namespace VolumeHaptics

#endif
