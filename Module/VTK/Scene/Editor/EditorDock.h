// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Places the function editor over the scene, or beside it in a separate viewport.
 */
#ifndef EditorDock_h
#define EditorDock_h

#include "VTK/Scene/Base/WindowDock.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWeakPointer.h"

#include <array>
#include <functional>

class vtkHapticFunctionEditor;
class vtkViewport;

namespace VolumeHaptics
{

class EditorDock
{
public:
  /** Function that draws the editor into a viewport and returns the number of drawn props. */
  using DrawFunction = std::function<int(vtkViewport*)>;

  EditorDock(vtkHapticFunctionEditor* editor, DrawFunction draw);
  ~EditorDock();
  EditorDock(const EditorDock&) = delete;
  EditorDock& operator=(const EditorDock&) = delete;

  /**
   * Sets the renderer that the editor was added to, without a reference. The editor docks in this
   * renderer's window.
   */
  void SetHost(vtkRenderer* host);
  /**
   * Docks or undocks the editor as its settings require. Call this before each frame of the window.
   */
  void Update();
  bool IsTaken() const { return this->HasRoom; }

  ///@{
  /** Returns the editor's rectangle in pixels of its viewport: left, bottom, width and height. */
  std::array<int, 4> GetRectangle();
  /** Returns whether a position on the display is in the editor. */
  bool Contains(int x, int y);
  ///@}

  ///@{
  /** Convert positions from the display to the viewport that draws the editor, or back. */
  void ToViewport(int& x, int& y);
  void ToDisplay(double position[2]);
  ///@}

  /**
   * Drags the border between editor and scene. `event` is a vtkCommand of the left button, or
   * MouseMoveEvent, at a position on the display. `isFree`: whether no other drag is in progress.
   * Returns false if the event does not concern the border.
   */
  bool MoveBorder(int event, bool isLeft, bool isFree, int x, int y);

private:
  DockEdge GetEdge() const;
  vtkRenderer* GetShown();
  void SetWindow(vtkRenderWindow* window);
  void Leave();
  bool IsOnBorder(int x, int y);
  void Drag(int x, int y);
  /** Shows the mouse cursor for a draggable border, or the normal cursor. */
  void ShowCursor(bool isOnBorder);

  vtkHapticFunctionEditor* const Editor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkCallbackCommand> StartObserver;
  vtkWeakPointer<vtkRenderer> Host;
  vtkWeakPointer<vtkRenderWindow> Window;
  WindowDock Room;
  bool HasRoom = false;
  bool IsDragged = false;
  bool HasCursor = false; ///< whether the cursor for the border is shown
};

} // namespace VolumeHaptics

#endif
