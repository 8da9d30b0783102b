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

/** A section of the report: figures under a heading. */
struct Section
{
  std::string Title;
  Figures Paper;
  Figures Precise;
};

/** Draws a plot to FOLDER/NAME.png. Needs a display, possibly a virtual one. */
void DrawPlot(const Plot& plot, const std::string& folder);

/** The contents of report.md, in the same order. */
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
 * Print the tables of the report to the terminal, each as soon as it is complete. PrintSection()
 * returns how many figures of PRECISE, excluding times, miss their bounds.
 */
int PrintSection(const Section& section);
void PrintComparison(const Comparison& comparison);
void PrintSafety(const PortSafety& safety);

/** Prints the heading above the tables of MeasureFeel() and the tables that follow. */
void PrintFeelTitle();

} // namespace evaluation

#endif
