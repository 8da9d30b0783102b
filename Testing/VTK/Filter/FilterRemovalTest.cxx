// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests the removal object: the value of air, the image of its fractions, its files, and errors for
 * unrelated files.
 */

#include "Rigs/ApiRig.h"
#include "Rigs/FullDisk.h"
#include "Rigs/TemporaryFolder.h"

#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkHapticBurr.h>
#include <vtkHapticRemoval.h>
#include <vtkPointData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLImageDataWriter.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>

using namespace apitest;

namespace
{
/// Drills a hole with a burr into a CT of bone (1000 HU) below air (-1000 HU). The extent does not
/// begin at 0.
class FilterRemoval : public ApiTest
{
protected:
  FilterRemoval()
  {
    this->Image =
      MakeImage(32, VTK_SHORT, [](const Point& x) { return x[2] > 11.5 ? 1000.0 : -1000.0; });
    this->Image->SetExtent(-5, 26, 3, 34, 100, 131);
    this->Image->SetOrigin(5.0, -3.0, -100.0);
    this->Filter->SetInputData(this->Image);
    this->Burr->SetRadius(4.0);
    this->Burr->SetSolidToAbove();
    SetConstant(this->Burr->GetSpecificEnergy(), 0.01);
    this->Filter->SetTool(this->Burr);
    this->Path = MakePath(Line({ 15.2, 15.4, 7.0 }, { 15.2, 15.4, 12.0 }, 800));
    this->Filter->SetPathData(this->Path);
  }

  vtkHapticRemoval* Drill()
  {
    vtkPolyData* const trace = this->Run(801);
    EXPECT_TRUE(this->Filter->GetRemoval()->ReadTrace(trace));
    return this->Filter->GetRemoval();
  }
  static std::vector<unsigned char> GetShares(vtkHapticRemoval* removal)
  {
    vtkNew<vtkImageData> image;
    removal->MakeShares(image);
    auto* const array = vtkUnsignedCharArray::SafeDownCast(image->GetPointData()->GetScalars());
    return array ? std::vector<unsigned char>(
                     array->GetPointer(0), array->GetPointer(0) + array->GetNumberOfValues())
                 : std::vector<unsigned char>();
  }
  static std::string ReadAll(const std::string& file)
  {
    std::ifstream stream(file, std::ios::binary);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
  }
  /// Expects that reading the file fails with an error that contains these words, and changes
  /// nothing.
  static void ExpectRefused(
    vtkHapticRemoval* removal, const std::string& file, const std::vector<std::string>& words)
  {
    const auto before = GetShares(removal);
    MessageLog log(removal);
    EXPECT_FALSE(removal->ReadFile(file));
    ASSERT_EQ(log.Errors.size(), 1u);
    for (const std::string& word : words)
    {
      EXPECT_NE(log.Errors[0].find(word), std::string::npos) << log.Errors[0];
    }
    EXPECT_EQ(GetShares(removal), before);
  }

  const std::string File = TemporaryPath("removal.vti");
  vtkNew<vtkHapticBurr> Burr;
};
} // namespace

TEST_F(FilterRemoval, HasTheAirOfTheVolume)
{
  EXPECT_TRUE(this->Filter->GetRemoval()->GetAutoAirValue());
  this->Run(801);
  EXPECT_EQ(this->Filter->GetRemoval()->GetAirValue(), -1000.0);
  this->Filter->GetRemoval()->SetAirValue(-900.0);
  EXPECT_FALSE(this->Filter->GetRemoval()->GetAutoAirValue());
  this->Run(801);
  EXPECT_EQ(this->Filter->GetRemoval()->GetAirValue(), -900.0);
  // If values below the contact value are solid, air is the volume's largest value.
  this->Filter->GetRemoval()->AutoAirValueOn();
  this->Burr->SetSolidToBelow();
  this->Run(801);
  EXPECT_EQ(this->Filter->GetRemoval()->GetAirValue(), 1000.0);
}

