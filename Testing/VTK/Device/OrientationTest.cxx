// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the orientation of a stylus on a device with a placement in the world, compared with VTK's
 * quaternions and transforms.
 */

#include "Rigs/RecordingRig.h"

#include <vtkMath.h>
#include <vtkQuaternion.h>
#include <vtkTable.h>
#include <vtkTransform.h>

#include <fstream>
#include <limits>

using namespace devicetest;

namespace
{
constexpr double Nan = std::numeric_limits<double>::quiet_NaN();

vtkQuaterniond TurnAbout(double degrees, double x, double y, double z)
{
  vtkQuaterniond q;
  const double n = std::sqrt(x * x + y * y + z * z);
  q.SetRotationAngleAndAxis(vtkMath::RadiansFromDegrees(degrees), x / n, y / n, z / n);
  return q;
}

class Orientation : public Recording
{
protected:
  /// Sets the device's placement: rotated by `degrees` about this axis, with 900 world units per
  /// metre.
  void PlaceDevice(double degrees, double x, double y, double z)
  {
    vtkNew<vtkTransform> place;
    place->Translate(1.0, -2.0, 3.0);
    place->RotateWXYZ(degrees, x, y, z);
    place->Scale(900.0, 900.0, 900.0);
    this->Device->SetDeviceToWorld(place->GetMatrix());
  }
  void SetOrientation(const vtkQuaterniond& q)
  {
    this->Device->GetVirtualHand()->SetOrientation(q.GetW(), q.GetX(), q.GetY(), q.GetZ());
  }
  vtkQuaterniond GetOrientation()
  {
    return vtkQuaterniond(this->Device->GetState()->GetTipOrientation());
  }
  /// Returns the distance of two rotations; it is 0 for q and -q, which are the same rotation.
  static double Difference(const vtkQuaterniond& a, const vtkQuaterniond& b)
  {
    double dot = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      dot += a[i] * b[i];
    }
    double square = 0.0;
    for (int i = 0; i < 4; ++i)
    {
      const double d = a[i] - (dot < 0.0 ? -b[i] : b[i]);
      square += d * d;
    }
    return std::sqrt(square);
  }
  bool WaitOrientation(const vtkQuaterniond& q)
  {
    return this->Wait(
      [&]
      {
        return this->Device->GetState()->HasTipOrientation() &&
          Difference(this->GetOrientation(), q) < 1e-14;
      });
  }
  static vtkQuaterniond At(vtkPolyData* trace, const char* array, vtkIdType tick)
  {
    vtkQuaterniond q;
    trace->GetPointData()->GetArray(array)->GetTuple(tick, q.GetData());
    return q;
  }
};
} // namespace

TEST_F(Orientation, IsNoneUntilItIsSet)
{
  this->Begin();
  EXPECT_FALSE(this->Device->GetState()->HasTipOrientation());
  EXPECT_EQ(Difference(this->GetOrientation(), vtkQuaterniond(1, 0, 0, 0)), 0.0);
  const vtkQuaterniond turn = TurnAbout(40.0, 1.0, 2.0, -3.0);
  this->SetOrientation(turn);
  ASSERT_TRUE(this->WaitOrientation(turn));
  this->Device->GetVirtualHand()->SetOrientation(0.0, 0.0, 0.0, 0.0);
  ASSERT_TRUE(this->Wait([this] { return !this->Device->GetState()->HasTipOrientation(); }));
  EXPECT_EQ(Difference(this->GetOrientation(), vtkQuaterniond(1, 0, 0, 0)), 0.0);
}

