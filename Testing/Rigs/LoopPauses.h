// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Detects pauses of the servo loop. If a busy machine stops the loop for longer than the watchdog
 * allows (30 ms), the proxy starts again at the tip, which may already be inside, and the force
 * rises from zero. The test must then repeat its preparation.
 */
#ifndef LoopPauses_h
#define LoopPauses_h

#include <vtkHapticDevice.h>

class LoopPauses
{
public:
  /// Checks for a pause after every UpdateState(). Each pause of the loop increases the delay of
  /// the states relative to the clock.
  void Look(vtkHapticDevice* device)
  {
    const double lag = device->GetState()->GetTime() -
      static_cast<double>(device->GetState()->GetTick()) / device->GetServoRate();
    this->HeldUp = this->HeldUp || lag > this->Lag + 0.02;
    this->Lag = lag;
  }
  /// Returns whether the states show a pause since Forget(). May return true without a pause.
  bool WasHeldUp() const { return this->HeldUp; }
  void Forget() { this->HeldUp = false; }

private:
  double Lag = 0.0;
  bool HeldUp = false;
};

#endif
