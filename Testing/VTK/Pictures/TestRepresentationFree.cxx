// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a tip above the surface: tip and proxy at one position, no force, the positions at which
// materials are read, and a ring on the surface. The tip is 3 mm above z = 0. Seen from (10, -60,
// 28), the ring is 3 mm * 65.8 / 25 = 7.9 mm away along the line of sight.
#include "ShownContact.h"

int TestRepresentationFree(int argc, char* argv[])
{
  return scenetest::ShowContact(argc, argv, { 0, -3.0, 0.0, 0.3, 4.0, true });
}
