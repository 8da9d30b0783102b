// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a thousand changes of images, functions, methods, kernels and placements, while the servo
 * runs at 5 kHz and is recorded.
 */

#include "Rigs/RecordingRig.h"

using namespace devicetest;

namespace
{
class Stress : public Recording
{
protected:
  void Change(int i)
  {
    vtkHapticProperty* const property = this->Filter->GetProperty();
    switch (i % 5)
    {
      case 0:
        this->Filter->SetInputData(0, MakeRamp()); // deletes the earlier image
        break;
      case 1:
        SetConstant(property->GetStiffness(), 200.0 + 10.0 * (i % 30));
        break;
      case 2:
        this->Filter->SetIsoValue(700.0);
        this->Filter->SetMethod(i / 5 % 4);
        break;
      case 3:
        this->Filter->SetGradientEstimator(i % 3);
        this->Filter->SetKernelRadius(1 + i % 2);
        break;
      default:
        this->Turn(i, 0.2 * std::sin(i));
        return;
    }
    ASSERT_TRUE(this->Device->Publish());
  }
};
} // namespace

TEST_F(Stress, AThousandChangesLeaveWholeStates)
{
  this->Filter->SetForceFieldGain(0.01);
  this->Device->SetServoRate(5000.0);
  this->Begin();
  this->Device->Arm();
  this->StartRecording();
  vtkIdType last = -1;
  double largest = 0.0;
  for (int i = 0; i < 1000; ++i)
  {
    const double t = 0.05 * i;
    this->Device->GetVirtualHand()->SetPosition(
      7.0 + 2.0 * std::sin(t), 7.0, 8.0 + 2.5 * std::sin(1.3 * t));
    this->Change(i);
    ASSERT_TRUE(this->Wait([&] { return this->Device->GetState()->GetTick() > last; }));
    last = this->Device->GetState()->GetTick();
    largest = std::max(largest, Length(this->Device->GetState()->GetForce()));
  }
  EXPECT_GT(largest, 0.2);
  ASSERT_TRUE(this->Device->GetRecorder()->Stop());
  this->Device->Stop();
  EXPECT_TRUE(this->Log.Errors.empty());

  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(this->Name.c_str());
  reader->Update();
  vtkPolyData* const trace = reader->GetOutput();
  vtkPointData* const data = trace->GetPointData();
  vtkDataArray* const tick = data->GetArray("Tick");
  const auto metersPerUnit = [&](vtkIdType i)
  {
    vtkDataArray* const matrices = trace->GetFieldData()->GetArray("DeviceToWorld");
    const double* m =
      matrices->GetTuple(static_cast<vtkIdType>(data->GetArray("Placement")->GetComponent(i, 0)));
    return 1.0 / std::sqrt(m[0] * m[0] + m[4] * m[4] + m[8] * m[8]);
  };
  vtkIdType springs = 0;
  for (vtkIdType i = 0; i < trace->GetNumberOfPoints(); ++i)
  {
    if (i > 0)
    {
      ASSERT_EQ(tick->GetComponent(i, 0), tick->GetComponent(i - 1, 0) + 1.0);
    }
    // A mixture of two ticks or two models would have a force that does not match its own spring.
    const double k = data->GetArray("Stiffness")->GetComponent(i, 0);
    double stretch[3];
    double force[3];
    data->GetArray("Tip")->GetTuple(i, stretch);
    data->GetArray("Force")->GetTuple(i, force);
    double proxy[3];
    trace->GetPoint(i, proxy);
    for (int c = 0; c < 3 && k > 0.0; ++c)
    {
      ASSERT_NEAR(force[c], k * (proxy[c] - stretch[c]) * metersPerUnit(i), 1e-9) << "tick " << i;
    }
    springs += k > 0.0 && Length(force) > 0.1 ? 1 : 0;
  }
  EXPECT_GT(springs, 100);
}
