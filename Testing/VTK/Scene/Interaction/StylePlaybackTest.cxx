// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a moving volume in a scene. The displayed time step must be the one that is felt, and keys
 * must control the playback.
 */

#include "StyleRig.h"

#include "Rigs/TimeSource.h"

#include <vtkAlgorithmOutput.h>
#include <vtkGPUVolumeRayCastMapper.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticTimeStepSource.h>
#include <vtkVolume.h>

#include <cmath>

using namespace scenetest;

namespace
{
/// Makes an image whose samples encode its number.
vtkSmartPointer<vtkImageData> MakeNumbered(int number, int components = 1)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(12, 12, 12);
  image->AllocateScalars(VTK_SHORT, components);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    for (int c = 0; c < components; ++c)
    {
      image->GetPointData()->GetScalars()->SetComponent(i, c, 100.0 * (number + c) + i % 12);
    }
  }
  return image;
}

class StylePlayback : public StyleTest
{
protected:
  StylePlayback()
  {
    for (int i = 0; i < 5; ++i)
    {
      this->Source->AddTimeStep(MakeNumbered(i), 2.0 + i);
    }
    this->Filter->SetInputConnection(0, this->Source->GetOutputPort());
    this->Filter->SetTimeUnitsPerSecond(10.0);
    this->Volume->SetMapper(this->Mapper);
    this->Renderer->AddVolume(this->Volume);
    this->Display->SetDevice(this->Device);
    this->Style->SetHeadUpDisplay(this->Display);
    this->Device->GetPlayback()->SetModeToPingPong();
  }
  void Start()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Run(2);
  }
  vtkImageData* GetShown()
  {
    return vtkImageData::SafeDownCast(this->Mapper->GetInputDataObject(0, 0));
  }
  int GetShownNumber()
  {
    return static_cast<int>(
      this->GetShown()->GetPointData()->GetScalars()->GetComponent(0, 0) / 100.0);
  }
  /// Expects that the scene displays the time step nearest to the data time. The first time step is
  /// at `first`, and the others follow at intervals of 1.
  void ExpectWhatIsFelt(double first)
  {
    const double number = this->Device->GetPlayback()->GetDataTime() - first;
    EXPECT_LE(std::abs(this->GetShownNumber() - number), 0.5 + 1e-9);
    EXPECT_EQ(this->Device->GetPlayback()->GetTimeStepValue(), first + this->GetShownNumber());
    EXPECT_EQ(this->GetShown()->GetPointData()->GetScalars()->GetNumberOfComponents(), 1);
  }
  /// Runs the playback until the scene has displayed `count` different time steps.
  void WatchTimeSteps(double first, std::size_t count)
  {
    std::vector<int> seen;
    ASSERT_TRUE(Eventually(
      [&]
      {
        this->Style->UpdateHaptics();
        // The time steps are in memory, so they must never be late.
        EXPECT_FALSE(this->Device->GetPlayback()->IsWaitingForData());
        if (this->Device->GetPlayback()->HasTimeSteps())
        {
          this->ExpectWhatIsFelt(first);
          if (std::find(seen.begin(), seen.end(), this->GetShownNumber()) == seen.end())
          {
            seen.push_back(this->GetShownNumber());
          }
        }
        return seen.size() == count;
      }));
  }

  vtkNew<vtkHapticTimeStepSource> Source;
  vtkNew<vtkGPUVolumeRayCastMapper> Mapper;
  vtkNew<vtkVolume> Volume;
  vtkNew<vtkHapticHeadUpDisplay> Display;
};
} // namespace

TEST_F(StylePlayback, WhatIsSeenIsWhatIsFelt)
{
  this->Mapper->SetInputConnection(this->Source->GetOutputPort());
  this->Start();
  EXPECT_EQ(this->GetShown(), this->Source->GetOutput());
  EXPECT_FALSE(this->Device->GetPlayback()->HasTimeSteps());
  EXPECT_EQ(this->Device->GetPlayback()->GetTimeStepImage(), nullptr);
  EXPECT_EQ(this->Display->GetText().find("Time"), std::string::npos);
  this->Press("space");
  this->WatchTimeSteps(2.0, 5);
  EXPECT_NE(this->Display->GetText().find(", back and forth"), std::string::npos)
    << this->Display->GetText();
  this->Press("space");
  EXPECT_NE(this->Display->GetText().find("paused"), std::string::npos);
  // The displayed image must share the array of the time step.
  EXPECT_EQ(this->GetShown()->GetPointData()->GetScalars(),
    this->Source->GetTimeStepImage(this->GetShownNumber())->GetPointData()->GetScalars());
  // Cropping the displayed volume must cause a warning, because the felt time step is not cropped.
  this->Mapper->SetCroppingRegionPlanes(0.0, 5.0, 0.0, 5.0, 0.0, 5.0);
  this->Mapper->CroppingOn();
  this->Run(2);
  ASSERT_EQ(this->Log.Warnings.size(), 1U);
  EXPECT_NE(this->Log.Warnings[0].find("crops it"), std::string::npos);
  this->Log.Warnings.clear();
  this->Style->SetDevice(nullptr);
  EXPECT_EQ(this->GetShown(), this->Source->GetOutput());
}

