// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads a volume at the points of a shell.
 *
 * As in FieldSampler.h, the kernels are compiled once per instruction set and chosen at run time,
 * and all give the same bits.
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
  FieldView View;                       ///< without a kernel
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
 * Of up to 64 points, sets the bits of those that are within the volume and whose trilinear value
 * is solid; NaN is not. The map from the tool to indices: a matrix by rows, and an offset.
 */
using MarkFunction = std::uint64_t (*)(
  const ShellReading&, const ShellNumbers&, const double* map) noexcept;
/**
 * The marks of 1 to 64 points as they were found before, while the tool was near. Only those of
 * points are found anew that may have come to the level since. Lengths are those that any point has
 * travelled at most, in voxels.
 */
struct ShellMarking
{
  std::uint64_t Marks; ///< as they were found
  double* Until;       ///< for each of 64 points: up to where its mark stays
  double Now;          ///< where the tool is
  double From;         ///< with what is found now, lengths count from here
  double PerValue;     ///< voxels that a value takes at least to change by 1; 0 if that is unknown
};
/** As MarkFunction. Writes to ShellMarking::Until. */
using MarkingFunction = std::uint64_t (*)(
  const ShellReading&, const ShellNumbers&, const double* map, const ShellMarking&) noexcept;
/** Whether any sample in a box of indices is solid; NaN is not. */
using BoxFunction = bool (*)(
  const ShellReading&, const std::int64_t* low, const std::int64_t* high) noexcept;
/**
 * The largest differences between neighbours in a box of indices, along each axis; not finite if a
 * sample is not.
 */
using SlopeFunction = void (*)(
  const ShellReading&, const std::int64_t* low, const std::int64_t* high, double* most) noexcept;

/** From Position and Before, where the points and their feet are. */
using PlaceFunction = void (*)(const ShellFrame&, const ShellPlacement&, ShellBatch&) noexcept;
/** Value, gradient and derivatives in the cell at a place: seven numbers. */
using FootFunction = void (*)(
  const ShellReading&, double x, double y, double z, double* to) noexcept;
/** The same of a batch, at Place. */
using ReadFunction = void (*)(const ShellReading&, ShellBatch&) noexcept;
/**
 * From these, Index, Offset and Solid, the rest of what is found. Sets the bits of points that may
 * be in contact: there is a gradient, and they are deep enough, which in a thin wall they may be
 * after they have come out of its other side.
 */
using FeetFunction = std::uint64_t (*)(
  const ShellReading&, const ShellFrame&, ShellBatch&) noexcept;
/** Trilinear values at indices; BorderValue if one is not finite. */
using ValuesFunction = void (*)(
  const ShellReading&, const ShellNumbers& indices, double* to) noexcept;
/**
 * The law of ShellContacts.h: appends the contacts, and the forces of those that are pressed, and
 * adds to the energy and the numbers of contacts. The batch is not empty. Sets the bits of points
 * that are in contact.
 */
using HoldFunction = std::uint64_t (*)(const ShellReading&, ShellLaw&, ShellBatch&,
  ShellContact*& next, ShellPushes&, ShellSum&) noexcept;
/**
 * Of the wrenches w: adds the sums of force w to the six numbers, and those of stiffness w w^T to
 * the 21 of a lower triangle, by rows.
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
/** Not inline, for the kernels: see FieldKernels.h. */
const MaterialTable::Segment* FindSegmentOf(const MaterialTable& table, double x) noexcept;
const DistinctnessTable::Segment* FindSegmentOf(const DistinctnessTable& table, double x) noexcept;
///@}

/** A volume, ready to be read, and what was removed of it. */
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

  /** See MarkFunction. Where tissue was removed, no place is solid that was not so before. */
  std::uint64_t Mark(const ShellNumbers& points, const double* toolToIndex) const noexcept
  {
    return this->Unmark(
      points, toolToIndex, this->Functions.Mark(this->Reading, points, toolToIndex));
  }
  /** The same of points that were marked before: without what was removed. */
  std::uint64_t MarkWhole(const ShellNumbers& points, const double* toolToIndex,
    const ShellMarking& before) const noexcept
  {
    return this->Functions.Marking(this->Reading, points, toolToIndex, before);
  }
  /** Takes away what was removed. */
  std::uint64_t Unmark(
    const ShellNumbers& points, const double* toolToIndex, std::uint64_t marks) const noexcept
  {
    return marks != 0 && this->Carved.HasAny() ? this->Remark(points, toolToIndex, marks) : marks;
  }
  /**
   * False if no position in a box around an index (half its size along each axis, in samples) is
   * solid. True if one may be, or if the box has too many samples for a look. What was removed
   * does not count: so no answer changes while tissue is only removed.
   */
  bool MayBeSolid(const Vector3& centre, const Vector3& half) const noexcept;
  /**
   * The largest slopes along each axis, per sample, in such a box. False if it has too many samples
   * for a look, reaches beyond those that are here, or has one that is not finite. Without what was
   * removed.
   */
  bool FindSlopes(const Vector3& centre, const Vector3& half, double* slopes) const noexcept;
  void Place(
    const ShellFrame& frame, const ShellPlacement& placement, ShellBatch& batch) const noexcept
  {
    this->Functions.Place(frame, placement, batch);
  }
  std::uint64_t FindFeet(const ShellFrame& frame, ShellBatch& batch) const noexcept
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
  /** Samples that are copied at a time: 32 KiB. */
  static constexpr std::int64_t MostCopied = 4096;
  /** If points need more samples each, they have copies of their own, which then take less time. */
  static constexpr std::int64_t WorthOfPoint = 40;

  /** Calls f(copy, i) for the boxes in which tissue was removed, and for some beside them. */
  template <typename F>
  void ForEachCopy(const CarvedBox* boxes, std::size_t count, const F& f) const noexcept;
  /** Takes the marks away of which the tissue was removed. */
  std::uint64_t Remark(
    const ShellNumbers& points, const double* toolToIndex, std::uint64_t marks) const noexcept;
  ///@{
  /** Where tissue was removed, what is left in place of what was read. */
  void ReadCarved(ShellBatch& batch) const noexcept;
  void ReadCarved(const ShellNumbers& indices, double* to) const noexcept;
  ///@}

  ShellReading Reading;
  VolumeView Given;
  CarvedView Carved;
  ShellFunctions Functions;
  ShellFunctions OfCopies; ///< of doubles
};

} // namespace VolumeHaptics

#endif