TEST_F(Orientation, TurnsWithTheDevice)
{
  this->PlaceDevice(70.0, 0.3, -1.0, 0.4);
  this->Begin();
  const vtkQuaterniond turn = TurnAbout(110.0, -1.0, 0.5, 2.0);
  this->SetOrientation(turn);
  ASSERT_TRUE(this->WaitOrientation(turn)) << "as it was set, in the world";

  // Change the device's placement while the hand rests.
  this->PlaceDevice(-155.0, 1.0, 0.2, 0.7);
  ASSERT_TRUE(this->Device->Publish());
  const vtkQuaterniond before = TurnAbout(70.0, 0.3, -1.0, 0.4);
  const vtkQuaterniond after = TurnAbout(-155.0, 1.0, 0.2, 0.7);
  EXPECT_TRUE(this->WaitOrientation(after * (before.Conjugated() * turn)));

  // vtkTransform must result in the same axis of the handle.
  vtkNew<vtkTransform> handle;
  handle->RotateWXYZ(-155.0, 1.0, 0.2, 0.7);
  handle->RotateWXYZ(-70.0, 0.3, -1.0, 0.4);
  handle->RotateWXYZ(110.0, -1.0, 0.5, 2.0);
  const double* const wanted = handle->TransformVector(0.0, 0.0, 1.0);
  double matrix[3][3];
  this->GetOrientation().ToMatrix3x3(matrix);
  for (int c = 0; c < 3; ++c)
  {
    EXPECT_NEAR(matrix[c][2], wanted[c], 1e-12);
  }
}

TEST_F(Orientation, IsDividedByItsNorm)
{
  this->Begin();
  const double long4[4] = { 0.0, 30.0, 0.0, -40.0 };
  this->Device->GetVirtualHand()->SetOrientation(long4);
  EXPECT_TRUE(this->WaitOrientation(vtkQuaterniond(0.0, 0.6, 0.0, -0.8)));
}

TEST_F(Orientation, StaysIfItIsSetToNonsense)
{
  this->Begin();
  const vtkQuaterniond turn = TurnAbout(40.0, 1.0, 2.0, -3.0);
  this->SetOrientation(turn);
  ASSERT_TRUE(this->WaitOrientation(turn));
  for (const double bad : { Nan, HUGE_VAL, -HUGE_VAL, 1e300, 1e-300 })
  {
    this->Device->GetVirtualHand()->SetOrientation(0.0, bad, 0.0, 0.0);
    this->ExpectError("quaternion of finite numbers");
  }
  this->Device->GetVirtualHand()->SetOrientation(nullptr);
  this->ExpectError("null pointer");
  ASSERT_TRUE(this->WaitTicks(5));
  EXPECT_LT(Difference(this->GetOrientation(), turn), 1e-14);
  this->Device->Close();
  this->SetOrientation(turn);
  this->ExpectError("Open(\"virtual\") first");
}

TEST_F(Orientation, IsInTheStates)
{
  this->PlaceDevice(70.0, 0.3, -1.0, 0.4);
  this->Begin();
  vtkNew<vtkTable> table;
  this->Device->GetState()->Drain(table);
  ASSERT_TRUE(this->WaitTicks(3));
  const vtkQuaterniond turn = TurnAbout(110.0, -1.0, 0.5, 2.0);
  this->SetOrientation(turn);
  ASSERT_TRUE(this->WaitOrientation(turn));
  this->Device->GetState()->Drain(table);
  auto* const column = vtkDataArray::SafeDownCast(table->GetColumnByName("Orientation"));
  ASSERT_TRUE(column);
  ASSERT_EQ(column->GetNumberOfComponents(), 4);
  const vtkIdType last = column->GetNumberOfTuples() - 1;
  ASSERT_GT(last, 2);
  double q[4];
  column->GetTuple(0, q);
  EXPECT_EQ(vtkQuaterniond(q).SquaredNorm(), 0.0) << "none at first";
  column->GetTuple(last, q);
  EXPECT_LT(Difference(vtkQuaterniond(q), turn), 1e-14);
}

