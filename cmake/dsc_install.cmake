# SPDX-License-Identifier: GPL-3.0-or-later
# Installation: libraries, headers under include/dsc, programs, and a package for find_package(dsc) with the targets
# dsc::core, dsc::io, ...
include_guard()
include(CMakePackageConfigHelpers)

get_property(libraries GLOBAL PROPERTY DSC_LIBRARIES)
get_property(programs GLOBAL PROPERTY DSC_PROGRAMS)
set(package_folder "${CMAKE_INSTALL_LIBDIR}/cmake/dsc")

install(TARGETS dsc_compile_options ${libraries} EXPORT dsc_targets ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}")
install(EXPORT dsc_targets NAMESPACE dsc:: FILE dsc_targets.cmake DESTINATION "${package_folder}")
if(programs)
  install(TARGETS ${programs} RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}")
endif()
foreach(folder core geometry io surface motion dsc2d dsc3d geodesic fluid apps)
  install(DIRECTORY "${PROJECT_SOURCE_DIR}/${folder}" DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/dsc"
          FILES_MATCHING PATTERN "*.h" PATTERN "assets.h" EXCLUDE)
endforeach()
install(FILES "${PROJECT_SOURCE_DIR}/LICENSE" DESTINATION "${CMAKE_INSTALL_DOCDIR}")

configure_package_config_file("${PROJECT_SOURCE_DIR}/cmake/dsc_config.cmake.in" "${PROJECT_BINARY_DIR}/dscConfig.cmake"
                              INSTALL_DESTINATION "${package_folder}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/dscConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/dscConfig.cmake" "${PROJECT_BINARY_DIR}/dscConfigVersion.cmake"
        DESTINATION "${package_folder}")
