// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** A library for LD_PRELOAD that sets a program's locale to the user's, as QApplication does. */
#include <clocale>
#include <cstdio>
#include <cstdlib>

namespace
{
struct FollowedLocale
{
  FollowedLocale()
  {
    // The tests are meaningless in a locale without a decimal comma.
    if (!std::setlocale(LC_ALL, "") || std::localeconv()->decimal_point[0] != ',')
    {
      std::fputs("The locale of the user has no decimal comma.\n", stderr);
      std::_Exit(1);
    }
  }
} const Followed;
} // namespace
