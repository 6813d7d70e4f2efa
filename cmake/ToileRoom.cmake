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

# toile_tests(ROOM [COMMON header] [LINKS library...] [DEPENDS target...] [ALONE test...])
# Every tst_<Unit>.cpp of the folder ROOM is a test of that name, labelled with the room: `ctest -L ROOM`. They are one
# program, tests/ROOM of the build, that is told the test's name: headers are parsed, templates made and libraries linked
# once for many. The target `tests_ROOM` builds it. What a test does to its whole program others are kept from if it is
# ALONE. Where files are compiled one by one, a COMMON header is what most of them include.
function(toile_tests room)
    cmake_parse_arguments(TESTS "" "COMMON" "LINKS;DEPENDS;ALONE" ${ARGN})
    file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${room}/tst_*.cpp)
    foreach(test IN LISTS TESTS_ALONE)
        set(source ${CMAKE_CURRENT_SOURCE_DIR}/${room}/${test}.cpp)
        list(REMOVE_ITEM sources ${source})
        toile_test_program(${test} ${test} ${source})
    endforeach()
    toile_test_program(tests_${room} ${room} ${sources})
    if(TESTS_ALONE)
        add_dependencies(tests_${room} ${TESTS_ALONE})
    endif()
endfunction()

# toile_test_program(TARGET NAME source...)
# One program of the room whose toile_tests() calls this.
function(toile_test_program target name)
    add_executable(${target} ${ARGN})
    set_target_properties(${target} PROPERTIES OUTPUT_NAME ${name} RUNTIME_OUTPUT_DIRECTORY ${CMAKE_BINARY_DIR}/tests)
    target_include_directories(${target} PRIVATE ${CMAKE_CURRENT_BINARY_DIR})
    target_link_libraries(${target} PRIVATE toile_options ${TESTS_LINKS} toile_suite)
    if(NOT CMAKE_UNITY_BUILD)
        list(TRANSFORM TESTS_COMMON PREPEND ${CMAKE_SOURCE_DIR}/)
        target_precompile_headers(${target} PRIVATE <QTest> <algorithm> <array> <cmath> <filesystem> <functional>
            <map> <memory> <optional> <set> <span> <string> <variant> <vector> ${TESTS_COMMON})
    endif()
    if(TESTS_DEPENDS)
        add_dependencies(${target} ${TESTS_DEPENDS})
    endif()
    foreach(source IN LISTS ARGN)
        get_filename_component(test ${source} NAME_WE)
        # The one file has the one class: AUTOMOC would compile another for every program.
        set(moc ${CMAKE_CURRENT_BINARY_DIR}/${test}.moc)
        qt_generate_moc(${source} ${moc})
        target_sources(${target} PRIVATE ${moc})
        add_test(NAME ${test} COMMAND ${target} ${test})
        # Qt's watchdog shows where a test hangs, shortly before ctest ends it. Left to itself it ends a test after 300 s,
        # and that of Qt 6.4 can miss that one function has ended and the next begun.
        set_tests_properties(${test} PROPERTIES LABELS ${room} TIMEOUT 900
            ENVIRONMENT "QTEST_FUNCTION_TIMEOUT=840000;QT_QPA_PLATFORM=offscreen;TOILE_SOURCE_DIR=${CMAKE_SOURCE_DIR};TOILE_BINARY_DIR=${CMAKE_BINARY_DIR};${TOILE_TEST_KERNELS}")
    endforeach()
endfunction()
