// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests that an unusable label image causes one error, which names the input and the remedy. */

#include "Rigs/ApiRig.h"

#include <vtkHapticLabelTable.h>
#include <vtkIntArray.h>
#include <vtkPointData.h>

#include <cmath>

using namespace apitest;

namespace
{
class BadLabelsTest : public ApiTest
{
protected:
  BadLabelsTest() { this->Filter->SetLabelData(this->Labels); }

  vtkSmartPointer<vtkImageData> Labels =
    MakeImage(8, VTK_FLOAT, [](const Point& p) { return p[0]; });
};
} // namespace

TEST_F(BadLabelsTest, WholeNumbersAreLabels)
{
  this->Run(51);
}

TEST_F(BadLabelsTest, FractionsAreNone)
{
  this->Labels->SetScalarComponentFromDouble(3, 4, 5, 0, 0.5);
  this->ExpectError({ "label image on input port 3", "Density", "0.5", "(3, 4, 5)", "whole" });
}

TEST_F(BadLabelsTest, NorAreNumbersThatAreNotFinite)
{
  for (const double value : { std::nan(""), HUGE_VAL, -HUGE_VAL, 1e30 })
  {
    this->Labels->SetScalarComponentFromDouble(7, 7, 7, 0, value);
    this->Labels->Modified();
    this->ExpectError({ "label image on input port 3", "(7, 7, 7)" });
    this->Log.Errors.clear();
    this->ExecutiveLog.Errors.clear();
  }
}

TEST_F(BadLabelsTest, AnEmptyImageHasNone)
{
  vtkNew<vtkImageData> empty;
  vtkNew<vtkIntArray> array;
  empty->GetPointData()->SetScalars(array);
  this->Filter->SetLabelData(empty);
  this->ExpectError({ "label image on input port 3", "empty" });
}

TEST_F(BadLabelsTest, NorDoesAnImageWithoutScalars)
{
  vtkNew<vtkImageData> bare;
  bare->SetDimensions(4, 4, 4);
  this->Filter->SetLabelData(bare);
  this->ExpectError({ "label image on input port 3", "SetInputArrayToProcess(1, 3, 0" });
}

TEST_F(BadLabelsTest, AVectorIsNoLabel)
{
  vtkNew<vtkImageData> colours;
  colours->SetDimensions(4, 4, 4);
  colours->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  this->Filter->SetLabelData(colours);
  this->ExpectError({ "label image on input port 3", "3 components", "vtkImageExtractComponents" });
}

TEST_F(BadLabelsTest, AGeometryMustBeOne)
{
  this->Labels->SetSpacing(1.0, 0.0, 1.0);
  this->ExpectError({ "spacing of the label image on input port 3", "SetSpacing" });
}

TEST_F(BadLabelsTest, ADirectionMustSpanSpace)
{
  this->Labels->SetDirectionMatrix(1, 0, 0, 1, 0, 0, 0, 0, 1);
  this->ExpectError({ "direction matrix of the label image on input port 3", "singular" });
}

TEST_F(BadLabelsTest, GeometryNeedsLabels)
{
  this->Filter->SetLabelData(nullptr);
  this->Filter->SetGeometryFromLabels();
  this->ExpectError({ "no label image", "port 3", "SetGeometryFromScalars" });
}

TEST_F(BadLabelsTest, AThinImageIsFelt)
{
  // The image is one voxel thin, which is valid for labels because they need no gradient. It is far
  // from the path.
  vtkNew<vtkImageData> thin;
  thin->SetDimensions(1, 4, 4);
  thin->SetOrigin(1e6, 0.0, 0.0);
  thin->AllocateScalars(VTK_SHORT, 1);
  thin->GetPointData()->GetScalars()->Fill(1.0);
  this->Filter->SetLabelData(thin);
  vtkNew<vtkHapticLabelTable> table;
  table->SetStiffness(1, 7.0);
  this->Filter->SetLabelTable(table);
  EXPECT_EQ(Get(this->Run(51), "Stiffness", 50), 500.0);
}
