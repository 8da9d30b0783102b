// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the style, the representation and the displays without a device, a filter, an interactor, a
 * window or a renderer. Nothing may crash, and without an interactor nothing is armed.
 */

#include "StyleRig.h"
#include "VTK/Scene/Display/DisplayProbe.h"
#include "VTK/Scene/Editor/EditorProbe.h"

#include <vtkGenericRenderWindowInteractor.h>
#include <vtkHapticFunctionEditor.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticRepresentation.h>
#include <vtkVolumeProperty.h>

using namespace scenetest;

namespace
{
/// A style with its device, filter, window and props, of which tests connect only some.
struct Parts
{
  vtkNew<vtkHapticDevice> Device;
  vtkNew<vtkVolumeHapticsFilter> Filter;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkGenericRenderWindowInteractor> Interactor;
  vtkNew<vtkHapticHeadUpDisplay> Display;
  vtkNew<vtkHapticFunctionEditor> Editor;
  vtkNew<vtkHapticRepresentation> Hand;
  vtkNew<vtkInteractorStyleHaptic> Style;
  MessageLog Logs[6] = { MessageLog(this->Device), MessageLog(this->Filter),
    MessageLog(this->Display), MessageLog(this->Editor), MessageLog(this->Hand),
    MessageLog(this->Style) };
  ~Parts() { this->Interactor->SetInteractorStyle(nullptr); }
};

void CallDisplays(Parts& parts)
{
  double place[2];
  double bounds[6];
  vtkNew<vtkTable> empty;
  parts.Display->AddStates(nullptr);
  parts.Display->AddStates(empty);
  parts.Display->AddTissue(nullptr, 0.0, 0.0);
  parts.Display->GetTissueName(0.0);
  VolumeHaptics::DisplayProbe::CopyPlot(parts.Display);
  VolumeHaptics::DisplayProbe::GetPlotTitle(parts.Display);
  parts.Display->GetText();
  parts.Display->ReleaseGraphicsResources(nullptr);
  parts.Display->Clear();
  parts.Editor->NextFunction();
  parts.Editor->GetPiecewiseFunction();
  for (const int at : { -5, 20, 100000 })
  {
    parts.Editor->MouseMove(at, at);
    parts.Editor->ButtonPress(vtkHapticFunctionEditor::LEFT_BUTTON, at, at);
    parts.Editor->DoubleClick(vtkHapticFunctionEditor::LEFT_BUTTON, at, at);
    parts.Editor->ButtonRelease(vtkHapticFunctionEditor::LEFT_BUTTON, at, at);
  }
  VolumeHaptics::EditorProbe::GetPosition(parts.Editor, 0.0, 0.0, place);
  parts.Editor->ReleaseGraphicsResources(nullptr);
  parts.Hand->SetTrail(nullptr);
  parts.Hand->SetTrailLookupTable(nullptr);
  parts.Hand->GetBounds();
  parts.Hand->ReleaseGraphicsResources(nullptr);
  parts.Renderer->ComputeVisiblePropBounds(bounds);
  vtkNew<vtkRenderer> elsewhere; // a renderer without a window
  for (vtkRenderer* renderer : { elsewhere.GetPointer(), static_cast<vtkRenderer*>(nullptr) })
  {
    parts.Display->RenderOverlay(renderer);
    parts.Editor->RenderOverlay(renderer);
    parts.Hand->RenderOpaqueGeometry(renderer);
    parts.Hand->RenderOverlay(renderer);
  }
  std::ostringstream text;
  parts.Display->Print(text);
  parts.Editor->Print(text);
  parts.Hand->Print(text);
  parts.Style->Print(text);
}

void CallStyle(Parts& parts)
{
  vtkInteractorStyleHaptic* const style = parts.Style;
  for (int touches = 1; touches >= 0; --touches)
  {
    style->SetTouchMode(touches != 0);
    style->SetClutch(touches != 0);
    style->UpdateHaptics();
    style->GetStates();
    style->OnTimer();
    style->OnMouseMove();
    style->OnLeftButtonDown();
    style->OnMouseMove();
    style->OnLeftButtonUp();
    style->OnRightButtonDown();
    style->OnRightButtonUp();
    style->OnLeftButtonDoubleClick();
    style->OnMouseWheelForward();
    style->OnMouseWheelBackward();
    style->OnKeyPress();
    style->OnKeyRelease();
    style->OnChar();
    for (const char* key :
      { "t", "a", "Escape", "c", "k", "Home", "plus", "minus", "m", "h", "g", "v", "n", "x", "t" })
    {
      parts.Interactor->SetKeySym(key);
      parts.Interactor->SetKeyCode(key[0]);
      style->OnKeyPress();
      style->OnChar();
      style->OnKeyRelease();
    }
    style->RecenterWorkspace();
    style->NextMethod();
  }
}
} // namespace

