// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Opens the explorer's window with two devices: both must be felt and visible at the same time, the
// display must report both, and only the first hand must have the tool.
#include "Applications/Explorer/Live/FreeFile.h"
#include "Applications/Explorer/Live/WindowFiles.h"
#include "Applications/Explorer/Live/WindowRecorder.h"
#include "Expectations.h"
#include "Rigs/DrawnPixels.h"
#include "TouchedHead.h"

#include "vtkMath.h"
#include "vtkVolumeHapticsFilter.h"

#include <vtksys/SystemTools.hxx>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace
{
/// Counts the pixels that the second hand changes clearly.
int CountSecondHand(TouchedHead& head)
{
  vtkRenderWindow* const window = head.Touch.Scene.Window;
  const auto draw = [&](bool isShown)
  {
    head.Touch.SecondHand->SetVisibility(isShown);
    window->Render();
    return apitest::ReadPixels(window, 0, 0, 389, 299);
  };
  const std::vector<double> without = draw(false);
  const std::vector<double> with = draw(true);
  int count = 0;
  for (std::size_t i = 0; i + 2 < with.size(); i += 3)
  {
    // The second hand is lilac: more blue than green, and more red than green.
    const bool isLilac = with[i + 2] > with[i + 1] + 20.0 && with[i] > with[i + 1] + 5.0;
    count += isLilac && std::abs(with[i + 2] - without[i + 2]) > 10.0 ? 1 : 0;
  }
  return count;
}
} // namespace

int TestTouchTwoHands(int argc, char* argv[])
{
  Explore::DeviceChoice devices;
  devices.SecondId = "virtual";
  TouchedHead head(argc, argv, Explore::MapperChoice::CPU, devices);
  vtkHapticDevice* const second = head.Touch.SecondDevice;
  Expect(second && second->IsRunning(), "the second hand is there");
  Expect(head.Touch.Device->GetUseTool() && !second->GetUseTool(), "the first one holds the tool");
  Expect(head.Touch.Style->GetSecondDevice() == second, "and in the scene");
  double start[3];
  head.TouchAt(165, 160,
    [&]
    {
      head.Press(165, 160, 3);
      std::copy_n(head.Touch.Device->GetState()->GetProxyPosition(), 3, start);
    });
  Expect(head.Touch.Device->GetState()->GetContact() != 0, "the first hand touches");
  // Begin beside the first hand, outside the face (-y), and press into the skin.
  second->GetVirtualHand()->SetPosition(start[0] + 25.0, start[1] - 30.0, start[2]);
  head.Run(200);
  second->Arm();
  head.Run(700);
  bool isFelt = false;
  for (int i = 0; i < 200 && !isFelt; ++i)
  {
    second->GetVirtualHand()->SetPosition(start[0] + 25.0, start[1] - 30.0 + 0.5 * i, start[2]);
    head.Run(10);
    isFelt = vtkMath::Norm(second->GetState()->GetForce()) > 0.3;
  }
  Expect(isFelt, "the second hand feels the same head");
  const std::string text = head.Touch.Display->GetText();
  Expect(text.find("\nSecond hand: ") != std::string::npos, "the display has its line: " + text);
  const int pixels = CountSecondHand(head);
  Expect(pixels > 30, "it is drawn in " + std::to_string(pixels) + " lilac pixels");
  {
    const auto press = [&head](const char* key)
    {
      head.Interactor->SetKeySym(key);
      head.Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    };
    const std::string file = Explore::FindFreeFile("touch", ".vtp");
    const std::string secondFile = file.substr(0, file.rfind('.')) + "-second.vtp";
    Explore::WindowRecorder recorder(head.Touch, head.Interactor, "");
    press("F10");
    head.Run(20);
    Expect(!second->GetRecorder()->GetFileName().empty(), "both are recorded");
    head.Touch.Device->GetRecorder()->Stop();
    press("F10"); // would fail for the first hand
    Expect(second->GetRecorder()->GetFileName().empty(), "the second recording ends, too");
    Expect(vtksys::SystemTools::RemoveFile(file) && vtksys::SystemTools::RemoveFile(secondFile),
      "both files are written");
    Explore::FileChoice choice;
    Explore::FileChoice now;
    now.Path = "touched.vti";
    const Explore::WindowFiles files(
      head.Touch, head.Interactor, head.Exploration.Input, now, choice);
    Expect(second->IsArmOrdered(), "the second hand is armed");
    press("F2");
    Expect(!second->IsArmOrdered(), "whoever reads a list watches neither hand");
    press("F2");
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
