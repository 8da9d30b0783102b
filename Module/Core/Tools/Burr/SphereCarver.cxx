// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Tools/Burr/SphereCarver.h"

#include "Core/Field/WholeData.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace VolumeHaptics
{
namespace
{

constexpr std::int64_t BrickSide = CarvedBricks::Side;
///@{
/**
 * Measured work (CarvingCost) for a brick and for a row, in addition to 1 for each. The work
 * depends only on the fractions and the sphere, and not on the carver's memory, so that a replay
 * ends its parts at the same places as the recording.
 */
constexpr std::size_t WorkOfPlace = 1;
constexpr std::size_t WorkOfSolid = 40; ///< work for a brick that is not in use
/** Work for a brick that is not in use and has no solid samples. */
constexpr std::size_t WorkOfEmpty = 100;
/** Divisor of WorkOfSolid and WorkOfEmpty after the first sphere. */
constexpr std::size_t KnownPart = 5;
constexpr std::size_t WorkOfFractions = 8;
constexpr std::size_t WorkOfChange = 12;
///@}
static_assert(SphereCarver::MostWorkOfBrick ==
    WorkOfPlace + WorkOfSolid + CarvedBricks::Rows * (1 + WorkOfFractions + WorkOfChange),
  "the sum of all");

/**
 * Returns how far a sphere (and its bounding box) reaches along an axis to both sides, in index
 * steps.
 */
double ReachAlong(const Vector3& row, double radius) noexcept
{
  return radius * Norm(row);
}

/** Half of the smallest step between fractions, relative to all of the tissue. */
constexpr double HalfFraction = 0.5 / CarvedBricks::Whole;
/**
 * Returns the remaining part of a voxel's volume for a fraction. `edge` is the fraction at the
 * sphere's surface.
 */
double ComputeLeft(std::int32_t fraction, double edge) noexcept
{
  const double rho = static_cast<double>(fraction) / CarvedBricks::Whole;
  const double low = std::max(edge - 0.5 * SphereCarver::CountedPart, 0.0);
  const double high = std::min(edge + 0.5 * SphereCarver::CountedPart, 1.0);
  return std::clamp((rho - low) / (high - low), 0.0, 1.0);
}

} // namespace

/** A sphere to try, with values that every row of samples needs. */
struct SphereCarver::Sphere
{
  Vector3 Centre; ///< centre of the sphere (m)
  Vector3 Index;  ///< index of Centre
  double Radius;
  double Width;
  double Outer; ///< squared distance (m^2) beyond which samples do not change
  double Ramp; ///< squared distance (m^2) beyond which samples with r of at least 1/2 do not change
  /**
   * Whether a sphere around From was removed before, so that samples that are nearer to From do not
   * change.
   */
  bool HasFrom;
  Vector3 Way; ///< Centre - From (m)
  /** (x - Centre) . Way for a position x in the middle between From and Centre (m^2). */
  double Middle;
  double BrickRadius; ///< distance from a brick's middle to its farthest corner (m)
  CarvedBox Box;      ///< the resident samples in reach
  CarvedBox Bricks;   ///< all samples in reach, resident or not
};

SphereCarver::SphereCarver()
  : Changes(MostChanges)
  , Empty(Remembered)
{
}

void SphereCarver::SetTissue(const HapticModel& model, const CarvedTissue& tissue) noexcept
{
  const bool isSame = this->Model == model.Baked->Number && this->Tissue.Level == tissue.Level &&
    this->Tissue.IsBelow == tissue.IsBelow;
  const VolumeView& view = model.Baked->Field.GetView();
  const bool isResident = isSame && std::equal(view.First, view.First + 3, this->View.First) &&
    std::equal(view.Dimensions, view.Dimensions + 3, this->View.Dimensions);
  this->Tissue = tissue;
  this->Model = model.Baked->Number;
  this->View = view;
  this->View.Data = WholeData(view);
  this->Air = model.Baked->Field.GetCarved().Air;
  this->ToIndex = model.DeviceToIndex;
  const BakedLabels* const labels = model.Baked->Labels.get();
  this->Labels = labels && labels->Table.HasSpecificEnergy() ? labels : nullptr;
  this->ToLabel = model.IndexToLabel;
  const Matrix3 columns = Transpose(Inverse(this->ToIndex.Linear));
  std::copy(columns.Row, columns.Row + 3, this->Step);
  const double volume = std::abs(Dot(this->Step[0], Cross(this->Step[1], this->Step[2])));
  this->Voxel = std::cbrt(volume);
  // Voxels that are cubes apart from rounding count as cubes, so that rounding does not select a
  // side.
  constexpr double cube = 1.0 - 1e-9;
  this->Longest = this->Voxel;
  for (const Vector3& step : this->Step)
  {
    this->Longest = std::max(this->Longest, cube * Norm(step));
  }
  this->Volume = 1e9 * volume;
  const double strongest = WithSampleType(view.Type,
    [&](auto sample)
    {
      using Limits = std::numeric_limits<decltype(sample)>;
      return static_cast<double>(tissue.IsBelow ? Limits::lowest() : Limits::max());
    });
  this->Reach = std::max(0.5, 1.0 - this->ComputeEdge(strongest));
  if (!isResident)
  {
    std::fill(this->Empty.begin(), this->Empty.end(), 0);
  }
  this->Count = 0;
}

CarvingCost SphereCarver::Try(const TissueRemoval& removal, const Vector3& centre, double radius,
  const Vector3* from, const CarvingPart& part) noexcept
{
  this->Count = 0;
  Sphere sphere{};
  sphere.Centre = centre;
  sphere.Index = this->ToIndex(centre);
  sphere.Radius = radius;
  sphere.Width = this->GetRampWidth();
  const double outer = radius + this->Reach * sphere.Width;
  sphere.Outer = outer * outer;
  const double ramp = radius + 0.5 * sphere.Width;
  sphere.Ramp = ramp * ramp;
  sphere.HasFrom = from != nullptr;
  if (from)
  {
    sphere.Way = centre - *from;
    sphere.Middle = -0.5 * Dot(sphere.Way, sphere.Way);
  }
  const double half = 0.5 * (BrickSide - 1);
  sphere.BrickRadius = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const Vector3 diagonal = half *
      (this->Step[0] + (corner & 1 ? 1.0 : -1.0) * this->Step[1] +
        (corner & 2 ? 1.0 : -1.0) * this->Step[2]);
    sphere.BrickRadius = std::max(sphere.BrickRadius, Norm(diagonal));
  }
  const double at[3] = { sphere.Index.X, sphere.Index.Y, sphere.Index.Z };
  CarvingCost cost;
  for (int a = 0; a < 3; ++a)
  {
    const double reach = ReachAlong(this->ToIndex.Linear.Row[a], outer);
    const auto first = static_cast<double>(this->View.First[a]);
    const auto last = static_cast<double>(this->View.Last(a));
    // The condition is true for NaN, too.
    if (!(at[a] + reach >= first && at[a] - reach <= last))
    {
      return cost;
    }
    sphere.Box.Low[a] = static_cast<std::int64_t>(std::ceil(std::max(at[a] - reach, first)));
    sphere.Box.High[a] = static_cast<std::int64_t>(std::floor(std::min(at[a] + reach, last)));
    sphere.Bricks.Low[a] =
      static_cast<std::int64_t>(std::floor(at[a] - reach)) >> CarvedBricks::Shift;
    sphere.Bricks.High[a] =
      static_cast<std::int64_t>(std::floor(at[a] + reach)) >> CarvedBricks::Shift;
    if (sphere.Box.Low[a] > sphere.Box.High[a])
    {
      return cost;
    }
  }
  return WithSampleType(this->View.Type,
    [&](auto sample) { return this->TryTyped<decltype(sample)>(removal.Bricks, sphere, part); });
}

