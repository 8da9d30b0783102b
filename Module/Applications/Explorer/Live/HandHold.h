// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_HandHold_h
#define Explore_HandHold_h

#include "Applications/Explorer/Live/TouchScene.h"

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

namespace Explore
{
/// Lets the hand of the mouse stay where it is, so that the pointer can go to a button, a menu or
/// another window while the hand still presses. Key f holds and frees the hand at once; after a
/// click on the bar's button, a click in the scene holds it, and the next one frees it. When it is
/// free again, the hand goes to where the pointer is.
class HandHold
{
public:
  HandHold(TouchScene& touch, vtkRenderWindowInteractor* interactor);
  ~HandHold();
  HandHold(const HandHold&) = delete;
  HandHold& operator=(const HandHold&) = delete;

  /// Holds or frees the hand, apart from the user's own hold, which goes on. The bar calls this
  /// while a menu is open.
  void SetMenuOpen(bool isOpen);

private:
  enum class State
  {
    Free,
    Awaited, // the next click in the scene holds the hand
    Held
  };

  bool IsHeld() const { return this->Now == State::Held || this->IsMenuOpen; }
  void PressKey();
  void PressButton();
  void Change(State state, bool isMenuOpen);
  bool Handle(unsigned long event);

  TouchScene& Touch;
  const vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  State Now = State::Free;
  bool IsMenuOpen = false;
  bool HasPress = false;   // whether the release of a click belongs to this class
  int Place[2] = { 0, 0 }; // where the pointer was when the hand was held (pixels)
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif
