# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# Makes the option VolumeHaptics_USE_NAME, on if the library is found (the variable `found`), and appends the library
# to a list if it is on; an error if it is asked for and not found. `purpose` is the option's text, `package` of Debian.
macro (volume_haptics_use list name found purpose package)
  if (${found})
    option(VolumeHaptics_USE_${name} "${purpose}" ON)
  else ()
    option(VolumeHaptics_USE_${name} "${purpose}" OFF)
  endif ()
  if (VolumeHaptics_USE_${name})
    if (NOT ${found})
      message(FATAL_ERROR "VolumeHaptics_USE_${name} is on, but the library is not found. "
        "Install it (on Debian: apt-get install ${package}), or turn the option off.")
    endif ()
    list(APPEND ${list} ${${name}_LINK_LIBRARIES})
  else ()
    message(STATUS "VolumeHaptics_USE_${name} is off. ${purpose}: apt-get install ${package} (on Debian)")
  endif ()
endmacro ()
