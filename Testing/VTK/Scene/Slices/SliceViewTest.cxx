// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests slices beside the scene: the voxel that each pixel displays, and the position to which a
 * click moves the tip.
 */

#include "VTK/Scene/Interaction/StyleRig.h"

#include <vtkDoubleArray.h>
#include <vtkHapticHeadUpDisplay.h>
#include <vtkHapticSliceView.h>
#include <vtkMatrix3x3.h>
#include <vtkUnsignedCharArray.h>

#include <array>

using namespace scenetest;

namespace
{
using SlicePlace = std::array<double, 3>;

/// The index axes i, j, k are -y, z and -x of the world, rotated about z by 20 degrees.
constexpr double SparkCos = 0.93969262078590838;
constexpr double SparkSin = 0.34202014332566873;
constexpr double SparkDirection[9] = { SparkSin, 0.0, -SparkCos, -SparkCos, 0.0, -SparkSin, 0.0,
  1.0, 0.0 };
constexpr double SparkSpacing[3] = { 1.0, 2.0, 3.0 };
constexpr double SparkOrigin[3] = { 7.0, -5.0, 11.0 };

/// Makes a black image with one bright voxel.
vtkSmartPointer<vtkImageData> MakeSpark(const int spark[3])
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetExtent(2, 19, -3, 9, 0, 7);
  image->SetSpacing(SparkSpacing);
  image->SetOrigin(SparkOrigin);
  image->SetDirectionMatrix(SparkDirection);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(0.0);
  image->SetScalarComponentFromDouble(spark[0], spark[1], spark[2], 0, 100.0);
  return image;
}

/// Computes the world position of an index without VTK: the origin, plus direction times spacing
/// times index for each axis.
SlicePlace SparkWorldOf(const int index[3])
{
  SlicePlace world;
  for (int row = 0; row < 3; ++row)
  {
    world[row] = SparkOrigin[row];
    for (int axis = 0; axis < 3; ++axis)
    {
      world[row] += SparkDirection[3 * row + axis] * SparkSpacing[axis] * index[axis];
    }
  }
  return world;
}

class SliceViewTest : public StyleTest
{
protected:
  SliceViewTest()
  {
    this->View->SetDevice(this->Device);
    this->View->SetShare(0.5);
    this->View->SetRenderWindow(this->Window);
    this->Style->SetSliceView(this->View);
  }
  std::array<int, 2> ComputeMiddle(int slice)
  {
    const int* const origin = this->View->GetRenderer(slice)->GetOrigin();
    const int* const size = this->View->GetRenderer(slice)->GetSize();
    return { origin[0] + size[0] / 2, origin[1] + size[1] / 2 };
  }
  /// Returns the centre (pixels of the window) of the bright grey pixels, which are neither text
  /// nor crosshair.
  std::array<int, 2> FindSpark(int slice)
  {
    const int* const origin = this->View->GetRenderer(slice)->GetOrigin();
    const int* const size = this->View->GetRenderer(slice)->GetSize();
    vtkNew<vtkUnsignedCharArray> pixels;
    this->Window->GetPixelData(
      origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1, 0, pixels);
    double sum[3] = {};
    for (vtkIdType i = 0; i < pixels->GetNumberOfTuples(); ++i)
    {
      const double grey = pixels->GetComponent(i, 0);
      if (grey > 60.0 && grey == pixels->GetComponent(i, 1) && grey == pixels->GetComponent(i, 2))
      {
        sum[0] += grey * static_cast<double>(i % size[0]);
        sum[1] += grey * static_cast<double>(i / size[0]);
        sum[2] += grey;
      }
    }
    return { origin[0] + static_cast<int>(std::lround(sum[0] / sum[2])),
      origin[1] + static_cast<int>(std::lround(sum[1] / sum[2])) };
  }
  SlicePlace Ask(int slice, int x, int y)
  {
    SlicePlace position{};
    EXPECT_TRUE(this->View->FindPosition(slice, x, y, position.data()));
    return position;
  }
  void OpenAndStart()
  {
    ASSERT_TRUE(this->Device->Open("virtual"));
    ASSERT_TRUE(this->Device->Start());
    this->Style->UpdateHaptics();
    this->Window->Render();
  }
  void ExpectTip(const SlicePlace& wanted)
  {
    const double* const tip = this->Device->GetState()->GetTipPosition();
    for (int axis = 0; axis < 3; ++axis)
    {
      EXPECT_NEAR(tip[axis], wanted[axis], 1e-6) << axis;
    }
  }

