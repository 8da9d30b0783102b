// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_MessageCapture_h
#define Explore_MessageCapture_h

#include "vtkLogger.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <sstream>
#include <streambuf>
#include <string>

class vtkAlgorithm;

namespace Explore
{
/// Collects the messages of VTK's readers as long as it lives, instead of showing them on the
/// terminal. A damaged file then gives one message of this program instead of a page. MetaIO writes
/// to std::cerr and std::cout directly, so both are captured, too.
class MessageCapture
{
public:
  MessageCapture();
  ~MessageCapture();
  MessageCapture(const MessageCapture&) = delete;
  MessageCapture& operator=(const MessageCapture&) = delete;

  /// Returns whether a reader reported an error, or a warning that means missing data.
  bool HasErrors() const;

  /// Returns the first error in one line, without VTK's addresses and source positions; empty if
  /// there is none.
  std::string FirstError() const;

private:
  vtkSmartPointer<vtkOutputWindow> Previous;
  vtkSmartPointer<vtkOutputWindow> Window;
  vtkLogger::Verbosity Verbosity;
  std::ostringstream Stream;
  std::streambuf* Cerr;
  std::streambuf* Cout;
};

/// Runs a reader in two steps, and checks its errors before it reads samples, because some readers
/// continue after an error, and read all samples into memory for one voxel. Calls `check` between
/// header and samples: it returns why the header can't be true (empty if it can). Returns false
/// after an error; `detail` then has the error in one line, if the reader reported one.
bool ReadChecked(
  vtkAlgorithm* reader, std::string& detail, const std::function<std::string()>& check = nullptr);

} // namespace Explore

#endif
