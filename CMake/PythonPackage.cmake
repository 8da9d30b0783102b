# SPDX-FileCopyrightText: Copyright (c) VTK Volume Haptics contributors
# SPDX-License-Identifier: BSD-3-Clause

# The Python package volumehaptics, usable from the build tree and from the install tree. VolumeHaptics_PYTHON_SITE,
# which must be set before, is the package's folder relative to either tree.
if (NOT DEFINED VolumeHaptics_PYTHON_SITE)
  vtk_module_python_default_destination(VolumeHaptics_PYTHON_SITE MAJOR_VERSION 3)
endif ()
set(python_options)
if (SKBUILD)
  # the suffix names the Python version and platform that the file is built for
  set(python_options SOABI "${Python3_SOABI}")
endif ()
set(CMAKE_UNITY_BUILD ON)  # also for the generated wrappers
vtk_module_wrap_python(
  MODULES             ${modules}
  TARGET              VolumeHaptics::PythonWrapped
  INSTALL_EXPORT      VolumeHapticsPython
  PYTHON_PACKAGE      "volumehaptics"
  MODULE_DESTINATION  "${VolumeHaptics_PYTHON_SITE}"
  LIBRARY_DESTINATION "${CMAKE_INSTALL_LIBDIR}"
  BUILD_STATIC        OFF
  INSTALL_HEADERS     OFF  # headers are needed only by projects that wrap subclasses of these classes
  ${python_options})
unset(CMAKE_UNITY_BUILD)

# Copy the parts that are written in Python beside the wrapped classes: the package, the head for its examples, and type
# hints.
get_filename_component(root "${CMAKE_CURRENT_LIST_DIR}" DIRECTORY)
set(package_source "${root}/Module/Python/volumehaptics")
set(package "${CMAKE_BINARY_DIR}/${VolumeHaptics_PYTHON_SITE}/volumehaptics")
set(python_destination "${VolumeHaptics_PYTHON_SITE}/volumehaptics")
configure_file("${package_source}/_version.py.in" "${package}/_version.py" @ONLY)
install(FILES "${package}/_version.py" DESTINATION "${python_destination}" COMPONENT python)

set(package_files)
foreach (file IN ITEMS
    __init__.py
    __main__.py
    _files.py
    _grids.py
    _hosts.py
    _identify.py
    _inspect.py
    _labels.py
    _large.py
    _paths.py
    _plotting.py
    _qt.py
    _tools.py
    _touch.py
    _trame.py
    _webdoor.py
    _webview.py
    arrays.py
    data/HeadPhantom.vti
    data/README.txt
    examples.py
    py.typed
    pyvista.py
    web.py)
  set(source "${package_source}/${file}")
  if (file MATCHES "vti$") # stored with the repository's other data
    set(source "${root}/Data/HeadPhantom.vti")
  endif ()
  add_custom_command(
    OUTPUT  "${package}/${file}"
    COMMAND "${CMAKE_COMMAND}" -E copy "${source}" "${package}/${file}"
    DEPENDS "${source}"
    COMMENT "Copying ${file} into the Python package")
  list(APPEND package_files "${package}/${file}")
  get_filename_component(folder "${python_destination}/${file}" DIRECTORY)
  install(FILES "${source}" DESTINATION "${folder}" COMPONENT python)
endforeach ()

# VTK's generator of type hints imports the classes. With sanitizers this fails, because the interpreter is not
# instrumented.
execute_process(
  COMMAND         "${Python3_EXECUTABLE}" -c "import vtkmodules.generate_pyi"
  RESULT_VARIABLE no_generator
  OUTPUT_QUIET ERROR_QUIET)
if (no_generator OR VolumeHaptics_SANITIZE)
  message(STATUS "No type hints of the classes: they need vtkmodules.generate_pyi, and a build without sanitizers")
else ()
  set(preload)
  if (SKBUILD) # the libraries beside the package are those of VTK only once it is installed
    set(preload "import vtkmodules.all; ")
  endif ()
  string(CONCAT generate
    "${preload}import sys; sys.path.insert(0, sys.argv[1]); from vtkmodules import generate_pyi; "
    "sys.exit(generate_pyi.main(['', '-p', 'volumehaptics', '-o', sys.argv[2], 'vtkVolumeHaptics']))")
  add_custom_command(
    OUTPUT  "${package}/vtkVolumeHaptics.pyi"
    COMMAND "${Python3_EXECUTABLE}" -B -c "${generate}"
            "${CMAKE_BINARY_DIR}/${VolumeHaptics_PYTHON_SITE}" "${package}"
    DEPENDS vtkVolumeHapticsPython ${package_files}
    COMMENT "Generating type hints of the Python package"
    VERBATIM)
  list(APPEND package_files "${package}/vtkVolumeHaptics.pyi")
  install(FILES "${package}/vtkVolumeHaptics.pyi" DESTINATION "${python_destination}" COMPONENT python)
endif ()
add_custom_target(VolumeHapticsPythonPackage ALL DEPENDS ${package_files})
