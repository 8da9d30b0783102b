// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * @file
 * The program volumehaptics-read: reads files for the module. Its argument is the path of the
 * module's library, which it loads. See Core/Platform/ReaderProcess.h.
 */
#include <cstdio>

#include <dlfcn.h>
#include <sys/stat.h>
#include <unistd.h>

int main(int argc, char** argv)
{
  struct stat input = {};
  if (argc != 2 || fstat(STDIN_FILENO, &input) != 0 || !S_ISSOCK(input.st_mode))
  {
    std::fputs("volumehaptics-read reads files for the module, which starts it.\n", stderr);
    return 2;
  }
  void* const library = dlopen(argv[1], RTLD_NOW | RTLD_GLOBAL);
  using Serve = void (*)(int);
  const auto serve =
    library ? reinterpret_cast<Serve>(dlsym(library, "vtkHapticServeReading")) : nullptr;
  if (!serve)
  {
    return 1;
  }
  serve(STDIN_FILENO);
  _exit(0); // skips the libraries' exit handlers, which are not needed
}
