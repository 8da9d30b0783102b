// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Applications/DeviceTool/DeviceTool.h"

#include <iostream>

int main(int argc, char* argv[])
{
  return RunDeviceTool({ argv + 1, argv + argc }, std::cin, std::cout, std::cerr);
}
