// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests shapes that represent the depth of the touch: the spring with its stretch and slack, the
 * contact patch, and the stylus.
 */

#include "Rigs/DeviceRig.h"
#include "VTK/Scene/Hand/LandingRing.h"
#include "VTK/Scene/Hand/SpringCoil.h"

#include <vtkCamera.h>
#include <vtkHapticRepresentation.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

using namespace devicetest;
using namespace VolumeHaptics;

namespace
{
class ContactShapes : public DeviceTest
{
};

/// Returns the length of a polyline between two of its points.
double ArcLength(vtkPolyData* line, vtkIdType from, vtkIdType to)
{
  double length = 0.0;
  for (vtkIdType i = from; i < to; ++i)
  {
    double a[3];
    double b[3];
    line->GetPoint(i, a);
    line->GetPoint(i + 1, b);
    const double step[3] = { b[0] - a[0], b[1] - a[1], b[2] - a[2] };
    length += Length(step);
  }
  return length;
}

/// Length of the spring's wire: eight windings, which have a radius of 0.5 at rest.
constexpr double Wire = 8.0 * 6.283185307179586 * 0.5;
} // namespace

TEST_F(ContactShapes, TheWireOfTheSpringKeepsItsLength)
{
  SpringCoil spring;
  const Vector3 proxy{ 1.0, 2.0, 3.0 };
  for (const double stretch : { 1.0, 6.0, 24.0 })
  {
    spring.Place(proxy, proxy + stretch * Vector3{ 0.6, 0.0, -0.8 }, 0.0, 1.0);
    vtkPolyData* const wire = spring.GetWire();
    const vtkIdType last = wire->GetNumberOfPoints() - 1;
    // Exclude the two end segments, which lead to the axis. A winding is drawn with 24 sides.
    EXPECT_NEAR(ArcLength(wire, 1, last - 1), Wire, 0.005 * Wire) << stretch;
    EXPECT_NEAR(wire->GetPoint(0)[2], 3.0, 1e-6);
    EXPECT_NEAR(wire->GetPoint(last)[2], 3.0 - 0.8 * stretch, 1e-5);
  }
  // A spring that is stretched beyond the length of its wire must be a straight line.
  spring.Place(proxy, proxy + Vector3{ 0.0, 0.0, 30.0 }, 0.0, 1.0);
  EXPECT_EQ(spring.GetWire()->GetNumberOfPoints(), 2);
}

TEST_F(ContactShapes, SlackIsStraight)
{
  SpringCoil spring;
  spring.Place({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 10.0 }, 4.0, 1.0);
  vtkPolyData* const wire = spring.GetWire();
  EXPECT_NEAR(wire->GetPoint(1)[2], 4.0, 1e-6);
  const vtkIdType last = wire->GetNumberOfPoints() - 1;
  EXPECT_NEAR(ArcLength(wire, 2, last - 1), Wire, 0.005 * Wire);
  spring.Place({ 0.0, 0.0, 0.0 }, { 0.0, 0.0, 10.0 }, 10.0, 1.0);
  EXPECT_EQ(wire->GetNumberOfPoints(), 2) << "all of it";
}

TEST_F(ContactShapes, AStifferSpringHasSlack)
{
  this->Filter->SetSolverToPrecise();
  SetConstant(this->Filter->GetProperty()->GetStiffness(), 500.0);
  this->BeginPressed();
  const double before = Length(this->Device->GetState()->GetComputedForce());
  EXPECT_EQ(this->Device->GetState()->GetSlack(), 0.0);
  constexpr double stiffness = 1000.0;
  SetConstant(this->Filter->GetProperty()->GetStiffness(), stiffness);
  ASSERT_TRUE(this->Device->Publish());
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetSlack() > 0.1; }));
  // The force f = K (d - s) must remain the same, so that a hand at rest gains no energy.
  const double force = Length(this->Device->GetState()->GetComputedForce());
  EXPECT_NEAR(force, before, 0.02 * before);
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double* const proxy = this->Device->GetState()->GetProxyPosition();
  const double d[3] = { tip[0] - proxy[0], tip[1] - proxy[1], tip[2] - proxy[2] };
  EXPECT_NEAR(this->Device->GetState()->GetSlack(), Length(d) - 1e3 * force / stiffness, 0.01);
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->GetContact() == 0; }));
  EXPECT_EQ(this->Device->GetState()->GetSlack(), 0.0) << "it ends with the contact";
}

