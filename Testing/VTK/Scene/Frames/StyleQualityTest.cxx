// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the rendering quality of volumes in a window on the screen: coarse in motion, as the
 * application has set it at rest, and never so fine that a frame blocks the hand.
 */

#include "QualityRig.h"

#include "Rigs/EventCounter.h"

#include <vtkHapticTimeStepSource.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkSmartVolumeMapper.h>

#include <string>

using namespace scenetest;

TEST_F(StyleQualityTest, MotionCastsFewerRaysIfFramesAreSlow)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.25f);
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 4);
  EXPECT_GT(mapper->GetImageSampleDistance(), 2.0f);
  EXPECT_GT(mapper->GetSampleDistance(), 0.25f);
  EXPECT_LE(mapper->GetSampleDistance(), 1.0f) << "rays miss what is thinner than a voxel";
  this->Slowness = 0;
  this->Draw(AtRest, 1);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f);
  EXPECT_EQ(mapper->GetSampleDistance(), 0.25f);
  EXPECT_EQ(mapper->GetAutoAdjustSampleDistances(), 0);
}

TEST_F(StyleQualityTest, AVolumeThatIsQuicklyDrawnIsDrawnFinely)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 4);
  const float coarse = mapper->GetImageSampleDistance();
  this->Slowness = 0;
  this->Window->SetSize(30, 30);
  this->Draw(InMotion, 8);
  EXPECT_LT(mapper->GetImageSampleDistance(), coarse);
}

TEST_F(StyleQualityTest, WhatTheApplicationSetsMeanwhileCounts)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 3);
  mapper->SetSampleDistance(0.125f);
  mapper->SetImageSampleDistance(2.0f);
  this->Draw(AtRest, 1);
  EXPECT_EQ(mapper->GetSampleDistance(), 0.125f);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 2.0f);
  this->Draw(InMotion, 3);
  ASSERT_NE(mapper->GetSampleDistance(), 0.125f);
  this->Interactor->SetInteractorStyle(nullptr);
  EXPECT_EQ(mapper->GetSampleDistance(), 0.125f);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 2.0f);
}

TEST_F(StyleQualityTest, AFrameThatCanNotBeInterruptedDoesNotBlockAnArmedHand)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Slowness = 400;
  this->Draw(AtRest, 2);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f) << "nobody waits";
  this->Arm();
  this->Draw(AtRest, 2);
  EXPECT_GE(mapper->GetImageSampleDistance(), 2.0f);
  this->Device->Disarm();
  ASSERT_TRUE(Eventually(
    [this]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetStatus() != vtkHapticDevice::ARMED;
    }));
  this->Draw(AtRest, 1);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f);
}

TEST_F(StyleQualityTest, AFrameThatCanBeInterruptedDoesNotCostAnArmedHandItsForce)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Slowness = 800;
  this->Draw(AtRest, 2);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f) << "nobody holds a device";
  this->Arm();
  this->Draw(AtRest, 2);
  EXPECT_GT(mapper->GetImageSampleDistance(), 1.0f);
  this->Slowness = 0;
  this->Draw(AtRest, 4);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f) << "there is time for all rays";
}

TEST_F(StyleQualityTest, SmartMapperCastsRaysOnTheProcessorWhereOpenGLRunsThere)
{
  vtkNew<vtkSmartVolumeMapper> mapper;
  this->Show(mapper.GetPointer());
  this->Draw(AtRest, 1);
  if (std::string(this->Window->ReportCapabilities()).find("llvmpipe") == std::string::npos)
  {
    GTEST_SKIP() << "OpenGL runs on a graphics card";
  }
  EXPECT_EQ(mapper->GetRequestedRenderMode(), vtkSmartVolumeMapper::DefaultRenderMode);
  this->Arm();
  this->Draw(AtRest, 1);
  EXPECT_EQ(mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::RayCastRenderMode);
  this->Style->AutoAdjustVolumeQualityOff();
  this->Style->UpdateHaptics();
  EXPECT_EQ(mapper->GetRequestedRenderMode(), vtkSmartVolumeMapper::DefaultRenderMode);
}

