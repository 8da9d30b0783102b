// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that the force is off while the style or the editor blocks the program, and that the
 * head-up display announces this.
 */

#include "StyleRig.h"

#include "Rigs/EventCounter.h"

#include <vtkAutoInit.h>
#include <vtkDataArray.h>
#include <vtkHapticFunctionEditor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkPiecewiseFunction.h>
#include <vtkTable.h>
#include <vtkUnsignedCharArray.h>
#include <vtkVariant.h>

#include <cmath>
#include <random>

// Charts and their text need these modules, whose headers this file does not include.
VTK_MODULE_INIT(vtkRenderingContextOpenGL2);
VTK_MODULE_INIT(vtkRenderingFreeType);

using namespace scenetest;

namespace
{
class StyleLongWork : public StyleTest
{
protected:
  StyleLongWork()
  {
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
    this->Renderer->AddViewProp(this->Display);
    this->Editor->SetProperty(this->Filter->GetProperty());
    this->Editor->SetRectangle(0, 0, 100, 80);
    this->Editor->VisibilityOff();
    this->Renderer->AddViewProp(this->Editor);
    this->Style->SetFunctionEditor(this->Editor);
    this->Device->SetAttentionTime(2.0);
    this->Interactor->Initialize();

    // Records the text and the force of every frame.
    vtkNew<vtkCallbackCommand> look;
    look->SetClientData(this);
    look->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*)
      {
        auto& test = *static_cast<StyleLongWork*>(self);
        test.Shown.push_back(test.Display->GetText());
      });
    this->Renderer->AddObserver(vtkCommand::StartEvent, look);
  }
  /// Presses the tip about 2 mm into the ball, and expects a force.
  void Touch()
  {
    ASSERT_NO_FATAL_FAILURE(this->PushIn());
    // After a pause of a busy machine, the servo starts again at the tip, so only a new contact
    // causes a force, as in StyleEnds. Press again in this case.
    constexpr int most = 400;
    for (int i = 1; i < most && Length(this->Device->GetState()->GetForce()) <= 0.5; ++i)
    {
      this->Run(100); // long enough for the force to increase
      for (int step = 0; step < 8 && i % 8 == 0; ++step)
      {
        this->Pointer(150, 150,
          step < 4 ? vtkCommand::MouseWheelBackwardEvent : vtkCommand::MouseWheelForwardEvent);
        this->Run(10);
      }
    }
    ASSERT_GT(Length(this->Device->GetState()->GetForce()), 0.5);
    this->Device->GetState()->Drain(this->States, 1);
    this->Shown.clear();
  }
  /// Sets an editor input of 43 million samples, whose histogram is counted in the background.
  void GiveEditorMuch()
  {
    constexpr int n = 350;
    vtkNew<vtkUnsignedCharArray> samples;
    samples->SetNumberOfValues(n * n * n);
    samples->FillValue(7);
    vtkNew<vtkImageData> image;
    image->SetDimensions(n, n, n);
    image->GetPointData()->SetScalars(samples);
    this->Editor->SetInputData(image);
  }
  /// Sets an editor input with a ball: the value is 0 outside and 100 inside, with a blur of 2.5
  /// voxels between them.
  void GiveEditorAnEdge()
  {
    constexpr int n = 64;
    constexpr double middle = 0.5 * (n - 1);
    this->Editor->SetInputData(apitest::MakeImage(n, VTK_FLOAT,
      [](const apitest::Point& x)
      {
        const double r = std::hypot(x[0] - middle, x[1] - middle, x[2] - middle);
        return 50.0 * std::erfc((r - 18.0) / (2.5 * std::sqrt(2.0)));
      }));
  }
  /// Fills the voxels beside the ball with noise, so that each voxel contains a piece of the
  /// isosurface at -4000.
  void GiveMethodMuch()
  {
    std::mt19937 random(1);
    vtkDataArray* const scalars = this->Ball->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
    {
      if (this->Ball->GetPoint(i)[0] < -36.0)
      {
        scalars->SetTuple1(i, -5000.0 + static_cast<double>(random() % 2001));
      }
    }
    scalars->Modified();
    this->Ball->Modified();
    this->Filter->GetProperty()->DistinctnessFromNoiseOff();
    this->Filter->SetIsoValue(-4000.0);
  }
  bool HasShown(const std::string& words) const
  {
    return std::any_of(this->Shown.begin(), this->Shown.end(),
      [&](const std::string& text) { return text.find(words) != std::string::npos; });
  }
  /// Updates the style until the editor has finished its search for functions. Returns false after
  /// a timeout.
  bool EndsProposing()
  {
    return Eventually(
      [this]
      {
        this->Style->UpdateHaptics();
        this->Editor->Update();
        return !this->Editor->IsProposing();
      });
  }
  /// Expects that the force was off without a fault, and that the device is active again.
  void ExpectPause()
  {
    this->Run(20);
    this->Device->GetState()->Drain(this->States, 1);
    int forceless = 0;
    for (vtkIdType i = 0; i < this->States->GetNumberOfRows(); ++i)
    {
      const auto number = [&](const char* name)
      { return vtkDataArray::SafeDownCast(this->States->GetColumnByName(name))->GetTuple(i); };
      forceless += Length(number("Command")) == 0.0;
      EXPECT_EQ(number("Fault")[0], 0.0);
      EXPECT_EQ(number("Armed")[0], 1.0);
    }
    EXPECT_GT(forceless, 10);
    EXPECT_EQ(this->Works.Count, 1);
    EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  }

  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkTable> States;
  std::vector<std::string> Shown;
  const apitest::EventCounter Works{ this->Device, vtkCommand::StartEvent };
};
} // namespace

