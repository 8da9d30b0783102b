// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "ScaleBenchmark.h"

#include "SparseVolume.h"

#include <vtkDoubleArray.h>
#include <vtkHapticDevice.h>
#include <vtkHapticFunctionEditor.h>
#include <vtkHapticLabelTable.h>
#include <vtkHapticProperty.h>
#include <vtkPiecewiseFunction.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkVolumeHapticsFilter.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace benchmarks
{
namespace
{
constexpr double LongestBlock = 50.0; // ms, limit for each call
/** Not limited, because this call waits for work that BeginProposal() does in the background. */
constexpr const char* WithoutHand = "without a hand: ProposeFromImage()";
constexpr double MebiBytes = 1.0 / (1 << 20);

struct CallCost
{
  double Milliseconds = 0.0;
  double Resident = 0.0; // MiB of the volume that became resident since the previous call
};

/** The calls of an application with a hand on a volume, in the order of a session. */
class Session
{
public:
  explicit Session(int size)
    : Volume(size)
    , Labels(size)
  {
    this->Filter->SetInputData(0, this->Volume.GetImage());
    this->Device->SetVolumeHaptics(this->Filter);
    this->Device->SetAttentionTime(2.0);
    this->Editor->SetProperty(this->Filter->GetProperty());
    this->Editor->SetInputData(this->Volume.GetImage());
    this->Editor->SetLabelTable(this->Table);
    this->Editor->SetLabelData(this->Labels.GetImage());
    const double middle = this->Volume.GetMiddle();
    vtkNew<vtkPoints> points;
    points->InsertNextPoint(middle, middle, middle);
    points->InsertNextPoint(middle, middle, middle + 1.0);
    this->Path->SetPoints(points);
  }

  void Run()
  {
    vtkVolumeHapticsFilter* const filter = this->Filter;
    vtkHapticDevice* const device = this->Device;
    const double middle = this->Volume.GetMiddle();
    filter->SetPathData(this->Path);
    this->Call("vtkVolumeHapticsFilter::Update(), first", [=] { filter->Update(); });
    filter->Modified();
    this->Call("vtkVolumeHapticsFilter::Update(), again", [=] { filter->Update(); });
    this->Call("Open()", [=] { device->Open("virtual"); });
    device->GetVirtualHand()->SetPosition(middle, middle, middle);
    this->Call("Start() to the first tick",
      [=]
      {
        device->Start();
        while (device->GetState()->GetTick() == 0)
        {
          device->UpdateState();
        }
      });
    this->Call("Arm()", [=] { device->Arm(); });
    this->Call("UpdateState()", [=] { this->Attend(200); });
    filter->GetProperty()->GetStiffness()->AddPoint(0.0, 400.0);
    this->Call("Publish() of another material", [=] { device->Publish(); });
    const std::string file = "volumehaptics-scale.vtp";
    this->Call("recorder->Start()", [&] { device->GetRecorder()->Start(file.c_str()); });
    this->Call("UpdateState(), recording", [=] { this->Attend(200); });
    this->Call("recorder->Stop(), armed", [=] { device->GetRecorder()->Stop(); });
    std::remove(file.c_str());
    this->Call("vtkHapticFunctionEditor::Update()", [this] { this->Editor->Update(); });
    this->Editor->SetFunctionToLabels();
    this->Call("the same of labels", [this] { this->Editor->Update(); });
    this->Editor->SetFunctionToStiffness();
    this->Call("BeginProposal() of the editor", [this] { this->Editor->BeginProposal(); });
    this->Call("Update() of the editor, proposing", [this] { this->PollProposal(); });
    filter->SetLabelData(this->Labels.GetImage());
    filter->SetLabelTable(this->Table);
    this->Call("Publish() with labels", [=] { device->Publish(); });
    this->Table->SetForbidden(600, true);
    this->Call("Publish() of a forbidden label", [=] { device->Publish(); });
    filter->SetLabelData(nullptr);
    filter->SetMethodToSurfaceProxy();
    filter->SetIsoValue(600.0);
    this->Call("Publish() of SURFACE_PROXY", [=] { device->Publish(); });
    filter->SetMethodToProxy();
    this->Call("Publish() of PROXY", [=] { device->Publish(); });
    this->Call("Close()", [=] { device->Close(); });
    this->Call(WithoutHand, [this] { this->Proposed->ProposeFromImage(this->Volume.GetImage()); });
  }

  std::vector<std::string> Names;
  std::map<std::string, CallCost> Costs;

private:
  void Call(const std::string& name, const std::function<void()>& call)
  {
    using Clock = std::chrono::steady_clock;
    const auto begin = Clock::now();
    call();
    const auto time = std::chrono::duration<double, std::milli>(Clock::now() - begin).count();
    const double resident =
      MebiBytes * static_cast<double>(this->Volume.GetResident() + this->Labels.GetResident());
    // If a step consists of several calls, report the longest call.
    const double longest = std::exchange(this->Longest, 0.0);
    this->Names.push_back(name);
    this->Costs[name] = { longest > 0.0 ? longest : time, resident - this->Resident };
    this->Resident = resident;
  }
  /** Calls UpdateState() periodically for a number of milliseconds, as a GUI does. */
  void Attend(int milliseconds)
  {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::milliseconds(milliseconds);
    for (auto now = Clock::now(); now < end; now = Clock::now())
    {
      this->Device->UpdateState();
      const double time = std::chrono::duration<double, std::milli>(Clock::now() - now).count();
      this->Longest = std::max(this->Longest, time);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  /** Updates the editor as a GUI does, until it has ended its search for functions. */
  void PollProposal()
  {
    using Clock = std::chrono::steady_clock;
    while (this->Editor->IsProposing())
    {
      const auto now = Clock::now();
      this->Device->UpdateState();
      this->Editor->Update();
      const double time = std::chrono::duration<double, std::milli>(Clock::now() - now).count();
      this->Longest = std::max(this->Longest, time);
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
  }

  SparseVolume Volume;
  SparseVolume Labels;
  vtkNew<vtkVolumeHapticsFilter> Filter;
  vtkNew<vtkHapticDevice> Device;
  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkHapticLabelTable> Table;
  vtkNew<vtkHapticProperty> Proposed;
  vtkNew<vtkPolyData> Path;
  double Resident = 0.0;
  double Longest = 0.0;
};

/** Waits until the background work on earlier volumes, which no hand uses any more, has ended. */
void AwaitBackground()
{
  constexpr auto pause = std::chrono::milliseconds(200);
  const std::clock_t idle = CLOCKS_PER_SEC / 100;
  std::clock_t before;
  do
  {
    before = std::clock(); // processor time of all threads
    std::this_thread::sleep_for(pause);
  } while (std::clock() - before > idle);
}
} // namespace

bool MeasureScale(int largest)
{
  std::vector<int> sizes;
  std::vector<std::unique_ptr<Session>> sessions;
  for (int size = 256; size <= largest; size *= 2)
  {
    AwaitBackground();
    sizes.push_back(size);
    sessions.push_back(std::make_unique<Session>(size));
    sessions.back()->Run();
  }
  if (sessions.empty())
  {
    std::printf("The smallest size is 256.\n");
    return false;
  }
  std::printf("Longest block of the owner's thread (ms), and MiB of the volume that the call, or "
              "work in the background, brought into memory\n\n%-42s",
    "");
  for (const int size : sizes)
  {
    std::printf("%12d^3      ", size);
  }
  std::printf("   growth\n");
  bool isAllShort = true;
  for (const std::string& name : sessions.front()->Names)
  {
    std::printf("%-42s", name.c_str());
    for (const auto& session : sessions)
    {
      const CallCost& cost = session->Costs[name];
      const bool isShort = cost.Milliseconds <= LongestBlock || name == WithoutHand;
      isAllShort = isAllShort && isShort;
      std::printf("%9.2f%s %8.1f  ", cost.Milliseconds, isShort ? " " : "!", cost.Resident);
    }
    std::printf("%8.1f\n",
      sessions.back()->Costs[name].Milliseconds /
        std::max(1.0, sessions.front()->Costs[name].Milliseconds));
  }
  std::printf("\nGrowth: the last time over the first one, of which less than 1 ms counts as 1 ms. "
              "! marks what is longer than %.0f ms.\n",
    LongestBlock);
  return isAllShort;
}

} // namespace benchmarks
