// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Tests tables of traces. Their text follows RFC 4180 (a line of titles, fields between commas).
 * The test reads the numbers with std::from_chars of the C++ standard, and the .vtp with VTK's
 * reader.
 */

#include "VTK/Trace/TraceWriter.h"

#include "Rigs/TemporaryFolder.h"

#include <gtest/gtest.h>
#include <vtkDoubleArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLPolyDataReader.h>
#include <vtksys/SystemTools.hxx>

#include <charconv>
#include <cmath>
#include <cstring>
#include <fstream>
#include <limits>
#include <locale>
#include <random>
#include <sstream>
#include <string>
#include <vector>

using VolumeHaptics::TraceTable;
using VolumeHaptics::WriteTracePolyData;
using VolumeHaptics::WriteTraceTable;

namespace
{

std::string ReadText(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  return { std::istreambuf_iterator<char>(stream), {} };
}

std::vector<std::string> Split(const std::string& text, char at)
{
  std::vector<std::string> fields;
  std::istringstream stream(text);
  for (std::string field; std::getline(stream, field, at);)
  {
    fields.push_back(field);
  }
  return fields;
}

double ToNumber(const std::string& text)
{
  double number = 0.0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  EXPECT_TRUE(read.ec == std::errc() && read.ptr == text.data() + text.size()) << text;
  return number;
}

/// German numbers, with a decimal comma and points between thousands.
class GermanNumbers : public std::numpunct<char>
{
protected:
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

/// Makes a trace of two ticks, with an array of each shape.
vtkSmartPointer<vtkPolyData> MakeTrace()
{
  auto trace = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  points->InsertNextPoint(1.5, 2.5, 1000.0 / 3.0);
  points->InsertNextPoint(-1.0, 0.0, 1e-300);
  trace->SetPoints(points);
  const auto add = [&trace](vtkDataArray* array, const char* name, int components)
  {
    array->SetName(name);
    array->SetNumberOfComponents(components);
    array->SetNumberOfTuples(2);
    for (int i = 0; i < 2 * components; ++i)
    {
      array->SetComponent(i / components, i % components, i + 1);
    }
    trace->GetPointData()->AddArray(array);
  };
  add(vtkNew<vtkDoubleArray>(), "Orientation", 4);
  add(vtkNew<vtkUnsignedCharArray>(), "Contact", 1);
  add(vtkNew<vtkDoubleArray>(), "Force", 3);
  add(vtkNew<vtkDoubleArray>(), "Time", 1);
  return trace;
}

} // namespace

TEST(TraceWriter, PutsTimeAndProxyFirstAndNamesUnits)
{
  const std::string file = TemporaryPath("trace-writer.csv");
  std::string error;
  ASSERT_TRUE(WriteTraceTable(MakeTrace(), file, error)) << error;
  const std::vector<std::string> lines = Split(ReadText(file), '\n');
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_EQ(lines[0],
    "Time (s),Proxy x (world),Proxy y (world),Proxy z (world),Orientation w,Orientation x,"
    "Orientation y,Orientation z,Contact,Force x (N),Force y (N),Force z (N)");
  const std::vector<std::string> fields = Split(lines[1], ',');
  const double wanted[] = { 1.0, 1.5, 2.5, 1000.0 / 3.0, 1.0, 2.0, 3.0, 4.0, 1.0, 1.0, 2.0, 3.0 };
  ASSERT_EQ(fields.size(), std::size(wanted));
  for (std::size_t i = 0; i < fields.size(); ++i)
  {
    EXPECT_EQ(ToNumber(fields[i]), wanted[i]) << fields[i];
  }
  EXPECT_EQ(ToNumber(Split(lines[2], ',')[3]), 1e-300);
}

TEST(TraceWriter, NumbersAreRestoredToTheBit)
{
  std::mt19937_64 random(7);
  TraceTable table;
  for (int i = 0; i < 20000; ++i)
  {
    const std::uint64_t bits = random();
    double number = 0.0;
    std::memcpy(&number, &bits, sizeof(number));
    if (!std::isfinite(number))
    {
      continue;
    }
    table.AddNumber(number);
    const std::string line = table.EndLine();
    ASSERT_EQ(line.back(), '\n');
    ASSERT_EQ(ToNumber(line.substr(0, line.size() - 1)), number) << line;
  }
}

TEST(TraceWriter, WritesPointsWhateverTheLocale)
{
  const std::locale before = std::locale::global(std::locale(std::locale(), new GermanNumbers));
  const std::string file = TemporaryPath("trace-writer-locale.csv");
  std::string error;
  const bool isWritten = WriteTraceTable(MakeTrace(), file, error);
  std::locale::global(before);
  ASSERT_TRUE(isWritten) << error;
  const std::string first = Split(ReadText(file), '\n')[1];
  EXPECT_EQ(first.rfind("1,1.5,2.5,333.333", 0), 0u) << first;
}

TEST(TraceWriter, PolyDataComeBackEqual)
{
  const std::string file = TemporaryPath("trace-writer.vtp");
  std::string error;
  const auto trace = MakeTrace();
  ASSERT_TRUE(WriteTracePolyData(trace, file, error)) << error;
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(file.c_str());
  reader->Update();
  vtkPolyData* const read = reader->GetOutput();
  ASSERT_EQ(read->GetNumberOfPoints(), 2);
  EXPECT_EQ(read->GetPoint(0)[2], 1000.0 / 3.0);
  ASSERT_EQ(read->GetPointData()->GetNumberOfArrays(), 4);
  for (int a = 0; a < 4; ++a)
  {
    vtkDataArray* const wanted = trace->GetPointData()->GetArray(a);
    vtkDataArray* const array = read->GetPointData()->GetArray(wanted->GetName());
    ASSERT_TRUE(array) << wanted->GetName();
    EXPECT_EQ(array->GetDataType(), wanted->GetDataType()) << wanted->GetName();
    for (vtkIdType i = 0; i < wanted->GetNumberOfValues(); ++i)
    {
      EXPECT_EQ(array->GetVariantValue(i), wanted->GetVariantValue(i)) << wanted->GetName();
    }
  }
}

TEST(TraceWriter, LeavesTheOldFileIfItCannotWrite)
{
  const std::string folder = TemporaryPath("trace-writer-folder");
  const std::string file = folder + "/trace";
  std::string error;
  EXPECT_FALSE(WriteTraceTable(MakeTrace(), file + ".csv", error)) << "there is no such folder";
  EXPECT_NE(error.find(folder), std::string::npos) << error;
  error.clear();
  EXPECT_FALSE(WriteTracePolyData(MakeTrace(), file + ".vtp", error));
  EXPECT_NE(error.find(folder), std::string::npos) << error;

  // A folder with the file's name can't be replaced. Writing must not leave another file beside it.
  ASSERT_TRUE(vtksys::SystemTools::MakeDirectory(file + ".csv/inside"));
  error.clear();
  EXPECT_FALSE(WriteTraceTable(MakeTrace(), file + ".csv", error));
  EXPECT_NE(error.find("is a folder"), std::string::npos) << error;
  EXPECT_TRUE(vtksys::SystemTools::FileIsDirectory(file + ".csv/inside"));
  EXPECT_TRUE(vtksys::SystemTools::RemoveADirectory(folder));
}