TEST_F(StyleLongWork, IsNotTheHistogramOfALargeVolume)
{
  this->GiveEditorMuch();
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  this->Press("v");
  EXPECT_EQ(this->Editor->EstimateUpdateTime(), 0.0);
  // The style must draw until all samples are counted, and then stop drawing.
  int timer = 0;
  while (this->Interactor->GetTimerDuration(timer) == 0)
  {
    ASSERT_LT(++timer, 1000) << "the style has no timer";
  }
  EXPECT_TRUE(Eventually(
    [&]
    {
      this->Interactor->InvokeEvent(vtkCommand::TimerEvent, &timer);
      return this->Editor->GetCountedFraction() == 1.0;
    }));
  EXPECT_EQ(this->Works.Count, 0);
  EXPECT_FALSE(this->HasShown("Force is off"));
}

TEST_F(StyleLongWork, IsNotTheHistogramOfASmallVolume)
{
  this->Editor->SetInputData(this->Ball);
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  this->Press("v");
  EXPECT_EQ(this->Editor->GetCountedFraction(), 1.0) << "it is counted at once";
  EXPECT_EQ(this->Works.Count, 0);
  EXPECT_FALSE(this->HasShown("Force is off"));
}

TEST_F(StyleLongWork, IsNotTheSearchForFunctions)
{
  this->GiveEditorAnEdge();
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  vtkHapticProperty* const property = this->Filter->GetProperty();
  this->Press("p");
  EXPECT_TRUE(this->HasShown("Looking for materials"));
  EXPECT_TRUE(this->Editor->GetVisibility());
  EXPECT_TRUE(this->Editor->IsProposing()) << "the key waits for nothing";
  this->Press("p");
  EXPECT_TRUE(this->Editor->IsProposing()) << "there is nothing to take yet";
  ASSERT_TRUE(this->EndsProposing());
  EXPECT_TRUE(this->Editor->HasProposal());
  this->Style->UpdateHaptics();
  EXPECT_STREQ(this->Display->GetNotice(), "") << "once the style has seen the end";
  EXPECT_EQ(this->Editor->GetCountedFraction(), 1.0);
  EXPECT_EQ(property->GetProposedKernelRadius(), 0) << "nothing changes before it is taken";
  this->Run(20);
  EXPECT_EQ(this->Works.Count, 0);
  EXPECT_FALSE(this->HasShown("Force is off"));
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
  this->Press("p");
  EXPECT_FALSE(this->Editor->HasProposal());
  EXPECT_EQ(property->GetProposedKernelRadius(), 5);
  EXPECT_EQ(this->Filter->GetKernelRadius(), 5);
  EXPECT_EQ(property->GetSurfaceStrength()->GetValue(100.0), 12.0);
  EXPECT_EQ(this->Works.Count, 0) << "to take it is no work";
}

