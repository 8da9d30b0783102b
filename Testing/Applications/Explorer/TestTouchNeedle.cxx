// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Presses a needle into the forehead in the explorer's window. The needle has its hub before it is
// inserted. Ctrl+F holds the hand, because Ctrl presses in depth. Ctrl+E writes the needle's track;
// on a full disk, the program reports the error and leaves no file.
#include "Applications/Explorer/Live/HandHold.h"
#include "Applications/Explorer/Live/HandTool.h"
#include "Expectations.h"
#include "Rigs/DrawnPixels.h"
#include "Rigs/FullDisk.h"
#include "TouchedHead.h"

#include "vtkPolyData.h"
#include "vtkXMLPolyDataReader.h"

#include <filesystem>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
/// Returns the text that the program prints when Ctrl and a letter are pressed.
std::string PressWithCtrl(TouchedHead& head, const char* letter)
{
  std::ostringstream text;
  std::streambuf* const before = std::cout.rdbuf(text.rdbuf());
  head.Interactor->SetKeyEventInformation(1, 0, '\0', 0, letter);
  head.Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
  head.Interactor->SetControlKey(0);
  std::cout.rdbuf(before);
  return text.str();
}

/// Counts the pixels of a new frame that have the blue of the needle's hub.
int CountHub(TouchedHead& head)
{
  vtkRenderWindow* const window = head.Touch.Scene.Window;
  window->Render();
  const int* const size = window->GetSize();
  const std::vector<double> levels = apitest::ReadPixels(window, 0, 0, size[0] - 1, size[1] - 1);
  int count = 0;
  for (std::size_t i = 0; i < levels.size(); i += 3)
  {
    count += levels[i + 2] > 140.0 && levels[i + 2] > levels[i] + 90.0 ? 1 : 0;
  }
  return count;
}

bool Contains(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}
} // namespace

int TestTouchNeedle(int argc, char* argv[])
{
  TouchedHead head(argc, argv, Explore::MapperChoice::CPU);
  // Change to the test's folder, because the program writes to the current folder.
  const std::filesystem::path file =
    std::filesystem::path(MakeTestFolder(argc, argv, "TouchNeedle")) / "track-001.vtp";
  std::filesystem::remove(file);
  std::filesystem::current_path(file.parent_path());
  head.TouchAt(165, 160, [] {});
  const int pen = CountHub(head);
  Expect(pen < 10, "a pen has no hub, but " + std::to_string(pen) + " of its pixels");
  const Explore::HandTool tool(head.Touch, head.Exploration, "needle");
  head.TouchAt(165, 160, [] {});
  const int needle = CountHub(head);
  Expect(needle > 40, "a needle in the air has a hub of " + std::to_string(needle) + " pixels");
  {
    const Explore::HandHold hold(head.Touch);
    PressWithCtrl(head, "f");
    Expect(head.Touch.Style->GetHoldClicks() == 1, "Ctrl+F holds a touching hand");
    PressWithCtrl(head, "f");
    Expect(head.Touch.Style->GetHoldClicks() == 0, "Ctrl+F lets a held hand go on");
  }
  Expect(
    Contains(PressWithCtrl(head, "e"), "has no track"), "there is no track without a puncture");
  head.TouchAt(165, 160, [&] { head.Press(165, 160, 6); });
  Expect(head.Touch.Device->GetState()->GetNeedleDepth() > 0.0, "the needle is inserted");
  {
    const devicetest::FullDisk full(100);
    const std::string text = PressWithCtrl(head, "e");
    Expect(!Contains(text, "Written"), "nothing is written to a full disk");
    Expect(Contains(text, "track-001.vtp"), "which file is not written is said: " + text);
  }
  Expect(!std::filesystem::exists(file), "no half of a file is left");
  const std::string text = PressWithCtrl(head, "e");
  Expect(Contains(text, "Written: " + file.string()), "then it is written: " + text);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  Expect(reader->GetOutput()->GetNumberOfLines() > 0, "the file has the track");
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