/// Reads a removal into a filter that never had a burr, and touches the hole with the point. The
/// file contains the value of air.
TEST_F(FilterRemoval, AFileIsFeltWithoutABurr)
{
  this->Filter->GetRemoval()->SetAirValue(-800.0);
  ASSERT_TRUE(this->Drill()->WriteFile(this->File));
  this->Filter->SetTool(nullptr);
  this->Filter->SetMethodToForceField(); // keeps the proxy at the tip
  this->Path = MakePath(Line({ 15.2, 15.4, 7.0 }, { 15.2, 15.4, 15.0 }, 80));
  this->Filter->SetPathData(this->Path);
  const vtkSmartPointer<vtkPolyData> felt = (this->Run(81), Keep(this->Filter));
  EXPECT_EQ(Get(felt, "Value", 40), -800.0) << "in the hole, at z = 11";
  EXPECT_LT(Get(felt, "Value", 52), 0.0) << "at z = 12.2, which was bone";
  vtkNew<vtkVolumeHapticsFilter> other;
  other->GetProperty()->DeepCopy(this->Property);
  other->SetMethodToForceField();
  other->SetInputData(this->Image);
  other->SetPathData(this->Path);
  ASSERT_TRUE(other->GetRemoval()->ReadFile(this->File));
  other->Update();
  EXPECT_TRUE(IsSame(felt, other->GetOutput()));
  std::remove(this->File.c_str());
}

TEST_F(FilterRemoval, IsAnImageOfTheVolumesShape)
{
  vtkNew<vtkImageData> image;
  this->Filter->GetRemoval()->MakeShares(image);
  EXPECT_EQ(image->GetPointData()->GetScalars(), nullptr) << "no burr has ticked";
  this->Drill()->MakeShares(image);
  for (int i = 0; i < 6; ++i)
  {
    EXPECT_EQ(image->GetExtent()[i], this->Image->GetExtent()[i]);
    EXPECT_EQ(image->GetBounds()[i], this->Image->GetBounds()[i]);
  }
  // The hole is where the burr was: at (15.2, 15.4) in the world, behind the surface at z = 11.5.
  auto* const array = image->GetPointData()->GetScalars();
  EXPECT_EQ(array->GetRange()[1], 255.0);
  EXPECT_EQ(array->GetComponent(image->FindPoint(15.2, 15.4, 13.0), 0), 0.0);
  EXPECT_EQ(array->GetComponent(image->FindPoint(15.2, 15.4, 25.0), 0), 255.0);
  EXPECT_EQ(array->GetComponent(image->FindPoint(3.0, 15.4, 13.0), 0), 255.0);
}

TEST_F(FilterRemoval, IsWrittenAndReadToTheByte)
{
  vtkHapticRemoval* const removal = this->Drill();
  const auto shares = GetShares(removal);
  ASSERT_TRUE(removal->WriteFile(this->File));
  EXPECT_LT(ReadAll(this->File).size(), 8000u) << "only the part that was drilled, compressed";
  vtkNew<vtkHapticRemoval> other;
  ASSERT_TRUE(other->ReadFile(this->File));
  EXPECT_EQ(GetShares(other), shares);
  EXPECT_EQ(other->GetNumberOfUndos(), 0);
  // The removal that was read must have the same forces as the written one.
  const vtkSmartPointer<vtkPolyData> felt = (this->Run(801), Keep(this->Filter));
  this->Filter->SetRemoval(other);
  this->Filter->Update();
  EXPECT_TRUE(IsSame(felt, this->Filter->GetOutput()));
  // A volume with another extent must be refused, and the removal must keep its contents.
  this->Image->SetExtent(0, 31, 0, 31, 0, 31);
  this->Image->SetOrigin(0.5, 0.0, 0.0);
  this->Image->Modified();
  this->ExpectError({ "-5 to 26", "0 to 31", "WriteFile()", "SetRemoval(nullptr)" });
  EXPECT_FALSE(other->IsEmpty());
  this->Filter->SetRemoval(nullptr);
  this->Run(801);
  std::remove(this->File.c_str());
}

