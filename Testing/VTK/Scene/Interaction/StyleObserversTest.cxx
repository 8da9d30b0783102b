// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests application observers that close the window, disarm, or remove the device or the interactor
 * from the style during long work. Nothing may crash, and no device may stay armed without a window
 * that updates it.
 */

#include "StyleRig.h"

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkSphereSource.h>

#include <functional>

using namespace scenetest;

namespace
{
class StyleObservers : public StyleTest
{
protected:
  StyleObservers()
  {
    this->Generic->SetRenderWindow(this->Window);
    this->Generic->SetInteractorStyle(this->Style);
    this->Other->SetVolumeHaptics(this->Filter);
    this->Filter->SetIsoValue(-1500.0); // surface of a sphere with a radius of 45 mm
    // The device announces publications as long work if they take more than an eighth of the
    // attention time, which is 50 ms here.
    this->Device->SetAttentionTime(0.05);
  }
  ~StyleObservers() override { this->Generic->SetInteractorStyle(nullptr); }

  void Start(bool meshes = true)
  {
    meshes ? this->Filter->SetMethodToSurfaceProxy() : this->Filter->SetMethodToForceField();
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Style->UpdateHaptics();
  }
  /// Sets a surface of 40000 triangles, whose publication is long work.
  void GiveSurface()
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetRadius(30.0);
    sphere->SetThetaResolution(200);
    sphere->SetPhiResolution(102);
    this->Filter->SetSurfaceConnection(sphere->GetOutputPort());
  }
  /// Calls `act` when the device announces that it is about to build the mesh.
  void AtWork(std::function<void()> act)
  {
    this->Act = std::move(act);
    vtkNew<vtkCallbackCommand> observer;
    observer->SetClientData(this);
    observer->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*)
      {
        auto& test = *static_cast<StyleObservers*>(self);
        ++test.Calls;
        test.Act();
      });
    this->Device->AddObserver(vtkCommand::StartEvent, observer);
  }
  void ExpectLetGo(const char* what)
  {
    EXPECT_FALSE(this->Style->GetTouchMode()) << what;
    this->ExpectDisarmed(this->Device, what);
  }
  /// Waits for 20 ticks, and expects the device to be neither armed nor in a fault.
  void ExpectDisarmed(vtkHapticDevice* device, const char* what)
  {
    const vtkIdType end = device->GetState()->GetTick() + 20;
    EXPECT_TRUE(Eventually(
      [&]
      {
        device->UpdateState();
        return !device->IsRunning() || device->GetState()->GetTick() >= end;
      }));
    EXPECT_NE(device->GetStatus(), vtkHapticDevice::ARMED) << what;
    EXPECT_NE(device->GetStatus(), vtkHapticDevice::ACTIVE) << what;
    EXPECT_NE(device->GetStatus(), vtkHapticDevice::FAULT) << what << ": it was armed";
  }

  vtkNew<vtkGenericRenderWindowInteractor> Generic;
  vtkNew<vtkHapticDevice> Other;
  int Calls = 0;

private:
  std::function<void()> Act;
};
} // namespace

TEST_F(StyleObservers, OfTheTouchModeEndIt)
{
  const std::pair<const char*, std::function<void()>> ends[] = {
    { "ExitCallback", [this] { this->Generic->ExitCallback(); } },
    { "TerminateApp", [this] { this->Generic->TerminateApp(); } },
    { "Disable", [this] { this->Generic->Disable(); } },
    { "Disarm", [this] { this->Device->Disarm(); } },
    { "FadeOut", [this] { this->Device->FadeOut(); } },
    { "TouchModeOff", [this] { this->Style->TouchModeOff(); } },
    { "Close", [this] { this->Device->Close(); } },
    { "no interactor", [this] { this->Generic->SetInteractorStyle(nullptr); } },
    { "no device", [this] { this->Style->SetDevice(nullptr); } },
    { "another device", [this] { this->Style->SetDevice(this->Other); } },
  };
  std::function<void()> end;
  this->AtWork([&] { end(); });
  for (const auto& [what, act] : ends)
  {
    this->Generic->SetDone(false);
    this->Generic->SetInteractorStyle(this->Style);
    this->Generic->Enable();
    this->Style->SetDevice(this->Device);
    this->Filter->Modified();
    this->Device->Close();
    ASSERT_NO_FATAL_FAILURE(this->Start());
    this->GiveSurface();
    end = act;
    this->Calls = 0;
    this->Style->TouchModeOn();
    EXPECT_GT(this->Calls, 0) << what;
    this->ExpectLetGo(what);
  }
  EXPECT_TRUE(this->Log.Errors.empty());
  // Touch mode must begin if the observer does not end anything.
  end = [] {};
  this->Generic->SetInteractorStyle(this->Style);
  this->Style->SetDevice(this->Device);
  this->Device->SetAttentionTime(0.0);
  this->Style->TouchModeOn();
  EXPECT_TRUE(this->Style->GetTouchMode());
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Device->UpdateState();
      return this->Device->GetStatus() >= vtkHapticDevice::ARMED;
    }));
}

