// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/LookSwitch.h"

#include "Applications/Explorer/Scene/VolumeLook.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

namespace
{
template <typename Function>
void Exchange(Function* a, Function* b)
{
  vtkNew<Function> kept;
  kept->DeepCopy(a);
  a->DeepCopy(b);
  b->DeepCopy(kept);
}
} // namespace

namespace Explore
{
LookSwitch::LookSwitch(
  TouchScene& touch, const Analysis& analysis, vtkRenderWindowInteractor* interactor)
  : Touch(touch)
  , Interactor(interactor)
  , HasOther(HasInside(analysis))
  , Key(interactor, "O", [this] { this->Switch(); })
{
  SetInsideLook(analysis, this->Other);
}

LookSwitch::~LookSwitch()
{
  this->ShowOutside();
}

void LookSwitch::ShowOutside()
{
  if (this->IsInside)
  {
    this->Swap();
  }
}

std::string LookSwitch::ListKeys() const
{
  return this->HasOther ? "Look\nO\tsee and feel the inside; the outside\n" : "";
}

void LookSwitch::Swap()
{
  vtkVolumeProperty* const look = this->Touch.Scene.Look;
  Exchange(look->GetScalarOpacity(), this->Other->GetScalarOpacity());
  Exchange(look->GetRGBTransferFunction(), this->Other->GetRGBTransferFunction());
  this->IsInside = !this->IsInside;
}

void LookSwitch::Switch()
{
  if (!this->HasOther)
  {
    return;
  }
  this->Swap();
  this->Touch.Display->SetNotice(
    this->IsInside ? "Inside: only what is shown is felt. O shows the outside" : "Outside");
  this->Interactor->Render();
}
} // namespace Explore
