# SPDX-License-Identifier: GPL-3.0-or-later

# toile_room(NAME [LINKS library...])
# One room of core: a folder, a namespace, a static library `toile_NAME`. LINKS are public.
function(toile_room name)
    cmake_parse_arguments(ROOM "" "" "LINKS;PRIVATE_LINKS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp ${CMAKE_CURRENT_SOURCE_DIR}/*.h)
    set(code ${sources})
    list(FILTER code INCLUDE REGEX "\\.cpp$")
    if(NOT code) # headers only
        add_library(toile_${name} INTERFACE)
        target_link_libraries(toile_${name} INTERFACE toile_options ${ROOM_LINKS} ${ROOM_PRIVATE_LINKS})
        return()
    endif()
    add_library(toile_${name} STATIC ${sources})
    target_link_libraries(toile_${name} PUBLIC toile_options ${ROOM_LINKS} PRIVATE ${ROOM_PRIVATE_LINKS})
endfunction()

# OpenBLAS takes other kernels on another kind of processor, and the last bits of a factor are others. Tests, which hold
# figures of the pages against the program, take the same wherever they can.
set(TOILE_TEST_KERNELS)
if(EXISTS /proc/cpuinfo)
    file(STRINGS /proc/cpuinfo avx2 REGEX " avx2" LIMIT_COUNT 1)
    if(avx2)
        set(TOILE_TEST_KERNELS OPENBLAS_CORETYPE=Haswell)
    endif()
endif()

# toile_tests(ROOM [COMMON header] [LINKS library...] [DEPENDS target...])
# Every tst_<Unit>.cpp of the folder ROOM is one QtTest program, labelled with the room: `ctest -L ROOM`. The target
# `tests_ROOM` builds them. Headers of the tests are parsed once for all rooms, or with a COMMON header, which many
# files of the room include, once for the room.
function(toile_tests room)
    cmake_parse_arguments(TESTS "" "COMMON" "LINKS;DEPENDS" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${room}/tst_*.cpp)
    get_property(parsed DIRECTORY PROPERTY TOILE_TEST_HEADERS)
    if(TESTS_COMMON)
        set(TESTS_COMMON ${CMAKE_SOURCE_DIR}/${TESTS_COMMON})
        set(parsed "")
    endif()
    foreach(source IN LISTS sources)
        get_filename_component(test ${source} NAME_WE)
        # The one file has the one class: AUTOMOC would compile another for every test.
        set(moc ${CMAKE_CURRENT_BINARY_DIR}/${test}.moc)
        qt_generate_moc(${source} ${moc})
        add_executable(${test} ${source} ${moc})
        set_target_properties(${test} PROPERTIES RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests UNITY_BUILD OFF)
        target_include_directories(${test} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
        target_link_libraries(${test} PRIVATE toile_options ${TESTS_LINKS} Qt6::Test)
        if(parsed)
            target_precompile_headers(${test} REUSE_FROM ${parsed})
        else()
            set(parsed ${test})
            target_precompile_headers(${test} PRIVATE <QTest> <algorithm> <array> <cmath> <filesystem> <functional>
                <map> <memory> <optional> <set> <span> <string> <variant> <vector>
                ${TESTS_COMMON})
        endif()
        if(TESTS_DEPENDS)
            add_dependencies(${test} ${TESTS_DEPENDS})
        endif()
        add_test(NAME ${test} COMMAND ${test})
        set_tests_properties(${test} PROPERTIES LABELS ${room} TIMEOUT 900
            ENVIRONMENT "QT_QPA_PLATFORM=offscreen;TOILE_SOURCE_DIR=${CMAKE_SOURCE_DIR};TOILE_BINARY_DIR=${CMAKE_BINARY_DIR};${TOILE_TEST_KERNELS}")
        list(APPEND programs ${test})
    endforeach()
    add_custom_target(tests_${room} DEPENDS ${programs})
    if(NOT TESTS_COMMON)
        set_property(DIRECTORY PROPERTY TOILE_TEST_HEADERS ${parsed})
    endif()
endfunction()
