// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests a table of labels in the field data of an image and of its file. The comment in
 * vtkHapticLabelTable.h defines the names and meanings of the arrays.
 */

#include "LabelFilesRig.h"

#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkLongLongArray.h>
#include <vtkStringArray.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>

#include <limits>

using namespace labeltest;

namespace
{
template <typename Array, typename Value>
void Add(vtkFieldData* data, const char* name, const std::vector<Value>& values)
{
  vtkNew<Array> array;
  array->SetName(name);
  for (const Value& value : values)
  {
    array->InsertNextValue(value);
  }
  data->AddArray(array);
}

vtkSmartPointer<vtkFieldData> Labels(const std::vector<long long>& labels)
{
  const auto data = vtkSmartPointer<vtkFieldData>::New();
  Add<vtkLongLongArray>(data, "Label", labels);
  return data;
}

class LabelFieldData : public LabelFiles
{
protected:
  void RefuseData(vtkFieldData* data, const std::vector<std::string>& words)
  {
    const vtkMTimeType before = this->Table->GetMTime();
    EXPECT_FALSE(this->Table->ReadFieldData(data));
    ASSERT_EQ(this->Log.Errors.size(), 1u);
    for (const std::string& word : words)
    {
      EXPECT_NE(this->Log.Errors[0].find(word), std::string::npos) << this->Log.Errors[0];
    }
    this->Log.Errors.clear();
    EXPECT_EQ(this->Table->GetMTime(), before);
  }
};
} // namespace

TEST_F(LabelFieldData, HasItsNames)
{
  this->Table->SetLabelName(5, "H\xC3\xB6hle");
  this->Table->SetColor(5, 0.1, 0.2, 0.3);
  this->Table->SetSurfaceStrength(5, 1.5);
  this->Table->SetSpecificEnergy(5, 12.5);
  this->Table->SetForbidden(-3, true);
  this->Table->SetStandOff(2.5);
  vtkNew<vtkFieldData> data;
  this->Table->WriteFieldData(data);
  EXPECT_EQ(data->GetArray("Label")->GetTuple1(0), -3.0);
  EXPECT_EQ(data->GetArray("Label")->GetTuple1(1), 5.0);
  EXPECT_EQ(
    vtkStringArray::SafeDownCast(data->GetAbstractArray("LabelName"))->GetValue(1), "H\xC3\xB6hle");
  EXPECT_EQ(data->GetArray("LabelColor")->GetTuple3(0)[2], -1.0);
  EXPECT_EQ(data->GetArray("LabelColor")->GetTuple3(1)[2], 0.3);
  EXPECT_EQ(data->GetArray("LabelSurfaceStrength")->GetTuple1(1), 1.5);
  for (const char* const name : { "LabelStiffness", "LabelFriction", "LabelViscosity" })
  {
    EXPECT_EQ(data->GetArray(name)->GetTuple1(1), -1.0) << name;
  }
  EXPECT_EQ(data->GetArray("LabelForbidden")->GetTuple1(0), 1.0);
  EXPECT_EQ(data->GetArray("LabelFelt")->GetTuple1(0), -1.0);
  EXPECT_EQ(data->GetArray("LabelStandOff")->GetTuple1(0), 2.5);
  EXPECT_EQ(data->GetArray("LabelSpecificEnergy")->GetTuple1(1), 12.5);
  EXPECT_EQ(data->GetArray("LabelSpecificEnergy")->GetTuple1(0), -1.0);
  EXPECT_EQ(data->GetNumberOfArrays(), 12);
  // Writing again must not add any array twice.
  this->Table->WriteFieldData(data);
  EXPECT_EQ(data->GetNumberOfArrays(), 12);
}

