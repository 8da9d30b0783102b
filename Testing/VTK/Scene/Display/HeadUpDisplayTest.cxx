// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the plot and the text of the head-up display.
 */

#include "Rigs/ScriptedStates.h"

#include "Rigs/DeviceRig.h"
#include "VTK/Scene/Display/DisplayProbe.h"

#include <vtkDoubleArray.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticMode.h>
#include <vtkPlane.h>
#include <vtkPointData.h>

using namespace devicetest;

namespace
{
class HeadUpDisplay : public DeviceTest
{
protected:
  double Largest(int column)
  {
    const vtkSmartPointer<vtkTable> plot = VolumeHaptics::DisplayProbe::CopyPlot(this->Display);
    auto* const values = vtkDataArray::SafeDownCast(plot->GetColumn(column));
    return values->GetNumberOfTuples() > 0 ? values->GetRange()[1] : 0.0;
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
  MessageLog DisplayLog{ this->Display };
};
} // namespace

TEST_F(HeadUpDisplay, LosesNoPeak)
{
  const auto spike = [](double t) { return std::abs(t - 2.3456) < 0.0004 ? 4.0 : 1.0; };
  this->Display->AddStates(scenetest::MakeStates(0.0, 5.0, spike));
  EXPECT_EQ(VolumeHaptics::DisplayProbe::CountStates(this->Display), 5000);
  EXPECT_LE(VolumeHaptics::DisplayProbe::CopyPlot(this->Display)->GetNumberOfRows(), 500);
  EXPECT_EQ(this->Largest(1), 4.0);
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetForceRange(this->Display), 5.0);
}

TEST_F(HeadUpDisplay, ForgetsWhatIsOlderThanItsSpan)
{
  const auto early = [](double t) { return t < 1.0 ? 7.0 : 0.9; };
  for (int second = 0; second < 20; ++second)
  {
    this->Display->AddStates(scenetest::MakeStates(second, second + 1.0, early));
    EXPECT_LE(VolumeHaptics::DisplayProbe::CountStates(this->Display), 5001);
    EXPECT_EQ(VolumeHaptics::DisplayProbe::GetForceRange(this->Display), second < 6 ? 10.0 : 1.0)
      << second;
  }
  EXPECT_LT(this->Largest(1), 1.0);
  // After a restart of the device, the time begins at 0 again, and older states are discarded.
  this->Display->AddStates(scenetest::MakeStates(0.0, 0.5, early));
  EXPECT_EQ(VolumeHaptics::DisplayProbe::CountStates(this->Display), 500);
  this->Display->Clear();
  EXPECT_EQ(VolumeHaptics::DisplayProbe::CountStates(this->Display), 0);
}

TEST_F(HeadUpDisplay, NamesTheColumnThatIsMissing)
{
  const auto states = scenetest::MakeStates(0.0, 1.0, [](double) { return 1.0; });
  states->RemoveColumnByName("DragForce");
  this->Display->AddStates(states);
  this->Display->AddStates(nullptr);
  ASSERT_EQ(this->DisplayLog.Errors.size(), 2U);
  EXPECT_NE(this->DisplayLog.Errors[0].find("DragForce"), std::string::npos);
  EXPECT_EQ(VolumeHaptics::DisplayProbe::CountStates(this->Display), 0);
}

