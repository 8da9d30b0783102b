// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Frames/FrameQuality.h"

#include "VTK/Base/HapticVolume.h"
#include "VTK/Scene/Base/SmartMapperParts.h"
#include "VTK/Scene/Base/WindowVolumes.h"
#include "VTK/Scene/Frames/KeptRays.h"
#include "VTK/Scene/Frames/PendingInput.h"
#include "VTK/Scene/Frames/SoftwareOpenGL.h"

#include "vtkCallbackCommand.h"
#include "vtkDataArray.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkRenderWindow.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkRenderer.h"
#include "vtkSmartVolumeMapper.h"
#include "vtkVolume.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace VolumeHaptics
{
namespace
{

// Hz: a window that requests at least this rate is in motion; VTK's rate for still frames is far
// lower.
constexpr double SlowestMotion = 1.0;
constexpr double LeastRate = 20.0; // Hz: lowest acceptable rate in motion
// Hz: target rate. It exceeds LeastRate, because input may wait for the end of one frame and then
// for a whole frame.
constexpr double AimedRate = 26.0;
// Fraction of the time between frames that drawing may take; the rest is for events and haptics.
constexpr double DrawingFraction = 0.8;
constexpr double LongestStillFrame = 0.1; // s: limit for a frame at rest that can't be interrupted
// s: limit for any frame at rest while armed, because the force fades if the device is not read.
constexpr double LongestRest = 0.5;
constexpr double LongestTry = 1.0; // s: a frame at rest is abandoned if it takes longer
// Steps assumed for a mapper on the processor before its first frame.
constexpr double UnknownSteps = 4.0;
// Number of consecutive slow frames after which rays become coarser; a busy processor may delay one
// or two.
constexpr int MostSlowFrames = 3;

/** Returns the sample distance that vtkGPUVolumeRayCastMapper chooses at rest. */
double AutomaticDistance(vtkImageData* image)
{
  const double* const spacing = image->GetSpacing();
  return (spacing[0] + spacing[1] + spacing[2]) / 6.0;
}

} // namespace

//------------------------------------------------------------------------------
FrameQuality::FrameQuality(std::function<Touch()> touch)
  : AskTouch(std::move(touch))
  , Observer(vtkSmartPointer<vtkCallbackCommand>::New())
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject* caller, unsigned long event, void* self, void* data)
    {
      auto* const quality = static_cast<FrameQuality*>(self);
      switch (event)
      {
        case vtkCommand::StartEvent:
          quality->Begin();
          break;
        case vtkCommand::EndEvent:
          quality->End();
          break;
        case vtkCommand::ConfigureEvent:
        case vtkCommand::ExposeEvent:
          quality->IsExposed = true;
          break;
        case vtkCommand::VolumeMapperRenderStartEvent:
          quality->RecordProgress(caller, 0.0);
          break;
        case vtkCommand::VolumeMapperRenderProgressEvent:
          quality->RecordProgress(caller, data ? *static_cast<double*>(data) : 0.0);
          [[fallthrough]];
        default:
          quality->Interrupt();
      }
    });
}

//------------------------------------------------------------------------------
FrameQuality::~FrameQuality()
{
  this->SetWindow(nullptr);
}

//------------------------------------------------------------------------------
void FrameQuality::SetWindow(vtkRenderWindow* window, bool offScreen)
{
  if (window == this->Window && offScreen == this->OffScreen)
  {
    return;
  }
  this->OffScreen = offScreen;
  if (this->Window)
  {
    this->Window->RemoveObserver(this->Observer);
  }
  if (this->Interactor)
  {
    this->Interactor->RemoveObserver(this->Observer);
  }
  this->Restore();
  this->Window = window;
  this->InMotion = RayPace();
  this->AtRest = RayPace();
  this->CoarseTime = 0.0;
  this->DrawnSize = {};
  this->OnProcessor.reset();
  this->Interactor = window ? window->GetInteractor() : nullptr;
  if (this->Interactor)
  {
    // Observe these events, because they arrive before the interactor draws.
    this->Interactor->AddObserver(vtkCommand::ConfigureEvent, this->Observer);
    this->Interactor->AddObserver(vtkCommand::ExposeEvent, this->Observer);
  }
  if (window)
  {
    window->AddObserver(vtkCommand::StartEvent, this->Observer);
    window->AddObserver(vtkCommand::EndEvent, this->Observer);
    window->AddObserver(vtkCommand::AbortCheckEvent, this->Observer);
  }
}

