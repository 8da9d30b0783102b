// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/TimeSlider.h"

#include "Applications/Explorer/View/SliderLook.h"

#include "vtkHapticPlayback.h"
#include "vtkHapticTimeStepSource.h"
#include "vtkInformation.h"
#include "vtkStreamingDemandDrivenPipeline.h"
#include "vtkVolumeHapticsFilter.h"

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace Explore
{
TimeSlider::TimeSlider(
  TouchScene& touch, const Exploration& exploration, vtkRenderWindowInteractor* interactor)
  : Touch(touch)
  , Interactor(interactor)
{
  vtkHapticTimeStepSource* const source = exploration.Input.TimeSteps;
  source->UpdateInformation();
  vtkInformation* const facts = source->GetOutputInformation(0);
  vtkInformationDoubleVectorKey* const key = vtkStreamingDemandDrivenPipeline::TIME_STEPS();
  const double* const times = facts->Get(key);
  this->Times.assign(times, times + facts->Length(key));
  const double units = std::abs(exploration.Filter->GetTimeUnitsPerSecond());
  this->UnitsPerSecond = units > 0.0 ? units : 1.0;
  this->Slider->SetMinimumValue(this->Times.front());
  this->Slider->SetMaximumValue(this->Times.back());
  this->Slider->SetTitleText("");
  ShowTimeSlider(this->Widget, this->Slider, interactor, touch.Scene.Overlay);
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto& slider = *static_cast<TimeSlider*>(self);
      switch (event)
      {
        case vtkCommand::InteractionEvent:
          slider.GoTo();
          break;
        case vtkCommand::TimerEvent:
          slider.Update();
          break;
        default:
          slider.IsDragged = event == vtkCommand::StartInteractionEvent;
      }
    });
  interactor->AddObserver(vtkCommand::TimerEvent, this->Observer);
  for (const unsigned long event : { vtkCommand::StartInteractionEvent,
         vtkCommand::InteractionEvent, vtkCommand::EndInteractionEvent })
  {
    this->Widget->AddObserver(event, this->Observer);
  }
  this->Update();
}

TimeSlider::~TimeSlider()
{
  this->Interactor->RemoveObserver(this->Observer);
  this->Widget->RemoveObserver(this->Observer);
  this->Widget->SetEnabled(0);
  this->Widget->SetInteractor(nullptr);
}

void TimeSlider::GoTo()
{
  vtkHapticPlayback* const playback = this->Touch.Device->GetPlayback();
  playback->Hold();
  playback->SetDataTime(this->Slider->GetValue());
  this->Update();
}

void TimeSlider::Update()
{
  const double time =
    this->IsDragged ? this->Slider->GetValue() : this->Touch.Device->GetPlayback()->GetDataTime();
  if (!this->IsDragged)
  {
    this->Slider->SetValue(std::clamp(time, this->Times.front(), this->Times.back()));
  }
  const auto nearest = std::min_element(this->Times.begin(), this->Times.end(),
    [time](double a, double b) { return std::abs(a - time) < std::abs(b - time); });
  std::ostringstream label;
  label << std::fixed << std::setprecision(2) << time / this->UnitsPerSecond << " s, frame "
        << (nearest - this->Times.begin() + 1) << " of " << this->Times.size();
  if (label.str() != this->Slider->GetLabelFormat())
  {
    this->Slider->SetLabelFormat(label.str().c_str());
  }
}
} // namespace Explore
