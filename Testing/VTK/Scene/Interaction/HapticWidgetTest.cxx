// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the widget in a program with its own style, observers and keys. The hand touches, and the
 * program must continue to work. VTK's vtkInteractorStyleTrackballCamera, and observers that count
 * the events that reach them, represent the program.
 */

#include "StyleRig.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticRepresentation.h>
#include <vtkHapticSliceView.h>
#include <vtkHapticWidget.h>
#include <vtkInteractorStyleImage.h>
#include <vtkInteractorStyleTrackballCamera.h>
#include <vtkPropCollection.h>
#include <vtkSequencePass.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <map>

using namespace scenetest;

namespace
{
class HapticWidget : public testing::Test
{
protected:
  HapticWidget()
  {
    SetUpView(this->Window, this->Renderer);
    this->Interactor->SetRenderWindow(this->Window);
    this->Interactor->SetInteractorStyle(this->Style);
    this->AddBall(this->Volume, 0.0);
    this->Counter->SetClientData(&this->Seen);
    this->Counter->SetCallback([](vtkObject*, unsigned long event, void* seen, void*)
      { ++(*static_cast<std::map<unsigned long, int>*>(seen))[event]; });
    // The observer has a higher priority than the style, which grabs all events between a press and
    // its release.
    this->Interactor->AddObserver(vtkCommand::AnyEvent, this->Counter, 0.1f);
    // Values outside the ball are negative, without strength. Inside, the strength exceeds any
    // force of the hand.
    vtkPiecewiseFunction* const strength = this->Widget->GetProperty()->GetSurfaceStrength();
    strength->AddPoint(0.0, 0.0);
    strength->AddPoint(0.1, 8.0);
  }
  ~HapticWidget() override
  {
    this->Widget->SetInteractor(nullptr);
    this->Interactor->SetInteractorStyle(nullptr);
    this->Interactor->RemoveObserver(this->Counter);
  }

  /// Adds a ball with a radius of 30 mm, shifted by `z` along z.
  void AddBall(vtkVolume* volume, double z)
  {
    vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
    mapper->SetInputData(MakeBall());
    volume->SetMapper(mapper);
    volume->SetPosition(0.0, 0.0, z);
    ShowBall(volume);
    this->Renderer->AddVolume(volume);
  }
  void Run(vtkIdType ticks)
  {
    const vtkIdType end = this->Widget->GetDevice()->GetState()->GetTick() + ticks;
    ASSERT_TRUE(Eventually(
      [&]
      {
        this->Widget->UpdateHaptics();
        return this->Widget->GetDevice()->GetState()->GetTick() >= end;
      }));
  }
  void Pointer(int x, int y, unsigned long event = vtkCommand::MouseMoveEvent)
  {
    this->Interactor->SetEventInformation(x, y);
    this->Interactor->InvokeEvent(event);
  }
  /// Presses a key as toolkits do: sends the key, and then the typed character. Returns how many of
  /// these two events reach the program.
  int Press(const char* symbol, char code = '\0', int shift = 0, int control = 0)
  {
    this->Seen.clear();
    this->Interactor->SetKeyEventInformation(control, shift, code, 1, symbol);
    this->Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    this->Interactor->InvokeEvent(vtkCommand::CharEvent);
    return this->Seen[vtkCommand::KeyPressEvent] + this->Seen[vtkCommand::CharEvent];
  }
  int Release(const char* symbol, char code = '\0')
  {
    this->Seen.clear();
    this->Interactor->SetKeyEventInformation(0, 0, code, 1, symbol);
    this->Interactor->InvokeEvent(vtkCommand::KeyReleaseEvent);
    return this->Seen[vtkCommand::KeyReleaseEvent];
  }
  /// Returns how many mouse events of this type reach the program.
  int Count(unsigned long event, int x = 150, int y = 150)
  {
    this->Seen.clear();
    this->Pointer(x, y, event);
    return this->Seen[event];
  }
  void SwitchOn()
  {
    this->Widget->SetInteractor(this->Interactor);
    this->Widget->On();
    ASSERT_TRUE(this->Widget->GetEnabled());
  }
  /// Touches the middle of the view with the key T, and presses into the ball with the wheel.
  void PushIn()
  {
    this->Pointer(150, 150);
    EXPECT_EQ(this->Press("t", 't'), 0);
    EXPECT_EQ(this->Release("t", 't'), 0);
    ASSERT_TRUE(this->Widget->GetTouchMode());
    ASSERT_TRUE(Eventually(
      [this]
      {
        this->Widget->UpdateHaptics();
        return IsFullyArmed(this->Widget->GetDevice());
      }));
    for (int i = 0; i < 4; ++i)
    {
      EXPECT_EQ(this->Count(vtkCommand::MouseWheelForwardEvent), 0);
      this->Run(10);
    }
    this->Run(30);
    ASSERT_GT(this->GetForce(), 0.3) << "N";
  }
  double GetForce() { return Length(this->Widget->GetDevice()->GetState()->GetForce()); }
  void ExpectLetGo()
  {
    EXPECT_FALSE(this->Widget->GetTouchMode());
    EXPECT_TRUE(Eventually(
      [this]
      {
        this->Widget->UpdateHaptics();
        return this->GetForce() == 0.0;
      }));
  }
  /// Returns the camera's position, which changes if the program's style has rotated the camera.
  std::vector<double> GetView()
  {
    const double* const at = this->Renderer->GetActiveCamera()->GetPosition();
    return { at, at + 3 };
  }

  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderWindowInteractor> Interactor;
  vtkNew<vtkInteractorStyleTrackballCamera> Style;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkHapticWidget> Widget;
  vtkNew<vtkCallbackCommand> Counter;
  std::map<unsigned long, int> Seen; ///< number of events by type that have reached the program
  MessageLog Log{ this->Widget };
};

constexpr unsigned long MouseEvents[] = { vtkCommand::MouseMoveEvent,
  vtkCommand::LeftButtonPressEvent, vtkCommand::LeftButtonReleaseEvent,
  vtkCommand::RightButtonPressEvent, vtkCommand::RightButtonReleaseEvent,
  vtkCommand::MiddleButtonPressEvent, vtkCommand::MiddleButtonReleaseEvent,
  vtkCommand::MouseWheelForwardEvent, vtkCommand::MouseWheelBackwardEvent };
} // namespace

