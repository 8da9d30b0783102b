// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/Live/LookSwitch.h"

#include "Applications/Explorer/Scene/VolumeLook.h"

#include "vtkColorTransferFunction.h"
#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <utility>

namespace
{
constexpr double OPACITY_STEP = 1.5; // factor per step
constexpr double LEAST_OPACITY = 0.01;

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
LookSwitch::LookSwitch(TouchScene& touch, const Analysis& analysis)
  : Touch(touch)
  , HasOther(HasInside(analysis))
{
  SetInsideLook(analysis, this->Other);
  CommandTable& table = touch.Commands;
  const auto hasOther = [this] { return this->HasOther; };
  table.Add(this,
    { "Look", "see and feel the inside; the outside", "o", [this] { this->Switch(); },
      [this] { return this->IsInside; }, hasOther });
  const auto scale = [this](double factor)
  { return [this, factor] { this->ScaleOpacity(factor); }; };
  table.Add(this, { "Look", "more transparent", "", scale(1.0 / OPACITY_STEP), nullptr, nullptr });
  table.Add(this, { "Look", "more opaque", "", scale(OPACITY_STEP), nullptr, nullptr });
}

LookSwitch::~LookSwitch()
{
  this->Touch.Commands.Remove(this);
  this->ShowOutside();
}

void LookSwitch::ShowOutside()
{
  if (this->IsInside)
  {
    this->Swap();
  }
}

void LookSwitch::Swap()
{
  vtkVolumeProperty* const look = this->Touch.Scene.Look;
  Exchange(look->GetScalarOpacity(), this->Other->GetScalarOpacity());
  Exchange(look->GetRGBTransferFunction(), this->Other->GetRGBTransferFunction());
  std::swap(this->Factor, this->OtherFactor);
  this->IsInside = !this->IsInside;
}

void LookSwitch::Switch()
{
  this->Swap();
  this->Touch.Display->SetNotice(
    this->IsInside ? "Inside: only what is shown is felt. o shows the outside" : "Outside");
}

void LookSwitch::ScaleOpacity(double factor)
{
  vtkPiecewiseFunction* const opacity = this->Touch.Scene.Look->GetScalarOpacity();
  double largest = 0.0;
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4]; // value, opacity, midpoint and sharpness
    opacity->GetNodeValue(i, node);
    largest = std::max(largest, node[1]);
  }
  // Scale all nodes by the same factor, so that a step in the other direction restores the same
  // look.
  if (largest * factor > 1.0 || largest * factor < LEAST_OPACITY)
  {
    this->Touch.Display->SetNotice(
      factor > 1.0 ? "This is as opaque as it gets" : "This is as transparent as it gets");
    return;
  }
  this->Factor *= factor;
  for (int i = 0; i < opacity->GetSize(); ++i)
  {
    double node[4];
    opacity->GetNodeValue(i, node);
    node[1] *= factor;
    opacity->SetNodeValue(i, node);
  }
}
} // namespace Explore