TEST(StyleAlone, DragsInARendererWithoutAWindow)
{
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> shown;
  vtkNew<vtkRenderer> elsewhere;
  window->AddRenderer(shown);
  vtkNew<vtkGenericRenderWindowInteractor> interactor;
  interactor->SetRenderWindow(window);
  vtkNew<vtkInteractorStyleHaptic> style;
  interactor->SetInteractorStyle(style);
  interactor->Initialize();
  style->SetDefaultRenderer(elsewhere);
  for (const int shift : { 0, 1 }) // with Shift (1), the right button rotates the environment
  {
    interactor->SetEventInformation(20, 20, 0, shift);
    style->OnLeftButtonDown();
    style->OnRightButtonDown();
    interactor->SetEventInformation(25, 30, 0, shift);
    style->OnMouseMove();
    style->OnRightButtonUp();
    style->OnLeftButtonUp();
  }
  // Drags must also be safe if the interactor has no window, and if the editor is removed during a
  // drag.
  vtkNew<vtkGenericRenderWindowInteractor> bare;
  vtkNew<vtkInteractorStyleHaptic> other;
  bare->SetInteractorStyle(other);
  other->OnLeftButtonDown();
  other->OnLeftButtonUp();
  vtkNew<vtkHapticFunctionEditor> editor;
  style->SetFunctionEditor(editor);
  style->OnLeftButtonDown();
  style->SetFunctionEditor(nullptr);
  style->OnLeftButtonUp();
}

TEST(StyleAlone, ReturnsWhateverIsMissing)
{
  enum
  {
    WithDevice = 1,
    WithStart = 2,
    WithFilter = 4,
    WithImage = 8,
    WithInteractor = 16,
    WithRenderer = 32,
    WithWindow = 64,
    WithParts = 128,
    All = 256
  };
  const auto ramp = MakeRamp();
  for (int with = 0; with < All; ++with)
  {
    if ((with & WithStart && !(with & WithDevice)) || (with & WithImage && !(with & WithFilter)))
    {
      continue;
    }
    Parts parts;
    SCOPED_TRACE(with);
    if (with & WithImage)
    {
      parts.Filter->SetInputData(0, ramp);
    }
    if (with & WithFilter)
    {
      parts.Device->SetVolumeHaptics(parts.Filter);
    }
    if (with & WithStart)
    {
      parts.Device->Open("virtual");
      parts.Device->Start();
    }
    if (with & WithDevice)
    {
      parts.Style->SetDevice(parts.Device);
      parts.Display->SetDevice(parts.Device);
      parts.Hand->SetDevice(parts.Device);
    }
    parts.Window->SetOffScreenRendering(1);
    if (with & WithWindow)
    {
      parts.Window->AddRenderer(parts.Renderer);
      parts.Interactor->SetRenderWindow(parts.Window);
    }
    if (with & WithRenderer)
    {
      parts.Style->SetDefaultRenderer(parts.Renderer);
      parts.Renderer->AddViewProp(parts.Hand);
    }
    if (with & WithParts)
    {
      parts.Style->SetHeadUpDisplay(parts.Display);
      parts.Style->SetFunctionEditor(parts.Editor);
    }
    if (with & WithInteractor)
    {
      parts.Interactor->SetInteractorStyle(parts.Style);
    }
    CallDisplays(parts);
    CallStyle(parts);
    for (const MessageLog& log : parts.Logs)
    {
      for (const std::string& error : log.Errors)
      {
        EXPECT_GT(error.size(), 20U) << "an error that says nothing";
      }
    }
  }
}

TEST(StyleAlone, DoesNotArmWithoutAnInteractor)
{
  const auto ramp = MakeRamp();
  Parts parts;
  parts.Filter->SetInputData(0, ramp);
  parts.Device->SetVolumeHaptics(parts.Filter);
  ASSERT_TRUE(parts.Device->Open("virtual"));
  ASSERT_TRUE(parts.Device->Start());
  parts.Style->SetDevice(parts.Device);
  parts.Style->SetDefaultRenderer(parts.Renderer);
  parts.Style->TouchModeOn();
  EXPECT_FALSE(parts.Style->GetTouchMode());
  EXPECT_LT(parts.Device->GetStatus(), vtkHapticDevice::ARMED);
  const std::vector<std::string>& errors = parts.Logs[5].Errors;
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_NE(errors[0].find("SetInteractorStyle"), std::string::npos) << errors[0];
}
