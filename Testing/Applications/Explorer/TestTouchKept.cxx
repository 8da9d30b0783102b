// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Expects that the next window offers edited but unsaved functions (materials and opacity) and
// unsaved measurements, which must not replace newer ones. Without changes, nothing must be saved.
#include "Applications/Explorer/Live/KeptWork.h"
#include "TouchedHead.h"

#include "vtkHapticHeadUpDisplay.h"
#include "vtkHapticMeasurements.h"
#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <iostream>

namespace
{
/// A window with the parts that contain unsaved work.
struct KeptHead : TouchedHead
{
  KeptHead(int argc, char* argv[], const std::string& file = "")
    : TouchedHead(argc, argv, Explore::MapperChoice::CPU)
    , Saved(this->Touch, file)
    , Tool(this->Touch, this->Exploration, "")
    , Look(this->Touch, this->Exploration.Values)
    , Kept(this->Touch, this->Exploration.Filter, this->Saved, this->Tool, this->Look,
        { Argument(argc, argv, "--volume"), 0, false })
  {
    this->Touch.Setup->SetVolumeHaptics(this->Exploration.Filter);
  }
  vtkPiecewiseFunction* GetStiffness()
  {
    return this->Exploration.Filter->GetProperty()->GetStiffness();
  }
  void Press(char code, const char* name)
  {
    this->Interactor->SetKeyCode(code);
    this->Interactor->SetKeySym(name);
    this->Interactor->InvokeEvent(vtkCommand::KeyPressEvent);
    this->Interactor->SetKeyCode(0);
  }
  void Save()
  {
    this->Interactor->SetControlKey(1);
    this->Press('\x13', "s");
    this->Interactor->SetControlKey(0);
  }
  vtkPiecewiseFunction* GetOpacity() { return this->Touch.Scene.Look->GetScalarOpacity(); }

  Explore::SavedMeasurements Saved;
  Explore::HandTool Tool;
  Explore::LookSwitch Look;
  Explore::KeptWork Kept;
};

/// Returns whether this point is the only one in the list.
bool HasOnly(vtkHapticMeasurements* list, const double point[3])
{
  if (list->GetNumberOfMeasurements() != 1)
  {
    return false;
  }
  vtkNew<vtkPolyData> shape;
  list->GetShape(0, shape);
  return std::equal(point, point + 3, shape->GetPoint(0));
}

bool Expect(bool is, const char* wrong)
{
  if (!is)
  {
    std::cerr << wrong << "\n";
  }
  return is;
}
} // namespace

int TestTouchKept(int argc, char* argv[])
{
  const std::string folder = MakeTestFolder(argc, argv, "TestTouchKept");
  vtksys::SystemTools::RemoveADirectory(folder);
  vtksys::SystemTools::PutEnv("XDG_STATE_HOME=" + folder);
  bool isRight = true;
  {
    KeptHead head(argc, argv);
    const double before = head.GetOpacity()->GetValue(1000.0);
    for (const Explore::Command& command : head.Touch.Commands.ListGroup("Look"))
    {
      if (command.Text == "more transparent")
      {
        command.Run();
      }
    }
    isRight = Expect(head.GetOpacity()->GetValue(1000.0) < before, "it is as opaque as before");
    head.Kept.KeepAtEnd(false);
    isRight =
      Expect(!vtksys::SystemTools::FileExists(folder), "something is kept of nothing") && isRight;
  }
  {
    KeptHead head(argc, argv);
    isRight = Expect(head.Kept.GetOffer().empty(), "something is offered") && isRight;
    head.GetStiffness()->AddPoint(77.0, 123.0);
    head.GetOpacity()->AddPoint(77.0, 0.77);
    head.Kept.KeepAtEnd(true);
    const bool isKept = vtksys::SystemTools::FileExists(folder);
    isRight = Expect(!isKept, "what --setup saved is kept") && isRight;
    const double before[3] = { 1.0, 2.0, 3.0 };
    head.Touch.Measurements->AddPoint(before, "before");
    head.Kept.KeepAtEnd(false);
  }
  {
    const std::string file = folder + "/since.csv";
    KeptHead head(argc, argv, file);
    isRight = Expect(head.Kept.GetOffer().find("edited functions") != std::string::npos,
                "the functions are not offered") &&
      isRight;
    const bool isUnasked = head.GetOpacity()->GetValue(77.0) == 0.77;
    isRight = Expect(!isUnasked, "they came back unasked") && isRight;
    // Saved functions are those for the outside, even while the inside is shown.
    head.Press('o', "o");
    isRight = Expect(head.GetOpacity()->GetValue(40.0) == 0.0, "o shows no inside") && isRight;
    vtkHapticMeasurements* const list = head.Touch.Measurements;
    const double since[3] = { 4.0, 5.0, 6.0 };
    list->AddPoint(since, "since");
    head.Press(0, "F11");
    const std::string notice = head.Touch.Display->GetNotice();
    isRight =
      Expect(notice ==
            "Save (Ctrl+S) and remove (Delete) the measurements of this window first, then F11" &&
          HasOnly(list, since),
        "what was measured since is not kept, or nothing is said of it") &&
      isRight;
    head.Save();
    head.Press(0, "Delete");
    head.Press(0, "F11");
    const double before[3] = { 1.0, 2.0, 3.0 };
    isRight = Expect(HasOnly(list, before), "the measurement did not come back") && isRight;
    vtkNew<vtkHapticMeasurements> saved;
    isRight = Expect(saved->ReadFile(file.c_str()) && HasOnly(saved, since),
                "what was measured since was not saved") &&
      isRight;
    isRight = Expect(head.GetStiffness()->GetValue(77.0) == 123.0 &&
                  head.GetOpacity()->GetValue(77.0) == 0.77,
                "the functions did not come back") &&
      isRight;
    head.Press('o', "o");
    isRight =
      Expect(head.GetOpacity()->GetValue(40.0) == 0.0, "the inside has got the work") && isRight;
    head.Press('o', "o");
    isRight = Expect(head.GetOpacity()->GetValue(77.0) == 0.77, "the outside lost it") && isRight;
    head.Save();
    head.Kept.KeepAtEnd(true);
  }
  KeptHead head(argc, argv);
  isRight = Expect(head.Kept.GetOffer().empty(), "what is saved is offered") && isRight;
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