/// The removal must be at the same place in volumes that are cropped or padded, even if their
/// indices begin elsewhere. Afterwards, the whole volume must have the whole removal again.
TEST_F(FilterRemoval, AFileIsFeltOnPartsOfItsVolume)
{
  ASSERT_TRUE(this->Drill()->WriteFile(this->File));
  vtkNew<vtkHapticRemoval> removal;
  ASSERT_TRUE(removal->ReadFile(this->File));
  const auto whole = GetShares(removal);
  vtkNew<vtkImageData> before;
  removal->MakeShares(before);
  this->Filter->SetRemoval(removal);
  this->Filter->SetTool(nullptr);
  const struct
  {
    int Extent[6];
    double Origin[3];
  } parts[] = {
    { { 7, 26, 10, 30, 103, 120 }, { 5.0, -3.0, -100.0 } }, // a part, cropped through the hole
    // the same part with indices that begin at 0
    { { 0, 19, 0, 20, 0, 17 }, { 12.0, 7.0, 3.0 } },
    // another part with the same extent as the last one
    { { 0, 19, 0, 20, 0, 17 }, { 9.0, 6.0, 1.0 } },
    { { -14, 40, 0, 50, 90, 140 }, { 5.0, -3.0, -100.0 } }, // padded
    { { -5, 3, 3, 11, 100, 104 }, { 5.0, -3.0, -100.0 } },  // beside the hole
    { { -5, 26, 3, 34, 100, 131 }, { 5.0, -3.0, -100.0 } }, // the whole volume again
  };
  for (const auto& part : parts)
  {
    vtkNew<vtkImageData> image;
    image->SetExtent(const_cast<int*>(part.Extent));
    image->SetOrigin(part.Origin);
    image->AllocateScalars(VTK_SHORT, 1);
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      const double z = image->GetPoint(i)[2];
      image->GetPointData()->GetScalars()->SetTuple1(i, z > 11.5 ? 1000.0 : -1000.0);
    }
    this->Filter->SetInputData(image);
    double middle[3];
    image->GetCenter(middle);
    this->Path = MakePath(
      Line({ middle[0], middle[1], middle[2] - 1.0 }, { middle[0], middle[1], middle[2] }, 10));
    this->Filter->SetPathData(this->Path);
    this->Run(11);
    vtkNew<vtkImageData> shares;
    removal->MakeShares(shares);
    ASSERT_EQ(shares->GetNumberOfPoints(), image->GetNumberOfPoints());
    vtkIdType carved = 0;
    for (vtkIdType i = 0; i < shares->GetNumberOfPoints(); ++i)
    {
      // Compare samples at the same position in the world, although their indices differ.
      double place[3];
      before->TransformPhysicalPointToContinuousIndex(image->GetPoint(i), place);
      int index[3];
      bool isThere = true;
      for (int a = 0; a < 3; ++a)
      {
        index[a] = static_cast<int>(std::lround(place[a]));
        isThere = isThere && index[a] >= before->GetExtent()[2 * a] &&
          index[a] <= before->GetExtent()[2 * a + 1];
      }
      const double wanted =
        isThere ? before->GetScalarComponentAsDouble(index[0], index[1], index[2], 0) : 255.0;
      const double found = shares->GetPointData()->GetScalars()->GetTuple1(i);
      ASSERT_EQ(found, wanted) << i;
      carved += found < 255.0;
    }
    EXPECT_EQ(carved > 0, part.Extent[1] != 3) << part.Extent[1];
  }
  EXPECT_EQ(GetShares(removal), whole);
  std::remove(this->File.c_str());
}

TEST_F(FilterRemoval, ADamagedFileChangesNothing)
{
  vtkHapticRemoval* const removal = this->Drill();
  ASSERT_TRUE(removal->WriteFile(this->File));
  const std::string whole = ReadAll(this->File);
  for (const double share : { 0.0, 0.2, 0.6, 0.9, 0.99 })
  {
    std::ofstream(this->File, std::ios::binary)
      << whole.substr(0, static_cast<std::size_t>(share * static_cast<double>(whole.size())));
    ExpectRefused(removal, this->File, { this->File, "WriteFile" });
  }
  ExpectRefused(removal, "/no/such/file.vti", { "/no/such/file.vti" });
  ExpectRefused(removal, "/dev", { "/dev" });
  // The file contains another image, which has no fractions.
  vtkNew<vtkXMLImageDataWriter> writer;
  writer->SetFileName(this->File.c_str());
  writer->SetInputData(this->Image);
  writer->Write();
  ExpectRefused(removal, this->File, { "no shares" });
  // The extent of the volume in this file is too small for the fractions.
  std::ofstream(this->File, std::ios::binary) << whole;
  vtkNew<vtkXMLImageDataReader> reader;
  reader->SetFileName(this->File.c_str());
  reader->Update();
  vtkNew<vtkImageData> moved;
  moved->ShallowCopy(reader->GetOutput());
  vtkDataArray* const extent = moved->GetFieldData()->GetArray("VolumeExtent");
  ASSERT_TRUE(extent);
  extent->SetComponent(0, 1, moved->GetExtent()[1] - 1);
  writer->SetInputData(moved);
  writer->Write();
  ExpectRefused(removal, this->File, { "no shares" });
  std::remove(this->File.c_str());
}

