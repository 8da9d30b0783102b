// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/TouchReplay.h"

#include "Applications/Explorer/Exploration/ShapeFile.h"
#include "Applications/Explorer/View/SliderLook.h"
#include "VTK/Reading/InputError.h"

#include "vtkDataArray.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace
{
constexpr double REPLAY_STEP = 0.1; // s, the step of F6 and F7

void DrawSource(vtkAlgorithm* source, vtkActor* actor, const double color[3])
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(source->GetOutputPort());
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color[0], color[1], color[2]);
  actor->PickableOff();
  actor->UseBoundsOff();
}

/// Returns the index of the last row whose time is at most `time`.
vtkIdType FindRow(vtkDataArray* times, double time)
{
  vtkIdType first = 0, last = times->GetNumberOfTuples() - 1;
  while (first < last)
  {
    const vtkIdType middle = (first + last + 1) / 2;
    if (times->GetComponent(middle, 0) <= time)
    {
      first = middle;
    }
    else
    {
      last = middle - 1;
    }
  }
  return first;
}
} // namespace

namespace Explore
{
TouchReplay::TouchReplay(
  TouchScene& touch, vtkRenderWindowInteractor* interactor, const std::string& file)
  : Touch(touch)
  , Interactor(interactor)
{
  this->Trace = ReadFile(file);
  vtkDataArray* const times = this->Trace->GetPointData()->GetArray("Time");
  this->Begin = times->GetComponent(0, 0);
  this->End = times->GetComponent(times->GetNumberOfTuples() - 1, 0);
  this->BuildActors();
  this->BuildSlider(file);
  // Hide the plot, because it shows the live hand, which is at rest. Key g shows it again.
  touch.Display->PlotVisibilityOff();
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long event, void* self, void*)
    {
      auto* const replay = static_cast<TouchReplay*>(self);
      if (event == vtkCommand::InteractionEvent)
      {
        replay->IsPlaying = false;
        replay->Show(replay->Begin + replay->Slider->GetValue());
      }
      else
      {
        replay->Update();
      }
    });
  interactor->AddObserver(vtkCommand::TimerEvent, this->Observer);
  this->Widget->AddObserver(vtkCommand::InteractionEvent, this->Observer);
  this->AddCommands();
  this->Show(this->Begin);
}

TouchReplay::~TouchReplay()
{
  this->Touch.Commands.Remove(this);
  this->Interactor->RemoveObserver(this->Observer);
  this->Widget->RemoveObserver(this->Observer);
  this->Widget->SetEnabled(0);
  this->Widget->SetInteractor(nullptr);
  for (vtkActor* const actor :
    { this->Way.Get(), this->ProxyActor.Get(), this->SpringActor.Get(), this->ForceActor.Get() })
  {
    this->Touch.Scene.Overlay->RemoveViewProp(actor);
  }
}

vtkSmartPointer<vtkPolyData> TouchReplay::ReadFile(const std::string& file)
{
  std::string error;
  const bool isThere = vtksys::SystemTools::FileExists(file, true);
  const vtkSmartPointer<vtkPolyData> trace = isThere ? ReadPolyData(file, error) : nullptr;
  vtkPointData* const data = trace ? trace->GetPointData() : nullptr;
  vtkDataArray* const times = data ? data->GetArray("Time") : nullptr;
  const auto isVector = [data](const char* name)
  { return data->GetArray(name) && data->GetArray(name)->GetNumberOfComponents() == 3; };
  if (!times || !isVector("Force") || !isVector("Tip") || times->GetNumberOfTuples() < 2)
  {
    throw InputError("--replay " + file,
      isThere ? "is not a recording of a touch" + (error.empty() ? "" : " (" + error + ")")
              : "there is no such file",
      "give a .vtp written by key F10 or vtkHapticRecorder::Start()");
  }
  if (!(times->GetComponent(times->GetNumberOfTuples() - 1, 0) > times->GetComponent(0, 0)))
  {
    throw InputError(
      "--replay " + file, "has times that do not increase", "record the touch again");
  }
  return trace;
}

