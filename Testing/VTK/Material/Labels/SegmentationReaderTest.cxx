// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests segmentation files according to 3D Slicer's documentation "Segmentation labelmap file
 * format (.seg.nrrd)" and Teem's definition of NRRD (teem.sourceforge.net/nrrd/format.html). The
 * test computes samples and positions independently, voxel by voxel.
 */

#include "LabelFilesRig.h"

#include "VTK/Material/Labels/SegmentationFile.h"

#include <vtkHapticLabelTable.h>
#include <vtkImageData.h>
#include <vtkPointData.h>

#include <algorithm>
#include <random>

using namespace labeltest;

namespace
{
constexpr int Size[3] = { 4, 3, 2 };
constexpr int Voxels = 24;

struct Type
{
  const char* Name;
  int Bytes;
  bool IsBig;
  bool IsGzip;
};

std::ostream& operator<<(std::ostream& os, const Type& type)
{
  return os << type.Name << (type.IsBig ? ", big" : "") << (type.IsGzip ? ", gzip" : "");
}

const Type Types[] = { { "signed char", 1, false, false }, { "uchar", 1, false, true },
  { "short", 2, false, true }, { "uint16", 2, true, false }, { "int", 4, true, true },
  { "unsigned int", 4, false, false }, { "int64_t", 8, true, true },
  { "unsigned long long", 8, false, false } };

/// Packs integers in two's complement, in the file's byte order.
std::string Pack(const std::vector<long long>& values, const Type& type)
{
  std::string bytes;
  for (const long long value : values)
  {
    std::string one;
    for (int b = 0; b < type.Bytes; ++b)
    {
      one += static_cast<char>(static_cast<unsigned long long>(value) >> (8 * b));
    }
    if (type.IsBig)
    {
      std::reverse(one.begin(), one.end());
    }
    bytes += one;
  }
  return type.IsGzip ? Compress(bytes) : bytes;
}

std::string Head(const Type& type, const std::string& geometry, const std::string& fields)
{
  return std::string("NRRD0004\n# Complete NRRD file format specification at:\ntype: ") +
    type.Name + "\n" + geometry + "endian: " + (type.IsBig ? "big" : "little") +
    "\nencoding: " + (type.IsGzip ? "gzip" : "raw") + "\n" + fields + "\n";
}

const std::string Plain = "dimension: 3\nspace: left-posterior-superior\nsizes: 4 3 2\n"
                          "space directions: (0.5,0,0) (0,0,2) (0,-3,0)\n"
                          "kinds: domain domain domain\nspace origin: (10,-20,30.5)\n";
const Type Small = { "uchar", 1, false, true };
const std::string Names = "Segment0_LabelValue:=1\nSegment0_Layer:=0\nSegment0_Name:=head\n"
                          "Segment0_Color:=1 0 0.5\n"
                          "Segment1_LabelValue:=2\nSegment1_Layer:=0\nSegment1_Name:=neck\n"
                          "Segment2_LabelValue:=1\nSegment2_Layer:=1\nSegment2_Name:=mass\n";

class SegmentationReader : public testing::Test
{
protected:
  std::string ReadFile()
  {
    return VolumeHaptics::ReadSegmentation(this->File, this->Image, this->Table);
  }
  vtkImageData* Read(const std::string& bytes)
  {
    Write(this->File, bytes);
    EXPECT_EQ(this->ReadFile(), "");
    return this->Image;
  }
  void Refuse(const std::string& bytes, const std::vector<std::string>& words)
  {
    Write(this->File, bytes);
    const std::string error = this->ReadFile();
    ASSERT_NE(error, "") << bytes.substr(0, 300);
    EXPECT_NE(error.find(this->File), std::string::npos);
    for (const std::string& word : words)
    {
      EXPECT_NE(error.find(word), std::string::npos) << error << "\nlacks: " << word;
    }
    EXPECT_EQ(this->Image->GetNumberOfPoints(), 0);
  }
  static std::vector<long long> LabelsOf(vtkImageData* image)
  {
    std::vector<long long> labels;
    for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
    {
      labels.push_back(static_cast<long long>(image->GetPointData()->GetScalars()->GetTuple1(i)));
    }
    return labels;
  }

  const std::string File = TemporaryPath("Segmentation.seg.nrrd");
  vtkNew<vtkImageData> Image;
  vtkNew<vtkHapticLabelTable> Table;
};

class SegmentationReaderType
  : public SegmentationReader
  , public testing::WithParamInterface<Type>
{
};
} // namespace

