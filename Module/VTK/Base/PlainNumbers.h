// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Reads JSON's numbers in any locale.
 */
#ifndef PlainNumbers_h
#define PlainNumbers_h

#include <locale>

namespace VolumeHaptics
{

/**
 * Reads numbers as JSON writes them while it lives. jsoncpp reads numbers in the application's
 * locale, where 0.5 may be written 0,5. Changes nothing if the locale already reads them so.
 */
class PlainNumbers
{
public:
  PlainNumbers()
  {
    const auto& numbers = std::use_facet<std::numpunct<char>>(this->Before);
    this->Changed = numbers.decimal_point() != '.' || !numbers.grouping().empty();
    if (this->Changed)
    {
      // The locale has no name, so that the locale of C stays unchanged.
      std::locale::global(std::locale(this->Before, new std::numpunct<char>));
    }
  }
  ~PlainNumbers()
  {
    if (this->Changed)
    {
      std::locale::global(this->Before);
    }
  }

private:
  std::locale Before;
  bool Changed = false;
};

} // namespace VolumeHaptics

#endif
