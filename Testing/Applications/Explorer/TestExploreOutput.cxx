// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
// Tests the program's output other than pictures: the summary and the table of the trace.
#include "Applications/Explorer/Report/ReportFiles.h"
#include "Applications/Explorer/Report/TraceSummary.h"
#include "Expectations.h"
#include "HeadExploration.h"
#include "VTK/Reading/InputError.h"

#include "vtkPointData.h"

#include <vtksys/FStream.hxx>

#include <algorithm>
#include <cmath>

int TestExploreOutput(int argc, char* argv[])
{
  const Explore::Exploration exploration = ExploreHead(argc, argv);
  const std::string summary = Explore::Summarise(exploration);
  for (const char* words : { "HeadPhantom.vti", "64 x 64 x 64 voxels", "Hounsfield",
         "\"CT contrast\"", "derivative of a Gaussian", "life-size", "sliding", "bone",
         "Largest force", "ticks per second" })
  {
    Expect(summary.find(words) != std::string::npos, std::string("the summary says ") + words);
  }

  const std::string folder = MakeTestFolder(argc, argv, "ExploreOutput");
  Explore::WriteTable(exploration.Trace, folder + "/trace.csv");
  vtksys::ifstream table((folder + "/trace.csv").c_str());
  std::string header, row, last;
  std::getline(table, header);
  for (const char* title : { "Time (s)", "Proxy x (world)", "Tip z (world)", "Force y (N)",
         "NormalForce (N)", "Stiffness (N/m)", "Friction", "Contact" })
  {
    Expect(("," + header + ",").find(std::string(",") + title + ",") != std::string::npos,
      std::string("the table has a column ") + title);
  }
  const auto columns = std::count(header.begin(), header.end(), ',');
  const std::string before = header.substr(0, header.find("Force y (N)"));
  const auto force = std::count(before.begin(), before.end(), ',');
  vtkDataArray* const forces = exploration.Trace->GetPointData()->GetArray("Force");
  bool isExact = true;
  vtkIdType rows = 0;
  while (std::getline(table, row))
  {
    Expect(std::count(row.begin(), row.end(), ',') == columns, "every row is complete");
    last = row;
    std::size_t cell = 0;
    for (auto i = force; i > 0; --i)
    {
      cell = row.find(',', cell) + 1;
    }
    isExact = isExact && std::stod(row.substr(cell)) == forces->GetComponent(rows, 1);
    ++rows;
  }
  Expect(rows == exploration.Trace->GetNumberOfPoints(), "the table has a row a tick");
  const double seconds = (rows - 1) / exploration.ServoRate;
  Expect(std::abs(std::stod(last) - seconds) < 1e-6, "the first column is the time");
  Expect(isExact, "the numbers of the table are those of the trace, to the bit");
  Expect(exploration.Trace->GetPointData()->GetArray("Force") != nullptr, "the trace is whole");

  try
  {
    Explore::WriteTable(exploration.Trace, folder);
    Expect(false, "a folder is no file to write a table to");
  }
  catch (const Explore::InputError& error)
  {
    Expect(std::string(error.what()).find("it is a folder") != std::string::npos,
      "the error says why the table can't be written");
  }
  return failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
