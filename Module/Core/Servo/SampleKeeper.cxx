// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Servo/SampleKeeper.h"

#include "Core/Field/WholeData.h"
#include "Core/Model/HapticModel.h"
#include "Core/Realtime/ServoClock.h"
#include "Core/Regions/Residency.h"
#include "Core/Servo/ModelExchange.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace VolumeHaptics
{
namespace
{

/** Time (ns) between two polls of the tip. */
constexpr std::int64_t TipPeriod = 5 * ServoClock::Millisecond;
/**
 * Margins (index steps along the axis with the smallest spacing), in the order in which they are
 * tried. The first one with few enough pages is used.
 */
constexpr int Margins[] = { 32, 24, 16, 12, 8, 6, 4, 3, 2, 1, 0 };
/**
 * Fractions of the reach that are tried for the box around the proxy if the full reach has too many
 * pages.
 */
constexpr double Fractions[] = { 1.0, 0.7, 0.5, 0.3, 0.2, 0.1, 0.0 };

/** Returns, for each index axis, the largest number of index steps for a vector of length 1. */
Vector3 StepsOf(const Affine3& toIndex) noexcept
{
  const Matrix3& m = toIndex.Linear;
  return { Norm(m.Row[0]), Norm(m.Row[1]), Norm(m.Row[2]) };
}

/** Returns the box of a view's samples between two indices, extended by a reach. */
SampleBox MakeBox(
  const VolumeView& view, const Vector3& low, const Vector3& high, const Vector3& reach) noexcept
{
  const Vector3 begin = low - reach;
  const Vector3 end = high + reach;
  const double first[3] = { begin.X, begin.Y, begin.Z };
  const double last[3] = { end.X, end.Y, end.Z };
  SampleBox box;
  for (int a = 0; a < 3; ++a)
  {
    const auto least = static_cast<double>(view.First[a]);
    const auto most = static_cast<double>(view.Last(a));
    box.First[a] = static_cast<std::int64_t>(std::clamp(std::floor(first[a]), least, most));
    box.Last[a] = static_cast<std::int64_t>(std::clamp(std::ceil(last[a]), least, most));
  }
  return box;
}

bool IsWithin(const SampleBox& box, const SampleBox& other) noexcept
{
  for (int a = 0; a < 3; ++a)
  {
    if (box.First[a] < other.First[a] || box.Last[a] > other.Last[a])
    {
      return false;
    }
  }
  return true;
}

} // namespace

bool CollectSamplePages(const VolumeView& view, const SampleBox& box, std::size_t pageSize,
  std::size_t most, std::vector<SamplePages>& pages)
{
  pages.clear();
  const auto data = reinterpret_cast<std::uintptr_t>(view.Data);
  const std::int64_t sampleSize = SizeOf(view.Type);
  const auto addressOf = [&](std::int64_t i, std::int64_t j, std::int64_t k)
  {
    return data +
      static_cast<std::uintptr_t>(sampleSize *
        ((i - view.First[0]) * view.Stride[0] + (j - view.First[1]) * view.Stride[1] +
          (k - view.First[2]) * view.Stride[2]));
  };
  std::size_t bytes = 0;
  for (std::int64_t k = box.First[2]; k <= box.Last[2]; ++k)
  {
    for (std::int64_t j = box.First[1]; j <= box.Last[1]; ++j)
    {
      const std::uintptr_t first = addressOf(box.First[0], j, k) / pageSize * pageSize;
      const std::uintptr_t last =
        addressOf(box.Last[0], j, k) + static_cast<std::uintptr_t>(sampleSize) - 1;
      const std::uintptr_t end = (last / pageSize + 1) * pageSize;
      const std::uintptr_t known = pages.empty() ? 0 : pages.back().End;
      const std::uintptr_t begin = std::max(first, known);
      if (begin >= end)
      {
        continue;
      }
      bytes += end - begin;
      if (bytes > most)
      {
        return false;
      }
      if (!pages.empty() && begin == known)
      {
        pages.back().End = end;
      }
      else
      {
        pages.push_back({ begin, end });
      }
    }
  }
  return true;
}

void SampleKeeper::Lock(const std::vector<SamplePages>& pages, Kept& kept)
{
  // Request all pages at once. If pages are read one by one, the kernel reads many unneeded pages
  // around each of them.
  for (const SamplePages& range : pages)
  {
    RequestPages(reinterpret_cast<const void*>(range.Begin), range.End - range.Begin);
  }
  for (const SamplePages& range : pages)
  {
    if (this->IsStopping())
    {
      return;
    }
    FetchPages(reinterpret_cast<const void*>(range.Begin), range.End - range.Begin);
  }
  const auto lock = [this, &pages]() -> std::unique_ptr<MemoryLock>
  {
    auto all = std::make_unique<MemoryLock>(true);
    const auto isLocked = [this, &all](const SamplePages& range)
    {
      return !this->IsStopping() &&
        all->Add(reinterpret_cast<const void*>(range.Begin), range.End - range.Begin);
    };
    return std::all_of(pages.begin(), pages.end(), isLocked) ? std::move(all) : nullptr;
  };
  // If both boxes fit into the limit, lock the new pages before the old ones are unlocked, so that
  // common pages stay locked.
  std::unique_ptr<MemoryLock> next = lock();
  if (!next && kept.Lock && !this->IsStopping())
  {
    kept.Lock.reset();
    next = lock();
  }
  kept.IsLocked = next != nullptr;
  kept.Lock = std::move(next);
}

void SampleKeeper::Keep(
  const VolumeView& view, const Affine3& deviceToIndex, const Vector3& reach, Kept& kept)
{
  if (kept.First != view.Data)
  {
    kept = {};
  }
  const Place& place = this->Places.Read();
  const Vector3 proxy = deviceToIndex(place.Proxy);
  const Vector3 tip = deviceToIndex(place.Tip);
  const Vector3 next = deviceToIndex(this->NextTip);
  const Vector3 low = Least(proxy, tip);
  const Vector3 high = Most(proxy, tip);
  const Vector3 nextLow = Least(low, next);
  const Vector3 nextHigh = Most(high, next);
  if (kept.First && IsWithin(MakeBox(view, nextLow, nextHigh, reach), kept.Enough))
  {
    return;
  }
  const Vector3 steps = StepsOf(deviceToIndex);
  const double mostSteps = std::max({ steps.X, steps.Y, steps.Z });
  std::vector<SamplePages> pages;
  const auto choose = [&](const Vector3& first, const Vector3& last, const Vector3& around)
  {
    return CollectSamplePages(
      view, MakeBox(view, first, last, around), GetPageSize(), MostBytes, pages);
  };
  const auto fits = [&](int margin)
  {
    const Vector3 around = (margin / mostSteps) * steps;
    kept.Enough = MakeBox(view, nextLow, nextHigh, reach + 0.5 * around);
    return choose(nextLow, nextHigh, reach + around);
  };
  if (!std::any_of(std::begin(Margins), std::end(Margins), fits) && !choose(low, high, reach))
  {
    for (const double fraction : Fractions)
    {
      if (choose(proxy, proxy, fraction * reach))
      {
        break;
      }
    }
  }
  kept.First = view.Data;
  this->Lock(pages, kept);
}

void SampleKeeper::Look()
{
  const HapticModel* const model = this->Models.Hold(ModelExchange::SampleKeeper);
  const bool isMoved = this->Places.Update();
  this->HasPlace = this->HasPlace || isMoved;
  const Place& place = this->Places.Read();
  if (!model || !model->Baked->Field.GetView().Data)
  {
    this->Scalars = {};
    this->Labels = {};
    this->LabelFractions = {};
  }
  else if (this->HasPlace && IsFinite(place.Tip) && IsFinite(place.Proxy))
  {
    const Vector3 next = place.Tip + (place.Tip - this->LastTip);
    this->NextTip = this->Scalars.First && IsFinite(next) ? next : place.Tip;
    this->LastTip = place.Tip;
    const Vector3 reach = ComputeReadReach(*model);
    this->Keep(model->Baked->Field.GetView(), model->DeviceToIndex, reach, this->Scalars);
    if (const BakedLabels* const labels = model->Baked->Labels.get())
    {
      const Vector3& steps = model->VoxelsPerMeter;
      const double length = std::max({ reach.X / steps.X, reach.Y / steps.Y, reach.Z / steps.Z });
      const Vector3 spare{ ResidencySpare, ResidencySpare, ResidencySpare };
      const Vector3 around = length * StepsOf(model->DeviceToLabel) + spare;
      this->Keep(labels->View.GetView(), model->DeviceToLabel, around, this->Labels);
      VolumeView fractions = labels->View.GetView();
      fractions.Type = ScalarType::UInt8;
      fractions.Data = labels->Fine ? labels->Fine->GetFractions() : nullptr;
      if (fractions.Data)
      {
        this->Keep(fractions, model->DeviceToLabel, around, this->LabelFractions);
      }
      else
      {
        this->LabelFractions = {};
      }
    }
    else
    {
      this->Labels = {};
      this->LabelFractions = {};
    }
    const auto isRefused = [](const Kept& kept) { return kept.First && !kept.IsLocked; };
    this->Refused.store(
      !this->Scalars.IsLocked || isRefused(this->Labels) || isRefused(this->LabelFractions),
      std::memory_order_relaxed);
    this->Looks.fetch_add(1, std::memory_order_release);
  }
}

void SampleKeeper::Run() noexcept
{
  ServoClock::BlockSignals();
  while (!this->IsStopping())
  {
    try
    {
      this->Look();
    }
    catch (...) // out of memory for the lists of pages
    {
      this->Refused.store(true, std::memory_order_relaxed);
    }
    this->Models.LetGo(ModelExchange::SampleKeeper);
    ServoClock::SleepUntil(ServoClock::Now() + TipPeriod);
  }
  this->Scalars = {};
  this->Labels = {};
  this->LabelFractions = {};
}

} // namespace VolumeHaptics
