// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Records a session, and compares the recording with the filter's replay. */
#ifndef RecordingRig_h
#define RecordingRig_h

#include "DeviceRig.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkPointData.h>
#include <vtkXMLPolyDataReader.h>

#include <cstring>

namespace devicetest
{
class Recording : public DeviceTest
{
protected:
  Recording()
  {
    SetConstant(this->Filter->GetProperty()->GetFriction(), 0.3);
    SetConstant(this->Filter->GetProperty()->GetViscosity(), 0.2);
  }
  void StartRecording() { ASSERT_TRUE(this->Device->GetRecorder()->Start(this->Name.c_str())); }
  void Wander(int steps)
  {
    for (int i = 0; i < steps; ++i)
    {
      const double t = 0.05 * this->Steps++;
      this->Device->GetVirtualHand()->SetPosition(
        7.0 + 3.0 * std::sin(t), 7.0 + 2.0 * std::sin(0.7 * t), 8.0 + 2.5 * std::sin(1.3 * t));
      ASSERT_TRUE(this->WaitTicks(4));
    }
  }
  void Turn(double degrees, double shift)
  {
    const double a = degrees * 0.017453292519943295;
    vtkNew<vtkMatrix4x4> m;
    const double rows[16] = { 900 * std::cos(a), -900 * std::sin(a), 0, shift, 900 * std::sin(a),
      900 * std::cos(a), 0, -shift, 0, 0, 900, 0.5 * shift, 0, 0, 0, 1 };
    m->DeepCopy(rows);
    this->Device->SetDeviceToWorld(m);
    ASSERT_TRUE(this->Device->Publish());
  }
  /// Stops the recording. Expects the filter's replay of the recording to be identical.
  void ExpectSame(double leastForce = 0.5)
  {
    ASSERT_TRUE(this->Device->GetRecorder()->Stop());
    this->Device->Stop();
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(this->Name.c_str());
    reader->Update();
    vtkPolyData* const recorded = reader->GetOutput();
    ASSERT_GT(recorded->GetNumberOfPoints(), 20);
    this->Filter->SetInputData(1, recorded);
    this->Filter->Update();
    vtkPolyData* const replayed = this->Filter->GetOutput();
    ASSERT_EQ(replayed->GetNumberOfPoints(), recorded->GetNumberOfPoints());
    double largest = 0.0;
    for (int a = 0; a < replayed->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* const here = replayed->GetPointData()->GetArray(a);
      vtkDataArray* const there = recorded->GetPointData()->GetArray(here->GetName());
      const std::string name = here->GetName();
      if (name == "Label" || name == "Depth" || name == "ShaftForce" ||
        name == "ForbiddenTouches" || name.compare(0, 10, "ModeForce_") == 0)
      {
        continue; // skips this array, which each replay recomputes
      }
      ASSERT_TRUE(there) << here->GetName();
      vtkIdType different = 0;
      for (vtkIdType i = 0; i < here->GetNumberOfValues(); ++i)
      {
        const double x = here->GetVariantValue(i).ToDouble();
        const double y = there->GetVariantValue(i).ToDouble();
        different += std::memcmp(&x, &y, sizeof(x)) ? 1 : 0;
      }
      EXPECT_EQ(different, 0) << here->GetName();
    }
    vtkDataArray* const force = recorded->GetPointData()->GetArray("Force");
    for (vtkIdType i = 0; i < force->GetNumberOfTuples(); ++i)
    {
      largest = std::max(largest, Length(force->GetTuple(i)));
    }
    EXPECT_GT(largest, leastForce) << "nothing was touched";
    this->Recorded = recorded;
  }

  const std::string Name = this->File("Recording.vtp");
  vtkSmartPointer<vtkPolyData> Recorded;
  int Steps = 0;
};
} // namespace devicetest

#endif