TEST_F(HapticWidget, ThreeLinesMakeAProgramTouchable)
{
  this->Widget->SetInteractor(this->Interactor);
  this->Widget->GetProperty()->GetStiffness()->AddPoint(0.0, 500.0);
  this->Widget->On();
  this->PushIn();
  // The ball has a radius of 30 mm. Four steps of the wheel, one voxel (1 mm) each, move the tip
  // below the first contact.
  const double* const tip = this->Widget->GetDevice()->GetState()->GetTipPosition();
  const double* const proxy = this->Widget->GetDevice()->GetState()->GetProxyPosition();
  EXPECT_NEAR(proxy[2], 30.0, 0.1) << "where it is seen";
  EXPECT_LT(tip[2], proxy[2] - 1.0);
  EXPECT_EQ(this->Interactor->GetInteractorStyle(), this->Style.Get()) << "the style lives on";
  EXPECT_EQ(this->Press("Escape", '\x1b'), 0);
  this->ExpectLetGo();
  EXPECT_TRUE(this->Log.Errors.empty());
}

TEST_F(HapticWidget, TheProgramGetsAllButTheActivationKeyWhileNothingIsTouched)
{
  // VTK's style grabs the events between a press and its release, with and without the widget.
  std::vector<int> alone;
  for (const unsigned long event : MouseEvents)
  {
    alone.push_back(this->Count(event));
  }
  this->SwitchOn();
  for (std::size_t i = 0; i < alone.size(); ++i)
  {
    EXPECT_EQ(this->Count(MouseEvents[i]), alone[i])
      << vtkCommand::GetStringFromEventId(MouseEvents[i]);
  }
  for (const char* const key :
    { "Escape", "a", "m", "y", "s", "c", "h", "question", "F1", "space" })
  {
    EXPECT_EQ(this->Press(key), 2) << key;
    EXPECT_EQ(this->Release(key), 1) << key;
  }
  EXPECT_EQ(this->Widget->GetDevice()->GetStatus(), vtkHapticDevice::READY) << "a did not arm";
  this->Widget->KeyPressActivationOff();
  EXPECT_EQ(this->Press("t", 't'), 2);
  EXPECT_FALSE(this->Widget->GetTouchMode());
}