TEST_P(SegmentationReaderType, ReadsEveryVoxel)
{
  const bool isSigned = std::string(this->GetParam().Name).find('u') == std::string::npos;
  std::mt19937 random(5);
  std::vector<long long> values(Voxels);
  for (long long& value : values)
  {
    const int most = std::min(this->GetParam().Bytes * 8 - 1, 30);
    value = static_cast<long long>(random() & ((1U << most) - 1));
    value = isSigned && random() % 2 ? -value : value;
  }
  // Values without a segment must also be labels.
  vtkImageData* const image =
    this->Read(Head(this->GetParam(), Plain, "") + Pack(values, this->GetParam()));
  EXPECT_EQ(LabelsOf(image), values);
  EXPECT_STREQ(image->GetPointData()->GetScalars()->GetName(), "Labels");
}

INSTANTIATE_TEST_SUITE_P(All, SegmentationReaderType, testing::ValuesIn(Types));

TEST_F(SegmentationReader, PlacesEveryVoxel)
{
  const std::string samples = Pack(std::vector<long long>(Voxels, 1), Small);
  struct Space
  {
    const char* Name;
    double X;
    double Y;
  };
  for (const Space& space : { Space{ "left-posterior-superior", 1, 1 }, Space{ "LPS", 1, 1 },
         Space{ "right-anterior-superior", -1, -1 }, Space{ "RAS", -1, -1 },
         Space{ "left-anterior-superior", 1, -1 } })
  {
    SCOPED_TRACE(space.Name);
    std::string geometry = Plain;
    geometry.replace(geometry.find("left-posterior"), 23, space.Name);
    vtkImageData* const image = this->Read(Head(Small, geometry, "") + samples);
    for (int k = 0; k < Size[2]; ++k)
    {
      for (int j = 0; j < Size[1]; ++j)
      {
        for (int i = 0; i < Size[0]; ++i)
        {
          const int index[3] = { i, j, k };
          double position[3];
          image->TransformIndexToPhysicalPoint(index, position);
          EXPECT_NEAR(position[0], space.X * (10 + 0.5 * i), 1e-12);
          EXPECT_NEAR(position[1], space.Y * (-20 - 3.0 * k), 1e-12);
          EXPECT_NEAR(position[2], 30.5 + 2.0 * j, 1e-12);
        }
      }
    }
  }
  vtkImageData* const image =
    this->Read(Head(Small, "dimension: 3\nsizes: 4 3 2\nspacings: 1 2.5 nan\n", "") + samples);
  EXPECT_EQ(image->GetSpacing()[1], 2.5);
  EXPECT_EQ(image->GetSpacing()[2], 1.0);
}

TEST_F(SegmentationReader, HasNamesAndColors)
{
  std::vector<long long> values(Voxels, 0);
  values[3] = 4;
  this->Table->SetStiffness(4, 300.0);
  Write(this->File,
    Head(Small, Plain, "Segment0_LabelValue:=4\nSegment0_Name:=liver\nSegment0_Color:=1 0 0.5\n") +
      Pack(values, Small));
  EXPECT_EQ(this->ReadFile(), "");
  vtkHapticLabelTable* const table = this->Table;
  EXPECT_EQ(table->GetLabelName(4), "liver");
  EXPECT_EQ(table->GetColor(4)[2], 0.5);
  EXPECT_EQ(table->GetStiffness(4), 300.0);
}

TEST_F(SegmentationReader, TheLastOfOverlappingSegmentsHolds)
{
  std::mt19937 random(9);
  for (const int listAxis : { 0, 1, 2, 3 })
  {
    SCOPED_TRACE(listAxis);
    constexpr int layers = 2;
    std::vector<std::array<long long, layers>> values(Voxels);
    std::vector<long long> expected(Voxels, 0);
    for (int v = 0; v < Voxels; ++v)
    {
      values[v] = { static_cast<long long>(random() % 4), static_cast<long long>(random() % 2) };
      // The segments are head (1), neck (2) and mass (3). The value 3 in the first layer belongs to
      // no segment.
      expected[v] = values[v][1] == 1 ? 3 : values[v][0] < 3 ? values[v][0] : 0;
    }
    // Writes the samples in the order of the file, whose first axis is the fastest.
    std::vector<int> sizes = { Size[0], Size[1], Size[2] };
    sizes.insert(sizes.begin() + listAxis, layers);
    std::vector<long long> samples;
    std::string text;
    std::string directions;
    int axis = 0;
    for (int a = 0; a < 4; ++a)
    {
      text += " " + std::to_string(sizes[a]);
      const char* const vectors[] = { " (1,0,0)", " (0, 1, 0)", " (0,0,1)" };
      directions += a == listAxis ? " none" : vectors[axis++];
    }
    for (int position = 0; position < Voxels * layers; ++position)
    {
      int rest = position;
      int index[4];
      for (int a = 0; a < 4; ++a)
      {
        index[a] = rest % sizes[a];
        rest /= sizes[a];
      }
      std::vector<int> place(index, index + 4);
      const int layer = place[listAxis];
      place.erase(place.begin() + listAxis);
      samples.push_back(values[place[0] + Size[0] * (place[1] + Size[1] * place[2])][layer]);
    }
    const std::string geometry = "dimension: 4\nspace: left-posterior-superior\nsizes:" + text +
      "\nspace directions:" + directions + "\nspace origin: (0,0,0)\n";
    vtkImageData* const image = this->Read(Head(Small, geometry, Names) + Pack(samples, Small));
    EXPECT_EQ(LabelsOf(image), expected);
    EXPECT_EQ(this->Table->GetLabelName(3), "mass");
    EXPECT_EQ(this->Table->GetNumberOfLabels(), 3);
  }
}