TEST_F(StyleLongWork, FindsTheSameFunctionsInTheBackground)
{
  this->GiveEditorAnEdge();
  vtkNew<vtkHapticProperty> atOnce;
  ASSERT_TRUE(atOnce->ProposeFromImage(this->Editor->GetInputData()));
  ASSERT_TRUE(this->Editor->BeginProposal());
  ASSERT_TRUE(this->EndsProposing());
  ASSERT_TRUE(this->Editor->TakeProposal());
  vtkPiecewiseFunction* const found = this->Filter->GetProperty()->GetSurfaceStrength();
  vtkPiecewiseFunction* const expected = atOnce->GetSurfaceStrength();
  ASSERT_EQ(found->GetSize(), expected->GetSize());
  for (int i = 0; i < found->GetSize(); ++i)
  {
    double node[2][4];
    found->GetNodeValue(i, node[0]);
    expected->GetNodeValue(i, node[1]);
    EXPECT_EQ(node[0][0], node[1][0]) << i;
    EXPECT_EQ(node[0][1], node[1][1]) << i;
  }
}

TEST_F(StyleLongWork, LooksForFunctionsAgainIfTheVolumeChanges)
{
  this->GiveEditorAnEdge();
  ASSERT_TRUE(this->Editor->BeginProposal());
  vtkImageData* const image = this->Editor->GetInputData();
  vtkDataArray* const scalars = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < scalars->GetNumberOfTuples(); ++i)
  {
    scalars->SetTuple1(i, 3.0 * scalars->GetTuple1(i));
  }
  scalars->Modified();
  image->Modified();
  ASSERT_TRUE(this->EndsProposing());
  ASSERT_TRUE(this->Editor->TakeProposal());
  vtkTable* const boundaries = this->Filter->GetProperty()->GetProposedBoundaries();
  EXPECT_NEAR(boundaries->GetValueByName(0, "High").ToDouble(), 300.0, 3.0);
}

TEST_F(StyleLongWork, LeavesNoProposalThatIsDropped)
{
  this->GiveEditorAnEdge();
  this->Press("p");
  ASSERT_TRUE(this->EndsProposing());
  EXPECT_TRUE(this->Editor->HasProposal());
  this->Press("BackSpace");
  EXPECT_FALSE(this->Editor->HasProposal());
  EXPECT_EQ(this->Filter->GetProperty()->GetProposedBoundaries(), nullptr);
  this->Press("p");
  EXPECT_STREQ(this->Display->GetNotice(), "Looking for materials");
  this->Press("BackSpace");
  EXPECT_FALSE(this->Editor->IsProposing());
  EXPECT_STREQ(this->Display->GetNotice(), "");
  this->Press("p");
  this->Editor->SetInputData(nullptr);
  EXPECT_FALSE(this->Editor->IsProposing());
}

TEST_F(StyleLongWork, TellsThatThereIsNothingToPropose)
{
  this->GiveEditorMuch();
  const apitest::MessageLog log(this->Editor);
  this->Press("p");
  ASSERT_TRUE(this->EndsProposing());
  ASSERT_EQ(log.Errors.size(), 1U);
  EXPECT_NE(log.Errors[0].find("7 everywhere"), std::string::npos);
  EXPECT_FALSE(this->Editor->HasProposal());
  EXPECT_STREQ(this->Display->GetNotice(), "No materials can be proposed for this volume");
  // An image without scalars must be refused at once.
  vtkNew<vtkImageData> empty;
  this->Editor->SetInputData(empty);
  EXPECT_FALSE(this->Editor->BeginProposal());
  ASSERT_EQ(log.Errors.size(), 2U);
  EXPECT_NE(log.Errors[1].find("no active point scalars"), std::string::npos);
}

TEST_F(StyleLongWork, IsNotTheMeshOfTheNextMethod)
{
  this->GiveMethodMuch();
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  this->Press("m");
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::SURFACE_PROXY);
  EXPECT_TRUE(this->HasShown("Surface proxy is being prepared"));
  EXPECT_FALSE(this->Device->IsPublished());
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->IsPublished();
    }));
  this->Style->UpdateHaptics();
  EXPECT_EQ(this->Device->GetMethodText(), "Surface proxy");
  EXPECT_STREQ(this->Display->GetNotice(), "");
  EXPECT_FALSE(this->HasShown("Force is off"));
  EXPECT_EQ(this->Works.Count, 0);
}

TEST_F(StyleLongWork, IsForgottenIfTheDeviceIsTakenAwayMeanwhile)
{
  this->GiveMethodMuch();
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  this->Press("m");
  ASSERT_FALSE(this->Device->IsPublished());
  EXPECT_STRNE(this->Display->GetNotice(), "");
  this->Style->SetDevice(nullptr);
  EXPECT_STREQ(this->Display->GetNotice(), "");
  EXPECT_FALSE(this->Style->UpdateHaptics());
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Device->UpdateState();
      return this->Device->IsPublished();
    }))
    << "the device goes on with it";
  EXPECT_EQ(this->Device->GetMethodText(), "Surface proxy");
  EXPECT_EQ(this->Works.Count, 0);
}

