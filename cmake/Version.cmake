# Writes OUTPUT with the commit of SOURCE, only where it changed. Run at every build.
# The commit is git's, with "-dirty" where a tracked file differs from it; in an unpacked archive,
# which has no .git, it is the one that `git archive` wrote into archive_commit.txt.
set(DIGITS 12)
set(COMMIT "unknown")
# Without this, git would answer for a repository that the archive was unpacked inside.
if(EXISTS ${SOURCE}/.git)
  # The owner of the folder may be another than who builds, in a container for example.
  set(GIT git -c safe.directory=* -C ${SOURCE})
  execute_process(COMMAND ${GIT} rev-parse --short=${DIGITS} HEAD
    OUTPUT_VARIABLE HEAD OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET RESULT_VARIABLE FAILED)
  if(NOT FAILED)
    set(COMMIT ${HEAD})
    execute_process(COMMAND ${GIT} status --porcelain --untracked-files=no
      OUTPUT_VARIABLE CHANGES ERROR_QUIET)
    if(CHANGES)
      string(APPEND COMMIT "-dirty")
    endif()
  endif()
else()
  file(READ ${CMAKE_CURRENT_LIST_DIR}/archive_commit.txt ARCHIVED)
  string(STRIP "${ARCHIVED}" ARCHIVED)
  if(ARCHIVED MATCHES "^[0-9a-f]+$")
    string(SUBSTRING ${ARCHIVED} 0 ${DIGITS} COMMIT)
  endif()
endif()
set(TEXT "#pragma once\n#define MACULA_COMMIT \"${COMMIT}\"\n#define MACULA_VERSION \"${VERSION}\"\n")
if(EXISTS ${OUTPUT})
  file(READ ${OUTPUT} OLD)
endif()
if(NOT "${OLD}" STREQUAL "${TEXT}")
  file(WRITE ${OUTPUT} "${TEXT}")
endif()