//------------------------------------------------------------------------------
vtkRenderWindow* FrameQuality::GetWindow() const
{
  vtkRenderWindow* const window = this->Window;
  return window && (this->OffScreen || !window->GetOffScreenRendering()) ? window : nullptr;
}

//------------------------------------------------------------------------------
FrameQuality::Interruption FrameQuality::DrainInterruption()
{
  return std::exchange(this->Interrupted, Interruption::None);
}

//------------------------------------------------------------------------------
template <typename Mapper>
void FrameQuality::Adjust(Mapper* mapper, const Shown& shown)
{
  const bool moves = this->Moves;
  auto* const image = vtkImageData::SafeDownCast(shown.Volume->GetMapper()->GetDataSetInput());
  if (!image)
  {
    return;
  }
  const Settings now{ mapper->GetImageSampleDistance(), mapper->GetSampleDistance(),
    mapper->GetAutoAdjustSampleDistances() != 0 };
  const auto isMapper = [mapper](const Caster& caster) { return caster.Mapper == mapper; };
  auto caster = std::find_if(this->Casters.begin(), this->Casters.end(), isMapper);
  if (caster == this->Casters.end())
  {
    caster = this->Casters.insert(caster, { mapper, now, now, nullptr, {}, 0 });
    mapper->AddObserver(vtkCommand::VolumeMapperRenderStartEvent, this->Observer);
    // A mapper reports progress more often than the window checks for an abort, so this observer
    // also calls Interrupt().
    mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, this->Observer);
  }
  // A setting that differs from the value set here was changed by the application since the last
  // frame.
  Settings& own = caster->Own;
  own.ImageDistance =
    now.ImageDistance == caster->Set.ImageDistance ? own.ImageDistance : now.ImageDistance;
  own.SampleDistance =
    now.SampleDistance == caster->Set.SampleDistance ? own.SampleDistance : now.SampleDistance;
  own.AutoAdjust = now.AutoAdjust == caster->Set.AutoAdjust ? own.AutoAdjust : now.AutoAdjust;

  const double voxel = SmallestSpacing(image);
  auto* const cpu = vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper);
  const bool isInterruptible = cpu != nullptr;
  const bool isShared = std::exchange(caster->Frame, this->Frame) == this->Frame;
  caster->Progress.Clear();
  if (isShared)
  {
    caster->Rays.reset();
  }
  else if (cpu)
  {
    KeepRays(*caster, cpu, shown);
  }
  const double finely =
    own.AutoAdjust && !isInterruptible ? AutomaticDistance(image) : own.SampleDistance;
  Settings next = own;
  if (moves)
  {
    next.AutoAdjust = false;
    next.SampleDistance = std::max(finely, std::min(2.0 * finely, voxel));
  }
  const bool isLimited = moves || this->IsArmed;
  // Estimate the time for a kind of frame that was not measured yet from the other kind: frames in
  // motion have half as many samples.
  if (!moves && !this->AtRest.IsKnown && this->InMotion.IsKnown)
  {
    this->AtRest = { 2.0 * this->InMotion.Time, this->InMotion.Steps, true };
  }
  else if (moves && !this->InMotion.IsKnown && this->AtRest.IsKnown)
  {
    this->InMotion = { 0.5 * this->AtRest.Time, this->AtRest.Steps, true };
  }
  else if (moves && !this->InMotion.IsKnown && cpu)
  {
    this->InMotion.Steps = UnknownSteps; // starts coarsely, because the first touch must not wait
  }
  if (!isLimited)
  {
    this->AtRest.Steps = 0.0; // casts all rays, so that the frame's time includes all of them
  }
  else
  {
    const double rate = std::max(AimedRate, this->Window->GetDesiredUpdateRate());
    const double distance = moves
      ? this->InMotion.Next(DrawingFraction / rate)
      : this->AtRest.Next(isInterruptible ? LongestRest : LongestStillFrame);
    next.ImageDistance = std::max(own.ImageDistance, distance);
  }
  const KeptRays* const rays = caster->Rays.get();
  if (moves && this->SlowFrames < MostSlowFrames && rays &&
    rays->GetImageDistance() < next.ImageDistance &&
    rays->GetImageDistance() >= own.ImageDistance &&
    rays->GetSampleDistance() >= own.SampleDistance && rays->IsCurrent())
  {
    next.ImageDistance = rays->GetImageDistance();
    next.SampleDistance = rays->GetSampleDistance();
    caster->Rays->Expect();
    this->IsFine = true;
  }
  mapper->SetAutoAdjustSampleDistances(next.AutoAdjust);
  mapper->SetImageSampleDistance(static_cast<float>(next.ImageDistance));
  mapper->SetSampleDistance(static_cast<float>(next.SampleDistance));
  caster->Set = { mapper->GetImageSampleDistance(), mapper->GetSampleDistance(), next.AutoAdjust };
}

