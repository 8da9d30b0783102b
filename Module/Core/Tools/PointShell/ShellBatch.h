// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The data that a shell's kernels read and write. ShellReader.h declares the kernels, and
 * ShellContacts.h explains contacts.
 */
#ifndef ShellBatch_h
#define ShellBatch_h

#include "Core/Math/PiecewiseTable.h"
#include "Core/Math/Vector3.h"

#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace VolumeHaptics
{

/**
 * A point in contact. Kernels read it as two vectors of four numbers, followed by the point's
 * number.
 */
struct ShellContact
{
  Vector3 Offset;   ///< vector from the foot to the point, along the device's axes (m)
  double Depth;     ///< length of Offset (m)
  double Energy;    ///< energy (J)
  double Stretch;   ///< stretch u (m)
  double Stiffness; ///< stiffness (N/m^3) with which the contact was computed
  double Strength;  ///< strength (N/m^2)
  std::uint32_t Point;
};
static_assert(std::is_standard_layout_v<ShellContact> &&
    offsetof(ShellContact, Depth) == 3 * sizeof(double) &&
    offsetof(ShellContact, Energy) == 4 * sizeof(double) &&
    offsetof(ShellContact, Strength) == 7 * sizeof(double),
  "eight numbers in this order");

/** Maps for a gradient per index step, and for a displacement in the device's space. */
struct ShellFrame
{
  /// matrix by rows, from a gradient per index step to one per world unit along the device's axes
  double GradientToDevice[9];
  double DeviceToIndex[9]; ///< matrix by rows, from m to index steps
  double UnitsPerMeter;
  double Voxel;        ///< smallest spacing (m)
  double KernelLength; ///< length of the kernel radius (m)
  double KernelRadius; ///< in voxels, if the kernel is that long along each direction; otherwise 0
};

/** The pose of a tool, as maps. */
struct ShellPlacement
{
  double ToolToIndex[12]; ///< a matrix by rows, followed by an offset
  double ToolToDevice[9]; ///< matrix by rows, for displacements
};

/**
 * Points that may be in contact. There is one array for each number, so that several points can be
 * computed at a time.
 */
struct ShellBatch
{
  /**
   * Limit of the points. With this limit, a batch with all results fits into the first-level cache.
   */
  static constexpr std::size_t Most = 64;

  std::size_t Count = 0;
  std::uint64_t Solid = 0;          ///< bit i is set if point i is solid
  std::uint32_t Point[Most];        ///< number of each point in the shell
  const ShellContact* Before[Most]; ///< last contact of each point; zeros if it had none
  double Position[3][Most];         ///< position in the frame of the tool
  double Area[Most];                ///< area in the tool's units
  ///@{
  /** Members that are computed from the tool's placement. */
  double Offset[3][Most]; ///< ShellContact::Offset of Before
  double Was[Most];       ///< ShellContact::Depth of Before
  double Place[3][Most];  ///< index of the known foot
  double Index[3][Most];  ///< index of the point
  double Arm[3][Most];    ///< vector from the tool's origin along the device's axes (m)
  ///@}
  ///@{
  /** Results, which may be NaN. */
  double Value[Most];       ///< trilinear value at Place
  double Gradient[3][Most]; ///< central differences over one sample to both sides, per index step
  double Cell[3][Most];     ///< derivatives in the cell of Place, per index step
  double Normal[3][Most];   ///< n, a unit vector along the device's axes into the solid side
  double Magnitude[Most];   ///< magnitude of the gradient per world unit
  double Beyond[Most];      ///< distance of Place beyond the level (m)
  double Depth[Most];       ///< depth of the point (m)
  double Foot[3][Most];     ///< index of the foot
  double Behind[3][Most];   ///< index of the place a kernel length behind the foot
  ///@}
  double Inside[Most]; ///< trilinear value at Behind
  /**
   * Stiffness, surface strength and visibility of the material at Behind. Only used if ShellLaw has
   * no table.
   */
  double Material[3][Most];
};

/**
 * The forces on points. There is one array for each number, padded with 0 to a multiple of four.
 */
struct ShellPushes
{
  /**
   * Limit of the points that may be in contact in one group. The forces of each group are summed at
   * once, and then added to those of the other groups.
   */
  static constexpr std::size_t Most = 128;

  std::size_t Count = 0;
  double Wrench[6][Most]; ///< wrench of 1 N along the normal n: n, and arm x n (m)
  double Force[Most];     ///< force (N)
  double Stiffness[Most]; ///< stiffness (N/m)
};

/** The data from which the forces of points are computed, given their depths. */
struct ShellLaw
{
  const MaterialTable* Materials; ///< null if ShellBatch::Material is set
  const DistinctnessTable* Distinctness;
  ///@{
  /** The segments that contained the last numbers. They only make the next lookup faster. */
  const MaterialTable::Segment* LastMaterial;
  const DistinctnessTable::Segment* LastDistinctness;
  ///@}
  double LeastStiffness;   ///< stiffness (N/m) below which nothing is felt
  double PerContactArea;   ///< inverse of the contact area (1/m^2)
  double SquareMeters;     ///< area (m^2) of a unit of ShellBatch::Area
  Vector3 FadePerVoxel;    ///< HapticModel::FadePerVoxel
  double Fraction;         ///< fraction of their energies that the earlier contacts keep
  double FarthestFollowed; ///< limit of ShellBatch::Beyond (m)
  bool IsStart;            ///< whether contacts begin without energy, whatever their depth is
};

} // namespace VolumeHaptics

#endif
