// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Tables with any columns, for a terminal and for the report.
 */
#ifndef Evaluation_Table_h
#define Evaluation_Table_h

#include <ostream>
#include <string>
#include <vector>

namespace evaluation
{

struct Table
{
  std::string Title;
  std::string Text; ///< the measurement and its result
  std::vector<std::string> Columns;
  std::vector<std::vector<std::string>> Rows;
};

/**
 * Formats a number with three significant digits; from 1000 upwards, with all digits before the
 * decimal point.
 */
std::string Number(double value);

/** Prints a table to the terminal, and flushes it. */
void PrintTable(const Table& table);
/** Writes a table as Markdown. */
void WriteTable(const Table& table, std::ostream& out);

} // namespace evaluation

#endif
