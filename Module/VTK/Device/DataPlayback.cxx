// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/DataPlayback.h"

#include "Core/Platform/HapticFiles.h"
#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Device/Playback/HapticChangeTime.h"
#include "VTK/Device/Playback/StreamedTimeSpan.h"
#include "VTK/Filter/FilterTimeSteps.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/HapticModelBuilder.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkHapticProperty.h"
#include "vtkHapticTimeStepSource.h"
#include "vtkInformation.h"
#include "vtkMatrix4x4.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <new>
#include <sstream>
#include <utility>

namespace VolumeHaptics
{
namespace
{

bool HasTimeSteps(vtkVolumeHapticsFilter* filter)
{
  using Pipeline = vtkStreamingDemandDrivenPipeline;
  vtkInformation* const input =
    filter->GetNumberOfInputConnections(0) > 0 ? filter->GetInputInformation(0, 0) : nullptr;
  return input && input->Has(Pipeline::TIME_STEPS()) && input->Length(Pipeline::TIME_STEPS()) > 1;
}

} // namespace

void DataPlayback::SetPlays(bool on)
{
  this->Orders.Plays = on;
  this->IsMoving = this->IsMoving || on;
  this->Send();
}

void DataPlayback::SetMode(Playback mode)
{
  this->Orders.Mode = mode;
  this->Send();
}

void DataPlayback::SetTime(double time)
{
  this->Orders.Place = time;
  ++this->Orders.Places;
  this->IsMoving = true;
  this->Send();
}

void DataPlayback::Begin()
{
  if (this->HasTime)
  {
    this->Orders.Place = this->GetTime();
    ++this->Orders.Places;
  }
  this->Send();
}

void DataPlayback::Send()
{
  if (ServoLoop* const loop = this->Session.GetLoop())
  {
    loop->SetDataClock(this->Orders);
    this->Sent = this->Orders;
  }
}

bool DataPlayback::IsAtPlace() const
{
  const DataClockReport& report = this->Session.GetState().Clock;
  const bool isPending =
    report.Places != this->Orders.Places || (report.IsWaiting && report.Wanted != this->Time);
  return this->Orders.Places == 0 || !(isPending || !this->HasTime);
}

double DataPlayback::GetTime() const
{
  return this->IsAtPlace() ? this->Time : this->Orders.Place;
}

bool DataPlayback::IsWaiting() const
{
  return this->Span && this->Session.IsRunning() && this->Session.GetState().Clock.IsWaiting;
}

std::string DataPlayback::Describe() const
{
  if (!this->IsWaiting())
  {
    return {};
  }
  const DataClockReport& report = this->Session.GetState().Clock;
  const Need need = this->Steps.ComputeNeed(report.Wanted, report.IsBackward, this->Orders.Mode);
  const std::size_t missing = this->Has(need.First) ? this->Steps.After(need.First) : need.First;
  std::ostringstream text;
  text << "The volume is waiting for the frame at data time " << this->Steps.Times[missing]
       << (missing == this->Failed ? ", which can't be read: see the errors." : ".");
  return text.str();
}

bool DataPlayback::IsFelt(vtkVolumeHapticsFilter* filter) const
{
  if (!this->IsMoving || !filter || filter->GetTimeUnitsPerSecond() == 0.0)
  {
    return false;
  }
  return filter->GetFrames() == vtkVolumeHapticsFilter::COMPONENTS ||
    (HasTimeSteps(filter) && !filter->GetBaker().IsResampled());
}

bool DataPlayback::DetectFelt(vtkVolumeHapticsFilter* filter) const
{
  if (this->IsMoving && filter && filter->GetNumberOfInputConnections(0) > 0)
  {
    filter->GetInputAlgorithm(0, 0)->UpdateInformation();
    filter->GetBaker().WarnOfStillSteps();
  }
  return this->IsFelt(filter);
}

ImageTimeStep DataPlayback::GetShown(vtkVolumeHapticsFilter* filter) const
{
  if (!this->Span || !this->HasTime)
  {
    return { this->Time, nullptr, nullptr, nullptr };
  }
  const std::size_t nearest = this->Span->FindNearestTimeStep(this->Time);
  const FieldTimeStep& timeStep = this->Span->TimeSteps[nearest];
  // Samples owns its vtkDataArray: see ShareArray() of the model's builder.
  auto* const array = static_cast<vtkDataArray*>(const_cast<void*>(timeStep.Samples.get()));
  const int component = this->Steps.AreComponents
    ? static_cast<int>(nearest % this->Steps.Times.size())
    : filter->GetProperty()->GetComponent();
  return { timeStep.Time, nullptr, array, nullptr, component };
}

bool DataPlayback::Has(std::size_t step) const
{
  const std::size_t offset =
    (step + this->Steps.Times.size() - this->First) % this->Steps.Times.size();
  return offset < this->Span->TimeSteps.size();
}

TimeStepPlace DataPlayback::ComputePlace(vtkVolumeHapticsFilter* filter) const
{
  const bool isKnown = this->HasTime || this->Orders.Places > 0;
  const bool isBackward = this->Speed * filter->GetTimeUnitsPerSecond() < 0.0;
  return { isKnown ? std::optional(this->GetTime()) : std::nullopt, isBackward, this->Orders.Mode };
}

bool DataPlayback::Read(vtkVolumeHapticsFilter* filter, std::size_t step, VolumeTimeStep& timeStep)
{
  std::string error;
  try
  {
    ImageTimeStep read;
    if (!ReadTimeStep(filter, this->Steps.Times[step], filter->GetBaker().GetReading(), read))
    {
      error = "A time step of the image on input port 0 can't be read: see the errors of its "
              "source. SetTimeUnitsPerSecond(0) takes one time step alone.";
    }
    else
    {
      const FieldTimeStep& like = this->Span->TimeSteps.front();
      const TimeStepShape shape{ like.Field.GetView(), this->Span->IndexToWorld, this->Span->Series,
        filter->GetKernelRadius(), filter->GetDisplacementArrayName(),
        filter->GetBaker().GetOutside() };
      MakeVolumeTimeStep(read, shape, timeStep, error);
    }
  }
  catch (const std::bad_alloc&)
  {
    error = "There is not enough memory for a time step of the image on input port 0: three of "
            "them are needed. Use a smaller image, or stop time with SetTimeUnitsPerSecond(0).";
  }
  if (!error.empty())
  {
    this->Failed = step;
    vtkErrorWithObjectMacro(filter, << Printable(error));
    return false;
  }
  return true;
}

std::shared_ptr<const HapticModel> DataPlayback::Make(vtkVolumeHapticsFilter* filter, double rate,
  const ForceCaps& caps, vtkMatrix4x4* deviceToWorld, bool isCurrent)
{
  std::string error;
  Affine3 placement = ScaledPlacement(filter->GetMetersPerWorldUnit());
  if (isCurrent && this->Span && rate == this->Rate &&
    (!deviceToWorld || ReadSimilarity(deviceToWorld, placement, error)))
  {
    return std::make_shared<const HapticModel>(this->Span, placement, caps);
  }
  const std::shared_ptr<const BakedVolume> last =
    this->IsStreamed(filter, rate) ? this->Span : nullptr;
  const BakedVolume* const kept = this->GetKept(filter);
  const std::shared_ptr<const BakedVolume> old = std::exchange(this->Span, nullptr);
  if (old)
  {
    this->Past.Record(old);
  }
  this->Failed = None;
  this->Meshless.clear();
  this->Mesher.End();
  PreparedTimeSpan span = this->Preparation.Drain(filter, this->ComputePlace(filter), kept);
  const TimeSteps before = std::exchange(this->Steps, std::move(span.Steps));
  this->First = span.First;
  if (!span.AreRead)
  {
    return nullptr;
  }
  std::vector<ImageTimeStep>& read = span.Images;
  if (read.empty())
  {
    return filter->GetBaker().Bake(rate, caps, deviceToWorld);
  }
  this->Rate = rate;
  this->MadeOf = GetTimeStepOrigin(filter);
  this->Span = last
    ? GoOnWithTimeSteps(*last, read, MakeSeries(this->Steps.Times), filter->GetKernelRadius(),
        filter->GetDisplacementArrayName(), filter->GetBaker().GetOutside())
    : nullptr;
  if (this->Span && (!deviceToWorld || ReadSimilarity(deviceToWorld, placement, error)))
  {
    this->GoOnFrom(*last, before.Times);
    this->WarnOfFastMotion(filter);
    return std::make_shared<const HapticModel>(this->Span, placement, caps);
  }
  auto model =
    filter->GetBaker().BakeTimeSteps(rate, caps, deviceToWorld, std::move(read), this->Steps.Times);
  this->Span = model ? model->Baked : nullptr;
  // Read the time after the bake, because the first bake creates the property's missing functions.
  this->MadeBeside = ComputeChangeTimeBesideImage(filter);
  if (this->Span)
  {
    this->WarnOfFastMotion(filter);
  }
  return model;
}

/**
 * Returns the current time span if the filter's next time span can reuse its samples; null
 * otherwise.
 */
const BakedVolume* DataPlayback::GetKept(vtkVolumeHapticsFilter* filter) const
{
  return !this->Steps.AreComponents && this->MadeOf == GetTimeStepOrigin(filter) ? this->Span.get()
                                                                                 : nullptr;
}

/**
 * Returns whether a new time span needs a time step that the last one lacks. Poll() then has to
 * read that step first, once the memory of another step is free.
 */
bool DataPlayback::LacksPair(vtkVolumeHapticsFilter* filter) const
{
  const TickCollector* const ticks = this->Session.GetTicks();
  const HapticModel* const felt = ticks ? ticks->GetLatestModel() : nullptr;
  if (!this->Session.IsRunning() || !this->HasTime || !felt || felt->Baked != this->Span ||
    !this->GetKept(filter) || this->Steps.AreAllAtOnce() || this->Failed != None)
  {
    return false;
  }
  const TimeStepPlace place = this->ComputePlace(filter);
  const Need need = this->Steps.ComputeNeed(*place.Time, place.IsBackward, place.Mode);
  return !this->Has(need.First) || !this->Has(this->Steps.After(need.First));
}

/** Connects the time span to the last time steps if a stream skipped time steps in between. */
void DataPlayback::GoOnFrom(const BakedVolume& last, const std::vector<double>& times)
{
  const bool isFelt = this->Session.IsRunning() && this->HasTime;
  auto joined = isFelt && !GoesOnWith(times, this->Steps.Times, this->Time)
    ? JoinTimeSpans(last, *this->Span, this->Time)
    : nullptr;
  if (joined)
  {
    this->Span = std::move(joined);
    this->Steps.Times.clear();
    for (std::size_t i = 0; i + 1 < this->Span->TimeSteps.size(); ++i)
    {
      this->Steps.Times.push_back(this->Span->TimeSteps[i].Time);
    }
  }
}

void DataPlayback::WarnOfFastMotion(vtkVolumeHapticsFilter* filter) const
{
  filter->GetBaker().WarnOfFastMotion(*this->Span, this->Orders.Mode == Playback::Loop);
}

bool DataPlayback::Prepare(vtkVolumeHapticsFilter* filter, double rate, bool isCurrent)
{
  const bool isMade = isCurrent && this->Span && rate == this->Rate;
  const bool isStreamed = !isMade && this->Span && this->IsStreamed(filter, rate);
  // Play the time steps of a stream to their end before the next time steps replace them.
  const auto isReady = [&](const std::vector<double>& times)
  {
    return !isStreamed || !this->IsOnItsWay() || times.size() < 2 ||
      GoesOnWith(this->Steps.Times, times, this->Time);
  };
  if (!isMade && this->LacksPair(filter))
  {
    this->EndPreparing();
    return false;
  }
  if (filter->GetMethod() != vtkVolumeHapticsFilter::SURFACE_PROXY || isMade)
  {
    this->EndPreparing();
    return isReady(ReadTimeSteps(filter->GetInputInformation(0, 0)));
  }
  const bool isPrepared = this->Preparation.Poll(filter, this->ComputePlace(filter),
    isStreamed ? this->Span.get() : nullptr, this->GetKept(filter));
  return isPrepared && isReady(this->Preparation.GetTimes());
}

/** Returns whether playback has not yet reached the end of the time steps. */
bool DataPlayback::IsOnItsWay() const
{
  const bool isBackward = this->Session.GetState().Clock.IsBackward;
  const double end = isBackward ? this->Steps.Times.front() : this->Steps.Times.back();
  return this->Session.IsRunning() && this->Orders.Plays && this->Orders.Rate != 0.0 &&
    this->Orders.Mode == Playback::Once && this->Time != end;
}

/** Returns whether the filter's time steps may continue the volume that was baked last. */
bool DataPlayback::IsStreamed(vtkVolumeHapticsFilter* filter, double rate) const
{
  auto* const source = vtkHapticTimeStepSource::SafeDownCast(filter->GetInputAlgorithm(0, 0));
  return source && source->GetStreamed() && rate == this->Rate &&
    filter->GetFrames() == vtkVolumeHapticsFilter::TIME_STEPS &&
    this->MadeBeside == ComputeChangeTimeBesideImage(filter);
}

/**
 * Returns `count` time steps of the time span, starting at index `first` of the series. The series
 * is cyclic.
 */
std::vector<VolumeTimeStep> DataPlayback::Keep(std::size_t first, std::size_t count)
{
  std::vector<VolumeTimeStep> timeSteps;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t step = (first + i) % this->Steps.Times.size();
    const std::size_t offset =
      (step + this->Steps.Times.size() - this->First) % this->Steps.Times.size();
    timeSteps.push_back(KeepTimeStep(*this->Span, offset));
  }
  return timeSteps;
}

