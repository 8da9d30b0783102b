// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "StiffWalls.h"

#include "Rigs/StiffWalls.h"

#include <algorithm>

using namespace rigs;

namespace evaluation
{

Table MeasureStiffWalls()
{
  Table table;
  table.Title = "Walls stiffer than 2 b / T";
  table.Text =
    "Arms like a Falcon (forces a tick late) and a Touch, with encoders and dry friction, pressed "
    "by weights of 1 and 2 N and by hands, at 20 and 100 mm/s. Shown: mean force / mean depth "
    "while it is pressed, the least of them. Energy: what the hand got / what it put in, the "
    "device's friction on the hand's side; and the most that it ever had too much, also without "
    "the "
    "dry friction's help.";
  table.Columns = { "arm", "2 b / T, N/mm", "gain", "wall", "force grows by, N/s", "shown, N/mm",
    "shown / (2 b / T)", "energy ratio", "mJ too much", "mJ without dry friction", "swing, mm" };
  struct Kind
  {
    double Gain;
    bool Augments;
    double Rate;
  };
  for (const StiffArm& arm : { StiffArm::FalconLike(), StiffArm::TouchLike() })
  {
    for (const Kind& kind : { Kind{ 1.0, false, 3000.0 }, Kind{ 6.0, false, 3000.0 },
           Kind{ 6.0, true, 3000.0 }, Kind{ 6.0, true, 500.0 }, Kind{ 10.0, true, 3000.0 },
           Kind{ 20.0, false, 3000.0 }, Kind{ 20.0, true, 3000.0 } })
    {
      double shown = 1e9;
      StiffResult worst;
      for (const bool isHeld : { false, true })
      {
        for (const double force : { 1.0, 2.0 })
        {
          for (const double speed : { 0.02, 0.1 })
          {
            const StiffResult result =
              PressStiffly(arm, { isHeld, force, speed, kind.Gain, kind.Augments, kind.Rate });
            shown = std::min(shown, result.Shown);
            worst.Ratio = std::max(worst.Ratio, result.Ratio);
            worst.MostGiven = std::max(worst.MostGiven, result.MostGiven);
            worst.MostWithoutFriction =
              std::max(worst.MostWithoutFriction, result.MostWithoutFriction);
            worst.Swing = std::max(worst.Swing, result.Swing);
          }
        }
      }
      table.Rows.push_back({ arm.Name, Number(1e-3 * arm.Sampled()), Number(kind.Gain),
        kind.Augments ? "augmented" : "plain", Number(kind.Rate), Number(1e-3 * shown),
        Number(shown / arm.Sampled()), Number(worst.Ratio), Number(1e3 * worst.MostGiven),
        Number(1e3 * worst.MostWithoutFriction), Number(1e3 * worst.Swing) });
    }
  }
  return table;
}

} // namespace evaluation