//------------------------------------------------------------------------------
void FrameQuality::KeepRays(
  Caster& caster, vtkFixedPointVolumeRayCastMapper* mapper, const Shown& shown)
{
  if (!caster.Rays || !caster.Rays->Follows(shown.Renderer, shown.Volume))
  {
    caster.Rays = std::make_shared<KeptRays>(shown.Renderer, shown.Volume, mapper);
  }
}

//------------------------------------------------------------------------------
void FrameQuality::AdjustProcessor(vtkSmartVolumeMapper* mapper, const Shown& shown)
{
  const auto smart = std::find_if(this->SmartMappers.begin(), this->SmartMappers.end(),
    [mapper](const Smart& known) { return known.Mapper == mapper; });
  auto* const image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  if (smart == this->SmartMappers.end() || !image)
  {
    return;
  }
  // Prevent VTK from drawing frames at rest as coarsely as the last frame in motion.
  vtkFixedPointVolumeRayCastMapper* const cpu = SmartMapperParts::GetCPUMapper(mapper);
  const auto isCPU = [cpu](const Caster& caster) { return caster.Mapper == cpu; };
  if (std::none_of(this->Casters.begin(), this->Casters.end(), isCPU))
  {
    cpu->AutoAdjustSampleDistancesOff();
    cpu->SetImageSampleDistance(1.0F);
    cpu->SetSampleDistance(static_cast<float>(AutomaticDistance(image)));
  }
  this->Adjust(cpu, shown);
  cpu->SetLockSampleDistanceToInputSpacing(!this->Moves);
  mapper->SetInteractiveAdjustSampleDistances(false);
  mapper->SetAutoAdjustSampleDistances(false);
  mapper->SetSampleDistance(
    this->Moves ? cpu->GetSampleDistance() : static_cast<float>(smart->SampleDistance));
}

//------------------------------------------------------------------------------
void FrameQuality::GiveBack(const Smart& smart)
{
  if (vtkSmartVolumeMapper* const mapper = smart.Mapper)
  {
    mapper->SetRequestedRenderMode(smart.Mode);
    mapper->SetInteractiveAdjustSampleDistances(smart.IsInteractive);
    mapper->SetAutoAdjustSampleDistances(smart.AutoAdjust);
    mapper->SetSampleDistance(static_cast<float>(smart.SampleDistance));
    SmartMapperParts::GetCPUMapper(mapper)->LockSampleDistanceToInputSpacingOn();
  }
}