std::shared_ptr<const HapticModel> DataPlayback::Show(
  std::size_t first, std::vector<VolumeTimeStep>&& timeSteps)
{
  const HapticModel* const last = this->Session.GetTicks()->GetLatestModel();
  this->Past.Record(this->Span);
  this->Span = std::make_shared<const BakedVolume>(*this->Span, timeSteps, this->Span->Series);
  this->First = first;
  return std::make_shared<const HapticModel>(
    this->Span, last->DeviceToWorld, this->Session.ComputeCaps(this->Session.GetRate()));
}

std::shared_ptr<const HapticModel> DataPlayback::Poll(vtkVolumeHapticsFilter* filter)
{
  const TickCollector* const ticks = this->Session.GetTicks();
  const HapticModel* const felt = ticks ? ticks->GetLatestModel() : nullptr;
  if (!felt || !filter)
  {
    return nullptr;
  }
  this->Orders.Rate = this->Speed * filter->GetTimeUnitsPerSecond();
  if (this->Orders.Rate != this->Sent.Rate)
  {
    this->Send();
  }
  const ServoSnapshot& state = this->Session.GetState();
  const DataClockReport& report = state.Clock;
  if (!report.IsMoving || !this->Span || felt->Baked != this->Span)
  {
    return nullptr;
  }
  this->Time = state.Record.DataTime;
  this->HasTime = true;
  if (this->Steps.AreAllAtOnce() || this->Preparation.IsBegun())
  {
    return nullptr;
  }
  if (!this->Meshless.empty())
  {
    return this->ShowMeshed(filter, this->MeshlessFirst, std::exchange(this->Meshless, {}));
  }
  const double wanted = report.IsWaiting ? report.Wanted : this->Time;
  const Need need = this->Steps.ComputeNeed(wanted, report.IsBackward, this->Orders.Mode);
  const std::size_t second = this->Steps.After(need.First);
  const bool hasPair = this->Has(need.First) && this->Has(second);
  const std::size_t begin = need.Next == this->Steps.Before(need.First) ? need.Next : need.First;
  if (this->Span->TimeSteps.size() > 2)
  {
    if (hasPair && this->First == begin)
    {
      return nullptr;
    }
    // Read the pair of steps around the present time. Read a third time step only when its memory
    // is free.
    const Need now = this->Steps.ComputeNeed(this->Time, report.IsBackward, this->Orders.Mode);
    const bool isThere = this->Has(now.First) && this->Has(this->Steps.After(now.First));
    const std::size_t first = isThere ? now.First
      : report.IsBackward             ? this->First
                                      : this->Steps.After(this->First);
    return this->Show(first, this->Keep(first, 2));
  }
  const auto isGood = [this](std::size_t step) { return step != this->Failed; };
  if (!this->Past.AreGone() || !this->Mesher.IsIdle() || !this->Preparation.IsIdle())
  {
    return nullptr;
  }
  VolumeTimeStep timeStep;
  if (hasPair)
  {
    if (!isGood(need.Next) || !this->Read(filter, need.Next, timeStep))
    {
      return nullptr;
    }
    std::vector<VolumeTimeStep> timeSteps = this->Keep(need.First, 2);
    timeSteps.insert(begin == need.First ? timeSteps.end() : timeSteps.begin(), timeStep);
    return this->ShowMeshed(filter, begin, std::move(timeSteps));
  }
  const std::vector<std::size_t> steps = this->ChooseSteps(need, wanted);
  std::vector<VolumeTimeStep> timeSteps;
  for (const std::size_t step : steps)
  {
    if (this->Has(step))
    {
      timeSteps.push_back(this->Keep(step, 1).front());
    }
    else if (isGood(step) && this->Read(filter, step, timeStep))
    {
      timeSteps.push_back(timeStep);
    }
    else
    {
      return nullptr;
    }
  }
  return this->ShowMeshed(filter, steps.front(), std::move(timeSteps));
}