TEST_F(StylePlayback, TellsThatTimeStepsAreLate)
{
  vtkNew<apitest::TimeSource> reader;
  reader->Steps = { 0.0, 1.0, 2.0, 3.0, 4.0 };
  reader->Make = [](double time) { return MakeNumbered(static_cast<int>(time)); };
  this->Filter->SetInputConnection(0, reader->GetOutputPort());
  this->Start();
  this->Device->GetPlayback()->SetDataTime(0.0);
  ASSERT_TRUE(Eventually(
    [&] { return this->Device->UpdateState() && this->Device->GetPlayback()->HasTimeSteps(); }));
  EXPECT_EQ(this->Display->GetText().find("waiting"), std::string::npos);
  // After a jump to another data time, the servo waits until the time steps are loaded.
  this->Device->GetPlayback()->SetDataTime(4.0);
  ASSERT_TRUE(Eventually([&]
    { return this->Device->UpdateState() && this->Device->GetPlayback()->IsWaitingForData(); }));
  EXPECT_NE(this->Display->GetText().find("paused, waiting for data"), std::string::npos)
    << this->Display->GetText();
  // The scene may display the new time step before the servo reports that the step is available.
  ASSERT_TRUE(Eventually(
    [&]
    {
      return this->Device->UpdateState() &&
        this->Device->GetPlayback()->GetTimeStepValue() == 4.0 &&
        !this->Device->GetPlayback()->IsWaitingForData();
    }));
  EXPECT_EQ(this->Display->GetText().find("waiting"), std::string::npos);
}

TEST_F(StylePlayback, AnImageWithTheFirstTimeStepsScalarsIsTheSame)
{
  vtkNew<vtkImageData> plain;
  plain->ShallowCopy(this->Source->GetTimeStepImage(0));
  plain->SetOrigin(-3.0, 0.0, 0.0); // sets an origin that the volume's matrix compensates
  vtkNew<vtkMatrix4x4> placed;
  placed->SetElement(0, 3, 3.0);
  this->Volume->SetUserMatrix(placed);
  this->Mapper->SetInputData(plain);
  this->Start();
  this->Device->GetPlayback()->Play();
  this->WatchTimeSteps(2.0, 5);
  EXPECT_EQ(this->GetShown()->GetOrigin()[0], -3.0);
  EXPECT_TRUE(this->Log.Warnings.empty());
  this->Style->SetDevice(nullptr);
  EXPECT_EQ(this->GetShown(), plain.GetPointer());
}

TEST_F(StylePlayback, ComponentsAreShownOneByOne)
{
  const auto timeSteps = MakeNumbered(0, 5);
  this->Filter->SetInputData(0, timeSteps);
  this->Filter->SetFramesToComponents();
  const auto first = MakeNumbered(0);
  this->Mapper->SetInputData(first);
  this->Start();
  this->Press("space");
  this->WatchTimeSteps(0.0, 5);
}

TEST_F(StylePlayback, AMaskOfTheSameShapeIsNoComponent)
{
  this->Filter->SetInputData(0, MakeNumbered(0, 5));
  this->Filter->SetFramesToComponents();
  const auto mask = MakeNumbered(2);
  for (vtkIdType i = 0; i < mask->GetNumberOfPoints(); i += 3)
  {
    mask->GetPointData()->GetScalars()->SetComponent(i, 0, 1.0);
  }
  this->Mapper->SetInputData(mask);
  const auto turned = MakeNumbered(2);
  turned->SetDirectionMatrix(0, 1, 0, -1, 0, 0, 0, 0, 1);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(turned);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  this->Renderer->AddVolume(volume);
  this->Start();
  this->Press("space");
  ASSERT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetPlayback()->HasTimeSteps();
    }));
  this->Run(20);
  EXPECT_EQ(this->GetShown(), mask);
  EXPECT_EQ(mapper->GetInputDataObject(0, 0), turned);
}

TEST_F(StylePlayback, AVolumeThatShowsSomethingElseIsLeftAlone)
{
  const auto other = MakeNumbered(7);
  this->Mapper->SetInputData(other);
  this->Start();
  this->Press("space");
  ASSERT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetPlayback()->HasTimeSteps();
    }));
  this->Run(20);
  EXPECT_EQ(this->GetShown(), other);
}

