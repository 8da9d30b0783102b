// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * The report: report.md and its pictures in one folder.
 */
#ifndef Evaluation_Report_h
#define Evaluation_Report_h

#include "Comparison.h"
#include "Feel.h"
#include "PortSafety.h"

namespace evaluation
{

/** A table of figures with a heading. */
struct Section
{
  std::string Title;
  Figures Paper;
  Figures Precise;
};

/** Draws a plot to FOLDER/NAME.png. Needs a display, which may be virtual. */
void DrawPlot(const Plot& plot, const std::string& folder);

/** The contents of report.md, in its order. */
struct Report
{
  std::vector<Section> Sections;
  std::vector<Plot> Plots;
  Feel Scans;
  Comparison Methods;
  Picture Transfer;
  PortSafety Safety;
};

/** Writes FOLDER/report.md. Returns false if the folder can't be written to. */
bool WriteReport(const Report& report, const std::string& folder);

/**
 * Print the same tables to the terminal, each when it is complete. PrintSection() returns how many
 * figures of PRECISE, without times, are not reached.
 */
int PrintSection(const Section& section);
void PrintComparison(const Comparison& comparison);
void PrintSafety(const PortSafety& safety);

/** Prints the heading of the tables of MeasureFeel() and of those after them. */
void PrintFeelTitle();

} // namespace evaluation

#endif
