// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Table.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <sstream>

namespace evaluation
{
namespace
{
/** Prints text in lines that fit a terminal. */
void PrintText(const std::string& text)
{
  std::istringstream words(text);
  std::string line = " ";
  for (std::string word; words >> word; line += " " + word)
  {
    if (line.size() + word.size() > 110)
    {
      std::printf("%s\n", line.c_str());
      line = " ";
    }
  }
  std::printf("%s\n", line.c_str());
}
} // namespace

std::string Number(double value)
{
  char text[32];
  const double size = std::abs(value);
  std::snprintf(text, sizeof(text), size >= 999.5 && size < 1e6 ? "%.0f" : "%.3g", value);
  return text;
}

void PrintTable(const Table& table)
{
  std::printf("\n%s\n", table.Title.c_str());
  PrintText(table.Text);
  std::vector<std::size_t> widths;
  for (const std::string& column : table.Columns)
  {
    widths.push_back(column.size());
  }
  for (const std::vector<std::string>& row : table.Rows)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      widths[i] = std::max(widths[i], row[i].size());
    }
  }
  const auto print = [&](const std::vector<std::string>& row)
  {
    for (std::size_t i = 0; i < row.size(); ++i)
    {
      std::printf("  %-*s", static_cast<int>(widths[i]), row[i].c_str());
    }
    std::printf("\n");
  };
  print(table.Columns);
  std::for_each(table.Rows.begin(), table.Rows.end(), print);
  std::fflush(stdout);
}

void WriteTable(const Table& table, std::ostream& out)
{
  out << "\n### " << table.Title << "\n\n" << table.Text << "\n";
  const auto write = [&](const std::vector<std::string>& row)
  {
    for (const std::string& cell : row)
    {
      out << "| " << cell << " ";
    }
    out << "|\n";
  };
  if (!table.Rows.empty())
  {
    out << "\n";
    write(table.Columns);
    write(std::vector<std::string>(table.Columns.size(), "---"));
    std::for_each(table.Rows.begin(), table.Rows.end(), write);
  }
}

} // namespace evaluation
