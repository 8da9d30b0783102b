// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a volume at the points of a shell.
 *
 * The kernels are compiled once per instruction set and chosen at run time, as in FieldSampler.h;
 * all give the same bits.
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

/** The volume that is read, and the level beyond which it is solid. Borrows the samples. */
struct ShellReading
{
  FieldView View;                       ///< samples without a kernel
  double Border[3] = { 0.0, 0.0, 0.0 }; ///< the volume's largest index along each axis
  double Level = 0.0;
  double Sign = 1.0; ///< -1 if values below the level are solid
};

/** Points in the frame of a tool, or indices. */
struct ShellNumbers
{
  const double* X;
  const double* Y;
  const double* Z;
  std::size_t Count;
};

/**
 * Marks up to 64 points: sets the bits of points within the volume whose trilinear value is solid;
 * NaN is not solid. The map from the tool to indices is a matrix by rows, and an offset.
 */
using MarkFunction = std::uint64_t (*)(
  const ShellReading&, const ShellNumbers&, const double* map) noexcept;
/**
 * The last marks of 1 to 64 points, made when the tool was near. Only points that may have reached
 * the level since are read again. Lengths are the largest way of any point, in voxels.
 */
struct ShellMarking
{
  std::uint64_t Marks; ///< the last marks
  double* Until;       ///< for each of 64 points: the length up to which its mark is valid
  double Now;          ///< the tool's length now
  double From;         ///< new marks count their lengths from here
  double PerValue;     ///< the fewest voxels over which a value changes by 1; 0 if that is unknown
};
/** Does the same as MarkFunction; also writes to ShellMarking::Until. */
using MarkingFunction = std::uint64_t (*)(
  const ShellReading&, const ShellNumbers&, const double* map, const ShellMarking&) noexcept;
/** Returns whether any sample in a box of indices is solid; NaN is not solid. */
using BoxFunction = bool (*)(
  const ShellReading&, const std::int64_t* low, const std::int64_t* high) noexcept;
/**
 * Computes the largest differences between neighbours in a box of indices, along each axis; not
 * finite if a sample is not.
 */
using SlopeFunction = void (*)(
  const ShellReading&, const std::int64_t* low, const std::int64_t* high, double* most) noexcept;

/** Computes the places of the points and their feet from Position and Before. */
using PlaceFunction = void (*)(const ShellFrame&, const ShellPlacement&, ShellBatch&) noexcept;
/** Reads value, gradient and derivatives in the cell at a place: seven numbers. */
using FootFunction = void (*)(
  const ShellReading&, double x, double y, double z, double* to) noexcept;
/** Reads value, gradient and cell derivatives for a batch, at Place. */
using ReadFunction = void (*)(const ShellReading&, ShellBatch&) noexcept;
/**
 * Computes the other results from Place's results, Index, Offset and Solid. Sets the bits of points
 * that may be in contact: there is a gradient, and the points are deep enough. In a thin wall,
 * points may still be in contact after they have come out of the wall's other side.
 */
using FeetFunction = std::uint64_t (*)(
  const ShellReading&, const ShellFrame&, ShellBatch&) noexcept;
/** Reads trilinear values at indices; BorderValue if a value is not finite. */
using ValuesFunction = void (*)(
  const ShellReading&, const ShellNumbers& indices, double* to) noexcept;
/**
 * The law of ShellContacts.h: appends the contacts, and the forces of pressed points, and adds to
 * the energy and the numbers of contacts. The batch must not be empty. Sets the bits of points that
 * are in contact.
 */
using HoldFunction = std::uint64_t (*)(const ShellReading&, ShellLaw&, ShellBatch&,
  ShellContact*& next, ShellPushes&, ShellSum&) noexcept;
/**
 * For the wrenches w: adds the sum of force w to the six numbers, and the sum of stiffness w w^T to
 * the 21 numbers of a lower triangle, by rows.
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
/** Not inline, because of the kernels: see FieldKernels.h. */
const MaterialTable::Segment* FindSegmentOf(const MaterialTable& table, double x) noexcept;
const DistinctnessTable::Segment* FindSegmentOf(const DistinctnessTable& table, double x) noexcept;
///@}

/** A volume, ready to be read, with its removed tissue. */
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

  /** See MarkFunction. Removal of tissue never makes a place solid. */
  std::uint64_t Mark(const ShellNumbers& points, const double* toolToIndex) const noexcept
  {
    return this->Unmark(
      points, toolToIndex, this->Functions.Mark(this->Reading, points, toolToIndex));
  }
  /** Does the same as Mark, as if nothing was removed, for points with earlier marks. */
  std::uint64_t MarkWhole(const ShellNumbers& points, const double* toolToIndex,
    const ShellMarking& before) const noexcept
  {
    return this->Functions.Marking(this->Reading, points, toolToIndex, before);
  }
  /** Clears the marks of removed tissue. */
  std::uint64_t Unmark(
    const ShellNumbers& points, const double* toolToIndex, std::uint64_t marks) const noexcept
  {
    return marks != 0 && this->Carved.HasAny() ? this->Remark(points, toolToIndex, marks) : marks;
  }
  /**
   * Returns false if no position in a box around an index (half its size along each axis, in
   * samples) is solid. Returns true if one may be, or if the box has too many samples to check.
   * Ignores removal: so the answer stays while tissue is only removed.
   */
  bool MayBeSolid(const Vector3& centre, const Vector3& half) const noexcept;
  /**
   * Computes the largest slopes along each axis, per sample, in such a box. Returns false if the
   * box has too many samples to check, reaches beyond the resident samples, or has a sample that is
   * not finite. Ignores removal.
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
  /** The most samples that are copied at a time: 32 KiB. */
  static constexpr std::int64_t MostCopied = 4096;
  /**
   * If a point needs more samples than this, it gets a copy of its own, which then takes less time.
   */
  static constexpr std::int64_t WorthOfPoint = 40;

  /** Calls f(copy, i) for the boxes in which tissue was removed, and for some boxes beside them. */
  template <typename F>
  void ForEachCopy(const CarvedBox* boxes, std::size_t count, const F& f) const noexcept;
  /** Clears the marks of points whose tissue was removed. */
  std::uint64_t Remark(
    const ShellNumbers& points, const double* toolToIndex, std::uint64_t marks) const noexcept;
  ///@{
  /** Replaces values by the values of the remaining tissue where tissue was removed. */
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
