// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Functions that were edited in a window and not saved come back in the next one: those of the
// materials, and the opacity. Without changes, nothing is kept.
#include "Applications/Explorer/Live/KeptWork.h"
#include "TouchedHead.h"

#include "vtkHapticProperty.h"
#include "vtkPiecewiseFunction.h"

#include <iostream>

namespace
{
/// A window with what keeps its work.
struct KeptHead : TouchedHead
{
  KeptHead(int argc, char* argv[])
    : TouchedHead(argc, argv, Explore::MapperChoice::CPU)
    , Saved(this->Touch, "")
    , Tool(this->Touch, this->Exploration, this->Interactor, "")
    , Look(this->Touch, this->Exploration.Values, this->Interactor)
    , Kept(this->Touch, this->Exploration.Filter, this->Saved, this->Tool, this->Look,
        this->Interactor, { Argument(argc, argv, "--volume"), 0, false })
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
  vtkPiecewiseFunction* GetOpacity() { return this->Touch.Scene.Look->GetScalarOpacity(); }

  Explore::SavedMeasurements Saved;
  Explore::HandTool Tool;
  Explore::LookSwitch Look;
  Explore::KeptWork Kept;
};

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
    head.Kept.KeepAtEnd(false);
    isRight = Expect(!vtksys::SystemTools::FileExists(folder), "something is kept of nothing");
  }
  {
    KeptHead head(argc, argv);
    isRight = Expect(head.Kept.GetOffer().empty(), "something is offered") && isRight;
    head.GetStiffness()->AddPoint(77.0, 123.0);
    head.GetOpacity()->AddPoint(77.0, 0.77);
    head.Kept.KeepAtEnd(true);
    const bool isKept = vtksys::SystemTools::FileExists(folder);
    isRight = Expect(!isKept, "what --setup saved is kept") && isRight;
    head.Kept.KeepAtEnd(false);
  }
  {
    KeptHead head(argc, argv);
    isRight = Expect(head.Kept.GetOffer().find("edited functions") != std::string::npos,
                "the functions are not offered") &&
      isRight;
    const bool isUnasked = head.GetOpacity()->GetValue(77.0) == 0.77;
    isRight = Expect(!isUnasked, "they came back unasked") && isRight;
    // Those of the outside, whatever is shown.
    head.Press('O', "O");
    isRight = Expect(head.GetOpacity()->GetValue(40.0) == 0.0, "O shows no inside") && isRight;
    head.Press(0, "F11");
    isRight = Expect(head.GetStiffness()->GetValue(77.0) == 123.0 &&
                  head.GetOpacity()->GetValue(77.0) == 0.77,
                "the functions did not come back") &&
      isRight;
    head.Press('O', "O");
    isRight =
      Expect(head.GetOpacity()->GetValue(40.0) == 0.0, "the inside has got the work") && isRight;
    head.Press('O', "O");
    isRight = Expect(head.GetOpacity()->GetValue(77.0) == 0.77, "the outside lost it") && isRight;
    head.Kept.KeepAtEnd(true);
  }
  KeptHead head(argc, argv);
  isRight = Expect(head.Kept.GetOffer().empty(), "what is saved is offered") && isRight;
  return isRight ? EXIT_SUCCESS : EXIT_FAILURE;
}