TEST_F(LabelFieldData, GoesThroughAFile)
{
  this->Table->SetLabelName(5, "H\xC3\xB6hle");
  this->Table->SetColor(5, 0.1, 0.2, 0.3);
  this->Table->SetStiffness(5, 300.1);
  this->Table->SetFriction(5, 0.3);
  this->Table->SetViscosity(2, 0.4);
  this->Table->SetShaftFriction(2, 25.5);
  this->Table->SetSpecificEnergy(5, 12.1);
  this->Table->SetFelt(2, false);
  this->Table->SetForbidden(-3, true);
  this->Table->SetStandOff(2.5);
  const auto image = apitest::MakeRamp(3);
  this->Table->WriteFieldData(image->GetFieldData());
  for (const int mode : { vtkXMLWriter::Ascii, vtkXMLWriter::Binary, vtkXMLWriter::Appended })
  {
    const std::string file = TemporaryPath("Labels.vti");
    vtkNew<vtkXMLImageDataWriter> writer;
    writer->SetDataMode(mode);
    writer->SetInputData(image);
    writer->SetFileName(file.c_str());
    ASSERT_EQ(writer->Write(), 1);
    vtkNew<vtkHapticLabelTable> read;
    ASSERT_TRUE(read->ReadFile(file.c_str())) << mode;
    const vtkMTimeType before = read->GetMTime();
    read->DeepCopy(this->Table);
    EXPECT_EQ(read->GetMTime(), before) << mode;

    // A truncated file must be refused.
    std::ifstream in(file, std::ios::binary);
    std::ostringstream bytes;
    bytes << in.rdbuf();
    this->Refuse(bytes.str().substr(0, 300), {}, "Half.vti");
    this->Table->RemoveLabel(77);
  }
}

TEST_F(LabelFieldData, OfAnImageWithoutATable)
{
  vtkNew<vtkXMLImageDataWriter> writer;
  const std::string file = TemporaryPath("Plain.vti");
  writer->SetInputData(apitest::MakeRamp(3));
  writer->SetFileName(file.c_str());
  ASSERT_EQ(writer->Write(), 1);
  this->RefuseFile(file, { "no array \"Label\"", "WriteFieldData" });
}

TEST_F(LabelFieldData, MadeByOthers)
{
  const auto data = Labels({ 7, -8 });
  Add<vtkFloatArray, float>(data, "LabelStiffness", { 2.5F, std::nanf("") });
  Add<vtkUnsignedCharArray, unsigned char>(data, "LabelFelt", { 0, 1 });
  this->Table->SetStiffness(-8, 4.0);
  ASSERT_TRUE(this->Table->ReadFieldData(data));
  EXPECT_EQ(this->Table->GetStiffness(7), 2.5);
  EXPECT_EQ(this->Table->GetStiffness(-8), 4.0);
  EXPECT_FALSE(this->Table->GetFelt(7));
}

TEST_F(LabelFieldData, ThatCannotBeRead)
{
  this->RefuseData(nullptr, { "no array \"Label\"" });
  this->RefuseData(Labels({ 1LL << 40 }), { "\"Label\"", "1099511627776", "out of range" });
  auto data = Labels({ 1, 2 });
  Add<vtkDoubleArray, double>(data, "LabelFriction", { 1.0 });
  this->RefuseData(data, { "LabelFriction", "1 tuples", "2 labels" });
  data = Labels({ 1, 2 });
  Add<vtkDoubleArray, double>(data, "LabelFriction", { 1.0, -0.5 });
  this->RefuseData(data, { "LabelFriction", "tuple 1", "0 or more" });
  data = Labels({ 1 });
  Add<vtkDoubleArray, double>(data, "LabelColor", { 1.0 });
  this->RefuseData(data, { "LabelColor", "of 1", "one of 3" });
  data = Labels({ 1, 2 });
  Add<vtkStringArray, std::string>(data, "LabelName", { "a" });
  this->RefuseData(data, { "LabelName", "2 labels" });
  data = Labels({ 1 });
  Add<vtkDoubleArray, double>(data, "LabelStandOff", { -2.0 });
  this->RefuseData(data, { "LabelStandOff", "0 or more" });
  this->Table->WriteFieldData(nullptr);
  EXPECT_EQ(this->Log.Errors.size(), 1u);
}
