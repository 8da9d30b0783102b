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

/** A point that is held. Kernels take it as two times four numbers, and that of the point. */
struct ShellContact
{
  Vector3 Offset;   ///< m, on the device's axes, from the foot to the point
  double Depth;     ///< m, the length of Offset
  double Energy;    ///< J
  double Stretch;   ///< m, u
  double Stiffness; ///< N/m^3, with which it was computed
  double Strength;  ///< N/m^2
  std::uint32_t Point;
};
static_assert(std::is_standard_layout_v<ShellContact> &&
    offsetof(ShellContact, Depth) == 3 * sizeof(double) &&
    offsetof(ShellContact, Energy) == 4 * sizeof(double) &&
    offsetof(ShellContact, Strength) == 7 * sizeof(double),
  "eight numbers in this order");

/** From a gradient per index step, and a position in it, to the device. */
struct ShellFrame
{
  double GradientToDevice[9]; ///< by rows; per world unit, on the device's axes
  double DeviceToIndex[9];    ///< by rows, of displacements in m
  double UnitsPerMeter;
  double Voxel;        ///< m
  double KernelLength; ///< m
  double KernelRadius; ///< voxels, if it counts along each direction instead; else 0
};

/** Where a tool is. */
struct ShellPlacement
{
  double ToolToIndex[12]; ///< a matrix by rows, and an offset
  double ToolToDevice[9]; ///< by rows, of displacements
};

/** Points that may be in contact, number by number, so that several are computed at a time. */
struct ShellBatch
{
  static constexpr std::size_t Most = 64; ///< with all that is found, it stays in the first cache

  std::size_t Count = 0;
  std::uint64_t Solid = 0;          ///< a bit for each: whether it is
  std::uint32_t Point[Most];        ///< its number
  const ShellContact* Before[Most]; ///< its contact; one of zeros if it has none
  double Position[3][Most];         ///< in the frame of the tool
  double Area[Most];                ///< in its units, too
  ///@{
  /** By the placement of the tool. */
  double Offset[3][Most]; ///< that of Before
  double Was[Most];       ///< the depth of Before
  double Place[3][Most];  ///< the index of the foot as it is known
  double Index[3][Most];  ///< of the point
  double Arm[3][Most];    ///< m, from the origin of the tool, on the device's axes
  ///@}
  ///@{
  /** Found; may be NaN. */
  double Value[Most];       ///< trilinear, at Place
  double Gradient[3][Most]; ///< central differences over one sample to either side, per index step
  double Cell[3][Most];     ///< the derivatives in the cell of Place, per index step
  double Normal[3][Most];   ///< n: unit, on the device's axes, into what is solid
  double Magnitude[Most];   ///< of the gradient, per world unit
  double Beyond[Most];      ///< m, how far Place is beyond the level
  double Depth[Most];       ///< m, of the point
  double Foot[3][Most];     ///< the index of the foot that was found
  double Behind[3][Most];   ///< the index at a kernel length behind it
  ///@}
  double Inside[Most]; ///< the trilinear value there
  /** Stiffness, surface strength and visibility of the material there, if ShellLaw has no table. */
  double Material[3][Most];
};

/** Forces on points, number by number, up to a multiple of four: the rest is 0. */
struct ShellPushes
{
  /** Of so many points that may be in contact, forces are summed before these sums are. */
  static constexpr std::size_t Most = 128;

  std::size_t Count = 0;
  double Wrench[6][Most]; ///< of 1 N along the normal n: n, and arm x n in m
  double Force[Most];     ///< N
  double Stiffness[Most]; ///< N/m
};

/** From the depths of points to their forces. */
struct ShellLaw
{
  const MaterialTable* Materials; ///< null if ShellBatch::Material is known
  const DistinctnessTable* Distinctness;
  ///@{
  /** That have held the last numbers; they only save time. */
  const MaterialTable::Segment* LastMaterial;
  const DistinctnessTable::Segment* LastDistinctness;
  ///@}
  double LeastStiffness;   ///< N/m: what has less is not felt
  double PerContactArea;   ///< 1/m^2
  double SquareMeters;     ///< in a unit of ShellBatch::Area
  double InverseRadius;    ///< 1/voxels, of the kernel
  double Share;            ///< of the energies of the contacts before
  double FarthestFollowed; ///< m: of ShellBatch::Beyond
  bool IsStart;            ///< no contact has energy
};

} // namespace VolumeHaptics

#endif
