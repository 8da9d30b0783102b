// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_MessageCapture_h
#define Explore_MessageCapture_h

#include "vtkLogger.h"
#include "vtkOutputWindow.h"
#include "vtkSmartPointer.h"

#include <sstream>
#include <streambuf>
#include <string>

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

  /// Whether a reader reported an error, or a warning that means missing data.
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
} // namespace Explore

#endif
