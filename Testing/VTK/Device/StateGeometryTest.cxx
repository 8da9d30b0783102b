// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests the geometry that represents the latest state. */

#include "Rigs/DeviceRig.h"

#include <vtkCellData.h>
#include <vtkCubeSource.h>
#include <vtkFieldData.h>
#include <vtkHapticPointShell.h>
#include <vtkHapticRepresentation.h>
#include <vtkHapticState.h>
#include <vtkPointData.h>

using namespace devicetest;

namespace
{
class StateGeometry : public DeviceTest
{
protected:
  vtkPolyData* Get()
  {
    this->Device->GetState()->GetGeometry(this->Geometry);
    return this->Geometry;
  }
  void ExpectLine(int part, const double* from, const double* vector)
  {
    vtkPolyData* const output = this->Get();
    vtkDataArray* const parts = output->GetCellData()->GetArray("Part");
    for (vtkIdType cell = 0; cell < output->GetNumberOfCells(); ++cell)
    {
      if (parts->GetComponent(cell, 0) == part)
      {
        vtkNew<vtkIdList> ends;
        output->GetCellPoints(cell, ends);
        ASSERT_EQ(ends->GetNumberOfIds(), 2);
        for (int c = 0; c < 3; ++c)
        {
          EXPECT_NEAR(output->GetPoint(ends->GetId(0))[c], from[c], 1e-9) << part;
          EXPECT_NEAR(output->GetPoint(ends->GetId(1))[c], from[c] + vector[c], 1e-6) << part;
        }
        EXPECT_NEAR(output->GetCellData()->GetArray("Newtons")->GetComponent(cell, 0),
          part == vtkHapticState::SPRING ? 0.0 : 0.1 * Length(vector), 1e-6);
        return;
      }
    }
    ADD_FAILURE() << "no part " << part;
  }

  vtkNew<vtkPolyData> Geometry;
};
} // namespace

TEST_F(StateGeometry, IsEmptyWithoutAState)
{
  vtkNew<vtkPoints> points;
  this->Geometry->SetPoints(points);
  points->InsertNextPoint(0.0, 0.0, 0.0);
  EXPECT_EQ(this->Get()->GetNumberOfPoints(), 0);
  MessageLog log(this->Device->GetState());
  this->Device->GetState()->GetGeometry(nullptr);
  this->Device->GetState()->GetGeometry(this->Geometry, 0.0);
  EXPECT_EQ(log.Errors.size(), 2U);
  vtkNew<vtkHapticRepresentation> representation;
  EXPECT_EQ(representation->GetBounds(), nullptr);
}

TEST_F(StateGeometry, IsTheStateOfTheDevice)
{
  SetConstant(this->Filter->GetProperty()->GetFriction(), 0.4);
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->Lead(7.0, 7.0, 8.0));
  ASSERT_TRUE(this->Lead(8.5, 7.0, 8.0));
  ASSERT_TRUE(this->WaitTicks(20));
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double* const proxy = this->Device->GetState()->GetProxyPosition();
  const double spring[3] = { proxy[0] - tip[0], proxy[1] - tip[1], proxy[2] - tip[2] };
  // The stiffness is 500 N/m, and an arrow has 1 mm per 0.1 N, so an arrow is 5 times as long as
  // the spring.
  const double force[3] = { 5.0 * spring[0], 5.0 * spring[1], 5.0 * spring[2] };
  const double normal[3] = { 0.0, 0.0, force[2] };
  const double friction[3] = { force[0], force[1], 0.0 };
  ASSERT_LT(normal[2], -10.0);
  ASSERT_LT(friction[0], -1.0);
  this->ExpectLine(vtkHapticState::SPRING, tip, spring);
  this->ExpectLine(vtkHapticState::FORCE, tip, force);
  this->ExpectLine(vtkHapticState::NORMAL_FORCE, proxy, normal);
  this->ExpectLine(vtkHapticState::FRICTION_FORCE, proxy, friction);
  EXPECT_NEAR(this->Get()->GetPoint(2)[2], proxy[2] + 2.0, 1e-6) << "x_s";
  EXPECT_NEAR(this->Get()->GetPoint(3)[2], proxy[2] - 2.0, 1e-6) << "x_v";
}

TEST_F(StateGeometry, FollowsTheDevice)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  EXPECT_NEAR(this->Get()->GetPoint(0)[2], 4.0, 1e-6);
}

TEST_F(StateGeometry, HasTheOrientationOfTheStylus)
{
  this->Begin();
  const auto orientation = [this] { return this->Get()->GetFieldData()->GetArray("Orientation"); };
  ASSERT_TRUE(orientation());
  ASSERT_EQ(orientation()->GetNumberOfComponents(), 4);
  EXPECT_EQ(orientation()->GetComponent(0, 0), 0.0) << "all 0: the device has none";
  this->Device->GetVirtualHand()->SetOrientation(0.6, 0.0, -0.8, 0.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->HasTipOrientation(); }));
  const double wanted[4] = { 0.6, 0.0, -0.8, 0.0 };
  for (int c = 0; c < 4; ++c)
  {
    EXPECT_NEAR(orientation()->GetComponent(0, c), wanted[c], 1e-14);
  }
}

