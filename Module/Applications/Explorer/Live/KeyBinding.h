// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_KeyBinding_h
#define Explore_KeyBinding_h

#include "vtkCallbackCommand.h"
#include "vtkNew.h"
#include "vtkRenderWindowInteractor.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <string>

namespace Explore
{
/// Calls a function whenever a key, such as "F8" or "O", is pressed in a window. The binding ends
/// when the object is deleted.
class KeyBinding
{
public:
  KeyBinding(
    vtkRenderWindowInteractor* interactor, std::string symbol, std::function<void()> press);
  ~KeyBinding();
  KeyBinding(const KeyBinding&) = delete;
  KeyBinding& operator=(const KeyBinding&) = delete;

private:
  const vtkSmartPointer<vtkRenderWindowInteractor> Interactor;
  const std::string Symbol;
  const std::function<void()> Press;
  vtkNew<vtkCallbackCommand> Observer;
};
} // namespace Explore

#endif
