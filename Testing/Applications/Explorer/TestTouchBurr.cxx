// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Drills into the forehead with a burr in the explorer's window. The hole is visible, although the
// picture shows a copy of the volume without objects around the body; undo removes the hole.
#include "Applications/Explorer/Live/HandTool.h"
#include "Expectations.h"
#include "Rigs/DrawnPixels.h"
#include "TouchedHead.h"

#include "vtkCommand.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkHapticRemoval.h"
#include "vtkImageData.h"
#include "vtkPNGWriter.h"
#include "vtkPropCollection.h"
#include "vtkVolume.h"
#include "vtkVolumeHapticsFilter.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace
{
constexpr int X = 165; // pixels, the forehead
constexpr int Y = 160;
constexpr int Around = 12;

/// Returns the pixels around the pointer without the hand, and writes the whole picture to `file`.
std::vector<double> Draw(TouchedHead& head, const std::string& file)
{
  head.Touch.Style->TouchModeOff();
  Explore::ExplorerScene& scene = head.Touch.Scene;
  for (int i = 0; i < 4; ++i) // the first frame may lack the texture
  {
    head.Touch.Style->UpdateHaptics();
    vtkPropCollection* const props = scene.Renderer->GetViewProps();
    vtkCollectionSimpleIterator it;
    props->InitTraversal(it);
    while (vtkProp* const prop = props->GetNextProp(it))
    {
      prop->SetVisibility(prop == scene.Volume.Get());
    }
    scene.Overlay->DrawOff();
    scene.Window->Render();
  }
  vtkNew<vtkWindowToImageFilter> grab;
  grab->SetInput(scene.Window);
  grab->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(grab->GetOutputPort());
  writer->SetFileName(file.c_str());
  writer->Write();
  return apitest::ReadPixels(scene.Window, X - Around, Y - Around, X + Around, Y + Around);
}

/// Counts the pixels that differ by more than noise.
int CountChanges(const std::vector<double>& a, const std::vector<double>& b)
{
  int count = 0;
  for (std::size_t i = 0; i + 2 < a.size(); i += 3)
  {
    const double most = std::max(
      { std::abs(a[i] - b[i]), std::abs(a[i + 1] - b[i + 1]), std::abs(a[i + 2] - b[i + 2]) });
    count += most > 20.0 ? 1 : 0;
  }
  return count;
}

void Drill(int argc, char* argv[], Explore::MapperChoice mapper, const std::string& name)
{
  TouchedHead head(argc, argv, mapper);
  Expect(head.Exploration.Body != head.Exploration.Input.Image, "a copy is shown");
  const std::string folder = MakeTestFolder(argc, argv, "TouchBurr") + "/";
  const Explore::HandTool tool(head.Touch, head.Exploration, "burr");
  vtkHapticRemoval* const removal = head.Exploration.Filter->GetRemoval();
  const std::vector<double> before = Draw(head, folder + name + "Before.png");
  head.Touch.Device->GetVirtualHand()->SpinningOn();
  head.TouchAt(X, Y,
    [&]
    {
      for (int i = 0; i < 40 && !(removal->GetRemovedVolume() > 400.0); ++i)
      {
        head.Press(X, Y, 2);
      }
    });
  head.Touch.Device->GetVirtualHand()->SpinningOff();
  Expect(removal->GetRemovedVolume() > 400.0, name + ": the burr removes something");
  const int changes = CountChanges(before, Draw(head, folder + name + "Drilled.png"));
  Expect(changes > 60, name + ": the hole is seen in " + std::to_string(changes) + " pixels");
  while (removal->GetNumberOfUndos() > 0)
  {
    removal->Undo();
    while (removal->GetNumberOfRequests() > 0)
    {
      head.Run(20);
    }
  }
  const int left = CountChanges(before, Draw(head, folder + name + "Undone.png"));
  Expect(left == 0, name + ": undone, it is gone but for " + std::to_string(left) + " pixels");
}
} // namespace

int TestTouchBurr(int argc, char* argv[])
{
  Drill(argc, argv, Explore::MapperChoice::CPU, "CPU");
  Drill(argc, argv, Explore::MapperChoice::GPU, "GPU");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
