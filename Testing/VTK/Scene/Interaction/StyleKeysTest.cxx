// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests keys of the style that an application has changed. The documentation of vtkInteractorStyle
 * defines the expected actions of VTK's own keys: r resets the camera.
 */

#include "StyleRig.h"

#include <vtkAbstractPicker.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticMeasurements.h>
#include <vtkObjectFactory.h>
#include <vtkStringArray.h>

#include <set>
#include <sstream>

using namespace scenetest;

namespace
{
class StyleKeys : public StyleTest
{
protected:
  StyleKeys()
  {
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
  }
  void Start()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Pointer(150, 150);
  }
  bool Lists(const std::string& line)
  {
    return ("\n" + this->Style->GetKeys()).find("\n" + line) != std::string::npos;
  }
  void Type(const char* key)
  {
    this->Press(key);
    this->Interactor->SetKeyCode(key[0]);
    this->Press(key, vtkCommand::CharEvent);
  }

  bool Says(const std::string& words)
  {
    return !this->Log.Errors.empty() && this->Log.Errors.back().find(words) != std::string::npos;
  }

  void Control(const char* symbol, char code)
  {
    this->Interactor->SetControlKey(1);
    this->Interactor->SetKeyCode(code);
    this->Press(symbol);
    this->Interactor->SetControlKey(0);
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
};

/// A style of an application that implements its own arming.
class AskedStyle : public vtkInteractorStyleHaptic
{
public:
  static AskedStyle* New();
  vtkTypeMacro(AskedStyle, vtkInteractorStyleHaptic);
  using vtkInteractorStyleHaptic::IsPressOf;
};
vtkStandardNewMacro(AskedStyle);
} // namespace

TEST_F(StyleKeys, AreThoseThatAnApplicationChose)
{
  this->Start();
  EXPECT_EQ(this->Style->GetKey("Touch"), "t");
  EXPECT_TRUE(this->Style->SetKey("Touch", "r Return"));
  this->Type("t");
  EXPECT_FALSE(this->Style->GetTouchMode());
  double before[3];
  this->Renderer->GetActiveCamera()->GetPosition(before);
  this->Type("r");
  EXPECT_TRUE(this->Style->GetTouchMode());
  double after[3];
  this->Renderer->GetActiveCamera()->GetPosition(after);
  EXPECT_TRUE(std::equal(before, before + 3, after)) << "VTK's own r would move it";
  this->Type("Return");
  EXPECT_FALSE(this->Style->GetTouchMode());
  this->Run(2);
  EXPECT_NE(std::string(this->Display->GetHint()).find("press r to touch"), std::string::npos)
    << this->Display->GetHint();
  EXPECT_TRUE(this->Lists("r  Return\ttouch what is under the pointer"));
}

TEST_F(StyleKeys, AreLeftToVTKWithoutAKeyOfOurs)
{
  this->Start();
  EXPECT_TRUE(this->Style->SetKey("NextMethod", ""));
  const std::string method = this->Filter->GetMethodName();
  this->Press("m");
  EXPECT_EQ(method, this->Filter->GetMethodName());
  EXPECT_FALSE(this->Lists("m\t"));
  EXPECT_TRUE(this->Style->SetKey("NextMethod", "m"));
  this->Press("m");
  EXPECT_NE(method, this->Filter->GetMethodName());
  EXPECT_TRUE(this->Lists("m\t"
                          "the next method"));
}

TEST_F(StyleKeys, MoveWithTheirWordsOnTheScreen)
{
  this->Start();
  EXPECT_TRUE(this->Style->SetKey("Help", "F2"));
  EXPECT_TRUE(this->Style->SetKey("LetGo", ""));
  this->Run(2);
  EXPECT_NE(std::string(this->Display->GetHint()).find("\nF2 shows all keys"), std::string::npos);
  this->Press("F1");
  EXPECT_FALSE(this->Display->GetHelpVisibility());
  this->Press("F2");
  EXPECT_TRUE(this->Display->GetHelpVisibility());
  this->Press("t");
  this->Press("Escape");
  EXPECT_TRUE(this->Style->GetTouchMode());
  this->Run(2);
  EXPECT_STREQ(this->Display->GetHint(), "Move the mouse to stroke, turn the wheel to press");
}

TEST_F(StyleKeys, NobodyHasTwoActions)
{
  EXPECT_FALSE(this->Style->SetKey("Touch", "a"));
  EXPECT_TRUE(this->Says("belongs to the action Arm already"));
  EXPECT_EQ(this->Style->GetKey("Touch"), "t");
  EXPECT_TRUE(this->Style->SetKey("Arm", ""));
  EXPECT_TRUE(this->Style->SetKey("Touch", "a"));
  EXPECT_FALSE(this->Style->SetKey("Jump", "j"));
  EXPECT_TRUE(this->Says("no action \"Jump\""));
  EXPECT_FALSE(this->Style->SetKey(nullptr, nullptr));
}

TEST_F(StyleKeys, AreAllDifferentByDefault)
{
  std::set<std::string> keys;
  std::size_t count = 0;
  vtkStringArray* const actions = vtkInteractorStyleHaptic::GetKeyActions();
  for (vtkIdType i = 0; i < actions->GetNumberOfValues(); ++i)
  {
    std::istringstream words(this->Style->GetKey(actions->GetValue(i).c_str()));
    for (std::string key; words >> key; ++count)
    {
      keys.insert(key);
    }
  }
  EXPECT_GE(actions->GetNumberOfValues(), 20);
  EXPECT_EQ(keys.size(), count);
}