TEST_F(FilterRemoval, AFullDiskIsToldAndKeepsTheOldFile)
{
  vtkHapticRemoval* const removal = this->Drill();
  ASSERT_TRUE(removal->WriteFile(this->File));
  const std::string before = ReadAll(this->File);
  ASSERT_GT(before.size(), 1000u);
  // Drill elsewhere, so that the next file differs from the old one.
  this->Path = MakePath(Line({ 9.2, 20.4, 7.0 }, { 9.2, 20.4, 12.0 }, 800));
  this->Filter->SetPathData(this->Path);
  this->Drill();
  MessageLog log(removal);
  for (const rlim_t bytes : { rlim_t{ 0 }, rlim_t{ 500 }, rlim_t{ before.size() / 2 } })
  {
    log.Errors.clear();
    {
      const devicetest::FullDisk full(bytes);
      EXPECT_FALSE(removal->WriteFile(this->File)) << bytes;
    }
    ASSERT_EQ(log.Errors.size(), 1u);
    EXPECT_NE(log.Errors[0].find(this->File), std::string::npos) << log.Errors[0];
    EXPECT_EQ(ReadAll(this->File), before) << bytes;
  }
  EXPECT_TRUE(removal->WriteFile(this->File));
  EXPECT_NE(ReadAll(this->File), before);
  log.Errors.clear();
  EXPECT_FALSE(removal->WriteFile("/dev/full"));
  ASSERT_EQ(log.Errors.size(), 1u);
  EXPECT_NE(log.Errors[0].find("/dev/full"), std::string::npos);
  log.Errors.clear();
  EXPECT_FALSE(removal->WriteFile("/no/such/folder/a.vti"));
  ASSERT_EQ(log.Errors.size(), 1u);
}

TEST_F(FilterRemoval, ItsErrorsNameTheCure)
{
  vtkNew<vtkHapticRemoval> removal;
  MessageLog log(removal);
  EXPECT_FALSE(removal->WriteFile(this->File));
  EXPECT_FALSE(removal->ReadTrace(nullptr));
  EXPECT_FALSE(removal->Undo());
  EXPECT_FALSE(removal->Redo());
  EXPECT_FALSE(removal->Reset());
  ASSERT_EQ(log.Errors.size(), 2u);
  EXPECT_NE(log.Errors[0].find("vtkHapticBurr"), std::string::npos);
  EXPECT_NE(log.Errors[1].find("Update()"), std::string::npos);
  vtkPolyData* const trace = this->Run(801);
  MessageLog own(this->Filter->GetRemoval());
  vtkNew<vtkPolyData> changed;
  changed->DeepCopy(trace);
  vtkDataArray* const places = changed->GetFieldData()->GetArray("FinalBricks");
  ASSERT_TRUE(places && places->GetNumberOfTuples() > 1);
  places->SetComponent(1, 0, -1.0);
  EXPECT_FALSE(this->Filter->GetRemoval()->ReadTrace(changed));
  places->SetTuple(1, places->GetTuple(0));
  EXPECT_FALSE(this->Filter->GetRemoval()->ReadTrace(changed));
  changed->GetFieldData()->RemoveArray("FinalShares");
  EXPECT_FALSE(this->Filter->GetRemoval()->ReadTrace(changed));
  changed->GetFieldData()->RemoveArray("FinalBricks");
  EXPECT_FALSE(this->Filter->GetRemoval()->ReadTrace(changed));
  ASSERT_EQ(own.Errors.size(), 4u);
  EXPECT_NE(own.Errors[0].find("tuple 1"), std::string::npos);
  EXPECT_NE(own.Errors[2].find("FinalShares"), std::string::npos);
  EXPECT_TRUE(this->Filter->GetRemoval()->IsEmpty());
}

TEST_F(FilterRemoval, ResetBringsTissueBackWithoutAServo)
{
  vtkHapticRemoval* const removal = this->Drill();
  const auto whole = std::vector<unsigned char>(GetShares(removal).size(), 255);
  EXPECT_NE(GetShares(removal), whole);
  EXPECT_TRUE(removal->Reset());
  EXPECT_EQ(removal->GetNumberOfRequests(), 0);
  EXPECT_EQ(GetShares(removal), whole);
  EXPECT_TRUE(removal->IsEmpty());
  EXPECT_FALSE(removal->Reset()) << "there is nothing to bring back";
}
