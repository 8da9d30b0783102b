// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests frames of a mapper that casts rays on the processor. Late frames end early, and fine rays
 * are reused in motion.
 */

#include "QualityRig.h"

using namespace scenetest;

using StyleRaysTest = StyleQualityTest;

TEST_F(StyleRaysTest, AFrameThatTakesTooLongIsGivenUpWhileADeviceIsArmed)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  vtkNew<vtkCallbackCommand> sleep;
  sleep->SetCallback([](vtkObject*, unsigned long, void*, void*)
    { std::this_thread::sleep_for(std::chrono::milliseconds(300)); });
  mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, sleep, 1.0f);
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 0) << "nobody holds a device";
  mapper->RemoveObserver(sleep);
  this->Arm();
  this->Draw(AtRest, 8);
  ASSERT_EQ(mapper->GetImageSampleDistance(), 1.0f);
  mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, sleep, 1.0f);
  this->Renderer->GetActiveCamera()->Azimuth(10.0); // requires casting all rays again
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 1);
  mapper->RemoveObserver(sleep);
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 0);
  EXPECT_GT(mapper->GetImageSampleDistance(), 1.0f);
}

/// The first rows take 0.1 s each, so the frame would take 1.5 s, and the style aborts it. The next
/// frame must be coarser, and the stroke must keep its rays.
TEST_F(StyleRaysTest, AFrameThatWouldTakeTooLongIsGivenUpSoonAndTheStrokeIsFine)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetNumberOfThreads(1);
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 4);
  const float coarse = mapper->GetImageSampleDistance();
  this->Slowness = 0;
  this->Arm();
  this->Draw(AtRest, 8);
  ASSERT_EQ(mapper->GetImageSampleDistance(), 1.0f);
  SlowRows rows(mapper, 100);
  this->Renderer->GetActiveCamera()->Azimuth(10.0); // requires casting all rays again
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 1);
  EXPECT_LE(rows.Count, 5) << "of 15, of which 10 take 1 s";
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 0);
  const float fine = mapper->GetImageSampleDistance();
  EXPECT_GT(fine, 1.0f);
  ASSERT_LT(fine, coarse);
  rows.Slowness = 0;
  this->Draw(InMotion, 1);
  EXPECT_EQ(mapper->GetImageSampleDistance(), fine);
}

TEST_F(StyleRaysTest, AFrameThatInputInterruptsTellsHowLongItWouldHaveTaken)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetNumberOfThreads(1);
  this->Show(mapper.GetPointer());
  this->Draw(AtRest, 1);
  if (!this->Window->IsA("vtkXOpenGLRenderWindow"))
  {
    GTEST_SKIP() << "only the queue of X11 tells of motions";
  }
  this->Arm();
  this->Draw(AtRest, 8);
  ASSERT_EQ(mapper->GetImageSampleDistance(), 1.0f);
  SlowRows rows(mapper, 55);
  rows.Move = 5;
  this->Renderer->GetActiveCamera()->Azimuth(10.0); // requires casting all rays again
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 1);
  rows.Slowness = 0;
  this->Draw(AtRest, 1);
  EXPECT_GT(mapper->GetImageSampleDistance(), 1.0f) << "15 times 55 ms are more than 0.5 s";
}

TEST_F(StyleRaysTest, TheFirstFrameOfAllIsCoarseInMotion)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Draw(InMotion, 1);
  EXPECT_GE(mapper->GetImageSampleDistance(), 4.0f);
}

TEST_F(StyleRaysTest, TheFirstFrameInMotionIsAsCoarseAsThoseAtRestTell)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Draw(AtRest, 1);
  this->Renderer->GetActiveCamera()->Azimuth(10.0); // requires casting all rays again
  this->Draw(AtRest, 1);
  this->Renderer->GetActiveCamera()->Azimuth(10.0);
  this->Draw(InMotion, 1);
  EXPECT_LE(mapper->GetImageSampleDistance(), 3.0f) << "a frame at rest took less than 0.6 s";
}

TEST_F(StyleRaysTest, MotionIsAsFineAsTheFrameAtRestWhoseRaysItKeeps)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.25f);
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 4);
  EXPECT_GT(mapper->GetImageSampleDistance(), 2.0f);
  this->Slowness = 0;
  this->Draw(AtRest, 1);
  this->Draw(InMotion, 3);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f);
  EXPECT_EQ(mapper->GetSampleDistance(), 0.25f);
  this->Slowness = 100;
  this->Renderer->GetActiveCamera()->Azimuth(10.0);
  this->Draw(InMotion, 2);
  EXPECT_EQ(this->Window->GetAbortRender(), 0);
  EXPECT_GT(mapper->GetImageSampleDistance(), 2.0f) << "all rays are cast";
}

TEST_F(StyleRaysTest, ThreeFramesThatAreSlowThoughTheyKeepRaysMakeThemCoarseAgain)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 4);
  this->Draw(AtRest, 1);
  this->Slowness = 1000;
  for (int frame = 0; frame < 3; ++frame)
  {
    this->Draw(InMotion, 1);
    EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f) << frame;
  }
  this->Draw(InMotion, 1);
  EXPECT_GT(mapper->GetImageSampleDistance(), 2.0f);
}

