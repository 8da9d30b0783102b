// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_PaintedItem_h
#define Explore_PaintedItem_h

#include "vtkAbstractContextItem.h"
#include "vtkObjectFactory.h"

#include <functional>

class vtkContext2D;

namespace Explore
{
/// A context item that calls a function to draw itself.
class PaintedItem : public vtkAbstractContextItem
{
public:
  static PaintedItem* New() { VTK_STANDARD_NEW_BODY(PaintedItem); }
  vtkTypeMacro(PaintedItem, vtkAbstractContextItem);
  bool Paint(vtkContext2D* painter) override { return this->Painter && this->Painter(painter); }

  std::function<bool(vtkContext2D*)> Painter;
};
} // namespace Explore

#endif
