// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * A label image with the materials of its labels, baked for the servo tick.
 */
#ifndef BakedLabels_h
#define BakedLabels_h

#include "Core/Field/LabelView.h"
#include "Core/Math/Vector3.h"
#include "Core/Model/ForbiddenZone.h"
#include "Core/Model/LabelTable.h"

#include <memory>

namespace VolumeHaptics
{

/** Immutable. The label image has a geometry of its own. */
struct BakedLabels
{
  LabelView View;
  Affine3 IndexToWorld;                ///< of the label image; not singular
  std::shared_ptr<const void> Samples; ///< keeps the memory of View alive
  LabelTable Table;
  std::shared_ptr<const ForbiddenZone> Zone; ///< null if nothing is forbidden

  /**
   * Replaces what the functions of the scalar say at a position by the materials of the labels
   * there, mixed by the trilinear shares of the eight voxels around it. The share of labels without
   * a value keeps the functions' value; if no label has one, the values stay as they are, to the
   * bit.
   */
  void Mix(const Vector3& labelIndex, MaterialTable::Values& values) const noexcept;
};

} // namespace VolumeHaptics

#endif