TEST_F(StyleLongWork, LeavesTheMethodIfTheMeshIsThereAndCannotBeFelt)
{
  this->GiveMethodMuch();
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  this->Filter->SetProxyRadius(100.0);
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  const apitest::MessageLog refusal(this->Filter);
  EXPECT_TRUE(this->Style->NextMethod());
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->IsPublished();
    }));
  this->Style->UpdateHaptics();
  ASSERT_EQ(refusal.Errors.size(), 1U);
  EXPECT_NE(refusal.Errors[0].find("ProxyRadius"), std::string::npos);
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::FORCE_FIELD);
  EXPECT_NE(std::string(this->Display->GetNotice()).find("Force field goes on"), std::string::npos);
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("Surface proxy can't be felt"), std::string::npos);
  this->Log.Errors.clear();
}

TEST_F(StyleLongWork, LeavesTheComparedSettingsIfTheMeshIsThereAndCannotBeFelt)
{
  this->GiveMethodMuch();
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  vtkPiecewiseFunction* const k = this->Filter->GetProperty()->GetStiffness();
  const double stiffness = k->GetValue(0.0);
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  const apitest::MessageLog refusal(this->Filter);
  EXPECT_TRUE(this->Style->SwapSettings());
  this->Filter->SetMethodToSurfaceProxy();
  this->Filter->SetProxyRadius(100.0);
  k->AddPoint(0.0, stiffness + 50.0);
  EXPECT_TRUE(this->Style->SwapSettings());
  EXPECT_EQ(this->Style->GetComparedSettings(), "A");
  EXPECT_TRUE(this->Style->SwapSettings());
  EXPECT_EQ(this->Style->GetComparedSettings(), "B");
  EXPECT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->IsPublished();
    }));
  this->Style->UpdateHaptics();
  ASSERT_EQ(refusal.Errors.size(), 1U);
  EXPECT_NE(refusal.Errors[0].find("ProxyRadius"), std::string::npos);
  EXPECT_EQ(this->Style->GetComparedSettings(), "A");
  EXPECT_TRUE(this->HasShown("Settings A"));
  EXPECT_EQ(this->Filter->GetMethod(), vtkVolumeHapticsFilter::FORCE_FIELD);
  EXPECT_EQ(k->GetValue(0.0), stiffness) << "not only the method is taken back";
  ASSERT_EQ(this->Log.Errors.size(), 1U);
  EXPECT_NE(this->Log.Errors[0].find("Settings B can't be felt"), std::string::npos);
  this->Log.Errors.clear();
  EXPECT_FALSE(this->Style->SwapSettings()) << "B is kept, to be tried again";
  EXPECT_EQ(refusal.Errors.size(), 2U);
  EXPECT_EQ(this->Style->GetComparedSettings(), "A");
  this->Log.Errors.clear();
}

TEST_F(StyleLongWork, IsNotTheMeshThatTheTouchModeLooksFor)
{
  this->GiveMethodMuch();
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  this->Style->TouchModeOff();
  this->Device->Arm();
  this->Filter->SetMethodToSurfaceProxy();
  this->Style->TouchModeOn();
  EXPECT_EQ(this->Works.Count, 0);
  EXPECT_FALSE(this->Device->IsPublished()) << "nothing waited for the mesh";
  this->Run(20);
  EXPECT_EQ(this->Device->GetStatus(), vtkHapticDevice::ACTIVE);
}

TEST_F(StyleLongWork, OfAnEditorEndsWithIt)
{
  this->GiveEditorAnEdge();
  ASSERT_NO_FATAL_FAILURE(this->Touch());
  this->Device->SetAttentionTime(0.0); // without the editor, the work is no longer announced
  // This observer runs after the style's observer. It removes the editor just before the work
  // starts.
  vtkNew<vtkCallbackCommand> take;
  take->SetClientData(this->Style);
  take->SetCallback([](vtkObject*, unsigned long, void* style, void*)
    { static_cast<vtkInteractorStyleHaptic*>(style)->SetFunctionEditor(nullptr); });
  this->Editor->AddObserver(vtkCommand::StartEvent, take, -1.0f);
  EXPECT_TRUE(this->Editor->Propose());
  EXPECT_TRUE(this->HasShown("Force is off while materials are proposed"));
  this->ExpectPause();
}