TEST_F(StateGeometry, TheStylusIsShownIfItIsTurned)
{
  this->Begin();
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(this->Device);
  hand->SetRadius(0.2);
  EXPECT_NEAR(hand->GetBounds()[1], 7.2, 0.01) << "the proxy";
  // A rotation by 90 degrees about y moves the handle from z to x.
  this->Device->GetVirtualHand()->SetOrientation(1.0, 0.0, 1.0, 0.0);
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetState()->HasTipOrientation(); }));
  EXPECT_NEAR(hand->GetBounds()[1], 7.0 + 25.0 * 0.2, 0.01) << "25 radii";
  EXPECT_NEAR(hand->GetBounds()[0], 6.8, 0.01) << "the proxy";
  hand->SetStylusLength(3.0);
  EXPECT_NEAR(hand->GetBounds()[1], 10.0, 0.01);
  hand->SetStylusVisibility(false);
  EXPECT_NEAR(hand->GetBounds()[1], 7.2, 0.01);
}

/// A shaped tool must be drawn instead of the stylus, with its position and orientation.
TEST_F(StateGeometry, AToolWithAShapeIsShown)
{
  vtkNew<vtkCubeSource> box;
  box->SetXLength(1.0);
  box->SetYLength(2.0);
  box->SetZLength(4.0);
  box->Update();
  vtkNew<vtkHapticPointShell> tool;
  tool->SetMesh(box->GetOutput());
  tool->SetSolidToAbove();
  tool->SetContactValue(1e6);
  this->Filter->SetTool(tool);
  this->Begin();
  ASSERT_TRUE(this->Wait([this] { return this->Device->IsPublished(); })) << "its points";
  ASSERT_TRUE(this->Lead(7.0, 7.0, 4.0));
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(this->Device);
  hand->SetRadius(0.2);
  EXPECT_NEAR(hand->GetBounds()[0], 6.5, 0.01);
  EXPECT_NEAR(hand->GetBounds()[3], 8.0, 0.01);
  EXPECT_NEAR(hand->GetBounds()[5], 6.0, 0.01);
  // A rotation by 90 degrees about y moves the box from z to x.
  this->Device->GetVirtualHand()->SetOrientation(1.0, 0.0, 1.0, 0.0);
  ASSERT_TRUE(
    this->Wait([this] { return this->Device->GetState()->GetToolOrientation()[2] > 0.7; }));
  ASSERT_TRUE(this->Wait([&] { return std::abs(hand->GetBounds()[1] - 9.0) < 0.01; }));
  EXPECT_NEAR(hand->GetBounds()[5], 4.5, 0.01);
  hand->SetStylusVisibility(false);
  EXPECT_NEAR(hand->GetBounds()[1], 7.2, 0.01);
}

TEST_F(StateGeometry, ArrowsAreNoLongerThanTheirMaximum)
{
  this->Begin();
  ASSERT_TRUE(this->ArmFully());
  ASSERT_TRUE(this->LeadInto(8.0));
  const double proxy = this->Device->GetState()->GetProxyPosition()[2];
  // The stiffness is 500 N/m, and an arrow has 1 mm per 0.1 N, so the arrow is 5 times as long as
  // the spring.
  const double length = 5.0 * (this->Device->GetState()->GetTipPosition()[2] - proxy);
  ASSERT_GT(length, 7.0);
  vtkNew<vtkHapticRepresentation> hand;
  hand->SetDevice(this->Device);
  hand->SetRadius(0.2);
  hand->SetForceVisibility(false); // hides the force, which equals the normal force here
  EXPECT_NEAR(hand->GetBounds()[4], proxy - 6.0, 0.01) << "30 radii";
  hand->SetMaximumArrowLength(2.5);
  EXPECT_NEAR(hand->GetBounds()[4], proxy - 2.5, 0.01);
  hand->SetMaximumArrowLength(100.0);
  EXPECT_NEAR(hand->GetBounds()[4], proxy - length, 0.01);
  this->Device->Disarm();
  ASSERT_TRUE(this->Wait([this] { return this->Device->GetStatus() == vtkHapticDevice::READY; }));
  EXPECT_EQ(hand->GetBounds(), nullptr) << "the hand has let go";
  ASSERT_TRUE(this->Lead(7.0, 7.0, 7.5));
  ASSERT_TRUE(hand->GetBounds()) << "it moves";
  EXPECT_NEAR(hand->GetBounds()[4], proxy - 0.2, 0.01);
}
