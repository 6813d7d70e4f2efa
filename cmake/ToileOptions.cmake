# SPDX-License-Identifier: GPL-3.0-or-later
# The language, the warnings and the sanitizers that every target of ours shares.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
set(CMAKE_RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/bin)

find_program(CCACHE_PROGRAM ccache)
if(CCACHE_PROGRAM AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CCACHE_PROGRAM})
endif()

# Programs are linked anew after every change: gold, of the same package as the default linker, takes a third of its time.
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold TOILE_HAS_GOLD)
if(TOILE_HAS_GOLD)
    add_link_options(-fuse-ld=gold)
endif()

# Presets for tests compile the files of a room ten at a time, and those of its tests, which parses headers and makes
# templates once for all: a third of the time. What is local to a file must so have a name of its own among them. Two
# warnings take such a local thing for a header's. The release preset compiles every file alone, with all warnings.
set(CMAKE_UNITY_BUILD_BATCH_SIZE 10)
add_library(toile_options INTERFACE)
target_include_directories(toile_options INTERFACE $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}>
                           $<INSTALL_INTERFACE:include/toile>)
target_compile_features(toile_options INTERFACE cxx_std_20)
# Designated initializers leave fields at their defaults; GCC 12 sees ghosts in std::variant and std::string.
target_compile_options(toile_options INTERFACE
    "$<BUILD_INTERFACE:-Wall;-Wextra;-Wpedantic;-Wshadow;-Werror;-Wno-missing-field-initializers;-Wno-maybe-uninitialized;-Wno-restrict>")
if(CMAKE_UNITY_BUILD)
    target_compile_options(toile_options INTERFACE -Wno-shadow -Wno-subobject-linkage)
endif()
# Fused multiply-add would make results depend on the processor and exact predicates wrong.
target_compile_options(toile_options INTERFACE $<BUILD_INTERFACE:-ffp-contract=off>)
# FCL and we must agree on the alignment of Eigen's types whatever flags a build adds.
target_compile_definitions(toile_options INTERFACE $<BUILD_INTERFACE:EIGEN_MAX_ALIGN_BYTES=16>)

if(TOILE_SANITIZE)
    target_compile_options(toile_options INTERFACE -fsanitize=${TOILE_SANITIZE} -fno-omit-frame-pointer)
    target_link_options(toile_options INTERFACE -fsanitize=${TOILE_SANITIZE})
    if(TOILE_SANITIZE MATCHES "undefined")
        # A null pointer that is used ends in the address sanitizer; these two checks take two fifths of the build.
        target_compile_options(toile_options INTERFACE -fno-sanitize-recover=undefined
                               -fno-sanitize=null,alignment)
    endif()
endif()