TEST_F(ContactShapes, ThePatchGrowsWithThePress)
{
  // According to Hertz, the contact patch of a soft ball with a radius R on a plane has the area pi
  // R d. Here R is 5.
  const double begin = ComputePatchRadius(0.0, 1.0);
  const double pressed = ComputePatchRadius(2.0, 1.0);
  EXPECT_NEAR(pressed * pressed - begin * begin, 5.0 * 2.0, 1e-12);
  EXPECT_EQ(ComputePatchRadius(-1.0, 1.0), begin);
  EXPECT_EQ(ComputePatchRadius(100.0, 1.0), 5.0) << "not without bounds";

  // The patch is in the tangent plane, which is across z. Its ring is slightly thicker than the
  // patch.
  this->BeginPressed();
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(this->Device);
  hand->SetRadius(0.5);
  hand->SetForceVisibility(false);
  hand->SetNormalForceVisibility(false);
  hand->SetStylusVisibility(false);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  renderer->AddViewProp(hand);
  window->Render();
  const double depth =
    this->Device->GetState()->GetTipPosition()[2] - this->Device->GetState()->GetProxyPosition()[2];
  ASSERT_GT(depth, 2.5);
  const double patch = std::min(std::sqrt(0.9 * 0.9 + 2.5 * depth), 2.5);
  const double half = 0.5 * (hand->GetBounds()[1] - hand->GetBounds()[0]);
  EXPECT_GT(half, 0.99 * patch);
  EXPECT_LT(half, 1.07 * std::sqrt(2.0) * patch) << "of a square around it, in any direction";
  hand->LandingVisibilityOff();
  window->Render();
  EXPECT_LT(0.5 * (hand->GetBounds()[1] - hand->GetBounds()[0]), 0.6) << "the proxy";
}

TEST_F(ContactShapes, AStylusLeansTowardsTheViewer)
{
  this->BeginPressed();
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(this->Device);
  hand->SetRadius(0.2);
  hand->SetForceVisibility(false);
  hand->SetNormalForceVisibility(false);
  hand->SetLandingVisibility(false);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  renderer->AddViewProp(hand);
  vtkCamera* const camera = renderer->GetActiveCamera();
  camera->SetPosition(7.0, 7.0, -50.0);
  camera->SetFocalPoint(7.0, 7.0, 5.0);
  camera->SetViewUp(0.0, 1.0, 0.0);
  window->Render();
  // In this view, right is -x, up is y, and the viewer is at -z. The stylus is 25 radii long, and
  // tilted like a pen in the right hand.
  const double* const proxy = this->Device->GetState()->GetProxyPosition();
  EXPECT_LT(hand->GetBounds()[0], proxy[0] - 0.4 * 5.0);
  EXPECT_GT(hand->GetBounds()[3], proxy[1] + 0.5 * 5.0);
  EXPECT_LT(hand->GetBounds()[4], proxy[2] - 0.5 * 5.0);
  EXPECT_GT(hand->GetBounds()[4], proxy[2] - 5.0);
  // The stylus must end in front of the eye, so a near viewer sees a shorter stylus.
  camera->SetPosition(7.0, 7.0, proxy[2] - 3.0);
  window->Render();
  EXPECT_GT(hand->GetBounds()[4], proxy[2] - 1.1);
  // No stylus must be drawn for a disarmed hand.
  this->Device->Disarm();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::READY; }));
  EXPECT_EQ(hand->GetBounds(), nullptr);
}