void TouchReplay::BuildActors()
{
  const double way[3] = { 0.55, 0.80, 1.0 }, proxy[3] = { 0.35, 0.70, 1.0 };
  const double spring[3] = { 1.0, 1.0, 1.0 }, force[3] = { 1.0, 0.75, 0.25 };
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(this->Trace);
  mapper->ScalarVisibilityOff();
  this->Way->SetMapper(mapper);
  this->Way->GetProperty()->SetColor(way[0], way[1], way[2]);
  this->Way->GetProperty()->SetLineWidth(2.0f);
  this->Way->GetProperty()->LightingOff();
  this->Way->PickableOff();
  this->Way->UseBoundsOff();
  this->Proxy->SetRadius(this->Touch.Hand->GetRadius());
  this->Proxy->SetThetaResolution(24);
  this->Proxy->SetPhiResolution(16);
  DrawSource(this->Proxy, this->ProxyActor, proxy);
  DrawSource(this->Spring, this->SpringActor, spring);
  this->Force->SetTipResolution(24);
  this->Force->SetShaftResolution(24);
  DrawSource(this->Force, this->ForceActor, force);
  for (vtkActor* const actor :
    { this->Way.Get(), this->ProxyActor.Get(), this->SpringActor.Get(), this->ForceActor.Get() })
  {
    this->Touch.Scene.Overlay->AddViewProp(actor);
  }
}

void TouchReplay::BuildSlider(const std::string& file)
{
  vtkSliderRepresentation2D* const slider = this->Slider;
  slider->SetMinimumValue(0.0);
  slider->SetMaximumValue(this->End - this->Begin);
  slider->SetTitleText(vtksys::SystemTools::GetFilenameName(file).c_str());
  slider->SetLabelFormat("%.2f s");
  ShowTimeSlider(this->Widget, slider, this->Interactor, this->Touch.Scene.Overlay);
}

void TouchReplay::AddCommands()
{
  const auto play = [this]
  {
    this->IsPlaying = !this->IsPlaying;
    this->Played = std::chrono::steady_clock::now();
    if (this->IsPlaying && this->Now >= this->End)
    {
      this->Show(this->Begin);
    }
  };
  const auto step = [this](double seconds)
  {
    return [this, seconds]
    {
      this->IsPlaying = false;
      this->Show(this->Now + seconds);
    };
  };
  CommandTable& table = this->Touch.Commands;
  table.Add(this,
    { "Recording", "play the recording; pause", "F5", play, [this] { return this->IsPlaying; },
      nullptr, Icon::Play });
  table.Add(this, { "Recording", "back 0.1 s", "F6", step(-REPLAY_STEP), nullptr, nullptr });
  table.Add(this, { "Recording", "forward 0.1 s", "F7", step(REPLAY_STEP), nullptr, nullptr });
}

void TouchReplay::Update()
{
  if (!this->IsPlaying)
  {
    return;
  }
  const auto now = std::chrono::steady_clock::now();
  const std::chrono::duration<double> passed = now - this->Played;
  this->Played = now;
  this->Show(this->Now + passed.count());
  this->IsPlaying = this->Now < this->End;
}

void TouchReplay::Show(double time)
{
  this->Now = std::clamp(time, this->Begin, this->End);
  vtkPointData* const data = this->Trace->GetPointData();
  const vtkIdType row = FindRow(data->GetArray("Time"), this->Now);
  double proxy[3], tip[3], force[3];
  this->Trace->GetPoint(row, proxy);
  data->GetArray("Tip")->GetTuple(row, tip);
  data->GetArray("Force")->GetTuple(row, force);
  this->Proxy->SetCenter(proxy);
  this->Spring->SetPoint1(proxy);
  this->Spring->SetPoint2(tip);

  // VTK's arrow points along x, and is 1 long.
  const double newtons = vtkMath::Norm(force);
  // Size the arrows like those of the live hand.
  constexpr double arrowRadii = 30.0;
  constexpr double thickness = 10.0; // thickness of VTK's arrow, whose shaft has a radius of 0.03
  const double radius = this->Touch.Hand->GetRadius();
  const double length = std::min(newtons / this->Touch.Hand->GetForceScale(), arrowRadii * radius);
  const double sizes[3] = { length, thickness * radius, thickness * radius };
  double axes[3][3];
  std::copy_n(force, 3, axes[0]);
  this->ForceActor->SetVisibility(vtkMath::Normalize(axes[0]) > 0.0);
  vtkMath::Perpendiculars(axes[0], axes[1], axes[2], 0.0);
  vtkNew<vtkMatrix4x4> place;
  for (int line = 0; line < 3; ++line)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      place->SetElement(line, axis, sizes[axis] * axes[axis][line]);
    }
    place->SetElement(line, 3, proxy[line]);
  }
  this->ForceActor->SetUserMatrix(place);

  std::ostringstream label;
  label << std::fixed << std::setprecision(2) << "%.2f s, " << newtons << " N";
  this->Slider->SetLabelFormat(label.str().c_str());
  this->Slider->SetValue(this->Now - this->Begin);
  if (!this->Touch.Scene.Window->GetNeverRendered())
  {
    this->Interactor->Render();
  }
}
} // namespace Explore
