// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a needle from tick to tick. See Core/Tools/Needle/NeedleTool.h.
 */
#ifndef NeedleState_h
#define NeedleState_h

#include "Core/Field/LabelView.h"
#include "Core/Math/Vector3.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

/** A stretch of the needle's track through one tissue. It ends where the next stretch begins. */
struct NeedleStretch
{
  float Begin = 0.0F; ///< distance (m) from the entry along the needle
  float Shaft = 0.0F; ///< friction tau (N per metre of the shaft)
  std::int64_t Label = NoLabel;
};

/**
 * The tissues along the inserted shaft, from entry to tip, in at most `Most` stretches. If there
 * are more, the two most similar neighbours are merged, with the same total friction.
 */
class NeedleTrack
{
public:
  static constexpr int Most = 32;

  int GetSize() const noexcept { return this->Size; }
  const NeedleStretch& operator[](int i) const noexcept
  {
    return this->Stretches[static_cast<std::size_t>(i)];
  }
  NeedleStretch& operator[](int i) noexcept { return this->Stretches[static_cast<std::size_t>(i)]; }

  /**
   * Adds the tissue that begins at a depth (m). The depth must be larger than those of all earlier
   * tissues. Adds nothing if the tissue is the same as in the last stretch.
   */
  void Append(double depth, double shaft, std::int64_t label) noexcept;
  /** Returns the friction (N) between the entry and a depth in the last stretch. */
  double Sum(double depth) const noexcept;
  const NeedleStretch& Last() const noexcept { return (*this)[this->Size - 1]; }
  /**
   * Returns whether depths ascend and frictions are possible, to check states that were read from
   * files.
   */
  bool IsPossible() const noexcept;
  void SetSize(int size) noexcept { this->Size = size < 0 ? 0 : (size > Most ? Most : size); }

private:
  void MergeTwo(double end) noexcept;

  std::array<NeedleStretch, Most> Stretches{};
  int Size = 0;
};

/** The state of a needle from tick to tick, in device space (metres and newtons). */
struct NeedleState
{
  bool IsInserted = false;
  /** Whether a free needle has been where nothing resists, so that it may be inserted. */
  bool IsOutside = false;
  Vector3 Axis;   ///< unit vector from handle to tip; constant if the device does not measure it
  Vector3 Normal; ///< unit vector into the tissue at the entry; 0 if there was no surface
  Vector3 Entry;  ///< position at which the insertion began
  double Depth = 0.0;   ///< depth (m) of the tip along the insertion
  double Deepest = 0.0; ///< largest depth (m) of the insertion
  /** Stiffness (N/m) of the spring, constant from the puncture to the end of the insertion. */
  double Stiffness = 0.0;
  double Puncture = 0.0;                 ///< strength (N) of the boundary in front of the tip, or 0
  double PuncturedAt = 0.0;              ///< depth (m) of the last puncture
  std::int64_t PuncturedLabel = NoLabel; ///< label of the tissue that was punctured last
  Vector3 Motion; ///< recent motion (m) of a free needle's tip; older steps have less weight
  /** Distance (m) by which a free needle was pushed through a surface that still holds it. */
  double Pushed = 0.0;
  std::uint32_t Touches = 0; ///< how often a forbidden label has stopped this insertion
  bool IsTouching = false;   ///< whether a forbidden label stops the insertion now
  NeedleTrack Track;
};

} // namespace VolumeHaptics

#endif
