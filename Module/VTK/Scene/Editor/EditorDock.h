// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Where the function editor is: over the scene, or in a viewport of its own beside it.
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

  /** The renderer that the editor was added to; it docks in that window. Not kept alive. */
  void SetHost(vtkRenderer* host);
  /** Takes the room, or gives it back, as the editor says; before each frame of the window. */
  void Follow();
  bool IsTaken() const { return this->HasRoom; }

  ///@{
  /** The editor's rectangle in pixels of its viewport: left, bottom, width and height. */
  std::array<int, 4> GetRectangle();
  /** Whether a position on the display is in it. */
  bool Contains(int x, int y);
  ///@}

  ///@{
  /** From the display to the viewport that draws the editor, and back. */
  void ToViewport(int& x, int& y);
  void ToDisplay(double position[2]);
  ///@}

  /**
   * A vtkCommand of the left button, or MouseMoveEvent, at a position on the display: drags the
   * border to the scene. False if the event is not for it. `isFree`: nothing else is held.
   */
  bool MoveBorder(int event, bool isLeft, bool isFree, int x, int y);

private:
  DockEdge GetEdge() const;
  vtkRenderer* GetShown();
  void SetWindow(vtkRenderWindow* window);
  void Leave();
  bool IsOnBorder(int x, int y);
  void Drag(int x, int y);
  /** Shows that the border can be dragged, or not. */
  void ShowCursor(bool isOnBorder);

  vtkHapticFunctionEditor* const Editor;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkCallbackCommand> StartObserver;
  vtkWeakPointer<vtkRenderer> Host;
  vtkWeakPointer<vtkRenderWindow> Window;
  WindowDock Room;
  bool HasRoom = false;
  bool IsDragged = false;
  bool HasCursor = false; ///< that of the border
};

} // namespace VolumeHaptics

#endif