TEST_F(Orientation, IsRecordedAndReplayed)
{
  this->PlaceDevice(70.0, 0.3, -1.0, 0.4);
  this->Begin();
  const std::string table = this->File("Recording.csv");
  for (const std::string& file : { this->Name, table })
  {
    ASSERT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
    this->Wander(5);
    for (int i = 0; i < 10; ++i)
    {
      this->SetOrientation(TurnAbout(17.0 * i, 1.0, -0.1 * i, 0.3));
      this->Wander(2);
    }
    this->Device->GetVirtualHand()->SetOrientation(0.0, 0.0, 0.0, 0.0);
    this->Wander(3);
    if (file == table)
    {
      ASSERT_TRUE(this->Device->GetRecorder()->Stop());
    }
    else
    {
      this->ExpectSame(0.0); // also checks the filter's replay of the recording
      this->Begin();
    }
  }
  this->Device->Close();
  ASSERT_TRUE(this->Filter->GetOutput()->GetPointData()->GetArray("Orientation"));

  const vtkQuaterniond place = TurnAbout(70.0, 0.3, -1.0, 0.4);
  const vtkIdType ticks = this->Recorded->GetNumberOfPoints();
  vtkIdType turned = 0;
  for (vtkIdType i = 0; i < ticks; ++i)
  {
    const vtkQuaterniond world = At(this->Recorded, "Orientation", i);
    const vtkQuaterniond device = At(this->Recorded, "DeviceOrientation", i);
    const bool isTurned = device.SquaredNorm() > 0.0;
    turned += isTurned ? 1 : 0;
    ASSERT_NEAR(device.SquaredNorm(), isTurned ? 1.0 : 0.0, 1e-14) << i;
    ASSERT_NEAR(world.SquaredNorm(), isTurned ? 1.0 : 0.0, 1e-14) << i;
    ASSERT_LT(Difference(world, place * device), 1e-14) << i;
    ASSERT_EQ(Length(this->Recorded->GetPointData()->GetArray("Torque")->GetTuple(i)), 0.0);
  }
  EXPECT_GT(turned, 20);
  EXPECT_LT(turned, ticks - 5);
  EXPECT_EQ(At(this->Recorded, "Orientation", ticks - 1).SquaredNorm(), 0.0);

  // A replay of the .vtp must repeat the orientations bitwise. A .csv has other ticks, so only
  // count its orientations.
  const std::string again = this->File("Again.vtp");
  for (const std::string& file : { this->Name, table })
  {
    ASSERT_TRUE(this->Device->Open(("replay:" + file).c_str()));
    ASSERT_TRUE(this->Device->Start());
    ASSERT_TRUE(this->Device->GetRecorder()->Start(again.c_str()));
    ASSERT_TRUE(this->Wait(
      [this] { return this->Device->GetStatusText().find("end") != std::string::npos; }));
    ASSERT_TRUE(this->Device->GetRecorder()->Stop());
    this->Device->Close();
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(again.c_str());
    reader->Update();
    vtkPolyData* const replayed = reader->GetOutput();
    turned = 0;
    for (vtkIdType i = 0; i < replayed->GetNumberOfPoints(); ++i)
    {
      const auto tick =
        static_cast<vtkIdType>(replayed->GetPointData()->GetArray("Tick")->GetComponent(i, 0));
      const vtkQuaterniond is = At(replayed, "DeviceOrientation", i);
      turned += is.SquaredNorm() > 0.0 ? 1 : 0;
      if (file == this->Name && tick < ticks)
      {
        const vtkQuaterniond was = At(this->Recorded, "DeviceOrientation", tick);
        ASSERT_EQ(std::memcmp(is.GetData(), was.GetData(), 4 * sizeof(double)), 0) << tick;
      }
    }
    EXPECT_GT(turned, 20) << file;
  }
}

TEST_F(Orientation, OfATraceInTheWorldIsReplayed)
{
  // The trace has tips and orientations only in world coordinates, not in the device's space.
  const vtkQuaterniond turn = TurnAbout(110.0, -1.0, 0.5, 2.0);
  const std::string file = this->File("World.csv");
  {
    std::ofstream text(file);
    text.precision(17);
    text << "Tip x,Tip y,Tip z,Orientation w,Orientation x,Orientation y,Orientation z\n";
    for (int i = 0; i < 50; ++i)
    {
      text << "7,7," << 5.0 + 0.01 * i << "," << turn[0] << "," << turn[1] << "," << turn[2] << ","
           << turn[3] << "\n";
    }
  }
  this->PlaceDevice(70.0, 0.3, -1.0, 0.4);
  ASSERT_TRUE(this->Device->Open(("replay:" + file).c_str()));
  ASSERT_TRUE(this->Device->Start());
  EXPECT_TRUE(this->WaitOrientation(turn));
  EXPECT_NEAR(this->Device->GetState()->GetTipPosition()[0], 7.0, 1e-9);
}