  vtkNew<vtkHapticSliceView> View;
};
} // namespace

TEST_F(SliceViewTest, APositionInASliceIsThatOfTheVoxelShownThere)
{
  this->Window->SetSize(500, 900);
  this->View->SetColorWindow(100.0);
  this->View->SetColorLevel(50.0);
  for (const bool anatomical : { false, true })
  {
    this->View->SetAnatomical(anatomical);
    for (const auto& spark : { std::array<int, 3>{ 8, 4, 2 }, std::array<int, 3>{ 13, -1, 5 } })
    {
      const auto image = MakeSpark(spark.data());
      const SlicePlace world = SparkWorldOf(spark.data());
      this->View->SetImage(image);
      this->View->SetPosition(world.data());
      this->Window->Render();
      for (int slice = 0; slice < 3; ++slice)
      {
        const auto [x, y] = this->FindSpark(slice);
        ASSERT_EQ(this->View->FindSlice(x, y), slice) << anatomical;
        const SlicePlace found = this->Ask(slice, x, y);
        // A pixel is 0.13 mm wide.
        EXPECT_NEAR(vtkMath::Distance2BetweenPoints(found.data(), world.data()), 0.0, 0.1)
          << "slice " << slice << ", anatomical " << anatomical;
      }
    }
  }
}

TEST_F(SliceViewTest, AnatomicalSlicesLieAsRadiologistsLookAtThem)
{
  const int spark[3] = { 10, 3, 4 };
  this->View->SetImage(MakeSpark(spark));
  this->View->AnatomicalOn();
  this->Window->Render();
  // Axes of the world that point to the right and upwards in each slice: +x is left, +y is
  // posterior, and +z is superior.
  const int right[3] = { 0, 0, 1 };
  const int rightSign[3] = { 1, 1, 1 };
  const int up[3] = { 1, 2, 2 };
  const int upSign[3] = { -1, 1, 1 };
  for (int slice = 0; slice < 3; ++slice)
  {
    const auto [x, y] = this->ComputeMiddle(slice);
    const SlicePlace here = this->Ask(slice, x, y);
    const SlicePlace beside = this->Ask(slice, x + 5, y);
    const SlicePlace above = this->Ask(slice, x, y + 5);
    EXPECT_GT(rightSign[slice] * (beside[right[slice]] - here[right[slice]]), 0.1) << slice;
    EXPECT_GT(upSign[slice] * (above[up[slice]] - here[up[slice]]), 0.1) << slice;
  }
  EXPECT_EQ(this->View->GetText(0).rfind("Axial 3\n", 0), 0U) << "along j";
  EXPECT_EQ(this->View->GetText(1), "Coronal 11") << "along i, the middle of 2 to 19";
  SlicePlace position = SparkWorldOf(spark);
  ASSERT_TRUE(this->View->MoveAcross(0, 1.0, position.data()));
  EXPECT_NEAR(position[2] - SparkWorldOf(spark)[2], 2.0, 1e-9) << "towards the head, by a voxel";
  ASSERT_TRUE(this->View->MoveAcross(0, 100.0, position.data()));
  const int last[3] = { 10, 9, 4 };
  EXPECT_NEAR(position[2], SparkWorldOf(last)[2], 1e-9) << "not out of the image";
}

