// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Fixture with a function editor in the right part of a window, and a mouse. */
#ifndef EditorMouse_h
#define EditorMouse_h

#include "VTK/Scene/Editor/EditorProbe.h"

#include "vtkHapticFunctionEditor.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <array>
#include <cmath>

namespace editortest
{
using Editor = vtkHapticFunctionEditor;
using Place = std::array<int, 2>;

/// A window with two viewports, because the editor must work in a viewport that does not begin at
/// 0.
class View
{
public:
  View()
  {
    this->Shown->SetRectangle(20, 30, 300, 200);
    this->Left->SetViewport(0.0, 0.0, 0.25, 1.0);
    this->Right->SetViewport(0.25, 0.0, 1.0, 1.0);
    this->Right->AddViewProp(this->Shown);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(480, 260);
    this->Window->AddRenderer(this->Left);
    this->Window->AddRenderer(this->Right);
  }

  void Check(bool holds, const char* what)
  {
    if (!holds)
    {
      cerr << "failed: " << what << "\n";
      this->Passed = false;
    }
  }

  /// Returns the display position of a scalar value and a function's value.
  Place At(double value, double functionValue)
  {
    double x[2];
    VolumeHaptics::EditorProbe::GetPosition(this->Shown, value, functionValue, x);
    return { static_cast<int>(std::lround(x[0])), static_cast<int>(std::lround(x[1])) };
  }

  /// Drags with this button from one position to another. Returns whether the editor consumed all
  /// events.
  bool Drag(int button, const Place& from, const Place& to)
  {
    bool taken = this->Shown->ButtonPress(button, from[0], from[1]);
    for (int i = 1; i <= 4; ++i)
    {
      taken = this->Shown->MouseMove(
                from[0] + (to[0] - from[0]) * i / 4, from[1] + (to[1] - from[1]) * i / 4) &&
        taken;
    }
    return this->Shown->ButtonRelease(button, to[0], to[1]) && taken;
  }

  vtkNew<Editor> Shown;
  vtkNew<vtkRenderWindow> Window;
  bool Passed = true;

private:
  vtkNew<vtkRenderer> Left;
  vtkNew<vtkRenderer> Right;
};

inline bool IsNode(
  vtkPiecewiseFunction* function, int index, double x, double y, double dx, double dy)
{
  double node[4];
  return function->GetNodeValue(index, node) > 0 && std::abs(node[0] - x) <= dx &&
    std::abs(node[1] - y) <= dy;
}
} // namespace editortest

#endif
