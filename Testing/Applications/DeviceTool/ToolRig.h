// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** Runs volumehaptics-device with typed input, and captures its output. */
#ifndef ToolRig_h
#define ToolRig_h

#include "Applications/DeviceTool/DeviceTool.h"

#include <gtest/gtest.h>

#include <sstream>

namespace emulated
{

class ToolTest : public testing::Test
{
protected:
  int Run(const std::vector<std::string>& arguments, const std::string& typed = "")
  {
    std::istringstream in(typed);
    std::ostringstream out;
    std::ostringstream errors;
    const int result = RunDeviceTool(arguments, in, out, errors);
    this->Out = out.str();
    this->Errors = errors.str();
    return result;
  }
  bool Shows(const char* words) { return this->Out.find(words) != std::string::npos; }
  bool Complains(const char* words) { return this->Errors.find(words) != std::string::npos; }

  std::string Out;
  std::string Errors;
};

} // namespace emulated

#endif