template <typename T>
CarvingCost SphereCarver::TryTyped(
  const CarvedBricks& bricks, const Sphere& sphere, const CarvingPart& wanted) noexcept
{
  CarvingCost cost;
  std::uint32_t added = 0;
  const auto first = [&](int a) { return sphere.Bricks.Low[a]; };
  const auto count = [&](int a) { return sphere.Bricks.Size(a); };
  const auto isHere = [&](std::int64_t at, int a)
  {
    return at >= sphere.Box.Low[a] >> CarvedBricks::Shift &&
      at <= sphere.Box.High[a] >> CarvedBricks::Shift;
  };
  const std::int64_t places = count(0) * count(1) * count(2);
  const double half = 0.5 * (BrickSide - 1);
  const double reach = std::sqrt(sphere.Outer) + sphere.BrickRadius;
  BrickPlace brick{ first(0) + wanted.First % count(0),
    first(1) + wanted.First / count(0) % count(1),
    first(2) + wanted.First / (count(0) * count(1)) };
  const auto next = [&]()
  {
    if (++brick.X == first(0) + count(0))
    {
      brick.X = first(0);
      if (++brick.Y == first(1) + count(1))
      {
        brick.Y = first(1);
        ++brick.Z;
      }
    }
  };
  for (std::int64_t place = wanted.First; place < places; ++place, next())
  {
    if (cost.Work >= wanted.MostWork || this->Count + CarvedBricks::Rows > MostChanges)
    {
      cost.Next = static_cast<std::uint32_t>(place);
      break;
    }
    cost.Work += WorkOfPlace;
    const auto from = [half](std::int64_t at, double centre)
    { return static_cast<double>(at * BrickSide) + half - centre; };
    const Vector3 middle = from(brick.X, sphere.Index.X) * this->Step[0] +
      from(brick.Y, sphere.Index.Y) * this->Step[1] + from(brick.Z, sphere.Index.Z) * this->Step[2];
    const bool isBehind = sphere.HasFrom &&
      Dot(middle, sphere.Way) + sphere.BrickRadius * Norm(sphere.Way) < sphere.Middle;
    if (isBehind || Dot(middle, middle) >= reach * reach || !isHere(brick.X, 0) ||
      !isHere(brick.Y, 1) || !isHere(brick.Z, 2))
    {
      continue;
    }
    added += this->LookAt<T>(bricks, sphere, brick, cost) ? 1 : 0;
  }
  cost.Changes = this->Count;
  cost.IsUsedUp = bricks.GetCount() + added > bricks.GetMost();
  return cost;
}

