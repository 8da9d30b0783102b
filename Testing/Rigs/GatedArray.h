// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/** An array that blocks worker threads until a test allows them to read it. */
#ifndef GatedArray_h
#define GatedArray_h

#include <vtkObjectFactory.h>
#include <vtkShortArray.h>

#include <atomic>
#include <thread>

namespace devicetest
{
/// An array that only the thread that created it can read, until the array is opened. Other threads
/// wait.
class GatedArray : public vtkShortArray
{
public:
  static GatedArray* New() { VTK_STANDARD_NEW_BODY(GatedArray); }
  vtkTypeMacro(GatedArray, vtkShortArray);
  void* GetVoidPointer(vtkIdType value) override
  {
    if (std::this_thread::get_id() != this->Owner)
    {
      ++this->Asked;
      while (!this->IsOpen)
      {
        std::this_thread::yield();
      }
    }
    return this->Superclass::GetVoidPointer(value);
  }

  std::atomic<bool> IsOpen{ false };
  std::atomic<int> Asked{ 0 };

private:
  const std::thread::id Owner = std::this_thread::get_id();
};
} // namespace devicetest

#endif
