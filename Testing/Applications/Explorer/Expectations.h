// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * The failures of a test of the explorer so far, which a program of VTK's test driver has no other
 * way to report, and the folder in which it writes.
 */
#ifndef Expectations_h
#define Expectations_h

#include <vtksys/FStream.hxx>

#include <iostream>
#include <string>

inline int failures = 0;
inline std::string folder;

inline void Expect(bool condition, const std::string& what)
{
  if (!condition)
  {
    std::cerr << "Not so: " << what << "\n";
    ++failures;
  }
}

/// In the folder; gives its path.
inline std::string WriteText(const std::string& name, const std::string& content)
{
  const std::string path = folder + "/" + name;
  vtksys::ofstream(path.c_str()) << content;
  return path;
}

#endif
