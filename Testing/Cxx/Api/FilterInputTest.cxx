// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Which samples are touched, and that they are touched where they lie: nothing is copied, nothing is
 * changed, and nothing is freed under way.
 */

#include "ApiRig.h"

#include <vtkDoubleArray.h>
#include <vtkFloatArray.h>
#include <vtkPointData.h>

#include <cstring>

using namespace apitest;

namespace
{
class FilterInput : public ApiTest
{
protected:
  vtkDataArray* Scalars() { return this->Image->GetPointData()->GetScalars(); }

  /// Calls back at every progress event of the next update.
  void OnProgress(const std::function<void()>& f)
  {
    this->Callback = f;
    this->Command->SetClientData(&this->Callback);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* callback, void*)
      { (*static_cast<std::function<void()>*>(callback))(); });
    this->Filter->AddObserver(vtkCommand::ProgressEvent, this->Command);
  }

  /// A tip at rest for so long that there are progress events under way.
  void Rest() { this->Filter->SetPathData(MakePath(std::vector<Point>(5000, { 7, 7, 7 }))); }

  std::function<void()> Callback;
  vtkNew<vtkCallbackCommand> Command;
};
} // namespace

TEST_F(FilterInput, ArrayByName)
{
  vtkNew<vtkFloatArray> other;
  other->SetName("Other");
  other->SetNumberOfTuples(this->Image->GetNumberOfPoints());
  other->Fill(-5.0);
  this->Image->GetPointData()->AddArray(other);
  EXPECT_EQ(Get(this->Run(51), "Value", 0), 500.0);
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Other");
  EXPECT_EQ(Get(this->Run(51), "Value", 0), -5.0);
  this->Filter->SetInputArrayToProcess(0, 0, 0, vtkDataObject::FIELD_ASSOCIATION_POINTS, "Density");
  EXPECT_EQ(Get(this->Run(51), "Value", 0), 500.0);
}

TEST_F(FilterInput, ComponentOfTheProperty)
{
  vtkNew<vtkDoubleArray> vectors;
  vectors->SetName("Vectors");
  vectors->SetNumberOfComponents(3);
  vectors->SetNumberOfTuples(this->Image->GetNumberOfPoints());
  for (vtkIdType i = 0; i < vectors->GetNumberOfTuples(); ++i)
  {
    vectors->SetTuple3(i, 1.0, this->Scalars()->GetComponent(i, 0), -2.0);
  }
  this->Image->GetPointData()->SetScalars(vectors);
  const double expected[] = { 1.0, 500.0, -2.0 };
  for (int c = 0; c < 3; ++c)
  {
    this->Property->SetComponent(c);
    EXPECT_EQ(Get(this->Run(51), "Value", 0), expected[c]);
  }
}

TEST_F(FilterInput, InPlaceEditsAreFelt)
{
  this->Run(51);
  this->Scalars()->Fill(42.0);
  this->Scalars()->Modified();
  EXPECT_EQ(Get(this->Run(51), "Value", 0), 42.0);
}

TEST_F(FilterInput, SamplesAreNotCopied)
{
  this->Rest();
  // A copy would not know of what is written while the filter runs.
  this->OnProgress([&] { this->Scalars()->Fill(42.0); });
  vtkPolyData* const output = this->Run(5000);
  EXPECT_EQ(Get(output, "Value", 4999), 42.0);
}

TEST_F(FilterInput, SamplesOutliveTheirImageWhileTheFilterRuns)
{
  this->Rest();
  bool deleted = false;
  bool deletedUnderWay = false;
  vtkNew<vtkCallbackCommand> onDelete;
  onDelete->SetClientData(&deleted);
  onDelete->SetCallback(
    [](vtkObject*, unsigned long, void* flag, void*) { *static_cast<bool*>(flag) = true; });
  this->Scalars()->AddObserver(vtkCommand::DeleteEvent, onDelete);
  double progress = 0.0;
  this->OnProgress(
    [&]
    {
      this->Image->GetPointData()->SetScalars(nullptr);
      progress = this->Filter->GetProgress();
      deletedUnderWay = deletedUnderWay || (deleted && progress < 1.0);
    });
  vtkPolyData* const output = this->Run(5000);
  EXPECT_FALSE(deletedUnderWay);
  EXPECT_TRUE(deleted) << "and the filter keeps no reference afterwards";
  EXPECT_EQ(Get(output, "Value", 4999), 700.0);
}

TEST_F(FilterInput, InputsAreLeftAlone)
{
  vtkNew<vtkImageData> before;
  before->DeepCopy(this->Image);
  const vtkMTimeType times[] = { this->Image->GetMTime(), this->Path->GetMTime() };
  const int references = this->Scalars()->GetReferenceCount();
  this->Run(51);
  EXPECT_EQ(this->Image->GetMTime(), times[0]);
  EXPECT_EQ(this->Path->GetMTime(), times[1]);
  EXPECT_EQ(this->Scalars()->GetReferenceCount(), references);
  EXPECT_EQ(std::memcmp(this->Scalars()->GetVoidPointer(0),
              before->GetPointData()->GetScalars()->GetVoidPointer(0), 16 * 16 * 16 * 8),
    0);
}
