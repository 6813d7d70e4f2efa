# SPDX-License-Identifier: GPL-3.0-or-later
# cmake -DSOURCE=… -DTEMPLATE=… -DOUTPUT=… -P WriteCommit.cmake
# Writes TEMPLATE as OUTPUT with what the program is built from as TOILE_COMMIT: the commit; where something of the
# program differs from it, "-dirty-" and a few digits that stand for the difference; nothing where that is unknown.
# OUTPUT stays untouched while this stays the same: nothing is compiled again.
set(program app core samples cmake CMakeLists.txt)
find_program(git git)
function(said variable)
    execute_process(COMMAND ${git} ${ARGN} WORKING_DIRECTORY ${SOURCE}
                    OUTPUT_VARIABLE text RESULT_VARIABLE failed OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
    if(failed)
        set(text "")
    endif()
    set(${variable} "${text}" PARENT_SCOPE)
endfunction()

set(TOILE_COMMIT "")
if(git AND EXISTS ${SOURCE}/.git) # not that of a repository further up
    said(TOILE_COMMIT rev-parse --short HEAD)
    said(difference diff --binary HEAD -- ${program})
    said(others -c core.quotePath=false ls-files --others --exclude-standard -- ${program})
    string(REPLACE "\n" ";" others "${others}")
    foreach(file IN LISTS others)
        if(EXISTS ${SOURCE}/${file})
            file(SHA256 ${SOURCE}/${file} hash)
            string(APPEND difference "${file} ${hash}\n")
        endif()
    endforeach()
    if(NOT difference STREQUAL "")
        string(SHA256 hash "${difference}")
        string(SUBSTRING ${hash} 0 8 hash)
        string(APPEND TOILE_COMMIT "-dirty-${hash}")
    endif()
endif()
configure_file(${TEMPLATE} ${OUTPUT} @ONLY)
