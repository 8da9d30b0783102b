// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Device/DataPlayback.h"

#include "VTK/Baking/HapticPlacement.h"
#include "VTK/Base/HapticFiles.h"
#include "VTK/Device/Playback/HapticChangeTime.h"
#include "VTK/Device/Playback/StreamedWindow.h"
#include "VTK/Filter/FilterFrames.h"
#include "VTK/Filter/HapticBaker.h"
#include "VTK/Filter/HapticModelBuilder.h"

#include "vtkAlgorithmOutput.h"
#include "vtkDataArray.h"
#include "vtkExecutive.h"
#include "vtkHapticFrameSource.h"
#include "vtkHapticProperty.h"
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
  return this->Window && this->Session.IsRunning() && this->Session.GetState().Clock.IsWaiting;
}

std::string DataPlayback::Describe() const
{
  if (!this->IsWaiting())
  {
    return {};
  }
  const DataClockReport& report = this->Session.GetState().Clock;
  const Need need = this->Steps.FindNeed(report.Wanted, report.IsBackward, this->Orders.Mode);
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

bool DataPlayback::FindFelt(vtkVolumeHapticsFilter* filter) const
{
  if (this->IsMoving && filter && filter->GetNumberOfInputConnections(0) > 0)
  {
    filter->GetInputAlgorithm(0, 0)->UpdateInformation();
    filter->GetBaker().WarnOfStillSteps();
  }
  return this->IsFelt(filter);
}

HapticFrame DataPlayback::GetShown(vtkVolumeHapticsFilter* filter) const
{
  if (!this->Window || !this->HasTime)
  {
    return { this->Time, nullptr, nullptr, nullptr };
  }
  const std::size_t nearest = this->Window->FindNearestFrame(this->Time);
  const FieldFrame& frame = this->Window->Frames[nearest];
  // See ShareArray() of the model's builder.
  auto* const array = static_cast<vtkDataArray*>(const_cast<void*>(frame.Samples.get()));
  const int component = this->Steps.AreComponents
    ? static_cast<int>(nearest % this->Steps.Times.size())
    : filter->GetProperty()->GetComponent();
  return { frame.Time, nullptr, array, nullptr, component };
}

bool DataPlayback::Has(std::size_t step) const
{
  const std::size_t offset =
    (step + this->Steps.Times.size() - this->First) % this->Steps.Times.size();
  return offset < this->Window->Frames.size();
}

FramePlace DataPlayback::FindPlace(vtkVolumeHapticsFilter* filter) const
{
  const bool isKnown = this->HasTime || this->Orders.Places > 0;
  const bool isBackward = this->Speed * filter->GetTimeUnitsPerSecond() < 0.0;
  return { isKnown ? std::optional(this->GetTime()) : std::nullopt, isBackward, this->Orders.Mode };
}

bool DataPlayback::Read(vtkVolumeHapticsFilter* filter, std::size_t step, VolumeFrame& frame)
{
  std::string error;
  try
  {
    HapticFrame read;
    if (!ReadFrame(filter, this->Steps.Times[step], filter->GetBaker().GetReading(), read))
    {
      error = "A time step of the image on input port 0 can't be read: see the errors of its "
              "source. SetTimeUnitsPerSecond(0) takes one time step alone.";
    }
    else
    {
      const FieldFrame& like = this->Window->Frames.front();
      const FrameShape shape{ like.Field.GetView(), this->Window->IndexToWorld,
        this->Window->Series, filter->GetKernelRadius(), filter->GetDisplacementArrayName(),
        filter->GetBaker().GetOutside() };
      MakeVolumeFrame(read, shape, frame, error);
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
  if (isCurrent && this->Window && rate == this->Rate &&
    (!deviceToWorld || ReadSimilarity(deviceToWorld, placement, error)))
  {
    return std::make_shared<const HapticModel>(this->Window, placement, caps);
  }
  const std::shared_ptr<const BakedVolume> last =
    this->IsStreamed(filter, rate) ? this->Window : nullptr;
  const BakedVolume* const kept = this->FindKept(filter);
  const std::shared_ptr<const BakedVolume> old = std::exchange(this->Window, nullptr);
  if (old)
  {
    this->Past.Note(old);
  }
  this->Failed = None;
  this->Meshless.clear();
  this->Mesher.End();
  ReadFrames window = this->Preparation.Take(filter, this->FindPlace(filter), kept);
  const TimeSteps before = std::exchange(this->Steps, std::move(window.Steps));
  this->First = window.First;
  if (!window.AreRead)
  {
    return nullptr;
  }
  std::vector<HapticFrame>& read = window.Frames;
  if (read.empty())
  {
    return filter->GetBaker().Bake(rate, caps, deviceToWorld);
  }
  this->Rate = rate;
  this->MadeOf = FindOrigin(filter);
  this->Window = last
    ? GoOnWithFrames(*last, read, MakeSeries(this->Steps.Times), filter->GetKernelRadius(),
        filter->GetDisplacementArrayName(), filter->GetBaker().GetOutside())
    : nullptr;
  if (this->Window && (!deviceToWorld || ReadSimilarity(deviceToWorld, placement, error)))
  {
    this->GoOnFrom(*last, before.Times);
    this->WarnOfFastMotion(filter);
    return std::make_shared<const HapticModel>(this->Window, placement, caps);
  }
  auto model =
    filter->GetBaker().BakeFrames(rate, caps, deviceToWorld, std::move(read), this->Steps.Times);
  this->Window = model ? model->Baked : nullptr;
  // Read after the bake, because the first bake creates what the property lacks.
  this->MadeBeside = FindChangeTimeBesideImage(filter);
  if (this->Window)
  {
    this->WarnOfFastMotion(filter);
  }
  return model;
}

/** Returns the window if a new window of the filter can keep its samples; null if it can't. */
const BakedVolume* DataPlayback::FindKept(vtkVolumeHapticsFilter* filter) const
{
  return !this->Steps.AreComponents && this->MadeOf == FindOrigin(filter) ? this->Window.get()
                                                                          : nullptr;
}

/**
 * Whether a new window would need a time step that the last window lacks: Follow() has to read that
 * step first, when the memory of another step is free.
 */
bool DataPlayback::LacksPair(vtkVolumeHapticsFilter* filter) const
{
  const TickCollector* const ticks = this->Session.GetTicks();
  const HapticModel* const felt = ticks ? ticks->GetLatestModel() : nullptr;
  if (!this->Session.IsRunning() || !this->HasTime || !felt || felt->Baked != this->Window ||
    !this->FindKept(filter) || this->Steps.AreWindow() || this->Failed != None)
  {
    return false;
  }
  const FramePlace place = this->FindPlace(filter);
  const Need need = this->Steps.FindNeed(*place.Time, place.IsBackward, place.Mode);
  return !this->Has(need.First) || !this->Has(this->Steps.After(need.First));
}

/** Joins the window to the last frames if frames of a stream were left out in between. */
void DataPlayback::GoOnFrom(const BakedVolume& last, const std::vector<double>& times)
{
  const bool isFelt = this->Session.IsRunning() && this->HasTime;
  auto joined = isFelt && !GoesOnWith(times, this->Steps.Times, this->Time)
    ? JoinWindows(last, *this->Window, this->Time)
    : nullptr;
  if (joined)
  {
    this->Window = std::move(joined);
    this->Steps.Times.clear();
    for (std::size_t i = 0; i + 1 < this->Window->Frames.size(); ++i)
    {
      this->Steps.Times.push_back(this->Window->Frames[i].Time);
    }
  }
}

void DataPlayback::WarnOfFastMotion(vtkVolumeHapticsFilter* filter) const
{
  filter->GetBaker().WarnOfFastMotion(*this->Window, this->Orders.Mode == Playback::Loop);
}

bool DataPlayback::Prepare(vtkVolumeHapticsFilter* filter, double rate, bool isCurrent)
{
  const bool isMade = isCurrent && this->Window && rate == this->Rate;
  const bool isStreamed = !isMade && this->Window && this->IsStreamed(filter, rate);
  // The frames of a stream are played to their end before the next frames replace them.
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
  const bool isPrepared = this->Preparation.Follow(filter, this->FindPlace(filter),
    isStreamed ? this->Window.get() : nullptr, this->FindKept(filter));
  return isPrepared && isReady(this->Preparation.GetTimes());
}

/** Whether time is still moving towards the end of the steps. */
bool DataPlayback::IsOnItsWay() const
{
  const bool isBackward = this->Session.GetState().Clock.IsBackward;
  const double end = isBackward ? this->Steps.Times.front() : this->Steps.Times.back();
  return this->Session.IsRunning() && this->Orders.Plays && this->Orders.Rate != 0.0 &&
    this->Orders.Mode == Playback::Once && this->Time != end;
}

/** Whether the frames may continue the volume that was baked last. */
bool DataPlayback::IsStreamed(vtkVolumeHapticsFilter* filter, double rate) const
{
  auto* const source = vtkHapticFrameSource::SafeDownCast(filter->GetInputAlgorithm(0, 0));
  return source && source->GetStreamed() && rate == this->Rate &&
    filter->GetFrames() == vtkVolumeHapticsFilter::TIME_STEPS &&
    this->MadeBeside == FindChangeTimeBesideImage(filter);
}

/** Returns frames of the window by their step's number in the series. */
std::vector<VolumeFrame> DataPlayback::Keep(std::size_t first, std::size_t count)
{
  std::vector<VolumeFrame> frames;
  for (std::size_t i = 0; i < count; ++i)
  {
    const std::size_t step = (first + i) % this->Steps.Times.size();
    const std::size_t offset =
      (step + this->Steps.Times.size() - this->First) % this->Steps.Times.size();
    frames.push_back(KeepFrame(*this->Window, offset));
  }
  return frames;
}

std::shared_ptr<const HapticModel> DataPlayback::Show(
  std::size_t first, std::vector<VolumeFrame>&& frames)
{
  const HapticModel* const last = this->Session.GetTicks()->GetLatestModel();
  this->Past.Note(this->Window);
  this->Window = std::make_shared<const BakedVolume>(*this->Window, frames, this->Window->Series);
  this->First = first;
  return std::make_shared<const HapticModel>(
    this->Window, last->DeviceToWorld, this->Session.FindCaps(this->Session.GetRate()));
}

std::shared_ptr<const HapticModel> DataPlayback::Follow(vtkVolumeHapticsFilter* filter)
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
  if (!report.IsMoving || !this->Window || felt->Baked != this->Window)
  {
    return nullptr;
  }
  this->Time = state.Record.DataTime;
  this->HasTime = true;
  if (this->Steps.AreWindow() || this->Preparation.IsBegun())
  {
    return nullptr;
  }
  if (!this->Meshless.empty())
  {
    return this->ShowMeshed(filter, this->MeshlessFirst, std::exchange(this->Meshless, {}));
  }
  const double wanted = report.IsWaiting ? report.Wanted : this->Time;
  const Need need = this->Steps.FindNeed(wanted, report.IsBackward, this->Orders.Mode);
  const std::size_t second = this->Steps.After(need.First);
  const bool hasPair = this->Has(need.First) && this->Has(second);
  const std::size_t begin = need.Next == this->Steps.Before(need.First) ? need.Next : need.First;
  if (this->Window->Frames.size() > 2)
  {
    if (hasPair && this->First == begin)
    {
      return nullptr;
    }
    // The pair of steps around the present time; a third frame comes only when its memory is free.
    const Need now = this->Steps.FindNeed(this->Time, report.IsBackward, this->Orders.Mode);
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
  VolumeFrame frame;
  if (hasPair)
  {
    if (!isGood(need.Next) || !this->Read(filter, need.Next, frame))
    {
      return nullptr;
    }
    std::vector<VolumeFrame> frames = this->Keep(need.First, 2);
    frames.insert(begin == need.First ? frames.end() : frames.begin(), frame);
    return this->ShowMeshed(filter, begin, std::move(frames));
  }
  const std::vector<std::size_t> steps = this->ChooseSteps(need, wanted);
  std::vector<VolumeFrame> frames;
  for (const std::size_t step : steps)
  {
    if (this->Has(step))
    {
      frames.push_back(this->Keep(step, 1).front());
    }
    else if (isGood(step) && this->Read(filter, step, frame))
    {
      frames.push_back(frame);
    }
    else
    {
      return nullptr;
    }
  }
  return this->ShowMeshed(filter, steps.front(), std::move(frames));
}

/**
 * Chooses the pair of steps that time needs. If the felt pair shares no step with it, chooses one
 * step only: the felt pair, which the servo needs until then, is released before the other step is
 * read.
 */
std::vector<std::size_t> DataPlayback::ChooseSteps(const Need& need, double time) const
{
  const std::size_t second = this->Steps.After(need.First);
  if (this->Window->Frames.size() < 2 || this->Has(need.First) || this->Has(second))
  {
    return { need.First, second };
  }
  // A mesh describes the way to the next step: it stays valid at the step itself.
  const std::vector<double>& times = this->Steps.Times;
  const bool isSecondNearer =
    std::abs(times[second] - time) < std::abs(times[need.First] - time) && !this->Window->Mesh;
  return { isSecondNearer ? second : need.First };
}

/** Returns the window, or null until it has its meshes. */
std::shared_ptr<const HapticModel> DataPlayback::ShowMeshed(
  vtkVolumeHapticsFilter* filter, std::size_t first, std::vector<VolumeFrame>&& frames)
{
  const std::vector<int> components(frames.size(), filter->GetProperty()->GetComponent());
  if (!this->Window->Mesh ||
    this->Mesher.Follow(
      frames, components, this->Window->Settings.IsoValue, this->Window->IndexToWorld))
  {
    auto model = this->Show(first, std::move(frames));
    this->WarnOfFastMotion(filter);
    return model;
  }
  this->Meshless = std::move(frames);
  this->MeshlessFirst = first;
  return nullptr;
}

} // namespace VolumeHaptics
