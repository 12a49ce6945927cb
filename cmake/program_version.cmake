# Writes OUTPUT, the source file that says which program this is: VERSION, and the commit of the sources in SOURCE_DIR.
# Run at every build, so that no commit is stale; the file changes only where its text does.
find_package(Git QUIET)
set(commit unknown)
if(GIT_FOUND)
    execute_process(COMMAND ${GIT_EXECUTABLE} describe --always --dirty=-changed --abbrev=12 --exclude=*
        WORKING_DIRECTORY ${SOURCE_DIR} OUTPUT_VARIABLE described OUTPUT_STRIP_TRAILING_WHITESPACE
        ERROR_QUIET RESULT_VARIABLE failed)
    if(failed EQUAL 0)
        set(commit ${described})
    endif()
endif()
file(CONFIGURE OUTPUT ${OUTPUT} @ONLY CONTENT [[
#include "chapters/terminal/program_version.h"

namespace crevice {

ProgramVersion program_version() { return {"@VERSION@", "@commit@"}; }

}  // namespace crevice
]])
