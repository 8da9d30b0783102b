// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/Explorer/View/LoadingScreen.h"

#include "VTK/Scene/Base/HapticPixels.h"
#include "VTK/Scene/Base/RendererAspect.h"

#include "vtkCoordinate.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkProperty2D.h"
#include "vtkTextProperty.h"

#include <algorithm>

namespace
{
/// Position and size of the progress bar, in fractions of the window.
constexpr double LEFT = 0.3;
constexpr double WIDTH = 0.4;
constexpr double BOTTOM = 0.46;
constexpr double HEIGHT = 0.012;
} // namespace

namespace Explore
{
LoadingScreen::LoadingScreen(vtkRenderWindow* window)
  : Window(window)
{
  this->Renderer->GradientBackgroundOn();
  this->Renderer->SetBackground(0.07, 0.09, 0.12);
  this->Renderer->SetBackground2(0.24, 0.29, 0.36);
  vtkTextProperty* const text = this->Text->GetTextProperty();
  const int points = window->GetSize()[1] * VolumeHaptics::OwnDotsPerInch / window->GetDPI();
  text->SetFontSize(std::max(12, points / 32));
  text->SetColor(0.93, 0.95, 0.98);
  text->SetJustificationToCentered();
  this->Text->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  this->Text->GetPositionCoordinate()->SetValue(0.5, 0.52);
  this->Renderer->AddViewProp(this->Text);
  this->AddBar(this->Whole, 0.32, 0.40, 0.52);
  this->AddBar(this->Done, 0.93, 0.95, 0.98);
  window->AddRenderer(this->Renderer);
  VolumeHaptics::ComputeAspect(this->Renderer);
}

LoadingScreen::~LoadingScreen()
{
  this->Window->RemoveRenderer(this->Renderer);
}

void LoadingScreen::AddBar(vtkPlaneSource* bar, double red, double green, double blue)
{
  vtkNew<vtkCoordinate> place;
  place->SetCoordinateSystemToNormalizedViewport();
  vtkNew<vtkPolyDataMapper2D> mapper;
  mapper->SetTransformCoordinate(place);
  mapper->SetInputConnection(bar->GetOutputPort());
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(red, green, blue);
  this->Renderer->AddViewProp(actor);
}

void LoadingScreen::Report(const std::string& step, double fraction)
{
  this->Text->SetInput(step.c_str());
  const auto place = [](vtkPlaneSource* bar, double width)
  {
    bar->SetOrigin(LEFT, BOTTOM, 0.0);
    bar->SetPoint1(LEFT + width, BOTTOM, 0.0);
    bar->SetPoint2(LEFT, BOTTOM + HEIGHT, 0.0);
  };
  place(this->Whole, WIDTH);
  place(this->Done, WIDTH * std::clamp(fraction, 0.001, 1.0));
  this->Window->Render();
}
} // namespace Explore