TEST_F(HapticWidget, TheProgramGetsWhatTheTouchDoesNotUse)
{
  this->SwitchOn();
  this->PushIn();
  for (const unsigned long event : MouseEvents)
  {
    // The program must receive presses of the right and the middle button; its style grabs their
    // releases.
    const bool isTheirs =
      event == vtkCommand::RightButtonPressEvent || event == vtkCommand::MiddleButtonPressEvent;
    EXPECT_EQ(this->Count(event), isTheirs ? 1 : 0) << vtkCommand::GetStringFromEventId(event);
  }
  // These keys have no meaning for the hand, or refer to parts that this scene does not have.
  for (const char* const key : { "3", "w", "x", "F2", "c", "k", "plus", "Home", "s", "1", "v",
         "space", "j", "Tab", "Control_L" })
  {
    EXPECT_EQ(this->Press(key), 2) << key;
    EXPECT_EQ(this->Release(key), 1) << key;
  }
  // While a key is held, Qt repeats presses, and X11 repeats releases and presses. None of them may
  // reach the program, even after Escape has ended the touch.
  for (const char* const key : { "h", "g", "d", "F1", "Escape" })
  {
    for (int repeat = 0; repeat < 3; ++repeat)
    {
      EXPECT_EQ(this->Press(key), 0) << key;
      EXPECT_EQ(this->Press(key), 0) << key << " is held";
      EXPECT_EQ(this->Release(key), 0) << key;
    }
  }
  EXPECT_FALSE(this->Widget->GetTouchMode());
}

TEST_F(HapticWidget, TheProgramsDragGoesOnWithItsStyle)
{
  this->SwitchOn();
  this->PushIn();
  const std::vector<double> before = this->GetView();
  const double depth = this->Widget->GetDevice()->GetState()->GetTipPosition()[2];
  this->Pointer(150, 150);
  EXPECT_EQ(this->Count(vtkCommand::MiddleButtonPressEvent), 1);
  this->Pointer(170, 150); // the program pans
  this->Pointer(170, 150, vtkCommand::MiddleButtonReleaseEvent);
  this->Run(10);
  EXPECT_NE(this->GetView(), before);
  EXPECT_NEAR(this->Widget->GetDevice()->GetState()->GetTipPosition()[2], depth, 1e-6);
  const std::vector<double> panned = this->GetView();
  EXPECT_EQ(this->Count(vtkCommand::MouseMoveEvent, 175, 150), 0) << "the hand has the mouse again";
  EXPECT_EQ(this->GetView(), panned);
  // After a press that the hand has consumed, it must also receive the release, even if touch mode
  // has ended meanwhile.
  EXPECT_EQ(this->Count(vtkCommand::LeftButtonPressEvent, 175, 150), 0);
  this->Widget->TouchModeOff();
  EXPECT_EQ(this->Count(vtkCommand::LeftButtonReleaseEvent, 175, 150), 0);
  EXPECT_EQ(this->Count(vtkCommand::LeftButtonPressEvent, 175, 150), 1);
}

TEST_F(HapticWidget, AnotherStyleOfTheProgramEndsNothing)
{
  this->SwitchOn();
  this->PushIn();
  const double before = this->GetForce();
  vtkNew<vtkInteractorStyleImage> other;
  this->Interactor->SetInteractorStyle(other);
  this->Run(20);
  EXPECT_TRUE(this->Widget->GetTouchMode());
  EXPECT_NEAR(this->GetForce(), before, 1e-3);
  EXPECT_EQ(this->Count(vtkCommand::MouseWheelBackwardEvent), 0);
  EXPECT_EQ(this->Press("Escape", '\x1b'), 0);
  this->ExpectLetGo();
}

TEST_F(HapticWidget, OffLeavesTheWindowAsItWas)
{
  const int props = this->Renderer->GetViewProps()->GetNumberOfItems();
  this->SwitchOn();
  EXPECT_EQ(this->Renderer->GetViewProps()->GetNumberOfItems(), props + 2) << "hand and display";
  EXPECT_TRUE(this->Widget->GetDevice()->IsRunning());
  this->PushIn();
  this->Widget->Off();
  EXPECT_FALSE(this->Widget->GetTouchMode());
  EXPECT_EQ(this->Renderer->GetViewProps()->GetNumberOfItems(), props);
  EXPECT_FALSE(this->Widget->GetDevice()->IsRunning());
  EXPECT_FALSE(this->Widget->GetDevice()->IsOpen());
  EXPECT_EQ(this->GetForce(), 0.0);
  EXPECT_EQ(this->Count(vtkCommand::MouseWheelForwardEvent), 1);
  EXPECT_EQ(this->Press("Escape"), 2);
  // The activation key must switch the widget on again, as for VTK's widgets.
  this->Pointer(150, 150);
  this->Press("t", 't');
  EXPECT_TRUE(this->Widget->GetEnabled());
  EXPECT_TRUE(this->Widget->GetTouchMode());
}

