// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file
 * Includes <windows.h> without its macros min and max, and converts texts from and to UTF-8.
 */
#ifndef WindowsApi_h
#define WindowsApi_h

#if defined(_WIN32)
#ifndef NOMINMAX
#define NOMINMAX
#endif
#ifndef WIN32_LEAN_AND_MEAN
#define WIN32_LEAN_AND_MEAN
#endif
#include <windows.h>

#include <string>

namespace VolumeHaptics
{

inline std::wstring ToWide(const std::string& text)
{
  const int size = static_cast<int>(text.size());
  std::wstring wide(
    static_cast<std::size_t>(MultiByteToWideChar(CP_UTF8, 0, text.data(), size, nullptr, 0)),
    L'\0');
  MultiByteToWideChar(CP_UTF8, 0, text.data(), size, wide.data(), static_cast<int>(wide.size()));
  return wide;
}

inline std::string FromWide(const std::wstring& wide)
{
  const int size = static_cast<int>(wide.size());
  std::string text(static_cast<std::size_t>(WideCharToMultiByte(
                     CP_UTF8, 0, wide.data(), size, nullptr, 0, nullptr, nullptr)),
    '\0');
  WideCharToMultiByte(
    CP_UTF8, 0, wide.data(), size, text.data(), static_cast<int>(text.size()), nullptr, nullptr);
  return text;
}

/** A handle that the destructor closes. */
class WindowsHandle
{
public:
  explicit WindowsHandle(HANDLE handle = nullptr) noexcept
    : Value(handle == INVALID_HANDLE_VALUE ? nullptr : handle)
  {
  }
  ~WindowsHandle() { this->Reset(); }
  WindowsHandle(const WindowsHandle&) = delete;
  WindowsHandle& operator=(const WindowsHandle&) = delete;

  HANDLE Get() const noexcept { return this->Value; }
  void Reset(HANDLE handle = nullptr) noexcept
  {
    if (this->Value)
    {
      CloseHandle(this->Value);
    }
    this->Value = handle == INVALID_HANDLE_VALUE ? nullptr : handle;
  }

private:
  HANDLE Value;
};

/** Describes an error number of GetLastError(). */
inline std::string DescribeWindowsError(DWORD number)
{
  wchar_t text[512];
  const DWORD size = FormatMessageW(FORMAT_MESSAGE_FROM_SYSTEM | FORMAT_MESSAGE_IGNORE_INSERTS,
    nullptr, number, 0, text, sizeof(text) / sizeof(text[0]), nullptr);
  std::string described = FromWide(std::wstring(text, size));
  while (!described.empty() && std::string(" .\r\n").find(described.back()) != std::string::npos)
  {
    described.pop_back();
  }
  return described.empty() ? "error " + std::to_string(number) : described;
}

} // namespace VolumeHaptics

#endif
#endif