//------------------------------------------------------------------------------
void FrameQuality::ChooseProcessor(vtkSmartVolumeMapper* mapper, bool touched)
{
  const auto isMapper = [mapper](const Smart& smart) { return smart.Mapper == mapper; };
  const auto known = std::find_if(this->SmartMappers.begin(), this->SmartMappers.end(), isMapper);
  if (!touched && known != this->SmartMappers.end())
  {
    GiveBack(*known);
    this->SmartMappers.erase(known);
  }
  const int mode = mapper->GetRequestedRenderMode();
  auto* const image = vtkImageData::SafeDownCast(mapper->GetDataSetInput());
  // Do not use the ray caster on the processor for cell data or several components.
  vtkDataArray* const values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (touched && known == this->SmartMappers.end() &&
    mode == vtkSmartVolumeMapper::DefaultRenderMode && values &&
    values->GetNumberOfComponents() == 1 && this->IsOnProcessor())
  {
    this->SmartMappers.push_back(
      { mapper, mode, mapper->GetSampleDistance(), mapper->GetAutoAdjustSampleDistances() != 0,
        mapper->GetInteractiveAdjustSampleDistances() != 0 });
    mapper->SetRequestedRenderModeToRayCast();
  }
}

//------------------------------------------------------------------------------
bool FrameQuality::IsOnProcessor()
{
  if (!this->OnProcessor && !this->Window->GetNeverRendered())
  {
    this->OnProcessor = IsSoftwareOpenGL(this->Window);
  }
  return this->OnProcessor.value_or(false);
}

//------------------------------------------------------------------------------
void FrameQuality::Begin()
{
  if (!this->GetWindow())
  {
    return;
  }
  const Touch touch = this->AskTouch();
  const int* const size = this->Window->GetSize();
  const bool isQuick = this->AtRest.IsKnown && this->AtRest.Time <= LongestStillFrame;
  this->IsResized = std::exchange(this->IsExposed, false) && !isQuick && this->DrawnSize[0] > 0 &&
    !std::equal(size, size + 2, this->DrawnSize.begin());
  this->Moves = this->IsResized || this->Window->GetDesiredUpdateRate() > SlowestMotion;
  this->IsArmed = touch == Touch::Armed;
  this->IsGivenUp = false;
  this->IsFine = false;
  ++this->Frame;
  ForEachVolume(this->Window,
    [&](vtkRenderer* renderer, vtkVolume* volume)
    {
      vtkAbstractVolumeMapper* const mapper = volume->GetMapper();
      const Shown shown{ renderer, volume };
      auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(mapper);
      auto* const cpu = vtkFixedPointVolumeRayCastMapper::SafeDownCast(mapper);
      auto* const smart = vtkSmartVolumeMapper::SafeDownCast(mapper);
      if (gpu)
      {
        this->Adjust(gpu, shown);
      }
      else if (cpu)
      {
        this->Adjust(cpu, shown);
      }
      else if (smart)
      {
        this->ChooseProcessor(smart, touch != Touch::Off);
        this->AdjustProcessor(smart, shown);
      }
    });
  this->Start = std::chrono::steady_clock::now();
}

//------------------------------------------------------------------------------
double FrameQuality::GetElapsed() const
{
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - this->Start).count();
}