// f3d's renderer has a render pass that caches its list of props until its MTime changes.
TEST_F(HapticWidget, TellsARenderPassOfTheProgramOfTheHand)
{
  vtkNew<vtkSequencePass> pass;
  this->Renderer->SetPass(pass);
  const vtkMTimeType before = pass->GetMTime();
  this->SwitchOn();
  const vtkMTimeType on = pass->GetMTime();
  EXPECT_GT(on, before);
  this->Widget->UpdateHaptics();
  EXPECT_EQ(pass->GetMTime(), on) << "only when the hand comes or goes";
  this->Widget->Off();
  EXPECT_GT(pass->GetMTime(), on);
  this->Renderer->SetPass(nullptr);
}

TEST_F(HapticWidget, EndsWithTheInteractorAndWithoutOne)
{
  this->SwitchOn();
  this->PushIn();
  this->Widget->SetInteractor(nullptr);
  EXPECT_FALSE(this->Widget->GetEnabled());
  this->ExpectLetGo();
  this->Widget->On();
  EXPECT_FALSE(this->Widget->GetEnabled());
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("SetInteractor()"), std::string::npos);
  this->Widget->SetInteractor(this->Interactor);
  this->Widget->On(); // the remedy
  EXPECT_TRUE(this->Widget->GetEnabled());
}

TEST_F(HapticWidget, TouchesTheFirstOfSeveralVolumes)
{
  vtkNew<vtkVolume> front;
  this->AddBall(front, 40.0);
  this->SwitchOn();
  this->PushIn();
  EXPECT_NEAR(this->Widget->GetDevice()->GetState()->GetProxyPosition()[2], 70.0, 0.1);
  this->Widget->TouchModeOff();
  this->ExpectLetGo();
  this->Widget->SetVolume(this->Volume);
  this->PushIn();
  EXPECT_NEAR(this->Widget->GetDevice()->GetState()->GetProxyPosition()[2], 30.0, 0.1);
  this->Widget->TouchModeOff();
  this->ExpectLetGo();
  this->Widget->SetVolume(nullptr);
  front->VisibilityOff();
  this->PushIn();
  EXPECT_NEAR(this->Widget->GetDevice()->GetState()->GetProxyPosition()[2], 30.0, 0.1);
}

TEST_F(HapticWidget, WaitsForAVolumeAndTellsIfThereIsNone)
{
  this->Renderer->RemoveVolume(this->Volume);
  this->SwitchOn();
  EXPECT_TRUE(this->Log.Errors.empty());
  this->Pointer(150, 150);
  this->Press("t", 't');
  this->Release("t", 't');
  EXPECT_FALSE(this->Widget->GetTouchMode());
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("add a visible vtkVolume"), std::string::npos);
  this->Renderer->AddVolume(this->Volume); // the remedy
  this->PushIn();
}

TEST_F(HapticWidget, TakesKeysThatHaveCodesAndNoNames)
{
  // VTK's wxVTKRenderWindowInteractor sends no key symbol. Its key code is GetKeyCode() of
  // wxKeyEvent, which is an upper-case letter even without Shift.
  this->SwitchOn();
  this->Pointer(150, 150);
  EXPECT_EQ(this->Press(nullptr, 'T'), 0);
  EXPECT_EQ(this->Release(nullptr, 'T'), 0);
  EXPECT_TRUE(this->Widget->GetTouchMode());
  // End and F1 have codes above 255 in wx, so these keys never arrive.
  const std::string listed = this->Widget->GetStyle()->GetKeys();
  EXPECT_NE(listed.find("Escape\t"), std::string::npos);
  EXPECT_NE(listed.find("?\t"), std::string::npos);
  EXPECT_EQ(listed.find("End"), std::string::npos);
  EXPECT_EQ(listed.find("F1"), std::string::npos);
  EXPECT_EQ(this->Press(nullptr, '/', 1), 0); // the key of ? on a US keyboard
  EXPECT_TRUE(this->Widget->GetHeadUpDisplay()->GetHelpVisibility());
  EXPECT_EQ(this->Press(nullptr, 'X'), 2);
  EXPECT_EQ(this->Press(nullptr, '\x1b'), 0);
  this->ExpectLetGo();
}

