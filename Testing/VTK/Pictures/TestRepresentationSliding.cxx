// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a drag along the surface with friction. The colours of the trail represent the force.
#include "ShownContact.h"

int TestRepresentationSliding(int argc, char* argv[])
{
  return scenetest::ShowContact(argc, argv, { 2, 4.0, 8.0, 0.3, 4.0, false, true });
}
