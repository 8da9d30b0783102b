// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Explore_InputError_h
#define Explore_InputError_h

#include <stdexcept>
#include <string>

namespace Explore
{
/// An error that the user can correct. Its message states the fault and the cure.
class InputError : public std::runtime_error
{
public:
  InputError(const std::string& subject, const std::string& fault, const std::string& cure)
    : std::runtime_error(subject + ": " + fault + ".\n  Cure: " + cure + ".")
  {
  }
  /// Rethrows an error of another process, given its complete message.
  explicit InputError(const std::string& message)
    : std::runtime_error(message)
  {
  }
};
} // namespace Explore

#endif