TEST_F(SliceViewTest, AClickBeginsTheTouchThereAndTheNextOneLeadsTheTip)
{
  this->OpenAndStart();
  const auto [x, y] = this->ComputeMiddle(0);
  const SlicePlace begin = this->Ask(0, x + 10, y);
  this->Pointer(x + 10, y, vtkCommand::LeftButtonPressEvent);
  this->Pointer(x + 10, y, vtkCommand::LeftButtonReleaseEvent);
  EXPECT_TRUE(this->Style->GetTouchMode());
  this->Run(20);
  this->ExpectTip(begin);
  EXPECT_NE(this->Device->GetStatus(), vtkHapticDevice::READY) << "armed";

  // Moving the pointer over a slice must not move the tip; only a drag does.
  this->Pointer(x + 20, y + 7);
  this->Run(20);
  this->ExpectTip(begin);
  const SlicePlace end = this->Ask(0, x - 20, y + 5);
  this->Pointer(x - 20, y + 5, vtkCommand::LeftButtonPressEvent);
  this->Run(2);
  EXPECT_GT(std::abs(this->Device->GetState()->GetTipPosition()[0] - end[0]), 1.0)
    << "2 m/s at most";
  this->Run(60);
  this->ExpectTip(end);
  EXPECT_EQ(this->Device->GetState()->GetButtons(), 0);
  const SlicePlace dragged = this->Ask(0, x - 15, y + 5);
  this->Pointer(x - 15, y + 5);
  this->Run(60);
  this->ExpectTip(dragged);
  this->Pointer(x - 15, y + 5, vtkCommand::LeftButtonReleaseEvent);

  this->Pointer(x, y, vtkCommand::MouseWheelForwardEvent);
  this->Run(60);
  this->ExpectTip({ dragged[0], dragged[1], dragged[2] + 1.0 }); // voxels are 1 mm along z
  double shown[3];
  this->View->GetPosition(shown);
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_NEAR(shown[axis], this->Device->GetState()->GetTipPosition()[axis], 0.5)
      << "the slices follow";
  }
}

TEST_F(SliceViewTest, DoesNotLeadAHeldHand)
{
  this->OpenAndStart();
  this->Press("t");
  this->Run(50);
  ASSERT_TRUE(this->Style->GetTouchMode());
  const double* const tip = this->Device->GetState()->GetTipPosition();
  const double start[3] = { tip[0], tip[1], tip[2] };
  const auto way = [&]
  {
    this->Run(300);
    const double moved[3] = { tip[0] - start[0], tip[1] - start[1], tip[2] - start[2] };
    return Length(moved);
  };
  this->Style->SetHoldClicks(1);
  const auto [x, y] = this->ComputeMiddle(2);
  const auto drag = [&, x = x, y = y]
  {
    this->Pointer(x, y, vtkCommand::LeftButtonPressEvent);
    this->Pointer(x + 10, y + 5);
    this->Pointer(x + 10, y + 5, vtkCommand::LeftButtonReleaseEvent);
    this->Pointer(x, y, vtkCommand::MouseWheelForwardEvent);
  };
  drag();
  EXPECT_LT(way(), 1e-3) << "it stays where it is held";
  EXPECT_EQ(this->Style->GetHoldClicks(), 1);
  this->Style->SetHoldClicks(2);
  drag();
  EXPECT_GT(way(), 1.0) << "it goes where it shall stay";
  EXPECT_EQ(this->Style->GetHoldClicks(), 1);
}

TEST_F(SliceViewTest, WithoutATouchTheWheelLooksThroughTheSlices)
{
  this->OpenAndStart();
  const auto [x, y] = this->ComputeMiddle(2);
  this->Pointer(x, y, vtkCommand::MouseWheelForwardEvent);
  this->Pointer(x, y, vtkCommand::MouseWheelForwardEvent);
  double shown[3];
  this->View->GetPosition(shown);
  EXPECT_NEAR(shown[0], 2.0, 1e-9) << "from the middle of the ball";
  EXPECT_EQ(this->View->GetText(2).rfind("i = 50\n", 0), 0U) << this->View->GetText(2);
  EXPECT_FALSE(this->Style->GetTouchMode());
}

