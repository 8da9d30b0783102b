// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a volume at the points of a shell.
 *
 * The kernels are compiled once for each instruction set, and chosen at run time, like those of
 * FieldSampler.h. All variants have the same results, to the bit.
 */
#ifndef ShellReader_h
#define ShellReader_h

#include "Core/Field/FieldSampler.h"
#include "Core/State/ShellState.h"
#include "Core/Tools/PointShell/ShellBatch.h"

#include <cstddef>
#include <cstdint>

namespace VolumeHaptics
{

/**
 * The volume to read, and the level beyond which it is solid. Does not own the samples.
 */
struct ShellReading
{
  FieldView View;                       ///< the samples, without a kernel
  double Border[3] = { 0.0, 0.0, 0.0 }; ///< largest index of the volume along each axis
  double Level = 0.0;
  double Sign = 1.0; ///< 1, or -1 if values below the level are solid
};

/** Coordinates of points in the frame of a tool, or indices. */
struct ShellNumbers
{
  const double* X;
  const double* Y;
  const double* Z;
  std::size_t Count;
};

/**
 * Marks up to 64 points: sets the bit of each point in the volume whose trilinear value is solid.
 * NaN is not solid. `map`, from the tool to indices, is a matrix by rows, followed by an offset.
 */
using MarkFunction = std::uint64_t (*)(
  const ShellReading&, const ShellNumbers&, const double* map) noexcept;
/**
 * The last marks of 1 to 64 points, which were made when the tool was nearby. Only points that may
 * have reached the level since then are read again. Lengths are the largest motion (voxels) of any
 * point.
 */
struct ShellMarking
{
  std::uint64_t Marks; ///< the last marks
  double* Until;       ///< for each of 64 points, the length up to which its mark is valid
  double Now;          ///< present length of the tool's motion
  double From;         ///< length from which on new marks are valid
  double PerValue; ///< least number of voxels over which a value changes by 1; 0 if it is not known
};
/** Like MarkFunction, and updates ShellMarking::Until. */
using MarkingFunction = std::uint64_t (*)(
  const ShellReading&, const ShellNumbers&, const double* map, const ShellMarking&) noexcept;
/** Returns whether any sample in a box of indices is solid. NaN is not solid. */
using BoxFunction = bool (*)(
  const ShellReading&, const std::int64_t* low, const std::int64_t* high) noexcept;
/**
 * Computes the largest differences between neighbours along each axis in a box of indices. A result
 * is not finite if a sample is not.
 */
using SlopeFunction = void (*)(
  const ShellReading&, const std::int64_t* low, const std::int64_t* high, double* most) noexcept;

/**
 * Computes those members of a batch that depend on the tool's placement, from Position and Before.
 */
using PlaceFunction = void (*)(const ShellFrame&, const ShellPlacement&, ShellBatch&) noexcept;
/** Reads value, gradient and cell derivatives at a place (seven numbers). */
using FootFunction = void (*)(
  const ShellReading&, double x, double y, double z, double* to) noexcept;
/** Reads value, gradient and cell derivatives at Place, for a batch. */
using ReadFunction = void (*)(const ShellReading&, ShellBatch&) noexcept;
/**
 * Computes the other results from the values at Place, Index, Offset and Solid. Sets the bits of
 * points that may be in contact, that is, of points with a gradient that are deep enough. In a thin
 * wall, a point may still be in contact after it has come out on the other side.
 */
using FeetFunction = std::uint64_t (*)(
  const ShellReading&, const ShellFrame&, ShellBatch&) noexcept;
/** Reads trilinear values at indices. A value that is not finite is replaced by BorderValue. */
using ValuesFunction = void (*)(
  const ShellReading&, const ShellNumbers& indices, double* to) noexcept;
/**
 * Applies the law of ShellContacts.h: appends the contacts and the forces of pressed points, and
 * adds to the energy and the numbers of contacts. Sets the bits of points that are in contact. The
 * batch must not be empty.
 */
using HoldFunction = std::uint64_t (*)(const ShellReading&, ShellLaw&, ShellBatch&,
  ShellContact*& next, ShellPushes&, ShellSum&) noexcept;
/**
 * Adds the sum of force w over all wrenches w to `gradient` (six numbers), and the sum of stiffness
 * w w^T to `curvature` (21 numbers, a lower triangle by rows).
 */
using AddFunction = void (*)(const ShellPushes&, double* gradient, double* curvature) noexcept;

/** The kernels for one scalar type. */
struct ShellFunctions
{
  MarkFunction Mark = nullptr;
  MarkingFunction Marking = nullptr;
  BoxFunction Box = nullptr;
  SlopeFunction Slope = nullptr;
  PlaceFunction Place = nullptr;
  FootFunction Foot = nullptr;
  ReadFunction Read = nullptr;
  FeetFunction Feet = nullptr;
  ValuesFunction Values = nullptr;
  HoldFunction Hold = nullptr;
  AddFunction Add = nullptr;
};

///@{
/**
 * These functions are not inline, because the kernels must not call inline functions
 * (FieldKernels.h).
 */
const MaterialTable::Segment* FindSegmentOf(const MaterialTable& table, double x) noexcept;
const DistinctnessTable::Segment* FindSegmentOf(const DistinctnessTable& table, double x) noexcept;
///@}

/** A volume in the form that the kernels read, with its removed tissue. */
class ShellReader
{
public:
  ShellReader(const VolumeView& view, double level, bool isBelow,
    InstructionSet instructions = DetectInstructionSet()) noexcept
    : ShellReader(view, level, isBelow, CarvedView{}, instructions)
  {
  }
  ShellReader(const VolumeView& view, double level, bool isBelow, const CarvedView& carved,
    InstructionSet instructions = DetectInstructionSet()) noexcept;

