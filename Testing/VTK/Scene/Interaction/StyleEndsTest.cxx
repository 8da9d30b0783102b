// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests windows that close while the hand presses. The force must be 0 when the loop has ended,
 * before anything is deleted. Every test runs its loop to the end, because VTK 9.1's X11
 * interactors otherwise leave a dangling pointer in the list that every loop traverses.
 */

#include "StyleRig.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <iterator>
#include <utility>

using namespace scenetest;

namespace
{
class StyleEnds : public StyleTest
{
protected:
  StyleEnds() { this->Window->SetOffScreenRendering(0); }

  /// Runs the loop, and presses into the ball until a force acts. Then calls `act` once.
  void PushUntilHeld(std::function<void()> act)
  {
    this->Window->Render();
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Pointer(150, 150);
    this->Style->TouchModeOn();
    this->Act = std::move(act);
    vtkNew<vtkCallbackCommand> watch;
    watch->SetClientData(this);
    watch->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*) { static_cast<StyleEnds*>(self)->Watch(); });
    this->Style->AddObserver(vtkInteractorStyleHaptic::StatesEvent, watch);
    this->Interactor->Start();
    EXPECT_FALSE(this->Act) << "the loop ended before anything was felt";
  }
  /// Moves the tip in and out. After a pause of a busy machine, the servo starts again at the tip,
  /// so only a new contact causes a force.
  void Watch()
  {
    const bool goesIn = this->Updates++ % 20 < 10;
    this->Pointer(
      150, 150, goesIn ? vtkCommand::MouseWheelForwardEvent : vtkCommand::MouseWheelBackwardEvent);
    if (this->Act && goesIn && Length(this->Device->GetState()->GetForce()) > 0.5)
    {
      std::exchange(this->Act, nullptr)();
    }
  }
  void ExpectNoForce()
  {
    EXPECT_TRUE(Eventually(
      [this]
      {
        this->Device->UpdateState();
        return Length(this->Device->GetState()->GetForce()) == 0.0;
      }));
    EXPECT_LT(this->Device->GetStatus(), vtkHapticDevice::ARMED) << this->Device->GetStatusText();
    EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::FAULT) << this->Device->GetStatusText();
    EXPECT_TRUE(this->Device->IsRunning());
  }
  /// Expects that the force of a hidden view fades to 0, and then ends the loop.
  void ExpectFadeOut()
  {
    this->Style->RemoveObservers(vtkInteractorStyleHaptic::StatesEvent);
    EXPECT_TRUE(Eventually(
      [this]
      {
        this->Style->UpdateHaptics();
        return Length(this->Device->GetState()->GetForce()) == 0.0;
      }));
    EXPECT_FALSE(this->Style->GetTouchMode());
    EXPECT_FALSE(this->Device->IsArmOrdered());
    this->Interactor->TerminateApp();
  }
  void TypeQ()
  {
    this->Interactor->SetKeyCode('q');
    this->Press("q");
    this->Interactor->InvokeEvent(vtkCommand::CharEvent);
  }

  std::function<void()> Act;
  int Updates = 0;
};
} // namespace

TEST_F(StyleEnds, WithTheKeyThatEndsTheLoop)
{
  this->PushUntilHeld([this] { this->TypeQ(); });
  this->ExpectNoForce();
  EXPECT_FALSE(this->Style->GetTouchMode());
  EXPECT_FALSE(this->Window->GetMapped()) << "a late frame has opened another window";
}

TEST_F(StyleEnds, WithALoopThatTheApplicationEnds)
{
  this->PushUntilHeld([this] { this->Interactor->TerminateApp(); });
  this->ExpectNoForce();
  EXPECT_FALSE(this->Window->GetMapped()) << "a late frame has opened another window";
}