TEST_F(StyleObservers, FindNoTouchAfterTheLoopWasEnded)
{
  ASSERT_NO_FATAL_FAILURE(this->Start(false));
  this->Generic->TerminateApp();
  this->Style->TouchModeOn();
  this->ExpectLetGo("TerminateApp");
}

TEST_F(StyleObservers, OfAnUpdateTakeTheDevice)
{
  this->GiveSurface();
  ASSERT_NO_FATAL_FAILURE(this->Start(false));
  this->AtWork([this] { this->Style->SetDevice(nullptr); });
  this->Filter->SetMethodToSurfaceProxy();
  EXPECT_FALSE(this->Style->UpdateHaptics());
  EXPECT_EQ(this->Calls, 1);
  EXPECT_FALSE(this->Style->GetDevice());
}

TEST_F(StyleObservers, OfAnUpdateGiveAnotherDevice)
{
  this->GiveSurface();
  ASSERT_NO_FATAL_FAILURE(this->Start(false));
  this->AtWork(
    [this]
    {
      this->Style->SetDevice(nullptr);
      EXPECT_FALSE(this->Style->GetDevice()) << "within the update";
      this->Style->SetDevice(this->Other);
      EXPECT_EQ(this->Style->GetDevice(), this->Other.GetPointer());
    });
  this->Filter->SetMethodToSurfaceProxy();
  EXPECT_FALSE(this->Style->UpdateHaptics()) << "states are of the device that the style has";
  EXPECT_EQ(this->Calls, 1);
  EXPECT_EQ(this->Style->GetDevice(), this->Other.GetPointer());
  EXPECT_FALSE(this->Style->UpdateHaptics()) << "the other device does not run";
  this->ExpectLetGo("another device");
}

TEST_F(StyleObservers, OfTheNextMethodTakeTheDevice)
{
  this->GiveSurface();
  ASSERT_NO_FATAL_FAILURE(this->Start(false));
  this->AtWork([this] { this->Style->SetDevice(nullptr); });
  EXPECT_TRUE(this->Style->NextMethod());
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::SURFACE_PROXY);
  EXPECT_EQ(this->Calls, 1);
  EXPECT_FALSE(this->Style->GetDevice());
}

TEST_F(StyleObservers, ArmNothingInADeviceThatIsTakenAway)
{
  this->Device->SetAttentionTime(0.0);
  for (const bool another : { false, true })
  {
    ASSERT_NO_FATAL_FAILURE(this->Start(false));
    this->Style->SetDevice(this->Device);
    this->Style->TouchModeOn();
    ASSERT_TRUE(this->Style->GetTouchMode());
    this->Style->SetDevice(another ? this->Other.GetPointer() : nullptr);
    this->ExpectLetGo("SetDevice");
    this->Device->Close();
  }
  // While SetDevice() switches devices, an observer of DisableEvent removes the device. The new
  // device must remain.
  ASSERT_NO_FATAL_FAILURE(this->Start(false));
  this->Style->SetDevice(this->Device);
  this->Style->TouchModeOn();
  vtkNew<vtkCallbackCommand> take;
  take->SetClientData(this->Style);
  take->SetCallback([](vtkObject*, unsigned long, void* style, void*)
    { static_cast<vtkInteractorStyleHaptic*>(style)->SetDevice(nullptr); });
  this->Device->AddObserver(vtkCommand::DisableEvent, take);
  this->Style->SetDevice(this->Other);
  EXPECT_EQ(this->Style->GetDevice(), this->Other.GetPointer());
  this->ExpectLetGo("SetDevice");
}
