// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a press straight into the surface. The proxy stays on the surface, and the force is
// normal to it.
#include "ShownContact.h"

int TestRepresentationSticking(int argc, char* argv[])
{
  return scenetest::ShowContact(argc, argv, { 1, 4.0, 0.0, 0.5, 4.0 });
}
