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
vtkSMHapticRegionProxy::Answer vtkSMHapticRegionProxy::Fetch(
  const std::string& array, const int region[6], vtkImageData* image, std::string& error)
{
  vtkSMSession* const session = this->GetSession();
  vtkMultiProcessController* const server =
    session ? session->GetController(vtkPVSession::DATA_SERVER_ROOT) : nullptr;
  if (!server)
  {
    return LOST;
  }
  vtkClientServerStream stream;
  stream << vtkClientServerStream::Invoke << VTKOBJECT(this) << "Send" << array.c_str();
  for (int i = 0; i < 6; ++i)
  {
    stream << region[i];
  }
  stream << vtkClientServerStream::End;
  session->ExecuteStream(vtkPVSession::DATA_SERVER, stream);
  std::vector<char> message;
  if (!VolumeHapticsLive::ReceiveMessage(server, message))
  {
    return LOST;
  }
  return VolumeHapticsLive::UnpackRegion(message, image, error) ? FETCHED : REFUSED;
}

//------------------------------------------------------------------------------
void vtkSMHapticRegionProxy::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Stale: " << (this->Stale ? "Yes" : "No") << "\n";
}