TEST_F(HeadUpDisplay, TakesNoStatesThatNoAxisCanShow)
{
  const auto column = [](vtkTable* table, const char* name)
  { return vtkDataArray::SafeDownCast(table->GetColumnByName(name)); };
  for (const double time : { std::nan(""), HUGE_VAL, -HUGE_VAL })
  {
    const auto states = scenetest::MakeStates(0.0, 0.1, [](double) { return 1.0; });
    column(states, "Time")->SetComponent(50, 0, time);
    this->Display->Clear();
    this->Display->AddStates(states);
    ASSERT_EQ(this->DisplayLog.Errors.size(), 1U);
    EXPECT_NE(this->DisplayLog.Errors[0].find("row 50"), std::string::npos);
    EXPECT_EQ(VolumeHaptics::DisplayProbe::CountStates(this->Display), 50) << "those before it";
    EXPECT_EQ(this->Largest(1), 1.0);
    this->DisplayLog.Errors.clear();
  }
  const auto cut = scenetest::MakeStates(0.0, 0.1, [](double) { return 1.0; });
  column(cut, "DragForce")->SetNumberOfTuples(7);
  this->Display->Clear();
  this->Display->AddStates(cut);
  EXPECT_EQ(this->DisplayLog.Errors.size(), 1U);
  EXPECT_EQ(VolumeHaptics::DisplayProbe::CountStates(this->Display), 7);

  this->DisplayLog.Errors.clear();
  this->Display->SetTimeSpan(std::nan(""));
  this->Display->Clear();
  this->Display->AddStates(scenetest::MakeStates(0.0, 8.0, [](double) { return 1.0; }));
  EXPECT_NEAR(VolumeHaptics::DisplayProbe::CountStates(this->Display), 5000, 1) << "as by default";
  EXPECT_EQ(this->Largest(1), 1.0);
  this->Display->SetTimeSpan(5.0);

  // Extreme forces, which invalid functions can cause, must leave the axis of the plot finite.
  for (const double force : { std::nan(""), HUGE_VAL, 1e308 })
  {
    const auto absurd = [force](double t) { return t > 0.05 ? force : 1.0; };
    this->Display->Clear();
    this->Display->AddStates(scenetest::MakeStates(0.0, 0.1, absurd));
    EXPECT_TRUE(std::isfinite(VolumeHaptics::DisplayProbe::GetForceRange(this->Display)));
    EXPECT_GE(VolumeHaptics::DisplayProbe::GetForceRange(this->Display), 1.0);
    EXPECT_LE(this->Largest(1), 1.001e30);
  }
}

TEST_F(HeadUpDisplay, HasAColumnForEachCurveUntilItIsCleared)
{
  const auto states = scenetest::MakeStates(0.0, 1.0, [](double) { return 2.0; });
  this->Display->AddStates(states);
  EXPECT_EQ(VolumeHaptics::DisplayProbe::CopyPlot(this->Display)->GetNumberOfColumns(), 5);
  EXPECT_EQ(this->Largest(1), 2.0);
  this->Display->Clear();
  EXPECT_EQ(VolumeHaptics::DisplayProbe::CopyPlot(this->Display)->GetNumberOfRows(), 0)
    << "nothing is left";
}

TEST_F(HeadUpDisplay, TitlesThePlotWithWhatIsFelt)
{
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display), "");
  this->Display->SetDevice(this->Device);
  this->Filter->SetSolverToPaper();
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display), "Proxy, PAPER")
    << "will be felt";
  this->Begin();
  this->Filter->SetMethodToForceField();
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display), "Proxy, PAPER")
    << "not published";
  ASSERT_TRUE(this->Device->Publish());
  EXPECT_EQ(VolumeHaptics::DisplayProbe::GetPlotTitle(this->Display), "Force field");
  EXPECT_EQ(this->Display->GetText(), "") << "nothing to tell";
  this->Display->SetNotice("to be known");
  EXPECT_EQ(this->Display->GetText(), "to be known");
}