TEST_F(SegmentationReader, FilesThatCannotBeRead)
{
  const std::string samples = Pack(std::vector<long long>(Voxels, 1), Small);
  const auto head = [](const std::string& from, const std::string& to)
  {
    std::string text = Head(Small, Plain, Names);
    return text.replace(text.find(from), from.size(), to);
  };
  this->Refuse("label,name\n1,a\n", { "no NRRD file", ".seg.nrrd" });
  this->Refuse(head("uchar", "float") + samples, { "\"float\"", "whole numbers", "3D Slicer" });
  this->Refuse(head("gzip", "bzip2") + samples, { "\"bzip2\"", "raw or gzip" });
  this->Refuse(head("gzip", "ascii") + samples, { "\"ascii\"", "raw or gzip" });
  this->Refuse(head("kinds:", "data file: x.raw\nkinds:") + samples, { "another file" });
  this->Refuse(head("kinds:", "byte skip: 7\nkinds:") + samples, { "byte skip" });
  for (const char* const bad : { "4 3", "4 3 2 2", "4 -3 2", "0 3 2", "4 x 2", "99999 99999 99999",
         "4 3 2 1 1", "2147483647 2147483647 2147483647" })
  {
    this->Refuse(head("4 3 2", bad) + samples, { "sizes", bad });
  }
  this->Refuse(head("4 3 2", "4000 3000 2000") + samples, { "fewer samples", "complete" });
  this->Refuse(head("4 3 2", "40 30 2") + samples, { "fewer samples", "complete" });
  for (const char* const bad : { "(1,0,0) (0,1,0) (1,1,0)", "(1,0,0) (0,1,0)", "(1,0,0) (0,1,0) 5",
         "(1,0,0) (0,1,0) (0,0,0)", "(1,0,0) (0,1,0) (0,1)", "(1,0,0) (0,1,0) (0,0,1,0)" })
  {
    this->Refuse(head("(0.5,0,0) (0,0,2) (0,-3,0)", bad) + samples, { "space directions", bad });
  }
  this->Refuse(head("(10,-20,30.5)", "(1,2)") + samples, { "space origin", "(1,2)" });
  this->Refuse(
    head("Segment0_Name", "Segmentation_SourceRepresentation:=Fractional labelmap\nX") + samples,
    { "fractional" });
  const std::string good = Head(Small, Plain, Names) + samples;
  this->Refuse(good.substr(0, good.size() - 12), { "fewer samples", "complete" });
  this->Refuse(good.substr(0, 60), { "no end", "complete" });
  // The samples are complete, but their checksum and length (the last 8 bytes, RFC 1952) are
  // truncated or wrong.
  for (const std::size_t lost : { 1, 4, 8 })
  {
    this->Refuse(good.substr(0, good.size() - lost), { "Check that the file is complete" });
  }
  std::string other = good;
  other[good.size() - 8] = static_cast<char>(other[good.size() - 8] ^ 1);
  this->Refuse(other, { "Check that the file is complete" });
  const Type wide = { "int64", 8, false, false };
  this->Refuse(Head(wide, Plain, "") + Pack(std::vector<long long>(Voxels, 1LL << 33), wide),
    { "8589934592", "out of range" });

  const std::string missing =
    VolumeHaptics::ReadSegmentation("/no/such/file.seg.nrrd", this->Image, this->Table);
  EXPECT_NE(missing.find("does not exist"), std::string::npos) << missing;
  // After all these errors, the reader must still read the valid file.
  EXPECT_EQ(this->Read(good)->GetNumberOfPoints(), Voxels);
}
