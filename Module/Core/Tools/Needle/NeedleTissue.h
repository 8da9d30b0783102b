// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads the tissue around a needle, from the values of a label or from the functions of the scalar.
 */
#ifndef NeedleTissue_h
#define NeedleTissue_h

#include "Core/Model/HapticModel.h"
#include "Core/Model/LabelMemory.h"
#include "Core/Tools/Needle/BakedNeedle.h"

namespace VolumeHaptics
{

/** Returns the tool of a model, which must be a needle. */
inline const BakedNeedle& GetNeedle(const HapticModel& model) noexcept
{
  return static_cast<const BakedNeedle&>(*model.Baked->Tool);
}

/** The tissue at a place. */
struct NeedleTissue
{
  double Cutting = 0.0; ///< cutting force R (N)
  double Shaft = 0.0;   ///< friction tau (N per metre)
  double Value = 0.0;   ///< value of the scalars
  std::int64_t Label = NoLabel;
  bool HasPuncture = false; ///< whether the label sets the strength of its boundary (Puncture)
  double Puncture = 0.0;    ///< T (N)

  bool Resists() const noexcept { return this->Cutting > 0.0 || this->Shaft > 0.0; }
};

/** Reads the tissue of a model at a data time. Allocates nothing. */
class NeedleTissueReader
{
public:
  /** Makes a reader. The model must have a needle, and must outlive the reader. */
  NeedleTissueReader(const HapticModel& model, double dataTime, LabelMemory& memory) noexcept;

  /**
   * Returns the tissue at a place. Outside the volume, and where it is cut away, nothing resists.
   */
  NeedleTissue At(const Vector3& place) const noexcept;

  /**
   * Returns T W_d (N) of the surface at a place, for a needle with an axis. Returns 0 if the
   * surface's normal does not point along the axis. Also returns 0 if the label behind the surface
   * has its own strength, because that strength belongs to the boundary between labels.
   */
  double SurfaceStrength(const Vector3& place, const Vector3& axis) const noexcept;

  /** Returns the stiffness (N/m) of the tissue at a place. */
  double Stiffness(const Vector3& place) const noexcept;

  bool HasForbidden() const noexcept { return this->Model.Baked->GetZone() != nullptr; }

  /** Returns whether a place is within the stand-off of a forbidden label. */
  bool IsForbidden(const Vector3& place) const noexcept;

  /** Returns the length (m) of a quarter of a voxel of the finer image along a unit axis. */
  double ComputeStep(const Vector3& axis) const noexcept;

private:
  const LabelMaterial* FindLabel(std::int64_t label) const noexcept
  {
    return this->Labels ? this->Labels->Table.Find(label) : nullptr;
  }

  const HapticModel& Model;
  const BakedNeedle& Needle;
  const BakedLabels* const Labels;
  const FieldAtTime Field;
  LabelMemory& Memory;
  const bool HasSurfaces; ///< whether any surface of the scalars can hold
};

} // namespace VolumeHaptics

#endif