/**
 * Chooses the pair of steps around `time`. If the felt pair has no step in common with that pair,
 * chooses only one step, so that the felt pair can be released before the second step is read.
 */
std::vector<std::size_t> DataPlayback::ChooseSteps(const Need& need, double time) const
{
  const std::size_t second = this->Steps.After(need.First);
  if (this->Span->TimeSteps.size() < 2 || this->Has(need.First) || this->Has(second))
  {
    return { need.First, second };
  }
  // With meshes, choose the first step: its mesh describes the motion to the next step, and is
  // valid at the first step alone.
  const std::vector<double>& times = this->Steps.Times;
  const bool isSecondNearer =
    std::abs(times[second] - time) < std::abs(times[need.First] - time) && !this->Span->Mesh;
  return { isSecondNearer ? second : need.First };
}

/** Returns the model of the time span; null while its meshes are being made. */
std::shared_ptr<const HapticModel> DataPlayback::ShowMeshed(
  vtkVolumeHapticsFilter* filter, std::size_t first, std::vector<VolumeTimeStep>&& timeSteps)
{
  const std::vector<int> components(timeSteps.size(), filter->GetProperty()->GetComponent());
  if (!this->Span->Mesh ||
    this->Mesher.Poll(
      timeSteps, components, this->Span->Settings.IsoValue, this->Span->IndexToWorld))
  {
    auto model = this->Show(first, std::move(timeSteps));
    this->WarnOfFastMotion(filter);
    return model;
  }
  this->Meshless = std::move(timeSteps);
  this->MeshlessFirst = first;
  return nullptr;
}

} // namespace VolumeHaptics
