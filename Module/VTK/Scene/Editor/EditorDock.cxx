// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Editor/EditorDock.h"

#include "VTK/Scene/Base/RendererAspect.h"

#include "vtkCommand.h"
#include "vtkHapticFunctionEditor.h"
#include "vtkObjectFactory.h"
#include "vtkProp.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace
{

/**
 * Draws the editor in the docked renderer. The editor itself is not added to that renderer, because
 * they would own each other and never be deleted.
 */
class HapticDockedProp : public vtkProp
{
public:
  static HapticDockedProp* New();
  vtkTypeMacro(HapticDockedProp, vtkProp);
  int RenderOverlay(vtkViewport* viewport) override { return this->Draw(viewport); }
  VolumeHaptics::EditorDock::DrawFunction Draw;

protected:
  HapticDockedProp() = default;
  ~HapticDockedProp() override = default;

private:
  HapticDockedProp(const HapticDockedProp&) = delete;
  void operator=(const HapticDockedProp&) = delete;
};

vtkStandardNewMacro(HapticDockedProp);

constexpr int BorderReach = 5; // pixels on either side of the border where the mouse can grab it

} // namespace

namespace VolumeHaptics
{

//------------------------------------------------------------------------------
EditorDock::EditorDock(vtkHapticFunctionEditor* editor, DrawFunction draw)
  : Editor(editor)
{
  vtkNew<HapticDockedProp> prop;
  prop->Draw = std::move(draw);
  prop->PickableOff();
  this->Renderer->AddViewProp(prop);
  this->Renderer->InteractiveOff(); // prevents interactors from moving its camera
  this->Renderer->SetBackground(0.93, 0.94, 0.95);
  this->StartObserver->SetClientData(this);
  this->StartObserver->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*) { static_cast<EditorDock*>(self)->Update(); });
}

//------------------------------------------------------------------------------
EditorDock::~EditorDock()
{
  this->SetWindow(nullptr);
}

//------------------------------------------------------------------------------
void EditorDock::SetHost(vtkRenderer* host)
{
  this->Host = host;
  this->SetWindow(host ? host->GetRenderWindow() : nullptr);
}

//------------------------------------------------------------------------------
vtkRenderer* EditorDock::GetShown()
{
  return this->HasRoom ? this->Renderer.Get() : this->Host.GetPointer();
}

//------------------------------------------------------------------------------
std::array<int, 4> EditorDock::GetRectangle()
{
  std::array<int, 4> rectangle{ { 0, 0, 0, 0 } };
  if (this->HasRoom)
  {
    std::copy_n(this->Renderer->GetSize(), 2, rectangle.begin() + 2);
  }
  else
  {
    std::copy_n(this->Editor->GetRectangle(), 4, rectangle.begin());
  }
  return rectangle;
}

//------------------------------------------------------------------------------
bool EditorDock::Contains(int x, int y)
{
  this->ToViewport(x, y);
  const std::array<int, 4> r = this->GetRectangle();
  return this->Editor->GetVisibility() && x >= r[0] && x < r[0] + r[2] && y >= r[1] &&
    y < r[1] + r[3];
}

//------------------------------------------------------------------------------
void EditorDock::ToViewport(int& x, int& y)
{
  if (vtkRenderer* const shown = this->GetShown())
  {
    const int* const origin = shown->GetOrigin();
    x -= origin[0];
    y -= origin[1];
  }
}

void EditorDock::ToDisplay(double position[2])
{
  int origin[2] = { 0, 0 };
  this->ToViewport(origin[0], origin[1]);
  position[0] -= origin[0];
  position[1] -= origin[1];
}

//------------------------------------------------------------------------------
void EditorDock::SetWindow(vtkRenderWindow* window)
{
  if (this->Window == window)
  {
    return;
  }
  this->Leave();
  if (this->Window)
  {
    this->Window->RemoveObserver(this->StartObserver);
  }
  this->Window = window;
  if (window)
  {
    window->AddObserver(vtkCommand::StartEvent, this->StartObserver);
  }
}

