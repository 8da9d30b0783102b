// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The state of a needle from tick to tick: see Core/Tools/Needle/NeedleTool.h.
 */
#ifndef NeedleState_h
#define NeedleState_h

#include "Core/Field/LabelView.h"
#include "Core/Math/Vector3.h"

#include <array>
#include <cstdint>

namespace VolumeHaptics
{

/** A stretch of the track in one tissue. The stretch ends where the next one begins. */
struct NeedleStretch
{
  float Begin = 0.0F; ///< m, from the entry along the needle
  float Shaft = 0.0F; ///< tau, N per metre
  std::int64_t Label = NoLabel;
};

/**
 * The tissues along the inserted shaft, from entry to tip. The size is fixed: if there are more
 * tissues, the two neighbours that differ least are merged, without changing the friction.
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
   * Adds the tissue that begins at a depth (m), below all earlier tissues; ignored if the tissue
   * continues the last stretch.
   */
  void Append(double depth, double shaft, std::int64_t label) noexcept;
  /** Returns the integral (N) of the friction from the entry to a depth in the last stretch. */
  double Sum(double depth) const noexcept;
  /** Returns the last stretch. */
  const NeedleStretch& Last() const noexcept { return (*this)[this->Size - 1]; }
  /** Returns whether depths ascend and friction is possible, for states from files. */
  bool IsPossible() const noexcept;
  void SetSize(int size) noexcept { this->Size = size < 0 ? 0 : (size > Most ? Most : size); }

private:
  void MergeTwo(double end) noexcept;

  std::array<NeedleStretch, Most> Stretches{};
  int Size = 0;
};

/** The state that a tick passes to the next one. Device space: metres, newtons. */
struct NeedleState
{
  bool IsInserted = false;
  bool IsOutside = false;   ///< whether a free needle has met no resistance, and may be inserted
  Vector3 Axis;             ///< unit, from handle to tip; frozen if it is not measured
  Vector3 Normal;           ///< unit, into the tissue, at the entry; 0 if there was no surface
  Vector3 Entry;            ///< where the insertion began
  double Depth = 0.0;       ///< m, depth of the tip along its insertion
  double Deepest = 0.0;     ///< m, the largest depth of the insertion
  double Stiffness = 0.0;   ///< N/m, the stiffness of the spring, from the puncture to the end of
                            ///< the insertion
  double Puncture = 0.0;    ///< N; if more than 0, the strength of a boundary in front of the tip
  double PuncturedAt = 0.0; ///< m; the depth of the last puncture
  std::int64_t PuncturedLabel = NoLabel; ///< the punctured label
  Vector3 Motion;            ///< m: recent motion of a free needle's tip; older steps count less
  double Pushed = 0.0;       ///< m, how far a free needle was pushed through a surface that still
                             ///< holds
  std::uint32_t Touches = 0; ///< how often a forbidden label stopped this insertion
  bool IsTouching = false;   ///< whether a forbidden label stops the insertion now
  NeedleTrack Track;
};

} // namespace VolumeHaptics

#endif
