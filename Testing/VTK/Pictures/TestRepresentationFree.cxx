// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Above the surface: tip and proxy at one position, no force; the positions at which materials are
// read.
#include "ShownContact.h"

int TestRepresentationFree(int argc, char* argv[])
{
  return scenetest::ShowContact(argc, argv, { 0, -3.0, 0.0, 0.3, 4.0, true });
}