//------------------------------------------------------------------------------
void FrameQuality::End()
{
  if (!this->GetWindow())
  {
    return;
  }
  const double time = this->GetElapsed();
  if (this->Window->GetAbortRender())
  {
    this->Interrupted = this->IsGivenUp ? Interruption::Slow : Interruption::Input;
    this->SlowFrames = this->Moves ? MostSlowFrames : this->SlowFrames;
    const std::optional<double> whole = this->EstimateTime();
    if (!this->Moves && (whole || time > LongestTry))
    {
      this->AtRest.Record(whole.value_or(time));
    }
    return;
  }
  std::copy_n(this->Window->GetSize(), 2, this->DrawnSize.begin());
  this->Interrupted = this->IsResized ? Interruption::Resized : this->Interrupted;
  // Record the time of a full frame only if the frame casts all rays.
  bool castsAll = false;
  bool keepsRays = false;
  bool isAdjusted = false;
  for (const Caster& caster : this->Casters)
  {
    if (caster.Frame == this->Frame)
    {
      castsAll = (caster.Rays && caster.Rays->DrainWhole()) || castsAll;
      keepsRays = caster.Rays || keepsRays;
      isAdjusted = true;
    }
  }
  if (castsAll || (isAdjusted && !keepsRays))
  {
    (this->Moves ? this->InMotion : this->AtRest).Record(time);
  }
  if (!this->Moves)
  {
    this->SlowFrames = 0;
  }
  else if (this->IsFine && !castsAll)
  {
    // Compare with coarse frames, too: on a busy processor, even these may be slow.
    const double coarsely = std::max(this->InMotion.Time, this->CoarseTime);
    this->SlowFrames = time > std::max(1.0 / LeastRate, 1.5 * coarsely) ? this->SlowFrames + 1 : 0;
  }
  else if (keepsRays && !castsAll)
  {
    constexpr double fraction = 0.2; // weight of the newest frame in the running mean
    this->CoarseTime += (this->CoarseTime == 0.0 ? 1.0 : fraction) * (time - this->CoarseTime);
  }
}

//------------------------------------------------------------------------------
void FrameQuality::RecordProgress(vtkObject* mapper, double fraction)
{
  for (Caster& caster : this->Casters)
  {
    if (caster.Mapper != mapper)
    {
      continue;
    }
    if (fraction == 0.0)
    {
      caster.Progress.Begin(this->GetElapsed());
    }
    else if (caster.Rays && caster.Rays->IsCastingAll())
    {
      caster.Progress.Record(this->GetElapsed(), fraction);
    }
  }
}

//------------------------------------------------------------------------------
std::optional<double> FrameQuality::EstimateTime() const
{
  const Caster* only = nullptr;
  for (const Caster& caster : this->Casters)
  {
    if (caster.Frame == this->Frame && std::exchange(only, &caster))
    {
      return {}; // with several mappers, the time for the rest of the frame is unknown
    }
  }
  return only ? only->Progress.GetWhole() : std::nullopt;
}

//------------------------------------------------------------------------------
void FrameQuality::Interrupt()
{
  if (this->GetWindow() && !this->Moves && this->Window->CheckInRenderStatus())
  {
    const bool isSlow = this->IsArmed && this->AtRest.Steps < RayPace::MostSteps &&
      std::max(this->GetElapsed(), this->EstimateTime().value_or(0.0)) > LongestTry;
    const bool hasInput = this->IsInterruptible && HasPendingInput(this->Window);
    this->IsGivenUp = isSlow && !hasInput;
    this->Window->SetAbortRender(isSlow || hasInput || this->Window->GetAbortRender());
  }
}

//------------------------------------------------------------------------------
void FrameQuality::Restore()
{
  const auto restore = [this](auto* mapper, const Caster& caster)
  {
    mapper->RemoveObserver(this->Observer);
    mapper->SetAutoAdjustSampleDistances(caster.Own.AutoAdjust);
    mapper->SetImageSampleDistance(static_cast<float>(caster.Own.ImageDistance));
    mapper->SetSampleDistance(static_cast<float>(caster.Own.SampleDistance));
  };
  for (const Caster& caster : this->Casters)
  {
    if (auto* const gpu = vtkGPUVolumeRayCastMapper::SafeDownCast(caster.Mapper))
    {
      restore(gpu, caster);
    }
    else if (auto* const cpu = vtkFixedPointVolumeRayCastMapper::SafeDownCast(caster.Mapper))
    {
      restore(cpu, caster);
    }
  }
  for (const Smart& smart : this->SmartMappers)
  {
    GiveBack(smart);
  }
  this->Casters.clear();
  this->SmartMappers.clear();
}

} // namespace VolumeHaptics
