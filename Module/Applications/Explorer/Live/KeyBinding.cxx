// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/KeyBinding.h"

#include <utility>

namespace Explore
{
KeyBinding::KeyBinding(
  vtkRenderWindowInteractor* interactor, std::string symbol, std::function<void()> press)
  : Interactor(interactor)
  , Symbol(std::move(symbol))
  , Press(std::move(press))
{
  this->Observer->SetClientData(this);
  this->Observer->SetCallback(
    [](vtkObject*, unsigned long, void* self, void*)
    {
      const KeyBinding& binding = *static_cast<KeyBinding*>(self);
      const char* const symbol = binding.Interactor->GetKeySym();
      if (symbol && symbol == binding.Symbol)
      {
        binding.Press();
      }
    });
  interactor->AddObserver(vtkCommand::KeyPressEvent, this->Observer);
}

KeyBinding::~KeyBinding()
{
  this->Interactor->RemoveObserver(this->Observer);
}
} // namespace Explore
