// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSMHapticRegionProxy.h"

#include "HapticRegionMessage.h"

#include "vtkClientServerStream.h"
#include "vtkImageData.h"
#include "vtkMultiProcessController.h"
#include "vtkObjectFactory.h"
#include "vtkPVSession.h"
#include "vtkSMSession.h"

#include <new>

vtkStandardNewMacro(vtkSMHapticRegionProxy);

//------------------------------------------------------------------------------
vtkSMHapticRegionProxy::vtkSMHapticRegionProxy() = default;

//------------------------------------------------------------------------------
vtkSMHapticRegionProxy::~vtkSMHapticRegionProxy() = default;

//------------------------------------------------------------------------------
void vtkSMHapticRegionProxy::MarkDirty(vtkSMProxy* modified)
{
  this->Stale = true;
  this->Superclass::MarkDirty(modified);
}

//------------------------------------------------------------------------------
bool vtkSMHapticRegionProxy::HasSender()
{
  // First check that the server has the class: a server without it would send no answer, and the
  // client would wait forever.
  if (!this->IsKnown)
  {
    vtkClientServerStream stream;
    stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "GetClassName"
           << vtkClientServerStream::End;
    vtkSMSession* const session = this->GetSession();
    session->ExecuteStream(vtkPVSession::DATA_SERVER_ROOT, stream, true);
    const vtkClientServerStream& result = session->GetLastResult(vtkPVSession::DATA_SERVER_ROOT);
    std::string name;
    this->IsKnown = result.GetNumberOfMessages() == 1 && result.GetArgument(0, 0, &name) &&
      name == "vtkPVHapticRegionSender";
  }
  return this->IsKnown;
}

//------------------------------------------------------------------------------
vtkSMHapticRegionProxy::Answer vtkSMHapticRegionProxy::Fetch(const std::string& array,
  const int region[6], double time, bool isPresent, vtkImageData* image, std::string& error)
{
  vtkSMSession* const session = this->GetSession();
  vtkMultiProcessController* const server =
    session ? session->GetController(vtkPVSession::DATA_SERVER_ROOT) : nullptr;
  if (!server)
  {
    return LOST;
  }
  if (!this->HasSender())
  {
    error = "The server can't send what is around the tip. Load the same VolumeHapticsPlugin there "
            "as here.";
    return REFUSED;
  }
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "Send" << array.c_str();
  for (int i = 0; i < 6; ++i)
  {
    stream << region[i];
  }
  stream << time << (isPresent ? 1 : 0);
  stream << vtkClientServerStream::End;
  session->ExecuteStream(vtkPVSession::DATA_SERVER, stream);
  std::vector<char> message;
  try
  {
    if (!VolumeHapticsLive::ReceiveMessage(server, message))
    {
      return LOST;
    }
  }
  catch (const std::bad_alloc&)
  {
    // after an unread answer, the connection is unusable: the next request would receive that
    // answer
    return LOST;
  }
  try
  {
    return VolumeHapticsLive::UnpackRegion(message, image, error) ? FETCHED : REFUSED;
  }
  catch (const std::bad_alloc&)
  {
    error = "This computer has no memory for the region around the tip. Lower MaximumRegionVoxels, "
            "or close what you do not need.";
    return REFUSED;
  }
}

//------------------------------------------------------------------------------
void vtkSMHapticRegionProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stale: " << (this->Stale ? "Yes" : "No") << "\n";
}