TEST_F(StyleQualityTest, SmartMapperCastsAllRaysAgainAtRest)
{
  struct Parts : vtkSmartVolumeMapper
  {
    static vtkFixedPointVolumeRayCastMapper* Find(vtkSmartVolumeMapper* mapper)
    {
      return mapper->*(&Parts::RayCastMapper);
    }
  };
  vtkNew<vtkSmartVolumeMapper> mapper;
  this->Show(mapper.GetPointer());
  this->Draw(AtRest, 1);
  if (std::string(this->Window->ReportCapabilities()).find("llvmpipe") == std::string::npos)
  {
    GTEST_SKIP() << "OpenGL runs on a graphics card";
  }
  const float sample = mapper->GetSampleDistance();
  this->Arm();
  this->Slowness = 100;
  this->Draw(InMotion, 5);
  ASSERT_EQ(mapper->GetLastUsedRenderMode(), vtkSmartVolumeMapper::RayCastRenderMode);
  EXPECT_GT(Parts::Find(mapper)->GetImageSampleDistance(), 2.0f);
  EXPECT_LE(Parts::Find(mapper)->GetSampleDistance(), 1.0f) << "rays miss what is thinner";
  this->Draw(AtRest, 8); // draws until all rays are cast
  EXPECT_EQ(Parts::Find(mapper)->GetImageSampleDistance(), 1.0f);
  const float atRest = Parts::Find(mapper)->GetSampleDistance();
  this->Slowness = 0;
  this->Draw(InMotion, 1);
  EXPECT_EQ(Parts::Find(mapper)->GetImageSampleDistance(), 1.0f) << "the rays are kept";
  EXPECT_EQ(Parts::Find(mapper)->GetSampleDistance(), atRest);
  this->Style->AutoAdjustVolumeQualityOff();
  this->Style->UpdateHaptics();
  EXPECT_EQ(mapper->GetSampleDistance(), sample);
  EXPECT_NE(mapper->GetInteractiveAdjustSampleDistances(), 0);
  EXPECT_NE(mapper->GetAutoAdjustSampleDistances(), 0);
}

TEST_F(StyleQualityTest, AVolumeThatPlaysIsDrawnAsOneThatIsTouched)
{
  vtkNew<vtkHapticTimeStepSource> frames;
  frames->AddTimeStep(this->Ball, 0.0);
  vtkNew<vtkImageData> other;
  other->DeepCopy(this->Ball);
  frames->AddTimeStep(other, 1.0);
  this->Filter->SetInputConnection(0, frames->GetOutputPort());
  vtkNew<vtkSmartVolumeMapper> mapper;
  this->Show(mapper.GetPointer());
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Draw(AtRest, 1);
  if (std::string(this->Window->ReportCapabilities()).find("llvmpipe") == std::string::npos)
  {
    GTEST_SKIP() << "OpenGL runs on a graphics card";
  }
  EXPECT_EQ(mapper->GetRequestedRenderMode(), vtkSmartVolumeMapper::DefaultRenderMode);
  this->Device->GetPlayback()->SetModeToLoop();
  this->Device->GetPlayback()->Play();
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Style->UpdateHaptics();
      return this->Device->GetPlayback()->HasTimeSteps();
    }));
  this->Draw(InMotion, 1);
  EXPECT_EQ(mapper->GetRequestedRenderMode(), vtkSmartVolumeMapper::RayCastRenderMode);
  this->Device->GetPlayback()->Hold();
  this->Draw(AtRest, 1);
  EXPECT_EQ(mapper->GetRequestedRenderMode(), vtkSmartVolumeMapper::DefaultRenderMode);
}

TEST_F(StyleQualityTest, PicturesOffTheScreenAreLeftAlone)
{
  this->Window->SetOffScreenRendering(1);
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 3);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f);
  EXPECT_NE(mapper->GetAutoAdjustSampleDistances(), 0);
}

TEST_F(StyleQualityTest, PicturesThatAreShownElsewhereAreDrawnAsThoseOfAWindow)
{
  this->Window->SetOffScreenRendering(1);
  this->Style->AutoAdjustOffScreenOn();
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 4);
  EXPECT_GT(mapper->GetImageSampleDistance(), 2.0f);
  this->Style->AutoAdjustOffScreenOff();
  this->Style->UpdateHaptics();
  this->Draw(InMotion, 1);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f) << "the mapper has its own setting back";
}

TEST_F(StyleQualityTest, AnApplicationWithoutTimersDrawsWhatTheTimerWould)
{
  vtkNew<vtkOpenGLGPUVolumeRayCastMapper> mapper;
  this->Window->SetOffScreenRendering(1);
  this->Show(mapper.GetPointer());
  this->Draw(AtRest, 1);
  const apitest::EventCounter frames(this->Interactor, vtkCommand::RenderEvent);
  EXPECT_FALSE(this->Style->DrawHaptics()) << "nothing has happened";
  EXPECT_EQ(frames.Count, 0);
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Device->GetVirtualHand()->SetPosition(40.0, 0.0, 0.0);
  ASSERT_TRUE(Eventually([this] { return this->Style->DrawHaptics(); }));
  EXPECT_GT(frames.Count, 0);
}
