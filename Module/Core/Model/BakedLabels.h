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
 * The material of the last cell whose eight voxels have one label. It makes the next lookup faster,
 * because the next position is usually in the same cell. The memory changes no result.
 */
struct MixMemory
{
  std::uint64_t Baked = 0; ///< number of the BakedVolume that used the memory; 0 if none did
  Vector3 Low;             ///< smallest indices of the cell
  bool HasMaterial = false;
  LabelMaterial Material;

  bool Knows(std::uint64_t baked, const Vector3& labelIndex) const noexcept
  {
    const Vector3 inside = labelIndex - this->Low;
    return this->Baked == baked && inside.X >= 0.0 && inside.X < 1.0 && inside.Y >= 0.0 &&
      inside.Y < 1.0 && inside.Z >= 0.0 && inside.Z < 1.0;
  }
};

/**
 * A label image with its materials. Immutable. The image has its own geometry, which may differ
 * from the volume's.
 */
struct BakedLabels
{
  LabelView View;
  Affine3 IndexToWorld;                ///< maps View's indices to the world; can be inverted
  std::shared_ptr<const void> Samples; ///< keeps the memory of the label image alive
  LabelTable Table;
  std::shared_ptr<const ForbiddenZone> Zone; ///< null if no label is forbidden
  /**
   * The finer grid that View shows, or null. If there is one, "label image" means this grid
   * everywhere in this struct, except that Zone belongs to the original image.
   */
  std::shared_ptr<const FineLabels> Fine;
  ///@{
  /** The original label image, if View shows a finer grid. */
  LabelView Image;
  Affine3 ImageToWorld;
  ///@}

  /** Replaces the view by a finer grid of the image. Does nothing if `fine` is null. */
  void Refine(std::shared_ptr<const FineLabels> fine);

  /** Returns the distance to forbidden labels (ForbiddenZone::Compute). Zone must not be null. */
  ForbiddenPlace ComputeForbidden(const Vector3& labelIndex) const noexcept;

  /**
   * Mixes the materials of the labels at a position into `values`, which come from the material
   * functions. The weights are the trilinear ones of the eight voxels around the position. A label
   * that does not set a value counts with the functions' value. A value that no label sets remains
   * unchanged, to the bit. `baked` identifies the volume with these labels in `memory`.
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
