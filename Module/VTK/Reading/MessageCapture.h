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
/// Captures the messages of VTK's readers during its lifetime, so that a damaged file gives one
/// message of this program instead of a page of VTK's. Also captures std::cerr and std::cout,
/// because MetaIO writes to them directly.
class MessageCapture
{
public:
  MessageCapture();
  ~MessageCapture();
  MessageCapture(const MessageCapture&) = delete;
  MessageCapture& operator=(const MessageCapture&) = delete;

  /// Returns whether a reader reported an error, or a warning about missing data.
  bool HasErrors() const;

  /// Returns the first error as one line, without VTK's addresses and source positions; empty if
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

/// Runs a reader in two steps, header and samples, and checks for errors in between. Some readers
/// would continue after an error, or read all samples into memory for one voxel. `check` is called
/// between the steps, and returns why the header can't be true (empty if it can). Returns false
/// after an error, with the reader's message, if any, in `detail`.
bool ReadChecked(
  vtkAlgorithm* reader, std::string& detail, const std::function<std::string()>& check = nullptr);

} // namespace Explore

#endif
