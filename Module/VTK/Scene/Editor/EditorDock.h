// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Places the function editor over the scene, or in a viewport of its own beside the scene.
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
  /** Draws the editor into a viewport. */
  using DrawFunction = std::function<int(vtkViewport*)>;

  EditorDock(vtkHapticFunctionEditor* editor, DrawFunction draw);
  ~EditorDock();
  EditorDock(const EditorDock&) = delete;
  EditorDock& operator=(const EditorDock&) = delete;

  /** Sets the renderer that has the editor; the editor docks in its window. Not kept alive. */
  void SetHost(vtkRenderer* host);
  /**
   * Takes the room, or returns it, as the editor's settings say; call before each frame of the
   * window.
   */
  void Update();
  bool IsTaken() const { return this->HasRoom; }

  ///@{
  /** Returns the editor's rectangle in pixels of its viewport: left, bottom, width and height. */
  std::array<int, 4> GetRectangle();
  /** Whether a position on the display is in the editor. */
  bool Contains(int x, int y);
  ///@}

  ///@{
  /** Converts from the display to the viewport that draws the editor, and back. */
  void ToViewport(int& x, int& y);
  void ToDisplay(double position[2]);
  ///@}

  /**
   * Drags the border between editor and scene by a vtkCommand of the left button, or
   * MouseMoveEvent, at a position on the display. False if the event is not for the border.
   * `isFree`: the mouse holds nothing else.
   */
  bool MoveBorder(int event, bool isLeft, bool isFree, int x, int y);

private:
  DockEdge GetEdge() const;
  vtkRenderer* GetShown();
  void SetWindow(vtkRenderWindow* window);
  void Leave();
  bool IsOnBorder(int x, int y);
  void Drag(int x, int y);
  /** Sets the mouse cursor for a border that can be dragged, or the usual one. */
  void ShowCursor(bool isOnBorder);

  vtkHapticFunctionEditor* const Editor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkCallbackCommand> StartObserver;
  vtkWeakPointer<vtkRenderer> Host;
  vtkWeakPointer<vtkRenderWindow> Window;
  WindowDock Room;
  bool HasRoom = false;
  bool IsDragged = false;
  bool HasCursor = false; ///< whether the cursor of the border is shown
};

} // namespace VolumeHaptics

#endif
