// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_CheckedReading_h
#define Explore_CheckedReading_h

#include <functional>
#include <string>

class vtkAlgorithm;

namespace Explore
{
/// Runs a reader in two steps, and checks its errors before it reads samples, because some readers
/// continue after an error, and read all samples into memory for one voxel. Calls `check` between
/// header and samples: it returns why the header can't be true (empty if it can). Returns false
/// after an error; `detail` then has the error in one line, if the reader reported one.
bool ReadChecked(
  vtkAlgorithm* reader, std::string& detail, const std::function<std::string()>& check = nullptr);
} // namespace Explore

#endif