TEST_F(StyleKeys, NeedNoCapitals)
{
  // While Caps Lock is on, keys have upper-case names.
  this->Start();
  this->Press("T");
  EXPECT_TRUE(this->Style->GetTouchMode());
  this->Press("T");
  EXPECT_FALSE(this->Style->GetTouchMode());
  vtkStringArray* const actions = vtkInteractorStyleHaptic::GetKeyActions();
  for (vtkIdType i = 0; i < actions->GetNumberOfValues(); ++i)
  {
    const std::string keys = this->Style->GetKey(actions->GetValue(i).c_str());
    EXPECT_FALSE(keys.size() == 1 && keys[0] >= 'A' && keys[0] <= 'Z') << keys;
  }
  // An upper-case letter that an application has assigned to a command is distinct from the
  // lower-case key.
  EXPECT_TRUE(this->Style->SetKey("Graph", "T"));
  const auto hasPlot = this->Display->GetPlotVisibility();
  this->Press("T");
  EXPECT_FALSE(this->Style->GetTouchMode());
  EXPECT_NE(hasPlot, this->Display->GetPlotVisibility());
}

TEST_F(StyleKeys, AreOthersWithCtrlButThoseThatLetGo)
{
  this->Start();
  vtkNew<vtkHapticMeasurements> list;
  this->Style->SetMeasurements(list);
  const double x[3] = { 1.0, 2.0, 3.0 };
  list->AddPoint(x);
  this->Control("z", '\x1a');
  EXPECT_EQ(list->GetNumberOfMeasurements(), 0);
  this->Control("y", '\x19');
  EXPECT_EQ(list->GetNumberOfMeasurements(), 1);
  this->Control(nullptr, '\x1a'); // sent by a toolkit that reports codes only
  EXPECT_EQ(list->GetNumberOfMeasurements(), 0);
  this->Control("t", '\x14');
  EXPECT_FALSE(this->Style->GetTouchMode());
  this->Press("t");
  EXPECT_TRUE(this->Style->GetTouchMode());
  this->Control("Escape", '\x1b'); // sent while the mouse with Ctrl moves the tip in depth
  EXPECT_FALSE(this->Style->GetTouchMode());
}

TEST_F(StyleKeys, OfTheHandWorkWhileCtrlAndTheMousePress)
{
  vtkNew<vtkHapticMeasurements> list;
  this->Style->SetMeasurements(list);
  this->PushIn();
  this->Control("1", '1');
  EXPECT_EQ(list->GetNumberOfMeasurements(), 1);
  this->Control("m", '\r'); // with Ctrl, this key belongs to the application
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::PROXY);
  this->Control("a", '\x01');
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetStatus() == vtkHapticDevice::READY;
    }));
  this->Control("t", '\x14');
  EXPECT_FALSE(this->Style->GetTouchMode());
}

TEST_F(StyleKeys, AreKnownToAStyleThatArmsInItsOwnWay)
{
  vtkNew<AskedStyle> style;
  this->Interactor->SetInteractorStyle(style);
  for (const char* const arm : { "a", "A" })
  {
    this->Interactor->SetKeySym(arm);
    EXPECT_TRUE(style->IsPressOf("Arm")) << arm;
    EXPECT_FALSE(style->IsPressOf("Touch"));
  }
  style->SetKey("Arm", "");
  EXPECT_FALSE(style->IsPressOf("Arm"));
}

TEST_F(StyleKeys, WithCtrlHaveSmallLettersOrCapitals)
{
  this->Start();
  vtkNew<vtkHapticMeasurements> list;
  this->Style->SetMeasurements(list);
  const double x[3] = { 1.0, 2.0, 3.0 };
  list->AddPoint(x);
  EXPECT_TRUE(this->Style->SetKey("Undo", "Ctrl+U"));
  EXPECT_FALSE(this->Style->SetKey("Redo", "Ctrl+u"));
  this->Control("u", '\x15');
  EXPECT_EQ(list->GetNumberOfMeasurements(), 0);
}

TEST_F(StyleKeys, OfVTKThatFlyTheCameraAreKeptFromItWithCapsLock)
{
  // VTK's keys pick the target of the camera's flight, so the test counts picks.
  int picks = 0;
  vtkNew<vtkCallbackCommand> note;
  note->SetClientData(&picks);
  note->SetCallback(
    [](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  this->Interactor->GetPicker()->AddObserver(vtkCommand::StartPickEvent, note);
  this->PushIn();
  this->Type("f");
  this->Type("F");
  EXPECT_EQ(picks, 0);
  this->Style->TouchModeOff();
  this->Type("F");
  EXPECT_EQ(picks, 1);
}

TEST_F(StyleKeys, AreNotNeededByAProgramWithButtons)
{
  this->Start();
  EXPECT_TRUE(this->Style->PerformAction("Touch"));
  EXPECT_TRUE(this->Style->GetTouchMode());
  EXPECT_TRUE(this->Style->PerformAction("LetGo"));
  EXPECT_FALSE(this->Style->GetTouchMode());
  EXPECT_EQ(this->Style->GetActionText("NextMethod"), "the next method");
  EXPECT_EQ(vtkInteractorStyleHaptic::GetActionGroup("NextMethod"), "Touch");
  EXPECT_EQ(this->Style->GetActionText("Point"), ""); // there is no list of measurements
  EXPECT_FALSE(this->Style->PerformAction("Point"));
  EXPECT_EQ(this->Style->GetActionText("Jump"), "");
  EXPECT_FALSE(this->Style->PerformAction("Jump"));
  EXPECT_FALSE(this->Style->PerformAction(nullptr));
}
