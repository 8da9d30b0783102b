// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The data that the kernels of a shell read and write. ShellReader.h declares the kernels;
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
 * A point that is held. Kernels read it as two times four numbers, followed by the point's number.
 */
struct ShellContact
{
  Vector3 Offset;   ///< m, on the device's axes, from the foot to the point
  double Depth;     ///< m, the length of Offset
  double Energy;    ///< J
  double Stretch;   ///< m, u
  double Stiffness; ///< N/m^3, the stiffness with which the contact was computed
  double Strength;  ///< N/m^2
  std::uint32_t Point;
};
static_assert(std::is_standard_layout_v<ShellContact> &&
    offsetof(ShellContact, Depth) == 3 * sizeof(double) &&
    offsetof(ShellContact, Energy) == 4 * sizeof(double) &&
    offsetof(ShellContact, Strength) == 7 * sizeof(double),
  "eight numbers in this order");

/** Maps from a gradient per index step, and from the device to an index. */
struct ShellFrame
{
  double GradientToDevice[9]; ///< map by rows; per world unit, on the device's axes
  double DeviceToIndex[9];    ///< map by rows, for displacements in m
  double UnitsPerMeter;
  double Voxel;        ///< m
  double KernelLength; ///< m
  double KernelRadius; ///< the kernel radius (voxels), if it applies along each direction; else 0
};

/** The pose of a tool, as maps. */
struct ShellPlacement
{
  double ToolToIndex[12]; ///< a matrix by rows, and an offset
  double ToolToDevice[9]; ///< map by rows, for displacements
};

/** Points that may be in contact, one array per number, so that several are computed at a time. */
struct ShellBatch
{
  static constexpr std::size_t Most = 64; ///< a batch with all results fits into the first cache

  std::size_t Count = 0;
  std::uint64_t Solid = 0;          ///< a bit for each point: whether it is solid
  std::uint32_t Point[Most];        ///< the point's number
  const ShellContact* Before[Most]; ///< the point's last contact; zeros if it has none
  double Position[3][Most];         ///< position in the tool's frame
  double Area[Most];                ///< the area, in the tool's units
  ///@{
  /** Computed from the tool's placement. */
  double Offset[3][Most]; ///< Offset of Before
  double Was[Most];       ///< Depth of Before
  double Place[3][Most];  ///< the index of the known foot
  double Index[3][Most];  ///< the index of the point
  double Arm[3][Most];    ///< m, from the origin of the tool, on the device's axes
  ///@}
  ///@{
  /** Results; may be NaN. */
  double Value[Most];       ///< trilinear, at Place
  double Gradient[3][Most]; ///< central differences over one sample to either side, per index step
  double Cell[3][Most];     ///< the derivatives in the cell of Place, per index step
  double Normal[3][Most];   ///< n: unit, on the device's axes, into the solid side
  double Magnitude[Most];   ///< the magnitude of the gradient, per world unit
  double Beyond[Most];      ///< m, distance of Place beyond the level
  double Depth[Most];       ///< m, the point's depth
  double Foot[3][Most];     ///< the index of the foot
  double Behind[3][Most];   ///< the index a kernel length behind the foot
  ///@}
  double Inside[Most]; ///< the trilinear value at Behind
  /**
   * Stiffness, surface strength and visibility of the material at Behind, if ShellLaw has no table.
   */
  double Material[3][Most];
};

/** Forces on points, one array per number, padded with 0 to a multiple of four. */
struct ShellPushes
{
  /**
   * The number of points that may be in contact whose forces are summed first; then these sums are
   * added.
   */
  static constexpr std::size_t Most = 128;

  std::size_t Count = 0;
  double Wrench[6][Most]; ///< the wrench of 1 N along the normal n: n, and arm x n in m
  double Force[Most];     ///< N
  double Stiffness[Most]; ///< N/m
};

/** Computes forces from the depths of points. */
struct ShellLaw
{
  const MaterialTable* Materials; ///< null if ShellBatch::Material is known
  const DistinctnessTable* Distinctness;
  ///@{
  /** The segments that contained the last numbers; used for speed only. */
  const MaterialTable::Segment* LastMaterial;
  const DistinctnessTable::Segment* LastDistinctness;
  ///@}
  double LeastStiffness;   ///< N/m: lower stiffness is not felt
  double PerContactArea;   ///< 1/m^2, the inverse of the area of contact
  double SquareMeters;     ///< the area (m^2) of a unit of ShellBatch::Area
  double InverseRadius;    ///< 1 / the kernel's radius (voxels)
  double Fraction;         ///< the fraction of their energies that the earlier contacts keep
  double FarthestFollowed; ///< the limit (m) of ShellBatch::Beyond
  bool IsStart;            ///< whether contacts begin without energy
};

} // namespace VolumeHaptics

#endif