//------------------------------------------------------------------------------
DockEdge EditorDock::GetEdge() const
{
  static_assert(static_cast<int>(DockEdge::Left) == vtkHapticFunctionEditor::LEFT_EDGE &&
    static_cast<int>(DockEdge::Right) == vtkHapticFunctionEditor::RIGHT_EDGE &&
    static_cast<int>(DockEdge::Bottom) == vtkHapticFunctionEditor::BOTTOM_EDGE &&
    static_cast<int>(DockEdge::Top) == vtkHapticFunctionEditor::TOP_EDGE);
  return static_cast<DockEdge>(this->Editor->GetDockEdge());
}

//------------------------------------------------------------------------------
void EditorDock::Update()
{
  // A removed editor, which no renderer uses, counts as hidden.
  const bool isShown = this->Editor->GetDocked() && this->Editor->GetVisibility() &&
    this->Editor->GetNumberOfConsumers() > 0 && this->Window;
  if (!isShown)
  {
    this->Leave();
    return;
  }
  if (!this->HasRoom)
  {
    this->Window->AddRenderer(this->Renderer);
    ComputeAspect(this->Renderer);
    this->HasRoom = true;
  }
  this->Room.Place(
    this->Window, this->GetEdge(), this->Editor->GetDockShare(), { this->Renderer.Get() });
}

//------------------------------------------------------------------------------
void EditorDock::Leave()
{
  if (!std::exchange(this->HasRoom, false))
  {
    return;
  }
  this->IsDragged = false;
  this->ShowCursor(false);
  if (this->Window)
  {
    this->Window->RemoveRenderer(this->Renderer);
  }
  this->Room.GiveBack();
}

//------------------------------------------------------------------------------
bool EditorDock::IsOnBorder(int x, int y)
{
  if (!this->HasRoom)
  {
    return false;
  }
  const int* const origin = this->Renderer->GetOrigin();
  const int* const size = this->Renderer->GetSize();
  const int at[2] = { x - origin[0], y - origin[1] };
  const int across = IsColumn(this->GetEdge()) ? 0 : 1; // index of the axis perpendicular to the
                                                        // border
  const int along = 1 - across;
  const int border = IsLow(this->GetEdge()) ? size[across] : 0;
  return std::abs(at[across] - border) <= BorderReach && at[along] >= 0 && at[along] < size[along];
}

//------------------------------------------------------------------------------
bool EditorDock::MoveBorder(int event, bool isLeft, bool isFree, int x, int y)
{
  const bool isMotion = event == vtkCommand::MouseMoveEvent;
  const bool isRelease = event == vtkCommand::LeftButtonReleaseEvent;
  if (this->IsDragged)
  {
    if (isMotion)
    {
      this->Drag(x, y);
    }
    this->IsDragged = !(isRelease && isLeft);
    return true;
  }
  const bool isOnBorder = isFree && this->Editor->GetVisibility() && this->IsOnBorder(x, y);
  this->ShowCursor(isOnBorder);
  this->IsDragged = isOnBorder && isLeft && !isMotion && !isRelease;
  return isOnBorder;
}

//------------------------------------------------------------------------------
void EditorDock::Drag(int x, int y)
{
  const int* const window = this->Window ? this->Window->GetSize() : nullptr;
  if (!this->HasRoom || !window || window[0] <= 0 || window[1] <= 0)
  {
    return;
  }
  const int* const origin = this->Renderer->GetOrigin();
  const int* const size = this->Renderer->GetSize();
  const int at[2] = { x - origin[0], y - origin[1] };
  const int across = IsColumn(this->GetEdge()) ? 0 : 1;
  const int thickness = IsLow(this->GetEdge()) ? at[across] : size[across] - at[across];
  this->Editor->SetDockShare(static_cast<double>(thickness) / window[across]);
}

//------------------------------------------------------------------------------
void EditorDock::ShowCursor(bool isOnBorder)
{
  if (this->HasCursor == isOnBorder || !this->Window)
  {
    return;
  }
  this->HasCursor = isOnBorder;
  this->Window->SetCurrentCursor(!isOnBorder ? VTK_CURSOR_DEFAULT
      : IsColumn(this->GetEdge())            ? VTK_CURSOR_SIZEWE
                                             : VTK_CURSOR_SIZENS);
}

} // namespace VolumeHaptics
