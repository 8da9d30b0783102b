// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "VTK/Scene/Hand/LandingRing.h"

#include "VTK/Base/HapticTuples.h"
#include "VTK/Scene/Base/HapticViewRay.h"

#include "vtkHapticDevice.h"
#include "vtkRenderer.h"
#include "vtkTextProperty.h"

#include <algorithm>
#include <iomanip>
#include <sstream>

namespace VolumeHaptics
{
namespace
{

/// Lengths in radii of the proxy: the distance at which the ring starts to close, and the height of
/// the patch above the surface, which prevents the surface from hiding part of the patch.
constexpr double FarAway = 20.0;
constexpr double Above = 0.1;
constexpr double Gap = 8.0; ///< pixels between ring and text

std::string DescribeDistance(double distance, const std::string& unit)
{
  std::ostringstream text;
  text << std::fixed << std::setprecision(distance < 10.0 ? 1 : 0) << distance << " " << unit;
  return text.str();
}

} // namespace

LandingRing::LandingRing()
{
  vtkTextProperty* const text = this->Distance->GetTextProperty();
  text->SetFontSize(13);
  text->SetColor(0.93, 0.95, 0.98);
  text->SetBackgroundColor(0.07, 0.09, 0.12);
  text->SetBackgroundOpacity(0.6);
  text->SetVerticalJustificationToCentered();
}

void LandingRing::Update(
  vtkRenderer* renderer, vtkHapticDevice* device, double radius, const std::string& unit)
{
  this->Ring.Show(false);
  this->Patch.Show(false);
  this->Distance->VisibilityOff();
  if (!renderer || !device)
  {
    return;
  }
  if (device->GetState()->GetContact() != 0)
  {
    const Vector3 normal = FromArray(device->GetState()->GetNormal());
    if (Norm(normal) > 0.0)
    {
      const Vector3 proxy = FromArray(device->GetState()->GetProxyPosition());
      const double depth = Dot(FromArray(device->GetState()->GetTipPosition()) - proxy, normal);
      const double patch = ComputePatchRadius(depth, radius);
      this->Ring.Show(true);
      this->Ring.PlaceRing(proxy, normal, patch);
      this->Patch.Show(true);
      this->Patch.PlaceRing(proxy - (Above * radius) * normal, normal, patch);
    }
    return;
  }
  const Vector3 tip = FromArray(device->GetState()->GetTipPosition());
  vtkVolumeHapticsFilter* const filter = device->GetVolumeHaptics();
  Vector3 contact;
  Vector3 normal;
  if (!filter || !FindContactAhead(renderer, tip, filter, contact, normal))
  {
    return;
  }
  const Vector3 sight = LineOfSight(renderer, tip);
  const double distance = Dot(contact - tip, sight);
  const double fraction = std::clamp(distance / (FarAway * radius), 0.0, 1.0);
  const double ring = (ClosedRing + fraction * (OpenRing - ClosedRing)) * radius;
  this->Ring.Show(true);
  this->Ring.PlaceRing(contact, Norm(normal) > 0.0 ? normal : sight, ring);
  if (distance >= radius)
  {
    renderer->SetWorldPoint(contact.X, contact.Y, contact.Z, 1.0);
    renderer->WorldToDisplay();
    double display[3];
    renderer->GetDisplayPoint(display);
    this->Distance->SetInput(DescribeDistance(distance, unit).c_str());
    this->Distance->SetPosition(display[0] + ring / PixelSize(renderer, contact) + Gap, display[1]);
    this->Distance->VisibilityOn();
  }
}

void LandingRing::RenderText(vtkViewport* viewport)
{
  if (this->Distance->GetVisibility())
  {
    this->Distance->RenderOpaqueGeometry(viewport); // renders the text into the texture that is
                                                    // drawn next
    this->Distance->RenderOverlay(viewport);
  }
}

void LandingRing::Release(vtkWindow* window)
{
  this->Ring.Release(window);
  this->Patch.Release(window);
  this->Distance->ReleaseGraphicsResources(window);
}

} // namespace VolumeHaptics
