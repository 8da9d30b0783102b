// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Report.h"

#include <algorithm>
#include <cstdio>
#include <fstream>

namespace evaluation
{
namespace
{
constexpr const char* ComparisonTitle = "Compared with other methods";
constexpr const char* FeelTitle = "The feel of real scans, and who could tell tissues apart";
constexpr const char* SafetyTitle = "Devices that would hurt a hand";

const char* Verdict(const Figure& figure)
{
  return figure.IsReached() ? "reached" : "NOT reached";
}

std::string Bound(const Figure& figure)
{
  return (figure.Bound == 0.0 ? "" : "< ") + Number(figure.Bound) +
    (figure.Unit.empty() ? "" : " " + figure.Unit);
}

/** Returns PAPER's value of the same figure, or empty if PAPER has none. */
std::string FindPaper(const Section& section, const Figure& figure)
{
  const auto found = std::find_if(section.Paper.begin(), section.Paper.end(),
    [&figure](const Figure& other) { return other.Name == figure.Name; });
  return found == section.Paper.end() ? std::string() : Number(found->Value);
}

void WritePicture(const std::string& title, const std::string& file, std::ostream& out)
{
  out << "\n![" << title << "](" << file << ".png)\n";
}

void WriteComparison(const char* title, const Comparison& comparison, std::ostream& out)
{
  out << "\n## " << title << "\n";
  for (const Table& table : comparison.Tables)
  {
    WriteTable(table, out);
  }
  for (const Plot& plot : comparison.Plots)
  {
    WritePicture(plot.Title, plot.File, out);
  }
}
} // namespace

bool WriteReport(const Report& report, const std::string& folder)
{
  std::ofstream out(folder + "/report.md");
  out << "# PAPER and PRECISE, measured\n\n"
         "The figures that the solver PRECISE must reach, and what the solver of the paper does. "
         "Fields are analytic, of voxels of 1 mm (closed forms: 0.5 mm) unless said, touched "
         "life-size at 1 kHz.\n";
  for (const Section& section : report.Sections)
  {
    out << "\n## " << section.Title << "\n\n| figure | required | PRECISE | | PAPER |\n"
        << "| --- | --- | --- | --- | --- |\n";
    for (const Figure& figure : section.Precise)
    {
      out << "| " << figure.Name << " | " << Bound(figure) << " | " << Number(figure.Value) << " | "
          << Verdict(figure) << " | " << FindPaper(section, figure) << " |\n";
    }
  }
  for (const Plot& plot : report.Plots)
  {
    WritePicture(plot.Title, plot.File, out);
  }
  WriteComparison(FeelTitle, report.Scans.Found, out);
  WriteComparison(ComparisonTitle, report.Methods, out);
  if (!report.Transfer.File.empty())
  {
    WritePicture(report.Transfer.Title, report.Transfer.File, out);
  }
  out << "\n## " << SafetyTitle << "\n";
  for (const Table& table : report.Safety.Tables)
  {
    WriteTable(table, out);
  }
  out.flush();
  return out.good();
}

int PrintSection(const Section& section)
{
  int missed = 0;
  std::printf("\n%-66s %16s %12s %12s\n", section.Title.c_str(), "required", "PRECISE", "PAPER");
  for (const Figure& figure : section.Precise)
  {
    const std::string paper = FindPaper(section, figure);
    std::printf("  %-64s %16s %12s %12s  %s\n", figure.Name.c_str(), Bound(figure).c_str(),
      Number(figure.Value).c_str(), paper.c_str(), Verdict(figure));
    missed += figure.IsReached() || figure.IsTime ? 0 : 1;
  }
  std::fflush(stdout);
  return missed;
}

void PrintFeelTitle()
{
  std::printf("\n%s\n", FeelTitle);
}

void PrintComparison(const Comparison& comparison)
{
  std::printf("\n%s\n", ComparisonTitle);
  std::for_each(comparison.Tables.begin(), comparison.Tables.end(), PrintTable);
}

void PrintSafety(const PortSafety& safety)
{
  std::printf("\n%s\n", SafetyTitle);
  std::for_each(safety.Tables.begin(), safety.Tables.end(), PrintTable);
}

} // namespace evaluation