TEST_F(SliceViewTest, DragsWindowAndLevelAsTheStyleForImagesDoes)
{
  this->OpenAndStart();
  this->View->SetColorWindow(300.0);
  this->View->SetColorLevel(-20.0);
  const auto [x, y] = this->ComputeMiddle(1);
  const int* const size = this->View->GetRenderer(1)->GetSize();
  const double position[3] = { this->Renderer->GetActiveCamera()->GetPosition()[0],
    this->Renderer->GetActiveCamera()->GetPosition()[1],
    this->Renderer->GetActiveCamera()->GetPosition()[2] };
  // A drag over the slice's width or height changes the window or the level by four times the
  // window.
  this->Pointer(x, y, vtkCommand::RightButtonPressEvent);
  this->Pointer(x + 10, y + 5);
  this->Pointer(x + 10, y + 5, vtkCommand::RightButtonReleaseEvent);
  EXPECT_NEAR(this->View->GetColorWindow(), 300.0 * (1.0 + 40.0 / size[0]), 1e-9);
  EXPECT_NEAR(this->View->GetColorLevel(), -20.0 + 300.0 * 20.0 / size[1], 1e-9);
  this->Pointer(x, y, vtkCommand::LeftButtonPressEvent, 1);
  this->Pointer(x, y - 5, vtkCommand::MouseMoveEvent, 1);
  this->Pointer(x, y - 5, vtkCommand::LeftButtonReleaseEvent, 1);
  EXPECT_LT(this->View->GetColorLevel(), -20.0 + 300.0 * 20.0 / size[1]);
  EXPECT_FALSE(this->Style->GetTouchMode());
  for (int axis = 0; axis < 3; ++axis)
  {
    EXPECT_EQ(this->Renderer->GetActiveCamera()->GetPosition()[axis], position[axis]);
  }
}

TEST_F(SliceViewTest, AKeyGivesTheSceneItsRoomBack)
{
  this->OpenAndStart();
  EXPECT_EQ(this->Renderer->GetViewport()[2], 0.5);
  EXPECT_NE(this->Style->GetKeys().find("Slices\n"), std::string::npos);
  this->Press("s");
  EXPECT_FALSE(this->View->GetVisibility());
  this->Window->Render();
  EXPECT_EQ(this->Renderer->GetViewport()[2], 1.0);
  EXPECT_EQ(this->View->FindSlice(200, 100), -1);
  this->Press("s", vtkCommand::KeyReleaseEvent);
  this->Run(30); // waits, so that the next press is not a held key's repetition
  this->Press("s");
  this->Window->Render();
  EXPECT_EQ(this->Renderer->GetViewport()[2], 0.5);
  this->View->SetRenderWindow(nullptr);
  EXPECT_EQ(this->Renderer->GetViewport()[2], 1.0);
  EXPECT_FALSE(this->Window->HasRenderer(this->View->GetRenderer(0)));
}

TEST_F(SliceViewTest, TellsValueTissueAndComponent)
{
  vtkNew<vtkHapticHeadUpDisplay> display;
  display->AddTissue("ball", 0.0, 1e9);
  this->View->SetHeadUpDisplay(display);
  this->View->SetUnit("HU");
  this->OpenAndStart();
  // The value is 100 times the depth (mm) below the surface, here in the middle of the ball.
  EXPECT_EQ(this->View->GetText(0), "k = 48\n3000 HU\nball");

  vtkNew<vtkDoubleArray> vectors;
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(this->Ball->GetNumberOfPoints());
  const double vector[3] = { 2.0, -6.0, 3.0 };
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    vectors->SetTuple(i, vector);
  }
  vtkNew<vtkImageData> flow;
  flow->CopyStructure(this->Ball);
  flow->GetPointData()->SetScalars(vectors);
  this->View->SetImage(flow);
  this->Filter->GetProperty()->SetComponent(1);
  EXPECT_EQ(this->View->GetText(0), "k = 48\ncomponent 2 of 3: -6 HU");
  this->Filter->SetMethodToPrimitives();
  EXPECT_EQ(this->View->GetText(0), "k = 48\nmagnitude 7 HU\nball");
}