TEST_F(StyleEnds, WithALoopThatAKeyOfTheApplicationEnds)
{
  vtkNew<vtkCallbackCommand> end;
  end->SetCallback(
    [](vtkObject* interactor, unsigned long, void*, void*)
    {
      static_cast<vtkRenderWindowInteractor*>(interactor)->SetDone(true);
    }); // ends the loop as TerminateApp() does since VTK 9.2
  this->Interactor->AddObserver(vtkCommand::KeyPressEvent, end, -1.0f);
  this->PushUntilHeld(
    [this]
    {
      this->Style->RemoveObservers(vtkInteractorStyleHaptic::StatesEvent);
      this->Press("x");
      this->ExpectNoForce();
    });
}

TEST_F(StyleEnds, WithTheWindow)
{
  this->PushUntilHeld(
    [this]
    {
      this->Window->Finalize();
      // A late frame would open a window on the screen again, so switch the window to off-screen
      // rendering.
      this->Window->SetOffScreenRendering(1);
      this->Style->RemoveObservers(vtkInteractorStyleHaptic::StatesEvent);
      this->ExpectNoForce();
      // End the loop without TerminateApp(), which writes to the closed window in VTK 9.1.
      this->Interactor->SetDone(true);
    });
  this->ExpectNoForce();
}

TEST_F(StyleEnds, WithAWindowThatIsHidden)
{
  this->PushUntilHeld(
    [this]
    {
      // like minimising the window, which would need a window manager
      this->Window->SetShowWindow(false);
      this->ExpectFadeOut();
    });
}

TEST_F(StyleEnds, WithAWindowAroundItThatIsHidden)
{
  // Views of Tk and wx are inside a parent window. Hide such a parent.
  vtkNew<vtkRenderWindow> outer;
  outer->SetSize(320, 320);
  outer->Render();
  this->Window->SetParentId(outer->GetGenericWindowId());
  this->PushUntilHeld(
    [&]
    {
      outer->SetShowWindow(false);
      this->ExpectFadeOut();
    });
}

TEST_F(StyleEnds, WithTheRenderer)
{
  this->PushUntilHeld(
    [this]
    {
      this->Style->RemoveObservers(vtkInteractorStyleHaptic::StatesEvent);
      // removes the renderer, to which the style still refers
      this->Window->RemoveRenderer(this->Renderer);
      this->Style->UpdateHaptics();
      EXPECT_FALSE(this->Style->GetTouchMode());
      this->ExpectNoForce();
      this->Interactor->TerminateApp();
    });
  this->ExpectNoForce();
}

TEST_F(StyleEnds, WithARendererThatIsDeleted)
{
  // Only the window holds a reference to the touched renderer.
  vtkSmartPointer<vtkRenderer> other = vtkSmartPointer<vtkRenderer>::New();
  other->SetActiveCamera(this->Renderer->GetActiveCamera());
  this->Style->SetDefaultRenderer(nullptr);
  this->Style->SetCurrentRenderer(nullptr);
  this->Window->RemoveRenderer(this->Renderer);
  this->Window->AddRenderer(other);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->InteractiveOff();
  this->PushUntilHeld(
    [&]
    {
      this->Style->RemoveObservers(vtkInteractorStyleHaptic::StatesEvent);
      this->Style->UpdateHaptics();
      this->Window->RemoveRenderer(other);
      other = nullptr;
      this->Style->SetCurrentRenderer(nullptr);
      this->Style->UpdateHaptics();
      EXPECT_FALSE(this->Style->GetTouchMode());
      this->ExpectNoForce();
      this->Interactor->TerminateApp();
    });
  this->ExpectNoForce();
}

TEST_F(StyleEnds, WithTheInteractorsDisabling)
{
  this->PushUntilHeld(
    [this]
    {
      this->Interactor->Disable();
      this->ExpectNoForce();
      this->Interactor->TerminateApp();
    });
  this->ExpectNoForce();
}

