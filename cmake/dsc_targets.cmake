# SPDX-License-Identifier: GPL-3.0-or-later
# How every target of the project is declared: one place for the language standard, the warnings, the sanitizers and
# the floating-point rules.
include_guard()

if(NOT CMAKE_BUILD_TYPE AND NOT CMAKE_CONFIGURATION_TYPES)
  set(CMAKE_BUILD_TYPE Release CACHE STRING "Debug, Release or RelWithDebInfo" FORCE)
endif()

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  # Precompiled headers can be cached only when ccache is told to trust them.
  set(CMAKE_CXX_COMPILER_LAUNCHER "${CMAKE_COMMAND};-E;env;CCACHE_SLOPPINESS=pch_defines,time_macros;${CCACHE_PROGRAM}")
  set(CMAKE_CXX_FLAGS "${CMAKE_CXX_FLAGS} -fpch-preprocess")
endif()

add_library(dsc_compile_options INTERFACE)
target_compile_features(dsc_compile_options INTERFACE cxx_std_20)
# Same input, same bits: no contraction into fused multiply-add, no fast-math.
target_compile_options(dsc_compile_options INTERFACE -ffp-contract=off)
add_library(dsc_warnings INTERFACE)
target_compile_options(dsc_warnings INTERFACE -Wall -Wextra -Wpedantic -Wnon-virtual-dtor -Woverloaded-virtual)
# In a unity build a source has the names of its neighbours around it, and is not the main file whose unnamed namespace
# GCC knows to be of no concern to others.
if(CMAKE_UNITY_BUILD)
  target_compile_options(dsc_warnings INTERFACE $<$<CXX_COMPILER_ID:GNU>:-Wshadow=local -Wno-subobject-linkage>)
else()
  target_compile_options(dsc_warnings INTERFACE -Wshadow)
endif()
# Designated initializers leave members at their defaults on purpose. GCC 12 sees an overlap in `"text" + std::string`
# that isn't there (GCC bug 105651).
target_compile_options(dsc_warnings INTERFACE -Wno-missing-field-initializers
                                              $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict -Wno-maybe-uninitialized>)
if(DSC_CHECKED)
  target_compile_definitions(dsc_compile_options INTERFACE DSC_CHECKED)
endif()
if(DSC_SANITIZE)
  # Five checks of undefined behaviour stand before every access through a reference: without them a test compiles in
  # two thirds of the time. What is given up: the address sanitizer sees a null or stray access when it happens, but
  # not one that stays within the same allocation, nor an address that overflows and is never used. x86-64 does not
  # ask for alignment, and no class is cast down unchecked (a test gets a metric back from a void pointer).
  target_compile_options(dsc_compile_options INTERFACE
    -fsanitize=address,undefined -fno-sanitize=alignment,null,object-size,pointer-overflow,vptr
    -fno-sanitize-recover=all -fno-omit-frame-pointer)
  target_link_options(dsc_compile_options INTERFACE -fsanitize=address,undefined)
endif()

# dsc_library(NAME SOURCES ... [LINKS public targets] [PRIVATE_LINKS targets behind the .cpp wall]):
# a static library dsc_NAME with the alias dsc::NAME, whose headers are included from the repository root.
function(dsc_library name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS;PRIVATE_LINKS" ${ARGN})
  add_library(dsc_${name} STATIC ${ARG_SOURCES})
  add_library(dsc::${name} ALIAS dsc_${name})
  set_target_properties(dsc_${name} PROPERTIES EXPORT_NAME ${name} POSITION_INDEPENDENT_CODE ON)
  target_include_directories(dsc_${name} PUBLIC "$<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>"
                                                "$<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/dsc>")
  target_link_libraries(dsc_${name} PUBLIC dsc_compile_options ${ARG_LINKS}
                                    PRIVATE "$<BUILD_INTERFACE:dsc_warnings>" ${ARG_PRIVATE_LINKS})
  if("${ARG_PRIVATE_LINKS}" MATCHES "CGAL::CGAL")
    target_precompile_headers(dsc_${name} REUSE_FROM dsc_cgal_library_headers)
  else()
    target_precompile_headers(dsc_${name} REUSE_FROM dsc_library_headers)
  endif()
  set_property(GLOBAL APPEND PROPERTY DSC_LIBRARIES dsc_${name})
endfunction()

# dsc_program(NAME SOURCES ... LINKS ...): an executable NAME in build/bin.
function(dsc_program name)
  cmake_parse_arguments(ARG "" "" "SOURCES;LINKS" ${ARGN})
  add_executable(${name} ${ARG_SOURCES})
  target_link_libraries(${name} PRIVATE dsc_compile_options dsc_warnings ${ARG_LINKS})
  set_target_properties(${name} PROPERTIES RUNTIME_OUTPUT_DIRECTORY "${PROJECT_BINARY_DIR}/bin")
  set_property(GLOBAL APPEND PROPERTY DSC_PROGRAMS ${name})
endfunction()
