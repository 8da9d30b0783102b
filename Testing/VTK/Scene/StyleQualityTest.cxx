// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * How finely volumes are drawn in a window that a person looks at: coarsely in motion, as the
 * application has set it at rest, and never so slowly that the hand waits.
 */

#include "StyleRig.h"

#include <vtkFixedPointVolumeRayCastMapper.h>
#include <vtkHapticFrameSource.h>
#include <vtkOpenGLGPUVolumeRayCastMapper.h>
#include <vtkSmartVolumeMapper.h>
#include <vtkVolume.h>
#include <vtkVolumeProperty.h>

#include <dlfcn.h>
#include <string>
#include <thread>

using namespace scenetest;

namespace
{
constexpr double InMotion = 15.0;
constexpr double AtRest = 0.001;

/// A motion of the mouse comes to the window, by X11's XSendEvent: the pointer itself may be over a
/// window of another test. The header of X11 defines macros that other tests must not see.
void SendMotion(vtkRenderWindow* window)
{
  using Send = int (*)(void* display, unsigned long window, int, long, void* event);
  static const auto send =
    reinterpret_cast<Send>(dlsym(dlopen("libX11.so.6", RTLD_LAZY), "XSendEvent"));
  constexpr int motionNotify = 6;
  struct // XMotionEvent, as far as it matters, in an XEvent
  {
    int Type;
    unsigned long Serial;
    int IsSent;
    void* Display;
    unsigned long Window;
    long Rest[24];
  } event = {};
  event.Type = motionNotify;
  event.Window = reinterpret_cast<unsigned long>(window->GetGenericWindowId());
  send(window->GetGenericDisplayId(), event.Window, 0, 0, &event);
}

class StyleQualityTest : public StyleTest
{
protected:
  StyleQualityTest()
  {
    this->Window->SetOffScreenRendering(0);
    this->Window->SetSize(120, 120);
    this->Volume->GetProperty()->GetScalarOpacity()->AddPoint(-1.0, 0.0);
    this->Volume->GetProperty()->GetScalarOpacity()->AddPoint(1.0, 1.0);
    this->Renderer->AddVolume(this->Volume);
    vtkNew<vtkCallbackCommand> wait;
    wait->SetClientData(this);
    wait->SetCallback(
      [](vtkObject*, unsigned long, void* self, void*)
      {
        std::this_thread::sleep_for(
          std::chrono::milliseconds(static_cast<StyleQualityTest*>(self)->Slowness));
      });
    this->Window->AddObserver(vtkCommand::EndEvent, wait, 1.0f); // before the style sees it
  }
  ~StyleQualityTest() override { this->Interactor->SetInteractorStyle(nullptr); }

  template <typename Mapper>
  void Show(Mapper* mapper)
  {
    mapper->SetInputData(this->Ball);
    this->Volume->SetMapper(mapper);
    this->Interactor->Initialize();
    this->Style->UpdateHaptics();
  }
  void Draw(double rate, int times)
  {
    this->Window->SetDesiredUpdateRate(rate);
    for (int i = 0; i < times; ++i)
    {
      this->Window->Render();
    }
  }
  void Arm()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Device->Arm();
    ASSERT_TRUE(Eventually(
      [this]
      {
        this->Style->UpdateHaptics();
        return this->Device->GetStatus() == vtkHapticDevice::ARMED;
      }));
  }

  vtkNew<vtkVolume> Volume;
  int Slowness = 0; ///< of a frame, ms
};
} // namespace

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

TEST_F(StyleQualityTest, AFrameThatTakesTooLongIsGivenUpWhileADeviceIsArmed)
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
  this->Renderer->GetActiveCamera()->Azimuth(10.0); // so that all rays are cast
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 1);
  mapper->RemoveObserver(sleep);
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 0);
  EXPECT_GT(mapper->GetImageSampleDistance(), 1.0f);
}

TEST_F(StyleQualityTest, MotionIsAsFineAsTheFrameAtRestWhoseRaysItKeeps)
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

/// One or two may be slow because the processor is busy.
TEST_F(StyleQualityTest, ThreeFramesThatAreSlowThoughTheyKeepRaysMakeThemCoarseAgain)
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

TEST_F(StyleQualityTest, AMapperOfTwoRenderersKeepsNoRays)
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

TEST_F(StyleQualityTest, InputInterruptsAFrameAtRest)
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
  // A motion of the mouse within the frame.
  vtkNew<vtkCallbackCommand> move;
  move->SetClientData(this->Window);
  move->SetCallback(
    [](vtkObject*, unsigned long, void* window, void*)
    {
      SendMotion(static_cast<vtkRenderWindow*>(window));
      std::this_thread::sleep_for(std::chrono::milliseconds(2)); // the X server's
    });
  mapper->AddObserver(vtkCommand::VolumeMapperRenderProgressEvent, move, 1.0f);
  this->Draw(AtRest, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 1);
  mapper->RemoveObserver(move);
  // A frame in motion is short, and has to be seen.
  this->Draw(InMotion, 1);
  EXPECT_EQ(this->Window->GetAbortRender(), 0);
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
  this->Draw(AtRest, 8); // finer, as far as there is time
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
  vtkNew<vtkHapticFrameSource> frames;
  frames->AddFrame(this->Ball, 0.0);
  vtkNew<vtkImageData> other;
  other->DeepCopy(this->Ball);
  frames->AddFrame(other, 1.0);
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
  this->Device->SetPlaybackToLoop();
  this->Device->Play();
  ASSERT_TRUE(Eventually(
    [&]
    {
      this->Style->UpdateHaptics();
      return this->Device->HasFrames();
    }));
  this->Draw(InMotion, 1);
  EXPECT_EQ(mapper->GetRequestedRenderMode(), vtkSmartVolumeMapper::RayCastRenderMode);
  this->Device->Hold();
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
  int frames = 0;
  vtkNew<vtkCallbackCommand> count;
  count->SetClientData(&frames);
  count->SetCallback(
    [](vtkObject*, unsigned long, void* number, void*) { ++*static_cast<int*>(number); });
  this->Interactor->AddObserver(vtkCommand::RenderEvent, count);
  EXPECT_FALSE(this->Style->DrawHaptics()) << "nothing has happened";
  EXPECT_EQ(frames, 0);
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Device->SetVirtualTip(40.0, 0.0, 0.0);
  ASSERT_TRUE(Eventually([this] { return this->Style->DrawHaptics(); }));
  EXPECT_GT(frames, 0);
}
