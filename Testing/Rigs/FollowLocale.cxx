// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * A library that is loaded before a program (LD_PRELOAD), and sets the program's locale to the
 * user's, as QApplication does.
 */
#include <clocale>
#include <cstdio>
#include <cstdlib>

namespace
{
struct FollowedLocale
{
  FollowedLocale()
  {
    // The tests prove something only in a locale with a decimal comma.
    if (!std::setlocale(LC_ALL, "") || std::localeconv()->decimal_point[0] != ',')
    {
      std::fputs("The locale of the user has no decimal comma.\n", stderr);
      std::_Exit(1);
    }
  }
} const Followed;
} // namespace