TEST_F(HapticWidget, LetsGoByASecondKeyWhereAToolkitKeepsEscape)
{
  // Mayavi's scene handles Escape before VTK does, so the key End must end the touch.
  this->SwitchOn();
  this->PushIn();
  EXPECT_EQ(this->Press("End"), 0);
  this->ExpectLetGo();
}

TEST_F(HapticWidget, TakesACapitalLetterAgainWhoseShiftWasReleasedFirst)
{
  // The key release has the lower-case name if Shift was released first.
  this->SwitchOn();
  this->PushIn();
  ASSERT_TRUE(this->Widget->GetStyle()->SetKey("Graph", "G"));
  const bool isShown = this->Widget->GetHeadUpDisplay()->GetPlotVisibility();
  EXPECT_EQ(this->Press("G", 'G', 1), 0);
  EXPECT_NE(this->Widget->GetHeadUpDisplay()->GetPlotVisibility(), isShown);
  EXPECT_EQ(this->Release("g", 'g'), 0);
  EXPECT_EQ(this->Press("G", 'G', 1), 0);
  EXPECT_EQ(this->Widget->GetHeadUpDisplay()->GetPlotVisibility(), isShown);
}

TEST_F(HapticWidget, TakesAKeyAgainWhoseCtrlWasReleasedFirst)
{
  this->SwitchOn();
  this->PushIn();
  this->Interactor->SetControlKey(1);
  EXPECT_EQ(this->Press("t", '\x14', 0, 1), 0);
  this->ExpectLetGo();
  EXPECT_EQ(this->Release("t", 't'), 0) << "the program has not got the press";
  EXPECT_EQ(this->Release("t", 't'), 1) << "nothing is held any more";
}

TEST_F(HapticWidget, BeginsAgainIfTheReleaseOfItsKeyWasLost)
{
  this->SwitchOn();
  this->Pointer(150, 150);
  EXPECT_EQ(this->Press("t", 't'), 0);
  EXPECT_TRUE(this->Widget->GetTouchMode());
  // ends the touch as for a hidden view, without a key release
  this->Widget->GetStyle()->FadeOut();
  EXPECT_EQ(this->Press("t", 't'), 0);
  EXPECT_TRUE(this->Widget->GetTouchMode());
}

TEST_F(HapticWidget, TellsThatTimersAreMissingAndGoesOnWithoutThem)
{
  MessageLog told(this->Widget->GetStyle());
  this->SwitchOn();
  this->Pointer(150, 150);
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Pointer(150, 150);
      return !told.Warnings.empty();
    }));
  EXPECT_NE(told.Warnings[0].find("Cure: call DrawHaptics()"), std::string::npos);
  this->Press("t", 't');
  this->Release("t", 't');
  ASSERT_TRUE(this->Widget->GetTouchMode());
  int steps = 0;
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Window->Render(); // draws as the program does
      const bool isArmed = IsFullyArmed(this->Widget->GetDevice());
      if (isArmed && steps < 5)
      {
        ++steps;
        this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
      }
      return this->GetForce() > 0.3;
    }));
  EXPECT_EQ(told.Warnings.size(), 1U);
  // from now on, the program calls DrawHaptics(), as the warning suggests
  this->Widget->GetStyle()->DrawHaptics();
  const vtkIdType tick = this->Widget->GetDevice()->GetState()->GetTick();
  this->Window->Render();
  EXPECT_EQ(this->Widget->GetDevice()->GetState()->GetTick(), tick);
  this->Press("Escape");
  this->ExpectLetGo();
}

TEST_F(HapticWidget, TellsThatTimersAreMissingInAProgramThatOnlyDraws)
{
  MessageLog told(this->Widget->GetStyle());
  this->SwitchOn();
  ASSERT_TRUE(Eventually(
    [&]
    {
      // draws in the program's own loop, as with a haptic device without a mouse
      this->Window->Render();
      return !told.Warnings.empty();
    }));
  EXPECT_NE(told.Warnings[0].find("Cure: call DrawHaptics()"), std::string::npos);
  const vtkIdType tick = this->Widget->GetDevice()->GetState()->GetTick();
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Window->Render();
      return this->Widget->GetDevice()->GetState()->GetTick() > tick;
    }));
  EXPECT_EQ(told.Warnings.size(), 1U);
}

