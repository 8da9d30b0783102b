// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the style's timer: it draws coarsely while something moves, and finely at rest. It does not
 * draw continuously if only numbers change.
 */

#include "VTK/Scene/Interaction/StyleRig.h"

#include "VTK/Scene/Display/HapticWrappedText.h"
#include "VTK/Scene/Frames/FrameQuality.h"
#include "VTK/Scene/Frames/HapticRenderPace.h"

#include <thread>

using namespace scenetest;

namespace
{
class StylePaceTest : public StyleTest
{
protected:
  StylePaceTest()
  {
    vtkNew<vtkCallbackCommand> note;
    note->SetClientData(this);
    note->SetCallback(
      [](vtkObject* window, unsigned long, void* self, void*)
      {
        auto* const test = static_cast<StylePaceTest*>(self);
        const double rate = static_cast<vtkRenderWindow*>(window)->GetDesiredUpdateRate();
        ++(rate == test->Interactor->GetDesiredUpdateRate() ? test->Quick : test->Still);
        std::this_thread::sleep_for(std::chrono::milliseconds(test->Slowness));
      });
    this->Window->AddObserver(vtkCommand::StartEvent, note);
  }
  /// Fires the style's timer for this time (ms), as an interactor's loop does. Calls `between`
  /// before each event.
  template <typename F>
  void Time(int milliseconds, F&& between)
  {
    this->Quick = 0;
    this->Still = 0;
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
    for (int i = 0; Clock::now() < end; ++i)
    {
      between(i);
      // Wait until the servo has processed a motion of the hand, which is drawn only then.
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      this->Interactor->InvokeEvent(vtkCommand::TimerEvent, &this->Timer);
    }
  }
  void Start()
  {
    this->Interactor->Initialize();
    while (this->Interactor->GetTimerDuration(this->Timer) == 0)
    {
      ++this->Timer;
      ASSERT_LT(this->Timer, 1000) << "the style has no timer";
    }
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Pointer(150, 150);
    this->Style->TouchModeOn();
    this->Time(800, [](int) {}); // runs until the hand is armed and drawn, and the scene is at rest
  }

  int Timer = 1;
  int Quick = 0;
  int Still = 0;
  int Slowness = 0; ///< sleep (ms) in each frame
};
} // namespace

TEST_F(StylePaceTest, DrawsAtTheInteractiveRateWhileTheTipMoves)
{
  this->Start();
  this->Time(500, [this](int i) { this->Pointer(100 + i % 100, 150); });
  EXPECT_GT(this->Quick, 5);
  EXPECT_EQ(this->Still, 0);
}

TEST_F(StylePaceTest, DrawsWellOnceAtRestAndThenForTheFigures)
{
  this->Start();
  this->Pointer(180, 150);
  this->Time(200, [](int) {});
  EXPECT_GE(this->Quick, 1);
  EXPECT_EQ(this->Still, 0) << "not yet at rest";
  this->Slowness = 60;
  this->Time(1500, [](int) {});
  EXPECT_GE(this->Still, 1);
  EXPECT_LE(this->Still, 4) << "frames that take 60 ms may come every 600 ms";
  EXPECT_EQ(this->Quick, 0);
}

// After a slow frame, the style must leave time for input. Otherwise, thirty waiting mouse motions
// would cause thirty frames, and a key pressed after them would be handled 30 frames late.
TEST(RenderPace, LeavesTimeForInputAfterASlowFrame)
{
  using VolumeHaptics::HapticRenderPace;
  using Frame = HapticRenderPace::Frame;
  HapticRenderPace pace;
  const auto next = [&](double now) { return pace.Next(now, true, false); };
  pace.Drawn(true, 1.0, 0.04);
  EXPECT_EQ(next(1.0), Frame::Quick) << "25 frames a second have no gap";
  pace.Drawn(true, 2.0, 0.2);
  EXPECT_EQ(next(2.04), Frame::None);
  EXPECT_EQ(next(2.06), Frame::Quick) << "a quarter of the frame is enough";
  pace.Drawn(true, 3.0, 2.0);
  EXPECT_EQ(next(3.09), Frame::None);
  EXPECT_EQ(next(3.11), Frame::Quick) << "a tenth of a second is the most";
}