TEST_F(StyleRaysTest, FineRaysAreKeptWhereCoarseOnesAreAsSlow)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Slowness = 100;
  this->Draw(InMotion, 8);
  EXPECT_GT(mapper->GetImageSampleDistance(), 2.0f);
  this->Draw(AtRest, 1);
  this->Draw(InMotion, 5);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f);
}

TEST_F(StyleRaysTest, AWindowOfANewSizeIsDrawnCoarselyFirst)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetNumberOfThreads(1);
  this->Show(mapper.GetPointer());
  SlowRows rows(mapper, 20); // 15 reports of 20 ms take 0.3 s
  this->Draw(AtRest, 1);
  ASSERT_EQ(mapper->GetImageSampleDistance(), 1.0f);
  this->Window->SetSize(140, 130);
  this->Interactor->InvokeEvent(vtkCommand::ExposeEvent, nullptr);
  this->Draw(AtRest, 1); // draws as the interactor does after an ExposeEvent
  EXPECT_GT(mapper->GetImageSampleDistance(), 1.0f);
  const auto isFine = [&]
  {
    this->Style->DrawHaptics();
    return mapper->GetImageSampleDistance() == 1.0f;
  };
  EXPECT_FALSE(isFine()) << "more sizes may come";
  EXPECT_TRUE(Eventually(isFine)) << "after a rest";
  // A script that sets the size and draws, without an ExposeEvent, must get all rays at once.
  this->Window->SetSize(120, 120);
  this->Draw(AtRest, 1);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f);
}

TEST_F(StyleRaysTest, AWindowOfANewSizeThatIsQuickIsFineAtOnce)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  this->Draw(AtRest, 1); // draws the first frame, which also computes the gradients
  this->Renderer->GetActiveCamera()->Azimuth(10.0);
  this->Draw(AtRest, 1);
  this->Window->SetSize(140, 130);
  this->Interactor->InvokeEvent(vtkCommand::ExposeEvent, nullptr);
  this->Draw(AtRest, 1);
  EXPECT_EQ(mapper->GetImageSampleDistance(), 1.0f);
}

TEST_F(StyleRaysTest, AMapperOfTwoRenderersKeepsNoRays)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  this->Show(mapper.GetPointer());
  vtkNew<vtkRenderer> second;
  this->Renderer->SetViewport(0.0, 0.0, 0.5, 1.0);
  second->SetViewport(0.5, 0.0, 1.0, 1.0);
  second->AddVolume(this->Volume);
  this->Window->AddRenderer(second);
  this->Slowness = 100;
  this->Draw(InMotion, 4);
  this->Draw(AtRest, 1);
  this->Draw(InMotion, 1);
  EXPECT_GT(mapper->GetImageSampleDistance(), 2.0f);
}

TEST_F(StyleRaysTest, InputInterruptsAFrameAtRest)
{
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->AutoAdjustSampleDistancesOff();
  mapper->SetSampleDistance(0.1f);
  this->Show(mapper.GetPointer());
  this->Draw(AtRest, 1);
  if (!this->Window->IsA("vtkXOpenGLRenderWindow"))
  {
    GTEST_SKIP() << "only the queue of X11 tells of motions";
  }
  ASSERT_EQ(this->Window->GetAbortRender(), 0);
  // Send a mouse motion during the frame.
  vtkNew<vtkCallbackCommand> move;
  move->SetClientData(this->Window);
  move->SetCallback([](vtkObject*, unsigned long, void* window, void*)
    { SendMotion(static_cast<vtkRenderWindow*>(window)); });
  mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, move, 1.0f);
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 1);
  mapper->RemoveObserver(move);
  // A frame in motion is short and must be displayed, so input must not interrupt it.
  this->Draw(InMotion, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 0);
}

/// After a frame that delays timers by about a second, the loop of VTK 9.1 would sleep until
/// another event arrives, so the style sends an event.
TEST_F(StyleRaysTest, TheLoopIsWokenAfterAFrameThatDelaysTimers)
{
  constexpr int noExpose = 14;
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  this->Show(mapper.GetPointer());
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Draw(AtRest, 1);
  if (!this->Window->IsA("vtkXOpenGLRenderWindow"))
  {
    GTEST_SKIP() << "only loops of X11 wait";
  }
  while (DrainEvent(this->Window, noExpose))
  {
  }
  const auto move = [this](double x)
  {
    this->Device->GetVirtualHand()->SetPosition(x, 0.0, 40.0);
    return Eventually([this] { return this->Style->DrawHaptics(); });
  };
  ASSERT_TRUE(move(10.0));
  AwaitServer(this->Window);
  EXPECT_FALSE(DrainEvent(this->Window, noExpose)) << "a quick frame";
  this->Slowness = 900;
  ASSERT_TRUE(move(-10.0));
  EXPECT_TRUE(Eventually([this] { return DrainEvent(this->Window, noExpose); }));
}
