// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * If a busy machine holds the servo loop up for longer than the watchdog allows (30 ms), the proxy
 * begins again from the tip, which may be inside by then, and force rises from zero: the situation
 * that a test has prepared is lost, and the test has to prepare it once more.
 */
#ifndef LoopPauses_h
#define LoopPauses_h

#include <vtkHapticDevice.h>

class LoopPauses
{
public:
  /// After every UpdateState. What the states lag behind the clock grows with every pause.
  void Look(vtkHapticDevice* device)
  {
    const double lag =
      device->GetTime() - static_cast<double>(device->GetTick()) / device->GetServoRate();
    this->HeldUp = this->HeldUp || lag > this->Lag + 0.02;
    this->Lag = lag;
  }
  /// Whether there was such a pause among the states since Forget; rather once too often.
  bool WasHeldUp() const { return this->HeldUp; }
  void Forget() { this->HeldUp = false; }

private:
  double Lag = 0.0;
  bool HeldUp = false;
};

#endif
