// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests that reading a file of measurements reproduces the list, and that errors state why a file
 * can't be read.
 */

#include "MeasureRig.h"

#include <vtkCellData.h>
#include <vtkPlaneSource.h>

#include <locale>

using namespace measuretest;

namespace
{
/// German numbers, with a decimal comma and points between thousands.
struct GermanNumbers : std::numpunct<char>
{
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Adds a measurement of each kind, with numbers that need all digits and names that need quotes.
void Fill(vtkHapticMeasurements* list)
{
  using M = vtkHapticMeasurements;
  const Point a = { 1.0 / 3.0, -82.0, 1e-17 };
  const Point b = { 31.4, std::sqrt(2.0), 12345.678 };
  const Point c = { -7.0, 8.0, 9.0 };
  list->AddPoint(a.data(), "Nasion, \"upper\"");
  list->AddMeasurement(M::POINT, MakeFelt({ b }),
    "Gr\xC3\xBC\xC3\x9F"
    "e; \xE5\xB7\xA6");
  list->AddDistance(a.data(), b.data());
  list->AddMeasurement(M::ANGLE, MakeFelt({ a, b, c }), " blanks ");
  list->AddMeasurement(M::PATH, MakeFelt(Line(a, c, 50)));
  list->AddPoint(c.data());
  vtkNew<vtkPlaneSource> plane;
  plane->SetResolution(3, 2);
  plane->Update();
  list->AddMeasurement(M::AREA, plane->GetOutput());
  list->AddMeasurement(M::PATH, MakeFelt({ c }), "a path of one point");
}

class MeasurementFiles : public MeasureTest
{
protected:
  void ExpectRoundTrip(const std::string& file)
  {
    SCOPED_TRACE(file);
    Fill(this->List);
    ASSERT_TRUE(this->List->WriteFile(file.c_str()));
    vtkNew<vtkHapticMeasurements> read;
    read->SetMetersPerWorldUnit(this->List->GetMetersPerWorldUnit());
    read->SetCoordinateSystem(this->List->GetCoordinateSystem());
    ASSERT_TRUE(read->ReadFile(file.c_str()));
    ExpectSame(this->List, read);
    this->List->RemoveAll();
  }
  void Refuse(const std::string& name, const std::string& text, std::vector<std::string> words)
  {
    SCOPED_TRACE(text);
    const std::string file = WriteTextFile(name, text);
    const double x[3] = { 1.0, 2.0, 3.0 };
    this->List->RemoveAll();
    this->List->AddPoint(x, "kept");
    EXPECT_FALSE(this->List->ReadFile(file.c_str()));
    words.push_back(file);
    this->ExpectError(words);
    ASSERT_EQ(this->List->GetNumberOfMeasurements(), 1);
    EXPECT_EQ(this->List->GetName(0), "kept");
  }
};
} // namespace

TEST_F(MeasurementFiles, ComeBackToTheBit)
{
  for (const char* const name : { "All.csv", "All.vtp", "All.mrk.json" })
  {
    this->ExpectRoundTrip(File(name));
    this->List->SetCoordinateSystemToRAS();
    this->List->SetMetersPerWorldUnit(1e-6);
    this->ExpectRoundTrip(File(name));
    this->List->SetCoordinateSystemToLPS();
    this->List->SetMetersPerWorldUnit(1e-3);
  }
}

/// Planned measurements, which no hand has touched, have only positions: no force, value or time.
TEST_F(MeasurementFiles, OfPositionsAloneComeBack)
{
  for (const char* const name : { "Plan.csv", "Plan.vtp", "Plan.mrk.json" })
  {
    SCOPED_TRACE(name);
    const double a[3] = { 1.0, 2.0, 3.0 };
    const double b[3] = { 4.0, 5.0, 7.0 };
    this->List->AddDistance(a, b);
    ASSERT_TRUE(this->List->WriteFile(File(name).c_str()));
    vtkNew<vtkHapticMeasurements> read;
    ASSERT_TRUE(read->ReadFile(File(name).c_str()));
    ExpectSame(this->List, read);
    this->List->RemoveAll();
  }
}

TEST_F(MeasurementFiles, DoNotDependOnTheLocale)
{
  const std::locale before = std::locale::global(std::locale(std::locale(), new GermanNumbers));
  for (const char* const name : { "German.csv", "German.vtp", "German.mrk.json" })
  {
    this->ExpectRoundTrip(File(name));
  }
  std::locale::global(before);
}

TEST_F(MeasurementFiles, WithCellsWhosePointsAreNotThereAreRefused)
{
  vtkNew<vtkPolyData> damaged;
  Fill(this->List);
  this->List->CopyToPolyData(damaged);
  for (const vtkIdType id : { vtkIdType{ 999999 }, vtkIdType{ -1 } })
  {
    vtkNew<vtkCellArray> lines;
    lines->DeepCopy(damaged->GetLines());
    lines->InsertNextCell({ 0, id });
    vtkNew<vtkPolyData> read;
    read->ShallowCopy(damaged);
    read->SetLines(lines);
    EXPECT_FALSE(this->List->ReadPolyData(read));
    this->ExpectError({ "points are not there" });
  }
  damaged->SetPoints(nullptr);
  EXPECT_FALSE(this->List->ReadPolyData(damaged));
  this->ExpectError({ "points are not there" });
}

TEST_F(MeasurementFiles, OfNothingAreReadAsNothing)
{
  for (const char* const name : { "Empty.csv", "Empty.vtp", "Empty.mrk.json" })
  {
    ASSERT_TRUE(this->List->WriteFile(File(name).c_str())) << name;
    Fill(this->List);
    ASSERT_TRUE(this->List->ReadFile(File(name).c_str())) << name;
    EXPECT_EQ(this->List->GetNumberOfMeasurements(), 0);
    EXPECT_TRUE(this->List->Undo()) << "reading is a change like others";
    EXPECT_EQ(this->List->GetNumberOfMeasurements(), 8);
    this->List->RemoveAll();
  }
}

TEST_F(MeasurementFiles, ATableNeedsOnlyPositions)
{
  // This table comes from a German spreadsheet.
  const std::string file = WriteTextFile("Points.csv",
    "Name;X (mm);Y (mm);Z (mm)\r\n"
    "Apex;1,5;-2;3\r\n\r\n;4;5;6,25\r\n");
  ASSERT_TRUE(this->List->ReadFile(file.c_str()));
  ASSERT_EQ(this->List->GetNumberOfMeasurements(), 2);
  EXPECT_EQ(this->List->GetName(0), "Apex");
  EXPECT_EQ(this->List->GetName(1), "Point 1");
  double x[3];
  this->List->GetPoint(1, 0, x);
  EXPECT_EQ(x[2], 6.25);
  EXPECT_EQ(this->List->GetKind(1), vtkHapticMeasurements::POINT);
}

TEST_F(MeasurementFiles, ATableSaysWhatIsMeasured)
{
  const double a[3] = { 0.0, 0.0, 0.0 };
  const double b[3] = { 3.0, 4.0, 0.0 };
  this->List->AddDistance(a, b, "across");
  ASSERT_TRUE(this->List->WriteFile(File("Table.csv").c_str()));
  std::ifstream stream(File("Table.csv"));
  std::string titles;
  std::string first;
  std::string second;
  std::getline(stream, titles);
  std::getline(stream, first);
  std::getline(stream, second);
  EXPECT_EQ(titles.rfind("measurement,name,kind,value,unit,point,x,y,z,", 0), 0u) << titles;
  EXPECT_EQ(first, "1,across,Distance,5,mm,0,0,0,0,,,,,");
  EXPECT_EQ(second, "1,across,Distance,5,mm,1,3,4,0,,,,,");
}

TEST_F(MeasurementFiles, ThatCannotBeReadSayWhy)
{
  this->Refuse("Bad.csv", "a,b\n1,2\n", { "x, y and z" });
  this->Refuse("Bad.csv", "", { "x, y and z" });
  this->Refuse("Bad.csv", "x,y,z\n1,2,3\n1,two,3\n", { "Line 3", "column y", "\"two\"" });
  this->Refuse("Bad.csv", "x,y,z\n1,2\n", { "Line 2", "column z" });
  this->Refuse("Bad.csv", "kind,x,y,z\nline,1,2,3\n", { "Line 2", "\"line\"", "Distance" });
  this->Refuse("Bad.csv", "kind,x,y,z\ndistance,1,2,3\n", { "1 point.", "A Distance needs 2" });
  this->Refuse("Bad.csv", "name,x,y,z\n\"a,1,2,3\n", { "quote" });
  this->Refuse("Bad.vtp", "no XML", { ".vtp" });
  this->Refuse("Bad.txt", "x,y,z\n1,2,3\n", { ".csv, .vtp or .mrk.json" });
  this->List->RemoveAll();
  EXPECT_FALSE(this->List->ReadFile(File("NotThere.csv").c_str()));
  this->ExpectError({ "NotThere.csv", "exists" });
  EXPECT_FALSE(this->List->ReadFile(nullptr));
  this->ExpectError({ "ending" });
  EXPECT_FALSE(this->List->ReadFile("/dev/zero.csv"));
  this->ExpectError({ "/dev/zero.csv" });
}

TEST_F(MeasurementFiles, OfAnotherPolyDataAreRefused)
{
  vtkNew<vtkPlaneSource> plane;
  plane->Update();
  EXPECT_FALSE(this->List->ReadPolyData(plane->GetOutput()));
  this->ExpectError({ "MeasurementName", "CopyToPolyData" });
  EXPECT_FALSE(this->List->ReadPolyData(nullptr));
  this->ExpectError({ "vtkPolyData" });
  Fill(this->List);
  vtkNew<vtkPolyData> data;
  this->List->CopyToPolyData(data);
  data->GetCellData()->Initialize();
  EXPECT_FALSE(this->List->ReadPolyData(data));
  this->ExpectError({ "cell array \"Measurement\"" });
}

TEST_F(MeasurementFiles, ThatCannotBeWrittenStay)
{
  Fill(this->List);
  EXPECT_FALSE(this->List->WriteFile("/no/such/folder/a.csv"));
  this->ExpectError({ "/no/such/folder/a.csv" });
  EXPECT_FALSE(this->List->WriteFile(File("a.png").c_str()));
  this->ExpectError({ ".csv, .vtp or .mrk.json" });
  EXPECT_FALSE(this->List->WriteFile(nullptr));
  this->ExpectError({ "ending" });
}
