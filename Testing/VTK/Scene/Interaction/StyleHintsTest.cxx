// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the hints and the list of keys that the style displays to a new user. */

#include "StyleRig.h"

#include <vtkHapticFunctionEditor.h>
#include <vtkHapticHeadUpDisplay.h>

using namespace scenetest;

namespace
{
class StyleHints : public StyleTest
{
protected:
  StyleHints()
  {
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
  }
  /**
   * Returns whether the hint contains these words; without words, returns whether there is no hint.
   */
  bool Hints(const std::string& words)
  {
    const std::string hint = this->Display->GetHint();
    return words.empty() ? hint.empty() : hint.find(words) != std::string::npos;
  }
  bool Lists(const std::string& words)
  {
    const std::string text = this->Display->GetHelpText();
    return this->Display->GetHelpVisibility() && text.find(words) != std::string::npos;
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<vtkHapticFunctionEditor> Editor;
};
} // namespace

TEST_F(StyleHints, SayWhatToDoUntilItWasDone)
{
  this->Style->UpdateHaptics();
  EXPECT_TRUE(this->Hints("")) << "there is no device";
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Run(2);
  EXPECT_TRUE(this->Hints("press t")) << this->Display->GetHint();
  this->Pointer(150, 150);
  this->Press("t");
  this->Run(2);
  EXPECT_TRUE(this->Hints("turn the wheel to press")) << this->Display->GetHint();
  this->RunUntilFullyArmed();
  for (int i = 0; i < 4; ++i)
  {
    this->Pointer(150, 150, vtkCommand::MouseWheelForwardEvent);
    this->Run(10);
  }
  ASSERT_NE(this->Device->GetState()->GetContact(), 0);
  EXPECT_TRUE(this->Hints("")) << this->Display->GetHint();
  EXPECT_EQ(std::string(this->Display->GetText()).find("Resting on the volume, "), 0U)
    << this->Display->GetText();
  for (int i = 0; i < 8; ++i)
  {
    this->Pointer(150, 150, vtkCommand::MouseWheelBackwardEvent);
    this->Run(10);
  }
  ASSERT_EQ(this->Device->GetState()->GetContact(), 0);
  EXPECT_TRUE(this->Hints("")) << "it was done, " << this->Display->GetHint();
  EXPECT_STREQ(this->Display->GetText().c_str(), "") << "nothing is touched";
  this->Press("Escape");
  this->Run(10);
  EXPECT_TRUE(this->Hints("press t")) << this->Display->GetHint();
}

TEST_F(StyleHints, SayHowToGoOnAfterAFault)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Pointer(150, 150);
  this->Style->TouchModeOn();
  this->RunUntilFullyArmed();
  this->Device->GetVirtualHand()->Place(
    0.0, 0.0, 500.0); // moves the hand faster than an armed device allows
  this->Run(20);
  ASSERT_EQ(this->Device->GetStatus(), vtkHapticDevice::FAULT);
  EXPECT_TRUE(this->Hints("Press a to go on")) << this->Display->GetHint();
  this->Press("a");
  this->Run(20);
  EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::FAULT);
  EXPECT_TRUE(this->Hints("Escape lets go")) << this->Display->GetHint();
}

TEST_F(StyleHints, OfTheApplicationStay)
{
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Run(2);
  this->Display->SetHint("Drop a file here");
  this->Run(10);
  EXPECT_STREQ(this->Display->GetHint(), "Drop a file here");
  this->Style->TouchModeOn();
  this->Run(10);
  EXPECT_TRUE(this->Hints("Escape lets go"));
}

TEST_F(StyleHints, KeysAreListedAsTheSceneHasThem)
{
  this->Press("question");
  EXPECT_TRUE(this->Lists("t\ttouch what is under the pointer"));
  EXPECT_TRUE(this->Lists("wheel\t"));
  EXPECT_FALSE(this->Lists("function editor")) << "there is none";
  EXPECT_FALSE(this->Lists("clutch")) << "there is no real device";
  EXPECT_FALSE(this->Lists("space\t")) << "the volume does not move";
  this->Press("question");
  EXPECT_FALSE(this->Display->GetHelpVisibility());
  this->Style->SetFunctionEditor(this->Editor);
  this->Style->SetApplicationKeys("Window\nq\tclose\n");
  this->Press("F1");
  EXPECT_TRUE(this->Lists("v\tfunction editor"));
  EXPECT_TRUE(this->Lists("\nWindow\nq\tclose\n"));
  EXPECT_EQ(this->Style->GetKeys(), this->Display->GetHelpText());
  this->Press("Escape");
  EXPECT_FALSE(this->Display->GetHelpVisibility());
  this->Press("d");
  EXPECT_TRUE(this->Display->GetDetailsVisibility());
}
