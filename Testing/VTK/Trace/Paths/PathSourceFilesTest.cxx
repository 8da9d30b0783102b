// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Tests paths from files, and settings that result in no path. */

#include "Rigs/ApiRig.h"
#include "Rigs/TemporaryFolder.h"

#include <vtkExecutive.h>
#include <vtkHapticPathSource.h>
#include <vtkPointData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <fstream>

using namespace apitest;

namespace
{
class PathSourceFiles : public testing::Test
{
protected:
  const std::string Csv = TemporaryPath("path-source.csv");
  const std::string Vtp = TemporaryPath("path-source.vtp");
  void WriteCsv(const std::string& text) { std::ofstream(this->Csv) << text; }
  vtkPolyData* Read(const char* file)
  {
    this->Source->SetShapeToFromFile();
    this->Source->SetFileName(file);
    this->Source->Modified();
    this->Source->Update();
    return this->Source->GetOutput();
  }
  void ExpectError(const std::vector<std::string>& words)
  {
    MessageLog log(this->Source);
    MessageLog executiveLog(this->Source->GetExecutive());
    this->Source->Modified();
    this->Source->Update();
    ASSERT_EQ(log.Errors.size(), 1u);
    for (const std::string& word : words)
    {
      EXPECT_NE(log.Errors[0].find(word), std::string::npos)
        << word << " is not in " << log.Errors[0];
    }
    EXPECT_EQ(this->Source->GetOutput()->GetNumberOfPoints(), 0);
  }

  vtkNew<vtkHapticPathSource> Source;
};
} // namespace

TEST_F(PathSourceFiles, TablesHaveTheirPositionsUnderAnyOfThreeTitles)
{
  for (const char* const head :
    { "x,y,z", "Points:0,Points:1,Points:2", "Tip x (world),Tip y (world),Tip z (world)" })
  {
    // The last line is not terminated.
    this->WriteCsv(std::string("Time (s),") + head + "\n0.5,1,2,3\n0.75,4,5,6");
    vtkPolyData* const path = this->Read(this->Csv.c_str());
    ASSERT_EQ(path->GetNumberOfPoints(), 2) << head;
    EXPECT_EQ(path->GetPoint(1)[2], 6.0);
    EXPECT_EQ(Get(path, "Time", 1), 0.75);
    EXPECT_EQ(path->GetNumberOfCells(), 1);
  }
  this->WriteCsv("x,y,z\n1,2,3\n4,5,6\n");
  EXPECT_EQ(this->Read(this->Csv.c_str())->GetPointData()->GetNumberOfArrays(), 0);
}

TEST_F(PathSourceFiles, PolyDataComeAsTheyAre)
{
  vtkNew<vtkXMLPolyDataWriter> writer;
  const auto path = MakePath(Line({ 7, 7, 5 }, { 7, 7, 10 }, 50), std::vector<double>(51, 0.25));
  writer->SetInputData(path);
  writer->SetFileName(this->Vtp.c_str());
  ASSERT_TRUE(writer->Write());
  EXPECT_TRUE(IsSame(this->Read(this->Vtp.c_str()), path));
}

TEST_F(PathSourceFiles, FilesThatAreNoPathAreNamed)
{
  this->Source->SetShapeToFromFile();
  this->ExpectError({ "path file", "no name", "FileName" });
  this->Source->SetFileName("nowhere.csv");
  this->ExpectError({ "nowhere.csv", "does not exist", "FileName" });
  this->Source->SetFileName("path.txt");
  this->ExpectError({ "path.txt", ".vtp", ".csv" });
  this->Source->SetFileName(this->Csv);
  this->WriteCsv("a,b\n1,2\n");
  this->ExpectError({ "path-source.csv", "no tip positions", "\"x\"" });
  this->WriteCsv("x,y,z\n1,2,3\n1,2,nan\n");
  this->ExpectError({ "path-source.csv", "NaN", "tick 1" });
  this->WriteCsv("Time,x,y,z\n1,1,2,3\n0,1,2,4\n");
  this->ExpectError({ "path-source.csv", "backwards", "tick 1" });
}

/// The settings specify the recording's labels. Without them, a recording would be replayed with
/// any labels, so unreadable settings must cause an error.
TEST_F(PathSourceFiles, SettingsBesideARecordingThatAreNoJsonAreNamed)
{
  this->WriteCsv("x,y,z\n1,2,3\n4,5,6\n");
  this->Source->SetShapeToFromFile();
  this->Source->SetFileName(this->Csv);
  const std::string file = this->Csv + ".json";
  std::ofstream(file) << "{ \"Settings\": " << std::string(70, '[') << std::string(70, ']') << " }";
  this->ExpectError({ "path-source.csv.json", "nested more than 64 deep", "remove it" });
  std::ofstream(file) << "{ \"Settings\": ";
  this->ExpectError({ "path-source.csv.json", "not JSON" });
  std::ofstream(file) << "{ \"Settings\": \"Method: PROXY\" }";
  EXPECT_EQ(this->Read(this->Csv.c_str())->GetNumberOfPoints(), 2);
  std::remove(file.c_str());
}

TEST_F(PathSourceFiles, SettingsThatMakeNoPathAreNamed)
{
  this->Source->SetPoint2(-50, 0, 0);
  this->ExpectError({ "Point1 and Point2", "Move" });
  this->Source->SetPoint2(std::nan(""), 0, 0);
  this->ExpectError({ "Point2", "not finite" });
  this->Source->SetPoint2(50, 0, 0);
  this->Source->SetSpeed(0.0);
  this->ExpectError({ "Speed", "more than 0" });
  this->Source->SetSpeed(1e-6);
  this->ExpectError({ "1e8 points", "Raise Speed" });
  this->Source->SetSpeed(100.0);
  this->Source->SetShapeToCircle();
  this->Source->SetRadius(-1.0);
  this->ExpectError({ "Radius" });
  this->Source->SetRadius(1.0);
  this->Source->SetTurns(0.0);
  this->ExpectError({ "Turns" });
  this->Source->SetTurns(1.0);
  this->Source->SetNormal(0, 0, 0);
  this->ExpectError({ "Normal" });
  this->Source->SetShapeToPressAndSlide();
  this->Source->SetBoxBounds(1, 0, 0, 1, 0, 1);
  this->ExpectError({ "BoxSize" });
  this->Source->SetBoxBounds(0, 1, 0, 1, 0, 1);
  this->Source->SetDepth(-1.0);
  this->ExpectError({ "Depth" });
}
