// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Display/HapticCurveNames.h"

#include "vtkContext2D.h"
#include "vtkObjectFactory.h"
#include "vtkStdString.h"
#include "vtkTextProperty.h"

vtkStandardNewMacro(HapticCurveNames);

namespace
{
/** Lengths relative to the size of letters. */
constexpr float NameLineHeight = 1.5f;
constexpr float NameGap = 0.9f;
constexpr double TitleInk[3] = { 0.90, 0.92, 0.95 };
} // namespace

//------------------------------------------------------------------------------
HapticCurveNames::HapticCurveNames() = default;

//------------------------------------------------------------------------------
HapticCurveNames::~HapticCurveNames() = default;

//------------------------------------------------------------------------------
void HapticCurveNames::Place(float left, float top, int letters, float scale)
{
  this->Left = left;
  this->Top = top;
  this->Letters = letters;
  this->Scale = scale;
}

//------------------------------------------------------------------------------
float HapticCurveNames::GetHeight(int letters)
{
  return 2.0f * NameLineHeight * static_cast<float>(letters);
}

//------------------------------------------------------------------------------
bool HapticCurveNames::Paint(vtkContext2D* painter)
{
  vtkTextProperty* const look = painter->GetTextProp();
  look->SetFontSize(this->Letters);
  look->BoldOff();
  look->ItalicOff();
  look->SetOrientation(0.0);
  look->SetJustificationToLeft();
  look->SetVerticalJustificationToTop();
  if (!this->Title.empty())
  {
    look->SetColor(TitleInk[0], TitleInk[1], TitleInk[2]);
    painter->DrawString(this->Left, this->Top, this->Title);
  }
  const float size = this->Scale * static_cast<float>(this->Letters);
  float x = this->Left;
  for (const Name& name : this->Names)
  {
    look->SetColor(name.Color[0] / 255.0, name.Color[1] / 255.0, name.Color[2] / 255.0);
    painter->DrawString(x, this->Top - NameLineHeight * size, name.Text);
    float bounds[4]; // lower left corner, width and height
    painter->ComputeStringBounds(name.Text, bounds);
    x += bounds[2] + NameGap * size;
  }
  return true;
}
