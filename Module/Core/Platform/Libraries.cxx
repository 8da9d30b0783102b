// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause
#include "Core/Platform/Libraries.h"

#if defined(_WIN32)
#include "Core/Platform/WindowsApi.h"
#else
#include <dlfcn.h>
#endif
#if defined(__APPLE__)
#include <mach-o/dyld.h>
#endif

namespace VolumeHaptics
{
namespace Libraries
{

#if defined(_WIN32)

namespace
{
std::string GetModulePath(HMODULE module)
{
  std::wstring path(MAX_PATH, L'\0');
  DWORD size = 0;
  while ((size = GetModuleFileNameW(module, path.data(), static_cast<DWORD>(path.size()))) ==
    path.size())
  {
    path.resize(2 * path.size());
  }
  path.resize(size);
  return FromWide(path);
}
} // namespace

void* Load(const std::string& path, std::string& error)
{
  const HMODULE library = LoadLibraryExW(ToWide(path).c_str(), nullptr,
    LOAD_LIBRARY_SEARCH_DLL_LOAD_DIR | LOAD_LIBRARY_SEARCH_DEFAULT_DIRS);
  if (!library)
  {
    error = DescribeWindowsError(GetLastError());
  }
  return reinterpret_cast<void*>(library);
}

void* Find(void* library, const char* name)
{
  return reinterpret_cast<void*>(GetProcAddress(static_cast<HMODULE>(library), name));
}

std::string FindFileOf(const void* code)
{
  HMODULE module = nullptr;
  const bool isFound = GetModuleHandleExW(GET_MODULE_HANDLE_EX_FLAG_FROM_ADDRESS |
                           GET_MODULE_HANDLE_EX_FLAG_UNCHANGED_REFCOUNT,
                         static_cast<LPCWSTR>(code), &module) != FALSE;
  return isFound ? GetModulePath(module) : std::string();
}

std::string FindOwnProgram()
{
  return GetModulePath(nullptr);
}

#else

void* Load(const std::string& path, std::string& error)
{
  void* const library = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library)
  {
    const char* const reason = dlerror();
    error = reason ? reason : "no reason is given";
  }
  return library;
}

void* Find(void* library, const char* name)
{
  return dlsym(library, name);
}

std::string FindFileOf(const void* code)
{
  Dl_info info{};
  return dladdr(code, &info) != 0 && info.dli_fname ? info.dli_fname : "";
}

std::string FindOwnProgram()
{
#if defined(__APPLE__)
  char path[4096];
  std::uint32_t size = sizeof(path);
  return _NSGetExecutablePath(path, &size) == 0 ? path : "";
#else
  return "/proc/self/exe";
#endif
}

#endif

} // namespace Libraries
} // namespace VolumeHaptics