/** Computes the changes in a brick. Returns whether the brick must be added to store them. */
template <typename T>
bool SphereCarver::LookAt(const CarvedBricks& bricks, const Sphere& sphere, const BrickPlace& place,
  CarvingCost& cost) noexcept
{
  const std::uint64_t key = CarvedBricks::KeyOf(place);
  const std::uint32_t brick = bricks.Find(key);
  if (brick == CarvedBricks::None)
  {
    const bool isSolid = this->IsAnySolid<T>(place);
    cost.Work += (isSolid ? WorkOfSolid : WorkOfEmpty) / (sphere.HasFrom ? KnownPart : 1);
    if (!isSolid)
    {
      return false;
    }
  }
  CarvedBox part;
  const std::int64_t bases[3] = { place.X * BrickSide, place.Y * BrickSide, place.Z * BrickSide };
  for (int a = 0; a < 3; ++a)
  {
    part.Low[a] = std::max(sphere.Box.Low[a], bases[a]);
    part.High[a] = std::min(sphere.Box.High[a], bases[a] + BrickSide - 1);
  }
  const double sign = this->Tissue.IsBelow ? -1.0 : 1.0;
  const double twice = this->Air + 2.0 * (this->Tissue.Level - this->Air);
  const double square = Dot(this->Step[0], this->Step[0]);
  const double slope = Dot(this->Step[0], sphere.Way);
  const double perWidth = 1.0 / sphere.Width;
  const std::int64_t* const stride = this->View.Stride;
  const std::size_t before = this->Count;
  for (std::int64_t k = part.Low[2]; k <= part.High[2]; ++k)
  {
    for (std::int64_t j = part.Low[1]; j <= part.High[1]; ++j)
    {
      ++cost.Work;
      const auto row = static_cast<int>(j - bases[1] + BrickSide * (k - bases[2]));
      const std::uint64_t fractions =
        brick == CarvedBricks::None ? CarvedBricks::WholeRow : bricks.GetRow(brick, row);
      if (fractions == 0)
      {
        continue;
      }
      // Relative to the centre, sample i of the row is at begin + i Step[0].
      const Vector3 begin = (static_cast<double>(bases[0]) - sphere.Index.X) * this->Step[0] +
        (static_cast<double>(j) - sphere.Index.Y) * this->Step[1] +
        (static_cast<double>(k) - sphere.Index.Z) * this->Step[2];
      const double c = Dot(begin, begin);
      const double b = Dot(begin, this->Step[0]);
      const double nearest = -b / square;
      const double within = std::min(std::max(nearest, 0.0), double(BrickSide - 1));
      const double nearestSquare = c + within * (2.0 * b + within * square);
      if (nearestSquare >= sphere.Outer)
      {
        continue;
      }
      const std::int64_t low = part.Low[0] - bases[0];
      const std::int64_t high = part.High[0] - bases[0];
      const double side = Dot(begin, sphere.Way);
      if (sphere.HasFrom &&
        std::max(side + static_cast<double>(low) * slope,
          side + static_cast<double>(high) * slope) < sphere.Middle)
      {
        continue;
      }
      if (nearestSquare >= sphere.Ramp)
      {
        const T* const line = static_cast<const T*>(this->View.Data) + bases[0] * stride[0] +
          j * stride[1] + k * stride[2];
        bool isReached = false;
        for (std::int64_t i = low; i <= high; ++i)
        {
          isReached |= sign * (static_cast<double>(line[i * stride[0]]) - twice) > 0.0;
        }
        if (!isReached)
        {
          continue;
        }
      }
      cost.Work += WorkOfFractions;
      // Compute all samples of the row together, because the compiler vectorises this loop.
      double ramp[BrickSide]; // distance of each sample from the surface in widths of the ramp
      for (int i = 0; i < BrickSide; ++i)
      {
        const double at = i;
        const double distance = std::sqrt(std::max(c + at * (2.0 * b + at * square), 0.0));
        ramp[i] = (distance - sphere.Radius) * perWidth;
      }
      std::uint64_t left = fractions;
      for (std::int64_t i = low; i <= high; ++i)
      {
        const auto old = static_cast<std::int32_t>(fractions >> (8 * i) & 255);
        if (old == 0 || ramp[i] >= 1.0 ||
          (sphere.HasFrom && side + static_cast<double>(i) * slope < sphere.Middle))
        {
          continue;
        }
        const auto value = static_cast<double>(static_cast<const T*>(
          this->View.Data)[(bases[0] + i) * stride[0] + j * stride[1] + k * stride[2]]);
        const double edge = this->ComputeEdge(value);
        const double rho = edge + ramp[i];
        const auto fraction =
          static_cast<std::int32_t>(CarvedBricks::Whole * std::min(std::max(rho, 0.0), 1.0) + 0.5);
        if (fraction >= old)
        {
          continue;
        }
        left &= ~(std::uint64_t{ 255 } << (8 * i));
        left |= static_cast<std::uint64_t>(fraction) << (8 * i);
        if (sign * (value - this->Tissue.Level) >= 0.0)
        {
          const double volume =
            this->Volume * (ComputeLeft(old, edge) - ComputeLeft(fraction, edge));
          cost.Volume += volume;
          if (volume > 0.0) // removing nothing costs nothing, even in tissue that can't be removed
          {
            const Vector3 index{ static_cast<double>(bases[0] + i), static_cast<double>(j),
              static_cast<double>(k) };
            cost.Energy += volume * this->ComputeEnergy(value, index);
          }
        }
      }
      if (left != fractions)
      {
        cost.Work += WorkOfChange;
        this->Changes[this->Count++] = { key, left, row };
      }
    }
  }
  return brick == CarvedBricks::None && this->Count > before;
}

