// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Regions/RegionStore.h"

#include "Core/Realtime/ServoClock.h"
#include "VTK/Base/ArrayMemory.h"
#include "VTK/Base/OutsideFiller.h"
#include "VTK/Base/WholeFacts.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkTimeStamp.h"

#include <algorithm>
#include <cstdlib>
#include <new>
#include <system_error>
#include <utility>

namespace VolumeHaptics
{
namespace
{

constexpr BoxExtent NoRegion = { 0, -1, 0, -1, 0, -1 };
/** Shortest time (s) over which the velocity of the tip is measured. */
constexpr double VelocityTime = 0.01;
/** Largest number of samples in a region of the coarse level: about ten milliseconds of work. */
constexpr vtkIdType MostStandInSamples = 1 << 20;
/** Fraction of the force that is felt while the coarse level stands in. */
constexpr double StandInFraction = 0.5;
/**
 * Longest interval (s) between polls that counts as typical for the next one. In a longer interval,
 * the owner was busy.
 */
constexpr double LongestInterval = 0.5;

vtkSmartPointer<vtkDataArray> NewSamples(int type, vtkIdType values = 0)
{
  auto array = NewArray(type, 1, values);
  array->SetName("Scalars");
  return array;
}

} // namespace

RegionStore::RegionStore()
  : Region(NoRegion)
{
}

RegionStore::~RegionStore() = default;

void RegionStore::SetVolume(const LargeVolumeKey& key, std::shared_ptr<const LargeVolume> volume)
{
  this->Clear();
  this->Key = key;
  this->Volume = std::move(volume);
  if (this->Volume->IsSmooth)
  {
    this->SetFacts({ 0.0, this->Volume->BorderValue, {}, {}, {} });
  }
}

void RegionStore::Clear()
{
  this->Thread.reset();
  this->Volume.reset();
  this->Facts.reset();
  this->Notice.clear();
  this->Samples = nullptr;
  this->Region = NoRegion;
  this->StandsIn = false;
  this->SetCoarseLevel({}, nullptr);
  this->Ordered.reset();
  this->TipTime = 0.0;
  this->Velocity = {};
  this->UseTime = 0.0;
  this->Trouble.clear();
  this->Planner.ResetLatency();
}

void RegionStore::SetCoarseLevel(const CoarseKey& key, std::shared_ptr<const CoarseLevel> level)
{
  this->StandIns.Forget();
  this->StandInOrdered.reset();
  this->CoarseOf = key;
  this->Coarse = std::move(level);
}

void RegionStore::SetFacts(const VolumeFacts& facts)
{
  this->Facts = facts;
  vtkTimeStamp stamp;
  stamp.Modified(); // gets a modification time, which no other volume has
  this->WholeTime = stamp.GetMTime();
  this->Notice = DescribeOutside(facts.Outside, NewSamples(this->Volume->ScalarType));
}

bool RegionStore::Survey(std::string& error)
{
  if (!this->Facts)
  {
    VolumeSurvey survey(*this->Volume);
    while (!survey.IsDone())
    {
      if (!survey.Advance(error))
      {
        return false;
      }
    }
    this->SetFacts(survey.GetFacts());
  }
  return true;
}

vtkSmartPointer<vtkDataArray> RegionStore::Read(const BoxExtent& region, std::string& error)
{
  try
  {
    if (!this->Survey(error))
    {
      return nullptr;
    }
    auto samples = NewSamples(this->Volume->ScalarType,
      static_cast<vtkIdType>(CountSamples(region)) * this->Volume->ValuesPerSample);
    return ReadSamples(*this->Volume, region, samples->GetVoidPointer(0), error) ? samples
                                                                                 : nullptr;
  }
  catch (const std::bad_alloc&)
  {
    error =
      "There is not enough memory for a region of " + this->Volume->Name + ". Read a smaller one.";
    return nullptr;
  }
}

void RegionStore::WriteFacts(vtkImageData* image, bool isFilled) const
{
  WholeFields fields;
  std::copy(this->Volume->Extent.begin(), this->Volume->Extent.end(), fields.Extent);
  const VolumeFacts facts = this->Facts.value_or(VolumeFacts{});
  fields.Noise = { facts.Noise };
  fields.BorderValues = { facts.BorderValue };
  fields.Solids = { facts.Solid };
  fields.Shifts = { facts.Shift };
  fields.Time = this->Facts ? static_cast<double>(this->WholeTime) : 0.0;
  fields.Share = this->StandsIn && image->GetPointData()->GetScalars() == this->Samples.Get()
    ? StandInFraction
    : 1.0;
  if (!isFilled)
  {
    fields.Outside = { facts.Outside };
  }
  WriteWholeFacts(fields, image);
}

bool RegionStore::Holds(const BoxExtent& region, const double tip[3]) const
{
  // The longest spring may need more room than a region with MaximumVoxels has, so allow for it
  // here.
  return this->Planner.ComputeRoom(tip, region.data()) + this->Planner.SpringLength >= 0.0;
}

void RegionStore::Show(RegionSamples&& region, bool standsIn)
{
  const auto samples = NewSamples(this->Volume->ScalarType);
  samples->SetVoidArray(region.Samples.release(),
    static_cast<vtkIdType>(CountSamples(region.Extent)) * this->Volume->ValuesPerSample, 0,
    vtkAbstractArray::VTK_DATA_ARRAY_FREE);
  this->Samples = samples;
  this->Region = region.Extent;
  this->StandsIn = standsIn;
}

bool RegionStore::ReceiveRegion(const double tip[3], double interval)
{
  const std::optional<VolumeFacts> facts = this->Facts ? std::nullopt : this->Thread->GetFacts();
  if (facts)
  {
    this->SetFacts(*facts);
    this->OrderTime = ServoClock::Now(); // starts the latency after the survey, which is not part
                                         // of it
  }
  this->Trouble = this->Thread->GetTrouble();
  std::optional<RegionSamples> come = this->Thread->Drain();
  if (!come)
  {
    return false;
  }
  if (this->Ordered == come->Extent)
  {
    // The order may have been late by one interval, because the hand was not polled in between.
    this->Planner.AddLatency(interval + ServoClock::SecondsSince(this->OrderTime) + this->UseTime);
    this->Ordered.reset();
  }
  if (this->StandsIn && this->Holds(this->Region, tip) && !this->Holds(come->Extent, tip))
  {
    return false; // the hand has left the box
  }
  this->Show(std::move(*come), false);
  return true;
}

bool RegionStore::UpdateStandIn(const double tip[3])
{
  const bool isWanted = this->Coarse && this->Facts && !this->Holds(this->Region, tip);
  const std::shared_ptr<RegionSamples>* const made =
    this->StandInOrdered ? this->StandIns.Find(*this->StandInOrdered) : nullptr;
  if (made)
  {
    this->StandInOrdered.reset();
    if (isWanted && *made && this->Holds((*made)->Extent, tip))
    {
      this->Show(std::move(**made), true);
      return true;
    }
  }
  BoxExtent box;
  if (!isWanted || this->StandIns.IsUnderWay())
  {
    return false;
  }
  const vtkIdType most = this->Planner.GetMaximumVoxels();
  this->Planner.SetMaximumVoxels(std::min(most, MostStandInSamples));
  const bool isThere = this->Planner.Plan(tip, this->Velocity.data(), NoRegion.data(), box.data());
  this->Planner.SetMaximumVoxels(most);
  if (isThere)
  {
    this->StandIns.Forget(); // the same box may be requested again later
    this->StandIns.Poll(box,
      [box, level = this->Coarse, volume = this->Volume](
        WorkMonitor&) -> std::optional<std::shared_ptr<RegionSamples>>
      {
        const auto size = static_cast<std::size_t>(CountSamples(box)) * volume->SampleSize;
        auto region = std::make_shared<RegionSamples>(
          RegionSamples{ box, std::unique_ptr<void, FreeMemory>(std::malloc(size)) });
        if (!region->Samples)
        {
          return std::nullopt;
        }
        level->Fill(box, volume->ScalarType, region->Samples.get());
        return region;
      });
    this->StandInOrdered = box;
  }
  return false;
}

void RegionStore::MeasureVelocity(const double tip[3], double time)
{
  const double elapsed = time - this->TipTime;
  if (elapsed >= VelocityTime || elapsed < 0.0)
  {
    for (int a = 0; a < 3; ++a)
    {
      this->Velocity[a] =
        this->TipTime > 0.0 && elapsed > 0.0 ? (tip[a] - this->Tip[a]) / elapsed : 0.0;
      this->Tip[a] = tip[a];
    }
    this->TipTime = time;
  }
}

void RegionStore::Order(const double tip[3])
{
  const vtkIdType most = this->Planner.GetMaximumVoxels();
  if (most < this->OrderedMost)
  {
    this->Ordered.reset(); // cancelled: there may be too little memory for the order
  }
  const BoxExtent here = this->Ordered.value_or(this->StandsIn ? NoRegion : this->Region);
  BoxExtent wanted;
  if (this->Planner.Plan(tip, this->Velocity.data(), here.data(), wanted.data()))
  {
    this->Thread->Order(wanted);
    this->Ordered = wanted;
    this->OrderedMost = most;
    this->OrderTime = ServoClock::Now();
  }
}

bool RegionStore::Poll(const double tip[3], double time)
{
  const std::int64_t now = ServoClock::Now();
  const double interval = this->LookTime > 0
    ? std::clamp(ServoClock::SecondsSince(this->LookTime), 0.0, LongestInterval)
    : 0.0;
  this->LookTime = now;
  if (!this->Thread)
  {
    try
    {
      this->Thread = std::make_unique<RegionReader>(this->Volume, this->Facts);
    }
    catch (const std::system_error& failure)
    {
      this->Trouble = "The system gives no thread to read from " + this->Volume->Name + ": " +
        failure.what() + ". End threads of this program, or raise its limits (ulimit -u).";
      return false;
    }
  }
  this->MeasureVelocity(tip, time);
  const bool hasCome = this->ReceiveRegion(tip, interval);
  this->Order(tip);
  return this->UpdateStandIn(tip) || hasCome;
}

} // namespace VolumeHaptics
