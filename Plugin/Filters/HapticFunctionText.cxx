// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "HapticFunctionText.h"

#include "vtkPiecewiseFunction.h"

#include <algorithm>
#include <locale>
#include <sstream>
#include <vector>

bool ReadFunctionText(std::string text, vtkPiecewiseFunction* function)
{
  std::replace(text.begin(), text.end(), ',', ' ');
  std::istringstream words(text);
  words.imbue(std::locale::classic());
  std::vector<double> numbers;
  for (double number; words >> number;)
  {
    numbers.push_back(number);
  }
  if (!words.eof() || (numbers.size() > 1 && numbers.size() % 2 != 0))
  {
    return false;
  }
  if (numbers.size() == 1)
  {
    numbers.insert(numbers.begin(), 0.0);
  }
  for (std::size_t i = 0; i < numbers.size(); i += 2)
  {
    function->AddPoint(numbers[i], numbers[i + 1]);
  }
  return true;
}
