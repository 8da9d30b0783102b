// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#if defined(_WIN32)
#include "Devices/Transport/Serial/SerialPort.h"

#include "Core/Platform/WindowsApi.h"

#include <algorithm>

#include <devguid.h>
#include <devpropdef.h>
#include <initguid.h> // must precede the property keys, which it turns into definitions
#include <setupapi.h>

namespace VolumeHaptics
{
namespace
{

/** Key of the name that a USB board reports (DEVPKEY_Device_BusReportedDeviceDesc). */
constexpr DEVPROPKEY NameOfBoard = {
  { 0x540b947e, 0x8b40, 0x45bc, { 0xa8, 0xa2, 0x6a, 0x0b, 0x89, 0x4c, 0xbd, 0xa2 } }, 4
};

std::string GetPortName(HDEVINFO devices, SP_DEVINFO_DATA& device)
{
  const HKEY key =
    SetupDiOpenDevRegKey(devices, &device, DICS_FLAG_GLOBAL, 0, DIREG_DEV, KEY_QUERY_VALUE);
  if (key == INVALID_HANDLE_VALUE)
  {
    return {};
  }
  wchar_t name[64] = L"";
  DWORD size = sizeof(name) - sizeof(name[0]);
  const LSTATUS result =
    RegQueryValueExW(key, L"PortName", nullptr, nullptr, reinterpret_cast<BYTE*>(name), &size);
  RegCloseKey(key);
  return result == ERROR_SUCCESS ? FromWide(name) : std::string();
}

/**
 * Returns the name that the board reports, followed by the serial number, which is the part after
 * the last '\\' of its instance id.
 */
std::string GetBoardName(HDEVINFO devices, SP_DEVINFO_DATA& device)
{
  wchar_t text[256] = L"";
  wchar_t instance[256] = L"";
  DEVPROPTYPE type = 0;
  SetupDiGetDevicePropertyW(devices, &device, &NameOfBoard, &type, reinterpret_cast<BYTE*>(text),
    sizeof(text) - sizeof(text[0]), nullptr, 0);
  SetupDiGetDeviceInstanceIdW(
    devices, &device, instance, sizeof(instance) / sizeof(instance[0]), nullptr);
  const std::string place = FromWide(instance);
  const std::string name = FromWide(text);
  return name.empty() ? name : name + "_" + place.substr(place.rfind('\\') + 1);
}

/** Returns the device path of a port, which is the only path that works for COM10 and higher. */
std::wstring ToDevice(const std::string& path)
{
  return ToWide(path.rfind("\\\\", 0) == 0 ? path : "\\\\.\\" + path);
}

HANDLE OpenAlone(const std::string& path)
{
  return CreateFileW(ToDevice(path).c_str(), GENERIC_READ | GENERIC_WRITE, 0, nullptr,
    OPEN_EXISTING, FILE_FLAG_OVERLAPPED, nullptr);
}

std::string Explain(DWORD fault)
{
  switch (fault)
  {
    case ERROR_ACCESS_DENIED:
    case ERROR_SHARING_VIOLATION:
      return "in use by another program or device. Close it there.";
    case ERROR_FILE_NOT_FOUND:
    case ERROR_PATH_NOT_FOUND:
      return "not plugged in. Plug it in, or give the port that it has.";
    case ERROR_INVALID_FUNCTION:
      return "not a serial port. Give the board's port, such as COM3.";
    default:
      return "can't be opened: " + DescribeWindowsError(fault) + ".";
  }
}

/**
 * Waits at most `time` (ms) for an operation. Returns its number of bytes, or a negative number on
 * failure.
 */
int Finish(HANDLE port, OVERLAPPED& operation, bool isDone, int time) noexcept
{
  DWORD size = 0;
  if (!isDone && GetLastError() != ERROR_IO_PENDING)
  {
    return -1;
  }
  if (WaitForSingleObject(operation.hEvent, static_cast<DWORD>(time)) != WAIT_OBJECT_0)
  {
    CancelIoEx(port, &operation);
  }
  const bool isGood = GetOverlappedResult(port, &operation, &size, TRUE) != FALSE;
  return isGood || GetLastError() == ERROR_OPERATION_ABORTED ? static_cast<int>(size) : -1;
}

} // namespace

bool SerialPort::IsPath(const std::string& path)
{
  return path.rfind("COM", 0) == 0 || path.rfind("\\\\.\\", 0) == 0;
}

bool SerialPort::IsThere(const std::string& path)
{
  wchar_t target[512];
  const std::string name = path.rfind("\\\\.\\", 0) == 0 ? path.substr(4) : path;
  return QueryDosDeviceW(ToWide(name).c_str(), target, sizeof(target) / sizeof(target[0])) != 0;
}

std::vector<SerialPortInfo> SerialPort::List(const std::string& word, const std::string&)
{
  std::vector<SerialPortInfo> ports;
  const HDEVINFO devices =
    SetupDiGetClassDevsW(&GUID_DEVCLASS_PORTS, nullptr, nullptr, DIGCF_PRESENT);
  if (devices == INVALID_HANDLE_VALUE)
  {
    return ports;
  }
  SP_DEVINFO_DATA device{};
  device.cbSize = sizeof(device);
  for (DWORD i = 0; SetupDiEnumDeviceInfo(devices, i, &device); ++i)
  {
    const std::string path = GetPortName(devices, device);
    const std::string name = GetBoardName(devices, device);
    if (path.rfind("COM", 0) == 0 && !name.empty() && name.find(word) != std::string::npos)
    {
      ports.push_back({ path, name });
    }
  }
  SetupDiDestroyDeviceInfoList(devices);
  std::sort(ports.begin(), ports.end(),
    [](const SerialPortInfo& a, const SerialPortInfo& b) { return a.Name < b.Name; });
  return ports;
}

std::string SerialPort::NameOf(const std::string& path, const std::string& folder)
{
  for (const SerialPortInfo& port : List("", folder))
  {
    if (port.Path == path)
    {
      return port.Name;
    }
  }
  return {};
}

std::string SerialPort::StateOf(const std::string& path)
{
  const HANDLE port = OpenAlone(path);
  if (port == INVALID_HANDLE_VALUE)
  {
    const DWORD fault = GetLastError();
    return fault == ERROR_ACCESS_DENIED ? "in use" : Explain(fault);
  }
  CloseHandle(port);
  return "available";
}

bool SerialPort::Open(const std::string& path, std::string& error)
{
  this->Close();
  const HANDLE port = OpenAlone(path);
  if (port == INVALID_HANDLE_VALUE)
  {
    error = path + ": " + Explain(GetLastError());
    return false;
  }
  this->Descriptor = reinterpret_cast<std::intptr_t>(port);
  DCB settings{};
  settings.DCBlength = sizeof(settings);
  bool isSet = GetCommState(port, &settings) != FALSE;
  settings.BaudRate = CBR_115200;
  settings.ByteSize = 8;
  settings.Parity = NOPARITY;
  settings.StopBits = ONESTOPBIT;
  settings.fBinary = TRUE;
  settings.fParity = FALSE;
  settings.fOutxCtsFlow = settings.fOutxDsrFlow = FALSE;
  settings.fOutX = settings.fInX = FALSE;
  settings.fNull = settings.fErrorChar = settings.fAbortOnError = FALSE;
  settings.fDsrSensitivity = FALSE;
  settings.fDtrControl = DTR_CONTROL_ENABLE; // boards send nothing unless DTR is set
  settings.fRtsControl = RTS_CONTROL_ENABLE;
  // Let a read return as soon as the first bytes arrive.
  COMMTIMEOUTS times{};
  times.ReadIntervalTimeout = MAXDWORD;
  times.ReadTotalTimeoutMultiplier = MAXDWORD;
  times.ReadTotalTimeoutConstant = MAXDWORD - 1;
  isSet = isSet && SetCommState(port, &settings) && SetCommTimeouts(port, &times);
  if (!isSet)
  {
    error =
      path + ": can't be set up as a serial port: " + DescribeWindowsError(GetLastError()) + ".";
    this->Close();
    return false;
  }
  PurgeComm(port, PURGE_RXCLEAR | PURGE_TXCLEAR);
  return true;
}

void SerialPort::Close() noexcept
{
  if (this->Descriptor != Closed)
  {
    CloseHandle(reinterpret_cast<HANDLE>(this->Descriptor));
    this->Descriptor = Closed;
  }
}

bool SerialPort::Write(const char* bytes, std::size_t size, int time) noexcept
{
  const auto port = reinterpret_cast<HANDLE>(this->Descriptor);
  const WindowsHandle event(CreateEventW(nullptr, TRUE, FALSE, nullptr));
  while (size > 0)
  {
    OVERLAPPED operation{};
    operation.hEvent = event.Get();
    const bool isDone =
      WriteFile(port, bytes, static_cast<DWORD>(size), nullptr, &operation) != FALSE;
    const int written = Finish(port, operation, isDone, time);
    if (written <= 0)
    {
      return false;
    }
    bytes += written;
    size -= static_cast<std::size_t>(written);
  }
  return true;
}

int SerialPort::Read(char* bytes, std::size_t size, int time) noexcept
{
  const auto port = reinterpret_cast<HANDLE>(this->Descriptor);
  const WindowsHandle event(CreateEventW(nullptr, TRUE, FALSE, nullptr));
  OVERLAPPED operation{};
  operation.hEvent = event.Get();
  const bool isDone = ReadFile(port, bytes, static_cast<DWORD>(size), nullptr, &operation) != FALSE;
  return Finish(port, operation, isDone, time);
}

void SerialPort::Drain() noexcept
{
  PurgeComm(reinterpret_cast<HANDLE>(this->Descriptor), PURGE_RXCLEAR);
}

} // namespace VolumeHaptics
#endif