  /** Like MarkFunction. Removal of tissue never makes a place solid. */
  std::uint64_t Mark(const ShellNumbers& points, const double* toolToIndex) const noexcept
  {
    return this->Unmark(
      points, toolToIndex, this->Functions.Mark(this->Reading, points, toolToIndex));
  }
  /** Like Mark(), ignoring removed tissue. The points must have earlier marks. */
  std::uint64_t MarkWhole(const ShellNumbers& points, const double* toolToIndex,
    const ShellMarking& before) const noexcept
  {
    return this->Functions.Marking(this->Reading, points, toolToIndex, before);
  }
  /** Clears the marks of points whose tissue was removed. */
  std::uint64_t Unmark(
    const ShellNumbers& points, const double* toolToIndex, std::uint64_t marks) const noexcept
  {
    return marks != 0 && this->Carved.HasAny() ? this->Remark(points, toolToIndex, marks) : marks;
  }
  /**
   * Returns false if no position in a box around an index is solid. `half` is half of the box's
   * size along each axis, in samples. Returns true if a position may be solid, or if the box has
   * too many samples to check. Ignores removed tissue, so that the result stays valid while tissue
   * is only removed.
   */
  bool MayBeSolid(const Vector3& centre, const Vector3& half) const noexcept;
  /**
   * Computes the largest slopes (per sample) along each axis in such a box. Returns false if the
   * box has too many samples to check, extends outside the resident samples, or has a sample that
   * is not finite. Ignores removed tissue.
   */
  bool ComputeSlopes(const Vector3& centre, const Vector3& half, double* slopes) const noexcept;
  void Place(
    const ShellFrame& frame, const ShellPlacement& placement, ShellBatch& batch) const noexcept
  {
    this->Functions.Place(frame, placement, batch);
  }
  std::uint64_t ComputeAllFeet(const ShellFrame& frame, ShellBatch& batch) const noexcept
  {
    this->Functions.Read(this->Reading, batch);
    if (this->Carved.HasAny())
    {
      this->ReadCarved(batch);
    }
    return this->Functions.Feet(this->Reading, frame, batch);
  }
  void Add(const ShellPushes& forces, double* gradient, double* curvature) const noexcept
  {
    this->Functions.Add(forces, gradient, curvature);
  }
  void ReadValues(const ShellNumbers& indices, double* to) const noexcept
  {
    this->Functions.Values(this->Reading, indices, to);
    if (this->Carved.HasAny())
    {
      this->ReadCarved(indices, to);
    }
  }
  std::uint64_t Hold(ShellLaw& law, ShellBatch& batch, ShellContact*& next, ShellPushes& pushes,
    ShellSum& sum) const noexcept
  {
    return this->Functions.Hold(this->Reading, law, batch, next, pushes, sum);
  }

private:
  /** Limit of the samples that are copied at a time (32 KiB). */
  static constexpr std::int64_t MostCopied = 4096;
  /**
   * A point with more samples than this gets its own copy, because that is faster.
   */
  static constexpr std::int64_t WorthOfPoint = 40;

  /** Calls f(copy, i) for the boxes in which tissue was removed, and for some boxes near them. */
  template <typename F>
  void ForEachCopy(const CarvedBox* boxes, std::size_t count, const F& f) const noexcept;
  /** Clears the marks of points whose tissue was removed. */
  std::uint64_t Remark(
    const ShellNumbers& points, const double* toolToIndex, std::uint64_t marks) const noexcept;
  ///@{
  /** Where tissue was removed, replace the values by values of the remaining tissue. */
  void ReadCarved(ShellBatch& batch) const noexcept;
  void ReadCarved(const ShellNumbers& indices, double* to) const noexcept;
  ///@}

  ShellReading Reading;
  VolumeView Given;
  CarvedView Carved;
  ShellFunctions Functions;
  ShellFunctions OfCopies; ///< functions for copies, which are doubles
};

} // namespace VolumeHaptics

#endif
