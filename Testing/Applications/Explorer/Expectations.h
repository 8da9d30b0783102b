// SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
// SPDX-License-Identifier: BSD-3-Clause

/**
 * Counts the failures of an explorer test, since VTK's test driver has no means for this, and
 * stores the folder for the test's files.
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

/// Writes a text file into the test's folder and returns its path.
inline std::string WriteText(const std::string& name, const std::string& content)
{
  const std::string path = folder + "/" + name;
  vtksys::ofstream(path.c_str()) << content;
  return path;
}

#endif
