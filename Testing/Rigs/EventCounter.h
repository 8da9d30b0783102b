// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Counts an object's events.
 */
#ifndef EventCounter_h
#define EventCounter_h

#include <vtkCallbackCommand.h>
#include <vtkNew.h>
#include <vtkObject.h>
#include <vtkWeakPointer.h>

namespace apitest
{

/** Counts an object's events of one kind during the counter's lifetime. */
class EventCounter
{
public:
  EventCounter(vtkObject* object, unsigned long event)
    : Object(object)
  {
    this->Command->SetClientData(this);
    this->Command->SetCallback([](vtkObject*, unsigned long, void* self, void*)
      { ++static_cast<EventCounter*>(self)->Count; });
    object->AddObserver(event, this->Command);
  }
  EventCounter(const EventCounter&) = delete;
  EventCounter& operator=(const EventCounter&) = delete;
  ~EventCounter()
  {
    if (this->Object)
    {
      this->Object->RemoveObserver(this->Command);
    }
  }

  int Count = 0;

private:
  const vtkWeakPointer<vtkObject> Object;
  vtkNew<vtkCallbackCommand> Command;
};

} // namespace apitest

#endif
