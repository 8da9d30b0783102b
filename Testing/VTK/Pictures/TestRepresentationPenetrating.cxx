// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

// Renders a press beyond the strength of the surface, which the proxy penetrates.
#include "ShownContact.h"

int TestRepresentationPenetrating(int argc, char* argv[])
{
  return scenetest::ShowContact(argc, argv, { 3, 6.0, 0.0, 0.3, 1.5 });
}
