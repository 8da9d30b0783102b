// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the rest positions of a sphere with a radius of 1 mm on known faces, edges and corners,
 * with a stiffness of 500 N/m.
 */

#include "Rigs/SurfaceRig.h"

using namespace coretest;
using SurfaceProxy = SurfaceTest;

TEST_F(SurfaceProxy, RestsOnAFaceAndLetsGo)
{
  Hand hand(DescribeMesh(this->Volume, MakeFloor()), { 0.3, 0.2, 5.0 });
  hand.Lead({ 0.3, 0.2, 1.5 });
  EXPECT_EQ(Norm(hand.Record.Force), 0.0);
  EXPECT_EQ(hand.Record.Contact, ContactState::Free);
  hand.Lead({ 0.3, 0.2, -3.0 });
  this->ExpectAt(hand, { 0.3, 0.2, 1.0 });
  EXPECT_NEAR(hand.Record.NormalForce, 2.0, 1e-4);
  EXPECT_LE(Norm(hand.Record.Normal - Vector3{ 0.0, 0.0, -1.0 }), 1e-9);
  hand.Lead({ 20.3, 10.2, -3.0 });
  this->ExpectAt(hand, { 20.3, 10.2, 1.0 });
  hand.Lead({ 0.3, 0.2, 5.0 });
  EXPECT_EQ(Norm(hand.Record.Force), 0.0);
}

TEST_F(SurfaceProxy, RollsRoundAnEdgeAndACorner)
{
  Hand hand(DescribeMesh(this->Volume, MakeCube(10.0)), { 0.0, 0.0, 15.0 });
  hand.Lead({ 0.0, 0.0, 8.0 });
  this->ExpectAt(hand, { 0.0, 0.0, 11.0 });
  // At an edge, the sphere is held diagonally, half by each face.
  hand.Lead({ 10.2, 0.0, 10.2 });
  const double s = std::sqrt(0.5);
  this->ExpectAt(hand, { 10.0 + s, 0.0, 10.0 + s });
  const double c = std::sqrt(1.0 / 3.0);
  hand.Lead({ 10.2, 10.2, 10.2 });
  this->ExpectAt(hand, { 10.0 + c, 10.0 + c, 10.0 + c });
  hand.Lead({ 8.0, 0.0, 0.0 });
  this->ExpectAt(hand, { 11.0, 0.0, 0.0 });
}

TEST_F(SurfaceProxy, StopsInAnInsideCornerOfTwoAndOfThreeFaces)
{
  Hand hand(DescribeMesh(this->Volume, MakeCube(10.0)), { 0.0, 0.0, 0.0 });
  hand.Lead({ 12.0, 0.0, 0.0 });
  this->ExpectAt(hand, { 9.0, 0.0, 0.0 });
  hand.Lead({ 12.0, 13.0, 1.0 });
  this->ExpectAt(hand, { 9.0, 9.0, 1.0 });
  hand.Lead({ 12.0, 13.0, -14.0 });
  this->ExpectAt(hand, { 9.0, 9.0, -9.0 });
}

// Triangles have no inner side. Ruspini's sphere may begin at the tip on either side of a surface,
// and must stay on this side.
TEST_F(SurfaceProxy, IsHeldWhereItBeganAndNotThrownOut)
{
  for (const double side : { 1.0, -1.0 })
  {
    // The sphere begins nearer to the floor than its radius.
    Hand hand(DescribeMesh(this->Volume, MakeFloor()), { 3.0, 4.0, 0.4 * side });
    EXPECT_EQ(Norm(hand.Record.Force), 0.0);
    EXPECT_LT(Norm(hand.Lead({ 5.0, 4.0, 0.4 * side }).Force), 1e-5) << "nothing pushes it out";
    hand.Lead({ 5.0, 4.0, -2.0 * side });
    this->ExpectAt(hand, { 5.0, 4.0, 0.4 * side });
    // While the sphere moves away from the floor, no force acts. After its return, the floor holds
    // it at a distance of its radius.
    double most = 0.0;
    for (const double z : { 0.4, 1.2, 3.0 })
    {
      hand.Lead({ 5.0, 4.0, z * side });
      most = std::max(most, Norm(hand.Record.Force));
    }
    EXPECT_LT(most, 1e-5);
    hand.Lead({ 5.0, 4.0, -2.0 * side });
    this->ExpectAt(hand, { 5.0, 4.0, 1.0 * side });
  }
}

TEST_F(SurfaceProxy, TracksABallOutsideAndInside)
{
  for (const double side : { 1.0, -1.0 })
  {
    Hand hand(
      DescribeMesh(this->Volume, MakeBall(20.0, 200, true)), { 0.0, 20.0 + 5.0 * side, 0.0 });
    hand.Lead({ 0.0, 20.0 - 2.0 * side, 0.0 });
    for (int i = 0; i < 1000; ++i)
    {
      const double angle = 0.01 * i;
      const Vector3 out = { std::sin(angle) * 0.6, std::cos(angle), std::sin(angle) * 0.8 };
      hand.Lead((20.0 - 2.0 * side) * out, 1.0);
      // The tolerance covers the facets: their middles are up to 20 (1 - cos 0.9 degrees / 2) mm
      // inside the sphere.
      EXPECT_NEAR(Norm(hand.Proxy()), 20.0 + side, 5e-3) << i;
      EXPECT_NEAR(Dot(hand.Proxy(), out), Norm(hand.Proxy()), 5e-3) << i;
      EXPECT_FALSE(hand.Record.IsUnfinished);
    }
  }
}

TEST_F(SurfaceProxy, FrictionHoldsAndSlidesAsTheLawSays)
{
  Hand hand(DescribeMesh(this->Volume, MakeFloor(), 0.5), { 0.0, 0.0, 5.0 });
  hand.Lead({ 0.0, 0.0, -3.0 }); // 4 mm of lag, at which friction holds up to 2 mm sideways
  hand.Lead({ 1.9, 0.0, -3.0 });
  this->ExpectAt(hand, { 0.0, 0.0, 1.0 });
  EXPECT_EQ(hand.Record.Contact, ContactState::Sticking);
  hand.Lead({ 7.0, 0.0, -3.0 });
  this->ExpectAt(hand, { 5.0, 0.0, 1.0 });
  EXPECT_EQ(hand.Record.Contact, ContactState::Sliding);
  EXPECT_NEAR(hand.Record.FrictionForce, 1.0, 1e-4);
}