TEST_F(HeadUpDisplay, SaysWhatTheDeviceDoes)
{
  EXPECT_EQ(this->Display->GetText(), "No device");
  this->Display->SetDevice(this->Device);
  EXPECT_NE(this->Display->GetText().find("Open()"), std::string::npos);
  this->Display->AddTissue("soft", 0.0, 1000.0);
  this->Display->AddTissue("hard", 1000.0, 1e9);
  EXPECT_EQ(this->Display->GetTissueName(999.9), "soft");
  EXPECT_EQ(this->Display->GetTissueName(1000.0), "hard");
  EXPECT_EQ(this->Display->GetTissueName(-1.0), "");
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  EXPECT_EQ(this->Display->GetText(), "") << "nothing is touched";
  ASSERT_TRUE(this->LeadInto(7.0));
  EXPECT_EQ(this->Display->GetText().find("ticks"), std::string::npos);
  this->Display->DetailsVisibilityOn();
  // The virtual device exerts at most 20 N. The default limit is half of that, 10 N.
  for (const char* words :
    { "Resting on soft, 1.00 N of at most 10 N\n", "Value ", " ticks/s, ", " missed" })
  {
    EXPECT_TRUE(
      this->Wait([&] { return this->Display->GetText().find(words) != std::string::npos; }))
      << words << " in\n"
      << this->Display->GetText();
  }
  // The text must contain the tissue that AddTissue() assigned to the value, here shifted by 400.
  this->Filter->GetProperty()->SetScalarShift(400.0);
  EXPECT_TRUE(this->Wait([&] { return this->Display->GetText().find("Resting on hard") == 0; }))
    << this->Display->GetText();
  this->Filter->GetProperty()->SetScalarShift(0.0);
  this->Filter->GetProperty()->NoteShift(400.0);
  EXPECT_TRUE(this->Wait([&]
    { return this->Display->GetText().find(" HU (stored as HU + -400)") != std::string::npos; }))
    << this->Display->GetText();
  this->Filter->GetProperty()->NoteShift(0.0);
  this->Display->RemoveAllTissues();
  EXPECT_EQ(this->Display->GetTissueName(10.0), "");
}

/// A mouse moves the tip in steps, so the tip is at rest in most ticks of a stroke. The text must
/// still say "Sliding".
TEST_F(HeadUpDisplay, SaysThatAHandSlidesBetweenTheStepsOfAMouse)
{
  const auto add = [this](double from, double to, int contact)
  {
    const auto states = scenetest::MakeStates(from, to, [](double) { return 1.0; });
    vtkNew<vtkDoubleArray> contacts;
    contacts->SetName("Contact");
    contacts->SetNumberOfTuples(states->GetNumberOfRows());
    contacts->FillValue(contact);
    states->AddColumn(contacts);
    this->Display->AddStates(states);
  };
  const auto says = [this](const char* words)
  { return this->Wait([&] { return this->Display->GetText().find(words) == 0; }); };
  this->Display->SetDevice(this->Device);
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(7.0));
  EXPECT_TRUE(says("Resting on the volume, 1.00 N")) << this->Display->GetText();
  add(0.0, 0.01, 2);
  add(0.01, 0.15, 1);
  EXPECT_TRUE(says("Sliding over the volume, 1.00 N")) << this->Display->GetText();
  add(0.15, 0.25, 1);
  EXPECT_TRUE(says("Resting on the volume, 1.00 N")) << this->Display->GetText();
  add(0.25, 0.26, 2);
  add(0.0, 0.01, 1); // states that begin at 0 again, as after a restart of the device
  EXPECT_TRUE(says("Resting on the volume, 1.00 N")) << this->Display->GetText();
}

