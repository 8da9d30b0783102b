// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests recordings with changed numbers. Each must cause either one error that describes the fault,
 * or a trace with finite forces within the filter's MaximumForce. A replay must always end.
 */

#include "Rigs/RecordingRig.h"

#include <vtkDoubleArray.h>
#include <vtkExecutive.h>

#include <iterator>
#include <limits>
#include <random>
#include <unistd.h>

using namespace devicetest;

namespace
{
constexpr double NaN = std::numeric_limits<double>::quiet_NaN();
constexpr double Inf = std::numeric_limits<double>::infinity();
constexpr double Most = std::numeric_limits<double>::max();
constexpr double TwoTo53 = 9007199254740992.0;
constexpr double MaximumForce = 3.0;

const double Numbers[] = { NaN, Inf, Most, TwoTo53, -TwoTo53, 1e9, 1e6, 1000.0, 5.0, -1.0, 0.5, 0.0,
  1e-3 };

class Tampered : public Recording
{
protected:
  Tampered()
  {
    this->Filter->SetMaximumForce(MaximumForce);
    this->Filter->SetIsoValue(700.0);
  }
  /// Records a wandering hand that begins in contact. The device's placement changes during the
  /// recording.
  vtkSmartPointer<vtkPolyData> Record()
  {
    const std::string file = this->File(("Tampered" + std::to_string(getpid()) + ".vtp").c_str());
    this->Begin();
    this->Wander(20);
    EXPECT_TRUE(this->Device->GetRecorder()->Start(file.c_str()));
    this->Wander(4);
    this->Turn(10.0, 0.4);
    this->Wander(4);
    EXPECT_TRUE(this->Device->GetRecorder()->Stop());
    this->Device->Close();
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    unlink(file.c_str());
    return reader->GetOutput();
  }
  /// Replays a recording. Returns true if the filter refused the recording.
  bool Replay(vtkPolyData* recording)
  {
    this->FilterLog.Errors.clear();
    this->Filter->SetInputData(1, recording);
    this->Filter->Update();
    if (!this->FilterLog.Errors.empty())
    {
      EXPECT_EQ(this->FilterLog.Errors.size(), 1U);
      EXPECT_NE(this->FilterLog.Errors[0].find("ecord"), std::string::npos)
        << this->FilterLog.Errors[0];
      return true;
    }
    vtkPolyData* const trace = this->Filter->GetOutput();
    EXPECT_EQ(trace->GetNumberOfPoints(), recording->GetNumberOfPoints());
    for (int a = 0; a < trace->GetPointData()->GetNumberOfArrays(); ++a)
    {
      vtkDataArray* const array = trace->GetPointData()->GetArray(a);
      vtkIdType odd = 0;
      for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i)
      {
        for (int c = 0; c < array->GetNumberOfComponents(); ++c)
        {
          odd += std::isfinite(array->GetComponent(i, c)) ? 0 : 1;
        }
      }
      EXPECT_EQ(odd, 0) << array->GetName() << " is not finite";
    }
    vtkDataArray* const force = trace->GetPointData()->GetArray("Force");
    for (vtkIdType i = 0; force && i < force->GetNumberOfTuples(); ++i)
    {
      EXPECT_LE(Length(force->GetTuple(i)), MaximumForce * (1.0 + 1e-9));
    }
    return false;
  }
  /// Replaces each number of the array's first tuples by each of the extreme numbers, and replays
  /// the recording.
  void ChangeEach(vtkPolyData* recording, const char* name, vtkIdType tuples)
  {
    vtkNew<vtkPolyData> other;
    other->DeepCopy(recording);
    vtkDataArray* array = other->GetFieldData()->GetArray(name);
    array = array ? array : other->GetPointData()->GetArray(name);
    ASSERT_TRUE(array) << name;
    int refused = 0;
    for (vtkIdType i = 0; i < std::min(tuples, array->GetNumberOfTuples()); ++i)
    {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c)
      {
        for (const double number : Numbers)
        {
          SCOPED_TRACE(std::string(name) + " " + std::to_string(i) + " " + std::to_string(c) + " " +
            std::to_string(number));
          const double before = array->GetComponent(i, c);
          array->SetComponent(i, c, number);
          array->Modified();
          other->Modified();
          refused += this->Replay(other) ? 1 : 0;
          array->SetComponent(i, c, before);
        }
      }
    }
    EXPECT_GT(refused, 0) << name;
  }
  /// Replaces six numbers of the first state at once by extreme numbers, mostly by those that are
  /// accepted individually, and replays the recording.
  void ChangeMany(vtkPolyData* recording)
  {
    std::mt19937 random(3);
    const auto draw = [&random](std::size_t size)
    { return static_cast<int>(random() % static_cast<std::mt19937::result_type>(size)); };
    for (int i = 0; i < 100; ++i)
    {
      SCOPED_TRACE(i);
      vtkNew<vtkPolyData> other;
      other->DeepCopy(recording);
      vtkDataArray* const state = other->GetFieldData()->GetArray("InitialState");
      for (int change = 0; change < 6; ++change)
      {
        constexpr std::size_t firstThatPasses = 5;
        const int number = firstThatPasses + draw(std::size(Numbers) - firstThatPasses);
        state->SetComponent(0, draw(state->GetNumberOfComponents()), Numbers[number]);
      }
      this->Replay(other);
    }
  }
  /// Scales the device's placement. Every uniform scale is valid, even an absurd one.
  void ChangeSize(vtkPolyData* recording)
  {
    for (const double factor :
      { 1e-300, 1e-60, 1e-20, 1e-12, 1e-9, 1e-6, 1e-3, 1e3, 1e6, 1e9, 1e12, 1e20, 1e60, 1e90 })
    {
      SCOPED_TRACE(factor);
      vtkNew<vtkPolyData> other;
      other->DeepCopy(recording);
      vtkDataArray* const matrices = other->GetFieldData()->GetArray("DeviceToWorld");
      for (const int c : { 0, 1, 2, 4, 5, 6, 8, 9, 10 })
      {
        matrices->SetComponent(1, c, factor * matrices->GetComponent(1, c));
      }
      this->Replay(other);
    }
  }
  void ChangeAll()
  {
    const auto recording = this->Record();
    const MessageLog executive(this->Filter->GetExecutive());
    ASSERT_FALSE(this->Replay(recording));
    this->ChangeSize(recording);
    this->ChangeMany(recording);
    for (const char* const name : { "InitialState", "DeviceToWorld", "TickPeriod", "Caps",
           "DeviceTip", "Placement", "Time", "Enabled", "Renewed" })
    {
      this->ChangeEach(recording, name, 2);
    }
  }
};
} // namespace

