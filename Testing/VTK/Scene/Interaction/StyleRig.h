// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Fixture with an interactor that has the haptic style over a ball, and a hand that sends events.
 */
#ifndef StyleRig_h
#define StyleRig_h

#include "Rigs/DeviceRig.h"

#include <vtkCallbackCommand.h>
#include <vtkCamera.h>
#include <vtkInteractorStyleHaptic.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderWindowInteractor.h>
#include <vtkRenderer.h>
#include <vtkTable.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

namespace scenetest
{
using namespace devicetest;

/// Makes an image of a ball with a radius of 30 mm. The value is 100 times the depth (mm) below its
/// surface, and negative outside.
inline vtkSmartPointer<vtkImageData> MakeBall()
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(97, 97, 97);
  image->SetOrigin(-48.0, -48.0, -48.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetTuple1(i, 100.0 * (30.0 - Length(image->GetPoint(i))));
  }
  return image;
}

/// Makes the inside of the ball opaque, and everything around it transparent.
inline void ShowBall(vtkVolume* volume)
{
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.0);
  opacity->AddPoint(0.1, 1.0);
  volume->GetProperty()->SetScalarOpacity(opacity);
}

/// Makes an off-screen window that looks along -z at the origin. A pixel is 0.2 mm.
inline void SetUpView(vtkRenderWindow* window, vtkRenderer* renderer)
{
  window->SetOffScreenRendering(1);
  window->SetSize(300, 300);
  window->AddRenderer(renderer);
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetPosition(0.0, 0.0, 200.0);
  camera->SetFocalPoint(0.0, 0.0, 0.0);
  camera->SetParallelProjection(1);
  camera->SetParallelScale(30.0);
  camera->SetClippingRange(1.0, 400.0);
}

class StyleTest : public testing::Test
{
protected:
  StyleTest()
  {
    this->Filter->SetInputData(0, this->Ball);
    // Values outside the ball are negative, without strength. Inside, the strength exceeds any
    // force of the hand.
    vtkPiecewiseFunction* const strength = this->Filter->GetProperty()->GetSurfaceStrength();
    strength->AddPoint(0.0, 0.0);
    strength->AddPoint(0.1, 8.0);
    this->Device->SetVolumeHaptics(this->Filter);
    SetUpView(this->Window, this->Renderer);
    this->Interactor->SetRenderWindow(this->Window);
    this->Style->SetDevice(this->Device);
    this->Style->SetDefaultRenderer(this->Renderer);
    this->Style->TipFollowsSurfaceOff();
    this->Interactor->SetInteractorStyle(this->Style);
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(&this->Events);
    note->SetCallback([](vtkObject*, unsigned long event, void* events, void*)
      { static_cast<std::vector<unsigned long>*>(events)->push_back(event); });
    using S = vtkInteractorStyleHaptic;
    for (const unsigned long event :
      { S::ContactBeginEvent, S::ContactEndEvent, S::ArmedEvent, S::DisarmedEvent, S::FaultEvent })
    {
      this->Style->AddObserver(event, note);
    }
  }
  ~StyleTest() override { this->Interactor->SetInteractorStyle(nullptr); }

  /// Updates the style until the servo has made `ticks` more ticks. Calls `see` for every state.
  template <typename F>
  void Run(vtkIdType ticks, F&& see)
  {
    const auto update = [&]
    {
      this->Style->UpdateHaptics();
      for (vtkIdType i = 0; i < this->Style->GetStates()->GetNumberOfRows(); ++i)
      {
        see(this->Style->GetStates(), i);
      }
    };
    // Count from now on, not from the device's last update.
    update();
    const vtkIdType end = this->Device->GetState()->GetTick() + ticks;
    ASSERT_TRUE(Eventually(
      [&]
      {
        update();
        return this->Device->GetState()->GetTick() >= end;
      }));
  }
  void Run(vtkIdType ticks)
  {
    this->Run(ticks, [](vtkTable*, vtkIdType) {});
  }
  /// Updates the style until the device is fully armed. A wall that is pressed earlier stays soft.
  void RunUntilFullyArmed()
  {
    ASSERT_TRUE(Eventually(
      [&]
      {
        this->Style->UpdateHaptics();
        return IsFullyArmed(this->Device);
      }));
  }
  /// Switches on touch mode, so that the mouse moves a stylus, and presses into the middle of the
  /// view.
  void PushIn(int x = 150, int y = 150)
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Pointer(x, y);
    this->Style->TouchModeOn();
    this->RunUntilFullyArmed();
    for (int i = 0; i < 4; ++i)
    {
      this->Pointer(x, y, vtkCommand::MouseWheelForwardEvent);
      this->Run(10);
    }
  }
  void Pointer(int x, int y, unsigned long event = vtkCommand::MouseMoveEvent, int shift = 0)
  {
    this->Interactor->SetEventInformation(x, y, 0, shift);
    this->Interactor->InvokeEvent(event);
  }
  void Press(const char* key, unsigned long event = vtkCommand::KeyPressEvent)
  {
    this->Interactor->SetKeySym(key);
    this->Interactor->InvokeEvent(event);
  }

  vtkSmartPointer<vtkImageData> Ball = MakeBall();
  vtkNew<vtkVolumeHapticsFilter> Filter;
  vtkNew<vtkHapticDevice> Device;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkInteractorStyleHaptic> Style;
  std::vector<unsigned long> Events;
  MessageLog Log{ this->Style };
};
} // namespace scenetest

#endif
