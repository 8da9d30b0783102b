// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a stylus that rests on the plane. A hand holds it from the right, with its button on top.
#include "ShownContact.h"

int TestRepresentationStylus(int argc, char* argv[])
{
  const double turn[4] = { 0.1853, 0.3609, -0.0920, 0.9094 };
  return scenetest::ShowContact(argc, argv, { 2, 4.0, 8.0, 0.3, 4.0, false, false, turn });
}