TEST_F(HeadUpDisplay, NamesTissuesAsTheEditorDoes)
{
  vtkHapticProperty* const property = this->Filter->GetProperty();
  this->Display->SetDevice(this->Device);
  this->BeginPressed();
  const auto says = [this](const char* words)
  { return this->Wait([&] { return this->Display->GetText().find(words) == 0; }); };
  EXPECT_TRUE(says("Resting on the volume, ")) << this->Display->GetText();
  const double value = this->Device->GetState()->GetSurfaceValue();
  property->AddTissue("all", value - 1.0, value + 1.0);
  EXPECT_TRUE(says("Resting on all, ")) << this->Display->GetText();
  // A change of the tissues must take effect at once. A value outside all tissues must get the name
  // of the nearest tissue.
  property->RemoveAllTissues();
  property->AddTissue("low", -500.0, 0.0);
  property->AddTissue("high", 100.0, 500.0);
  EXPECT_EQ(this->Display->GetTissueName(-600.0), "low");
  EXPECT_EQ(this->Display->GetTissueName(49.0), "low");
  EXPECT_EQ(this->Display->GetTissueName(51.0), "high");
  EXPECT_EQ(this->Display->GetTissueName(1e9), "high");
  // Values at the surface are blends of both sides, so the text must name the tissue below the
  // surface.
  const double* const spacing = this->Image->GetSpacing();
  double below[3];
  for (int i = 0; i < 3; ++i)
  {
    below[i] = this->Device->GetState()->GetSurfacePosition()[i] +
      2.0 * spacing[0] * this->Device->GetState()->GetNormal()[i];
  }
  const double deeper =
    this->Image->GetPointData()->GetScalars()->GetTuple1(this->Image->FindPoint(below));
  ASSERT_GT(deeper, value + 10.0) << "the values rise";
  property->RemoveAllTissues();
  property->AddTissue("skin", value - 1.0, value + 1.0);
  property->AddTissue("fat", deeper - 1.0, deeper + 1.0);
  EXPECT_TRUE(says("Resting on fat, ")) << this->Display->GetText();
}

/// With "CT physical", values between air and fat that resist the hand are called skin; a blanket
/// is not.
TEST_F(HeadUpDisplay, CallsSkinWhatHoldsAsSkin)
{
  vtkHapticProperty* const property = this->Filter->GetProperty();
  ASSERT_TRUE(property->ApplyPreset("CT physical"));
  this->Display->SetDevice(this->Device);
  for (double value = -600.0; value <= -40.0; value += 1.0)
  {
    const std::string name = this->Display->GetTissueName(value);
    const bool isHeld = property->GetSurfaceStrength()->GetValue(value) > 0.0;
    EXPECT_EQ(name.find("skin") != std::string::npos, isHeld || value > -430.0)
      << value << ": " << name;
    EXPECT_FALSE(isHeld && name.find("cloth") != std::string::npos) << value << ": " << name;
  }
}

TEST_F(HeadUpDisplay, SaysThatAHandRestsWhereItsFrictionIsAtTheLimit)
{
  this->Display->SetDevice(this->Device);
  this->BeginPressed();
  const auto add = [this](double begin, double speed)
  {
    vtkNew<vtkTable> states;
    states->DeepCopy(scenetest::MakeStates(begin, begin + 0.3, [](double) { return 1.0; }));
    vtkNew<vtkDoubleArray> contacts;
    contacts->SetName("Contact");
    vtkNew<vtkDoubleArray> proxies;
    proxies->SetName("Proxy");
    proxies->SetNumberOfComponents(3);
    for (vtkIdType i = 0; i < states->GetNumberOfRows(); ++i)
    {
      contacts->InsertNextValue(2.0);
      proxies->InsertNextTuple3(speed * 0.001 * static_cast<double>(i), 0.0, 0.0);
    }
    states->AddColumn(contacts);
    states->AddColumn(proxies);
    this->Display->AddStates(states);
  };
  add(0.0, 10.0); // mm/s
  EXPECT_EQ(this->Display->GetText().find("Sliding over the volume, "), 0U)
    << this->Display->GetText();
  add(0.3, 0.0);
  EXPECT_EQ(this->Display->GetText().find("Resting on the volume, "), 0U)
    << this->Display->GetText();
}