TEST_F(StyleEnds, BeforeTheApplicationHearsOfAnExit)
{
  // The application asks whether to quit, so the loop must continue without force.
  struct Question
  {
    vtkHapticDevice* Device;
    int Asked = 0;
    int Status = vtkHapticDevice::ARMED;
  } question{ this->Device };
  vtkNew<vtkCallbackCommand> ask;
  ask->SetClientData(&question);
  ask->SetCallback(
    [](vtkObject*, unsigned long, void* data, void*)
    {
      auto* const asked = static_cast<Question*>(data);
      ++asked->Asked;
      asked->Device->UpdateState();
      asked->Status = asked->Device->GetStatus();
    });
  this->Interactor->AddObserver(vtkCommand::ExitEvent, ask, 100.0f);
  this->PushUntilHeld(
    [&]
    {
      this->TypeQ();
      this->TypeQ();
      EXPECT_EQ(question.Asked, 2);
      this->ExpectNoForce();
      EXPECT_FALSE(this->Interactor->GetDone());
      EXPECT_TRUE(this->Window->GetMapped());
      this->Interactor->TerminateApp();
    });
}

TEST_F(StyleEnds, WhereTwoStylesListen)
{
  vtkNew<vtkInteractorStyleHaptic> other;
  other->SetInteractor(this->Interactor);
  this->PushUntilHeld([this] { this->TypeQ(); });
  this->ExpectNoForce();
  other->SetInteractor(nullptr);
}

TEST_F(StyleEnds, AndBeginsAnewInTheNextLoop)
{
  this->PushUntilHeld([this] { this->TypeQ(); });
  this->ExpectNoForce();
  this->Style->RemoveObservers(vtkInteractorStyleHaptic::StatesEvent);
  this->Window->Render(); // reopens the window
  this->Style->TouchModeOn();
  ASSERT_TRUE(this->Style->GetTouchMode());
  this->Run(20);
  EXPECT_GE(this->Device->GetStatus(), vtkHapticDevice::ARMED);
  this->Window->Finalize();
  this->ExpectNoForce();
}

TEST_F(StyleEnds, WhereItIsDeletedByWhatHearsOfIt)
{
  // The application removes and deletes the style as soon as the device is disarmed.
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkWeakPointer<vtkInteractorStyleHaptic> weak;
  {
    vtkNew<vtkInteractorStyleHaptic> style;
    style->SetDevice(this->Device);
    interactor->SetInteractorStyle(style);
    weak = style;
  }
  vtkNew<vtkCallbackCommand> leave;
  leave->SetClientData(interactor);
  leave->SetCallback([](vtkObject*, unsigned long, void* interactor, void*)
    { static_cast<vtkRenderWindowInteractor*>(interactor)->SetInteractorStyle(nullptr); });
  window->Render();
  this->PushUntilHeld(
    [&]
    {
      weak->UpdateHaptics();
      this->Device->AddObserver(vtkCommand::DisableEvent, leave);
      window->Finalize();
      EXPECT_FALSE(weak);
      this->ExpectNoForce();
      this->Device->RemoveObserver(leave);
      interactor->SetDone(true);
      this->Interactor->TerminateApp();
    });
}

TEST_F(StyleEnds, WithTheConnectionToTheServer)
{
  // Opens windows in sequence, and renders each before it has an interactor. Connections to the X
  // server must not leak.
  const auto countOpenFiles = []
  {
    using Files = std::filesystem::directory_iterator;
    return std::distance(Files("/proc/self/fd"), Files());
  };
  vtkNew<vtkCallbackCommand> end;
  end->SetCallback([](vtkObject* interactor, unsigned long, void*, void*)
    { static_cast<vtkRenderWindowInteractor*>(interactor)->ExitCallback(); });
  std::ptrdiff_t afterTwo = 0;
  constexpr int most = 12;
  for (int i = 0; i < most; ++i)
  {
    vtkNew<vtkRenderWindow> window;
    vtkNew<vtkRenderer> renderer;
    window->SetSize(40, 40);
    window->AddRenderer(renderer);
    window->Render();
    vtkNew<vtkRenderWindowInteractor> interactor;
    interactor->SetRenderWindow(window);
    vtkNew<vtkInteractorStyleHaptic> style;
    interactor->SetInteractorStyle(style);
    interactor->AddObserver(vtkCommand::TimerEvent, end);
    interactor->Start();
    interactor->SetInteractorStyle(nullptr);
    afterTwo = i < 2 ? countOpenFiles() : afterTwo;
  }
  EXPECT_LE(countOpenFiles(), afterTwo + 2);
}