TEST(RenderPace, HasNoGapWhereNothingWaits)
{
  using VolumeHaptics::HapticRenderPace;
  using Frame = HapticRenderPace::Frame;
  HapticRenderPace pace;
  pace.Drawn(true, 1.0, 0.2);
  EXPECT_EQ(pace.Next(1.01, true, false), Frame::None);
  EXPECT_EQ(pace.Next(1.01, true, false, true), Frame::Quick);
  EXPECT_FALSE(pace.IsLate(1.002)) << "the motion before is not felt yet";
  EXPECT_TRUE(pace.IsLate(1.005));
  EXPECT_FALSE(pace.IsLate(1.3)) << "the first motion after a rest is not felt yet";
  EXPECT_TRUE(pace.IsFirst(1.3));
  EXPECT_FALSE(pace.IsFirst(1.01)) << "the stroke goes on";
  pace.Drawn(false, 1.6, 0.4);
  EXPECT_TRUE(pace.IsFirst(1.601)) << "a motion that has interrupted a frame at rest";
  pace.Drawn(true, 2.0, 0.015);
  EXPECT_FALSE(pace.IsLate(2.015)) << "timers are quick enough for quick frames";
}

TEST(RenderPace, AFrameThatWasGivenUpIsDueAtOnceAndAnInterruptedOneAfterARest)
{
  using VolumeHaptics::HapticRenderPace;
  using Frame = HapticRenderPace::Frame;
  HapticRenderPace pace;
  pace.Drawn(false, 1.0, 1.0);
  pace.Interrupted(1.01);
  EXPECT_EQ(pace.Next(1.02, false, true), Frame::None);
  pace.GivenUp();
  EXPECT_EQ(pace.Next(1.02, false, true), Frame::Still);
  EXPECT_EQ(pace.Next(1.02, true, true), Frame::Quick) << "the hand comes first";
}

TEST(TextPace, FiguresWaitInMotionAndWordsDoNot)
{
  VolumeHaptics::HapticTextPace pace;
  EXPECT_EQ(pace.Choose("fat, 0.6 N", false, 1.0), "fat, 0.6 N");
  EXPECT_EQ(pace.Choose("fat, 0.7 N", false, 1.001), "fat, 0.7 N") << "at rest";
  EXPECT_EQ(pace.Choose("fat, 10.8 N", true, 2.0), "fat, 0.7 N") << "the first of a motion";
  EXPECT_EQ(pace.Choose("fat, 0.9 N", true, 2.03), "fat, 0.9 N");
  EXPECT_EQ(pace.Choose("fat, 1.0 N", true, 2.12), "fat, 0.9 N");
  EXPECT_EQ(pace.Choose("bone, 1.1 N", true, 2.125), "bone, 1.1 N");
  EXPECT_EQ(pace.Choose("bone, 1.2 N", true, 2.22), "bone, 1.1 N");
  EXPECT_EQ(pace.Choose("bone, 1.3 N", true, 2.23), "bone, 1.3 N");
  EXPECT_EQ(pace.Choose("bone, 1.4 N", false, 2.24), "bone, 1.4 N");
  EXPECT_EQ(pace.Choose("", true, 2.25), "");
}

TEST(RayProgress, TellsTheTimeOfAllRowsByThoseThatAreDone)
{
  VolumeHaptics::RayProgress progress;
  progress.Begin(0.2);
  progress.Record(0.25, 0.05);
  EXPECT_FALSE(progress.GetWhole()) << "too few rows tell nothing";
  progress.Record(0.45, 0.25);
  ASSERT_TRUE(progress.GetWhole());
  EXPECT_DOUBLE_EQ(*progress.GetWhole(), 1.2); // 0.2 + 0.25 / 0.25
  progress.Begin(0.1);
  EXPECT_FALSE(progress.GetWhole()) << "that was another frame";
}

TEST_F(StylePaceTest, AMotionOfTheMouseDrawsWhileTimersAreLate)
{
  this->Start();
  this->Slowness = 40;
  this->Pointer(150, 150);
  this->Style->SetTouchMode(true);
  this->Time(400, [this](int i) { this->Pointer(150 + i % 20, 150); });
  ASSERT_GT(this->Quick, 0);
  int drawn = 0;
  for (int i = 0; i < 40; ++i)
  {
    // Wait until the servo has processed the motion.
    std::this_thread::sleep_for(std::chrono::milliseconds(8));
    this->Quick = 0;
    this->Pointer(150 + 6 * (i % 4), 150);
    drawn += this->Quick;
    // The timer must draw the motion after a pause.
    this->Interactor->InvokeEvent(vtkCommand::TimerEvent, &this->Timer);
  }
  EXPECT_GE(drawn, 4) << "motions have left it to the timer";
}

TEST_F(StylePaceTest, LeavesTheFramesOfAWidgetAsQuickAsItWantsThem)
{
  this->Start();
  // VTK's widgets call vtkInteractorObserver::StartInteraction() before a drag, which sets this
  // rate.
  this->Window->SetDesiredUpdateRate(this->Interactor->GetDesiredUpdateRate());
  this->Style->SetTouchMode(false); // makes the style draw one frame at rest
  this->Time(800, [](int) {});
  EXPECT_GT(this->Still, 0);
  this->Quick = 0;
  this->Interactor->Render();
  EXPECT_EQ(this->Quick, 1) << "the widget's next frame";
}
