// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a touch of half a minute, with the servo at 1 kHz and frames as fast as possible. No state
 * may be missed, and memory must not grow.
 */

#include "StyleRig.h"

#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticRepresentation.h>

#include <fstream>
#include <iostream>

#include <unistd.h>

VTK_MODULE_INIT(vtkRenderingContextOpenGL2)

using namespace scenetest;

namespace
{
/// Returns the resident memory (MiB) of this process.
double ResidentMemory()
{
  double total = 0.0;
  double resident = 0.0;
  std::ifstream("/proc/self/statm") >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE)) / (1024.0 * 1024.0);
}
class LongRunTest : public StyleTest
{
protected:
  /// Prints the time that the display, its text and its plot add to a frame with new states. The
  /// four cases alternate between frames.
  void PrintCost(vtkHapticHeadUpDisplay* display)
  {
    double cost[4] = {};
    constexpr int frames = 800;
    for (int i = 0; i < frames; ++i)
    {
      this->Pointer(150 + static_cast<int>(40.0 * std::sin(0.02 * i)), 150);
      const int shown = i % 4;
      display->SetTextVisibility(shown & 1);
      display->SetPlotVisibility(shown >> 1);
      this->Style->UpdateHaptics();
      const auto start = std::chrono::steady_clock::now();
      this->Window->Render();
      const std::chrono::duration<double, std::milli> time =
        std::chrono::steady_clock::now() - start;
      cost[shown] += time.count() / (frames / 4);
    }
    std::cout << "A frame takes " << cost[0] << " ms; the head-up display adds "
              << cost[3] - cost[0] << " ms, its text alone " << cost[1] - cost[0]
              << ", its plot alone " << cost[2] - cost[0] << ".\n";
  }
};
} // namespace

TEST_F(LongRunTest, HalfAMinuteMissesNoState)
{
  vtkNew<vtkHapticRepresentation> hand;
  vtkNew<vtkHapticHeadUpDisplay> display;
  hand->SetDevice(this->Device);
  display->SetDevice(this->Device);
  MessageLog displayLog(display);
  this->Style->SetHeadUpDisplay(display);
  this->Renderer->AddViewProp(hand);
  this->Renderer->AddViewProp(display);
  ASSERT_TRUE(this->Device->Open("virtual"));
  ASSERT_TRUE(this->Device->Start());
  this->Pointer(150, 150);
  this->Style->TouchModeOn();

  using Clock = std::chrono::steady_clock;
  const Clock::time_point start = Clock::now();
  double last = -1.0;
  double begun = 0.0;
  vtkIdType states = 0;
  vtkIdType missing = 0;
  vtkIdType touched = 0;
  for (int frame = 0; Clock::now() - start < std::chrono::seconds(30); ++frame)
  {
    const double phase = 0.02 * frame;
    this->Pointer(150 + static_cast<int>(40.0 * std::sin(phase)), 150);
    if (frame % 50 < 2 && frame < 600)
    {
      this->Pointer(150, 150,
        frame % 100 < 50 ? vtkCommand::MouseWheelForwardEvent
                         : vtkCommand::MouseWheelBackwardEvent);
    }
    this->Style->UpdateHaptics();
    vtkTable* const table = this->Style->GetStates();
    auto* const ticks = vtkDataArray::SafeDownCast(table->GetColumnByName("Tick"));
    auto* const contact = vtkDataArray::SafeDownCast(table->GetColumnByName("Contact"));
    for (vtkIdType i = 0; i < table->GetNumberOfRows(); ++i)
    {
      missing += last >= 0.0 && ticks->GetComponent(i, 0) != last + 1.0 ? 1 : 0;
      touched += contact->GetComponent(i, 0) != 0.0 ? 1 : 0;
      last = ticks->GetComponent(i, 0);
      ++states;
    }
    this->Window->Render();
    if (begun == 0.0 && Clock::now() - start > std::chrono::seconds(10))
    {
      begun = ResidentMemory(); // measured after the plot has been full for some seconds
    }
  }
  EXPECT_EQ(missing, 0);
  EXPECT_GT(states, 1000);
  EXPECT_GT(touched, 100);
  EXPECT_LT(ResidentMemory() - begun, 16.0);
  EXPECT_TRUE(this->Log.Errors.empty());
  EXPECT_TRUE(displayLog.Errors.empty());
  this->PrintCost(display);
}