/// A flow along x resists a hand that moves 2 mm along z with 1 N. The text must not mention a
/// surface.
TEST_F(HeadUpDisplay, NamesNoSurfaceWhereModesAreFelt)
{
  vtkNew<vtkDoubleArray> flow;
  flow->SetName("flow");
  flow->SetNumberOfComponents(3);
  for (vtkIdType i = 0; i < this->Image->GetNumberOfPoints(); ++i)
  {
    flow->InsertNextTuple3(1.0, 0.0, 0.0);
  }
  this->Image->GetPointData()->AddArray(flow);
  vtkNew<vtkHapticMode> follow;
  follow->SetArrayName("flow");
  this->Filter->AddMode(follow);
  this->Filter->SetMethodToPrimitives();
  this->Display->AddTissue("everything", -1e9, 1e9);
  this->Display->SetDevice(this->Device);
  this->Display->DetailsVisibilityOn();
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(7.0));
  const auto says = [&](const char* words)
  { return this->Display->GetText().find(words) != std::string::npos; };
  EXPECT_TRUE(this->Wait([&] { return says("Held, 1.00 N of at most 10 N\n"); }))
    << this->Display->GetText();
  EXPECT_TRUE(says(" ticks/s, ")) << this->Display->GetText();
  EXPECT_FALSE(says("Value ")) << this->Display->GetText();
  EXPECT_FALSE(says("everything")) << this->Display->GetText();
}

TEST_F(HeadUpDisplay, NamesTheLabelThatIsTouched)
{
  // Layers of 0.5 mm across z, as wide as the volume, are numbered downwards from z = 15.5 mm. The
  // table has names for every second layer.
  vtkNew<vtkImageData> labels;
  labels->SetDimensions(2, 2, 32);
  labels->SetSpacing(20.0, 20.0, 0.5);
  labels->SetOrigin(-1.0, -1.0, 15.5);
  labels->SetDirectionMatrix(1, 0, 0, 0, 1, 0, 0, 0, -1);
  labels->AllocateScalars(VTK_SHORT, 1);
  vtkNew<vtkHapticLabelTable> table;
  for (vtkIdType i = 0; i < labels->GetNumberOfPoints(); ++i)
  {
    labels->GetPointData()->GetScalars()->SetTuple1(i, static_cast<double>(i / 4));
  }
  for (int layer = 0; layer < 32; layer += 2)
  {
    table->SetLabelName(layer, "layer " + std::to_string(layer) + " \xC3\xB6");
    table->SetFelt(layer + 1, true);
  }
  this->Display->AddTissue("ramp", -1e9, 1e9);
  this->Display->SetDevice(this->Device);
  this->BeginPressed();
  EXPECT_NE(this->Display->GetText().find(" ramp, "), std::string::npos);
  this->Filter->SetLabelData(labels);
  this->Filter->SetLabelTable(table);
  const double* const position = this->Device->GetState()->GetSurfacePosition();
  const int layer = static_cast<int>(std::lround((15.5 - position[2]) / 0.5));
  const std::string name = layer % 2 == 0 ? " layer " + std::to_string(layer) + " \xC3\xB6, "
                                          : " label " + std::to_string(layer) + ", ";
  EXPECT_NE(this->Display->GetText().find(name), std::string::npos) << this->Display->GetText();
  // The text must name the tissue at the value ("ramp") if a label has no name, or if the hand is
  // outside of the label image.
  table->RemoveLabel(layer);
  EXPECT_NE(this->Display->GetText().find(" ramp, "), std::string::npos);
  table->SetLabelName(layer, "back");
  EXPECT_NE(this->Display->GetText().find(" back, "), std::string::npos);
  labels->SetOrigin(-1.0, -1.0, 150.0);
  EXPECT_NE(this->Display->GetText().find(" ramp, "), std::string::npos);
}

TEST_F(HeadUpDisplay, TellsThatTheVolumeIsCutOpen)
{
  this->Display->SetDevice(this->Device);
  this->Device->SetVolumeHaptics(this->Filter);
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  EXPECT_EQ(this->Display->GetText().find("Cut"), std::string::npos) << this->Display->GetText();
  vtkNew<vtkPlane> plane;
  this->Filter->AddClippingPlane(plane);
  EXPECT_NE(this->Display->GetText().find("Cut open, its faces are not felt"), std::string::npos);
  this->Filter->RemoveAllClippingPlanes();
  this->Filter->CroppingOn();
  this->Filter->FeelCutFacesOn();
  EXPECT_NE(this->Display->GetText().find("Cut open, its faces are felt"), std::string::npos);
}