TEST_F(HapticWidget, HasAnotherKeyAndADeviceOfTheProgram)
{
  vtkNew<vtkHapticDevice> device;
  ASSERT_TRUE(device->Open("virtual"));
  this->Widget->SetDevice(device);
  this->Widget->SetKeyPressActivationValue('w');
  this->SwitchOn();
  EXPECT_TRUE(device->IsRunning());
  this->Pointer(150, 150);
  EXPECT_EQ(this->Press("t", 't'), 2);
  EXPECT_EQ(this->Press("w", 'w'), 0);
  EXPECT_TRUE(this->Widget->GetTouchMode());
  this->Widget->Off();
  EXPECT_TRUE(device->IsOpen()) << "the program has opened it";
  EXPECT_FALSE(device->IsRunning());
}

TEST_F(HapticWidget, HasTheSlicesBesideTheScene)
{
  this->SwitchOn();
  vtkNew<vtkHapticSliceView> slices;
  slices->SetDevice(this->Widget->GetDevice());
  slices->SetRenderWindow(this->Window);
  this->Widget->GetStyle()->SetSliceView(slices);
  this->Window->Render();
  ASSERT_GE(slices->FindSlice(270, 250), 0);
  EXPECT_EQ(this->Count(vtkCommand::LeftButtonPressEvent, 100, 150), 1) << "the scene's";
  this->Count(vtkCommand::LeftButtonReleaseEvent, 100, 150);
  EXPECT_EQ(this->Count(vtkCommand::MouseWheelForwardEvent, 270, 250), 0);
  EXPECT_EQ(this->Count(vtkCommand::LeftButtonPressEvent, 270, 250), 0);
  EXPECT_EQ(this->Count(vtkCommand::LeftButtonReleaseEvent, 270, 250), 0);
  EXPECT_TRUE(this->Widget->GetTouchMode()) << "a click goes there";
}

TEST_F(HapticWidget, FeelsWhatTheProgramHasConnected)
{
  // A program may display an isosurface of the image without a volume.
  this->Renderer->RemoveVolume(this->Volume);
  this->Widget->GetVolumeHaptics()->SetInputData(0, MakeBall());
  this->Widget->SetDefaultRenderer(this->Renderer);
  this->SwitchOn();
  EXPECT_TRUE(this->Renderer->HasViewProp(this->Widget->GetRepresentation()));
  this->PushIn();
  EXPECT_NEAR(this->Widget->GetDevice()->GetState()->GetProxyPosition()[2], 30.0 + 2.0, 1.5);
  this->Press("Escape");
  this->ExpectLetGo();
  EXPECT_TRUE(this->Log.Errors.empty());
  // The widget has selected the volume itself, so it may select another one.
  this->Renderer->AddVolume(this->Volume);
  vtkNew<vtkVolumeHapticsFilter> other;
  other->GetProperty()->DeepCopy(this->Widget->GetProperty());
  this->Widget->SetVolumeHaptics(other);
  this->PushIn();
  EXPECT_EQ(this->Widget->GetStyle()->GetTouchedVolume(), this->Volume.Get());
  this->Widget->Off();
  this->Volume->SetPosition(0.0, 0.0, -10.0);
  this->Widget->On();
  this->Press("Escape");
  this->PushIn();
  EXPECT_NEAR(this->Widget->GetDevice()->GetState()->GetProxyPosition()[2], 20.0, 0.1);
}

TEST_F(HapticWidget, TellsWhatIsMissingWithTheCure)
{
  const auto expectTold = [this](const char* cure)
  {
    ASSERT_EQ(this->Log.Errors.size(), 1U) << cure;
    EXPECT_NE(this->Log.Errors[0].find(cure), std::string::npos) << this->Log.Errors[0];
    this->Log.Errors.clear();
  };
  this->Widget->SetDevice(nullptr);
  expectTold("needs a device");
  EXPECT_NE(this->Widget->GetDevice(), nullptr);
  this->Widget->SetVolumeHaptics(nullptr);
  expectTold("needs a filter");
  EXPECT_NE(this->Widget->GetVolumeHaptics(), nullptr);
  this->Widget->SetInteractor(this->Interactor);
  this->Widget->TouchModeOn();
  expectTold("Cure: On()");
  vtkNew<vtkVolume> other;
  this->Widget->SetVolume(other);
  this->Widget->On();
  this->Widget->TouchModeOn();
  expectTold("of a renderer of the window");
  EXPECT_FALSE(this->Widget->GetTouchMode());
  this->AddBall(other, 0.0); // the remedy
  this->PushIn();
}