double SphereCarver::ComputeEdge(double value) const noexcept
{
  const double fraction = (this->Tissue.Level - this->Air) / (value - this->Air);
  // If the value is not solid, no fraction of tissue gives the sample the level. The sample then
  // keeps all of its tissue except half a step.
  return fraction >= 0.0 && fraction < 1.0 - HalfFraction ? std::max(fraction, HalfFraction)
                                                          : 1.0 - HalfFraction;
}

double SphereCarver::ComputeEnergy(double value, const Vector3& index) const noexcept
{
  if (this->Labels)
  {
    const LabelMaterial* const material =
      this->Labels->Table.Find(this->Labels->View.Nearest(this->ToLabel(index)));
    if (material && material->HasSpecificEnergy)
    {
      return material->SpecificEnergy;
    }
  }
  return (*this->Tissue.SpecificEnergy)(value)[0];
}

template <typename T>
bool SphereCarver::IsAnySolid(const BrickPlace& place) noexcept
{
  const std::uint64_t key = CarvedBricks::KeyOf(place);
  std::uint64_t& known = this->Empty[(key * 0x9e3779b97f4a7c15) >> 52];
  static_assert(Remembered == 4096, "as many as 12 bits number");
  if (known == key + 1)
  {
    return false;
  }
  const std::int64_t brick[3] = { place.X, place.Y, place.Z };
  std::int64_t low[3];
  std::int64_t high[3];
  for (int a = 0; a < 3; ++a)
  {
    low[a] = std::max(brick[a] * BrickSide - 1, this->View.First[a]);
    high[a] = std::min(brick[a] * BrickSide + BrickSide, this->View.Last(a));
  }
  const double sign = this->Tissue.IsBelow ? -1.0 : 1.0;
  const std::int64_t* const stride = this->View.Stride;
  for (std::int64_t k = low[2]; k <= high[2]; ++k)
  {
    for (std::int64_t j = low[1]; j <= high[1]; ++j)
    {
      const T* const line = static_cast<const T*>(this->View.Data) + k * stride[2] + j * stride[1];
      for (std::int64_t i = low[0]; i <= high[0]; ++i)
      {
        if (sign * (static_cast<double>(line[i * stride[0]]) - this->Tissue.Level) >= 0.0)
        {
          return true;
        }
      }
    }
  }
  known = key + 1;
  return false;
}

void SphereCarver::AppendTables(std::vector<MemoryRange>& tables) const
{
  tables.push_back({ this->Changes.data(), this->Changes.size() * sizeof(this->Changes[0]) });
  tables.push_back({ this->Empty.data(), this->Empty.size() * sizeof(this->Empty[0]) });
}

void SphereCarver::Carve(TissueRemoval& removal) const noexcept
{
  CarvedBricks& bricks = removal.Bricks;
  for (std::size_t i = 0; i < this->Count;)
  {
    const std::uint64_t key = this->Changes[i].Key;
    const std::uint32_t brick = bricks.FindOrAdd(key);
    if (brick == CarvedBricks::None)
    {
      return;
    }
    removal.Journal.Keep(brick);
    for (; i < this->Count && this->Changes[i].Key == key; ++i)
    {
      bricks.SetRow(brick, this->Changes[i].Row, this->Changes[i].Fractions);
    }
    bricks.MarkChanged(brick);
  }
}

} // namespace VolumeHaptics