TEST_F(Tampered, OfPrecise)
{
  this->ChangeAll();
}

TEST_F(Tampered, OfPaper)
{
  this->Filter->SetSolverToPaper();
  this->ChangeAll();
}

TEST_F(Tampered, OfAForceField)
{
  this->Filter->SetMethodToForceField();
  this->Filter->SetForceFieldGain(0.01);
  this->Filter->SetForceFieldDamping(2.0);
  this->ChangeAll();
}

TEST_F(Tampered, OfASurfaceProxy)
{
  this->Filter->SetMethodToSurfaceProxy();
  this->ChangeAll();
}

TEST_F(Tampered, OfALocalSurface)
{
  this->Filter->SetMethodToLocalSurface();
  this->Filter->SetLocalSurfaceShapeToQuadric();
  this->ChangeAll();
}

TEST_F(Tampered, SaysWhichArray)
{
  const auto recording = this->Record();
  const MessageLog executive(this->Filter->GetExecutive());
  const auto expect = [this](vtkPolyData* other, const std::vector<std::string>& words)
  {
    EXPECT_TRUE(this->Replay(other)) << words[0];
    for (const std::string& word : words)
    {
      EXPECT_NE(this->FilterLog.Errors.at(0).find(word), std::string::npos)
        << word << " in " << this->FilterLog.Errors[0];
    }
  };
  for (const char* const name : { "Enabled", "Renewed", "Placement", "Time" })
  {
    vtkNew<vtkPolyData> other;
    other->DeepCopy(recording);
    other->GetPointData()->RemoveArray(name);
    expect(other, { name, "is missing", "Record again" });
    vtkNew<vtkDoubleArray> shorter;
    shorter->SetName(name);
    shorter->InsertNextValue(0.0);
    other->GetPointData()->AddArray(shorter);
    expect(other, { name, "1 tuples of 1 component(s) instead of" });
  }
  for (const char* const name : { "InitialState", "DeviceToWorld", "TickPeriod", "Caps" })
  {
    vtkNew<vtkPolyData> other;
    other->DeepCopy(recording);
    other->GetFieldData()->RemoveArray(name);
    expect(other, { name, "is missing" });
    vtkNew<vtkDoubleArray> other3;
    other3->SetName(name);
    other3->SetNumberOfComponents(3);
    other3->InsertNextTuple3(1.0, 2.0, 3.0);
    other->GetFieldData()->AddArray(other3);
    expect(other, { name, "1 tuples of 3 component(s) instead of" });
  }
  vtkNew<vtkPolyData> other;
  other->DeepCopy(recording);
  other->GetFieldData()->GetArray("DeviceToWorld")->SetComponent(1, 0, 1.0);
  expect(other, { "DeviceToWorld", "one uniform, positive scale", "tuple 1" });
}