TEST_F(StylePlayback, KeysGoFromTimeStepToTimeStep)
{
  this->Start();
  const auto expect = [this](const char* key, double time)
  {
    this->Press(key);
    EXPECT_FALSE(this->Device->GetPlayback()->IsPlaying());
    ASSERT_TRUE(Eventually(
      [&]
      {
        this->Style->UpdateHaptics();
        return this->Device->GetPlayback()->HasTimeSteps() &&
          this->Device->GetPlayback()->GetDataTime() == time &&
          !this->Device->GetPlayback()->IsWaitingForData() &&
          this->Device->GetPlayback()->GetTimeStepValue() == time;
      }))
      << key << " " << time << ", but at " << this->Device->GetPlayback()->GetDataTime();
  };
  expect("Right", 3.0);
  expect("Right", 4.0);
  expect("Left", 3.0);
  expect("Left", 2.0);
  expect("Left", 6.0);
  expect("Right", 2.0);
  this->Device->GetPlayback()->SetDataTime(4.25);
  this->Run(2);
  expect("Left", 4.0);
}

/// Sends a release and a press at the same time, as X servers do for a held key. The key must
/// switch only once.
TEST_F(StylePlayback, AKeyThatIsHeldSwitchesOnce)
{
  this->Start();
  this->Press("space");
  ASSERT_TRUE(this->Device->GetPlayback()->IsPlaying());
  int switches = 0;
  for (int i = 0; i < 20; ++i)
  {
    const bool wasPlaying = this->Device->GetPlayback()->IsPlaying();
    this->Press("space", vtkCommand::KeyReleaseEvent);
    this->Press("space");
    switches += this->Device->GetPlayback()->IsPlaying() != wasPlaying;
  }
  EXPECT_LE(switches, 4) << "but for pauses of a busy machine";
  const double speed = this->Device->GetPlayback()->GetSpeed();
  this->Press("period");
  this->Press("period", vtkCommand::KeyReleaseEvent);
  this->Press("period");
  EXPECT_EQ(this->Device->GetPlayback()->GetSpeed(), 4.0 * speed) << "steps go on";
}

TEST_F(StylePlayback, KeysChangeTheSpeedAndWhatIsAtTheEnd)
{
  this->Start();
  this->Press("period");
  EXPECT_EQ(this->Device->GetPlayback()->GetSpeed(), 2.0);
  this->Device->GetPlayback()->SetSpeed(-0.5);
  this->Press("comma");
  EXPECT_EQ(this->Device->GetPlayback()->GetSpeed(), -0.25);
  for (int i = 0; i < 20; ++i)
  {
    this->Press("period");
  }
  EXPECT_EQ(this->Device->GetPlayback()->GetSpeed(), -64.0);
  for (const int playback : { vtkHapticPlayback::ONCE, vtkHapticPlayback::LOOP,
         vtkHapticPlayback::PING_PONG, vtkHapticPlayback::ONCE })
  {
    this->Press("b");
    EXPECT_EQ(this->Device->GetPlayback()->GetMode(), playback);
  }
  this->Device->GetPlayback()->SetSpeed(std::nan(""));
  EXPECT_EQ(this->Device->GetPlayback()->GetSpeed(), -64.0);
  // Playback keys must not change anything for a volume without time steps.
  this->Filter->SetInputData(0, this->Ball);
  this->Press("b");
  this->Press("space");
  EXPECT_EQ(this->Device->GetPlayback()->GetMode(), vtkHapticPlayback::ONCE);
  EXPECT_FALSE(this->Device->GetPlayback()->IsPlaying());
}

TEST_F(StylePlayback, TheSourceKeepsTheOrderOfTimesAndRefusesWhatIsNoTimeStep)
{
  vtkNew<vtkHapticTimeStepSource> source;
  const MessageLog log(source);
  EXPECT_FALSE(source->AddTimeStep(nullptr, 0.0));
  EXPECT_FALSE(source->AddTimeStep(MakeNumbered(0), std::nan("")));
  source->Update();
  ASSERT_EQ(log.Errors.size(), 3U);
  EXPECT_NE(log.Errors[2].find("There are no frames"), std::string::npos);
  source->Update(); // updates only the data, as VTK requests here
  EXPECT_EQ(source->GetOutput()->GetNumberOfPoints(), 0);
  EXPECT_TRUE(source->AddTimeStep(MakeNumbered(1), 5.0));
  EXPECT_TRUE(source->AddTimeStep(MakeNumbered(0), -1.0));
  EXPECT_TRUE(source->AddTimeStep(MakeNumbered(2), 5.0));
  ASSERT_EQ(source->GetNumberOfTimeSteps(), 2);
  EXPECT_EQ(source->GetTimeStepValue(0), -1.0);
  EXPECT_EQ(source->GetTimeStepImage(1)->GetScalarComponentAsDouble(0, 0, 0, 0), 200.0);
  EXPECT_EQ(source->GetTimeStepImage(2), nullptr);
  for (const double time : { -9.0, -1.0, 4.9, 5.0, 9.0 })
  {
    source->UpdateTimeStep(time);
    EXPECT_EQ(
      source->GetOutput()->GetScalarComponentAsDouble(0, 0, 0, 0), time < 5.0 ? 0.0 : 200.0);
  }
}
