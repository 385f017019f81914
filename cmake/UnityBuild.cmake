# Unity builds: several sources compiled as one, which parses their headers and instantiates their
# templates once. CMake can batch sources by itself, but two files may each have a kGroup of their
# own in an anonymous namespace; so the batches are made here, of sources that share no such name.
# A name that is added later and clashes is a compile error that goes away when CMake runs again.
#
# MACULA_UNITY=OFF (the dev preset) compiles every source alone and so finds what is missing among
# the includes of a file; so does clang-tidy in tools/check.sh.

# Sets OUT to the last words of declarations.
function(macula_declared DECLARATIONS OUT)
  list(TRANSFORM DECLARATIONS REPLACE "[ (=]+$" "")
  list(TRANSFORM DECLARATIONS REPLACE "^.*[ &*:]" "")
  list(REMOVE_DUPLICATES DECLARATIONS)
  list(REMOVE_ITEM DECLARATIONS "")
  set(${OUT} "${DECLARATIONS}" PARENT_SCOPE)
endfunction()

# Sets OUT to the names that a source or its header declares (constants, types, functions, aliases),
# and LOCAL to the constants of its functions, which must not hide another source's.
function(macula_own_names SOURCE OUT LOCAL)
  file(READ ${SOURCE} TEXT)
  string(REGEX REPLACE "\\.cpp$" ".h" HEADER ${SOURCE})
  if(EXISTS ${HEADER})
    file(READ ${HEADER} DECLARED)
    string(APPEND TEXT "${DECLARED}")
  endif()
  string(REPLACE "[[nodiscard]] " "" TEXT "${TEXT}")
  set(CONSTANT "(static |inline )?(constexpr|const) [^]=;\n{([]+")
  string(REGEX MATCHALL "\n${CONSTANT}" CONSTANTS "${TEXT}")
  string(REGEX MATCHALL "\n((struct|class|enum class|enum) [A-Za-z0-9_:]+|using [A-Za-z0-9_]+ =)"
    TYPES "${TEXT}")
  string(REGEX MATCHALL "\n[A-Za-z][A-Za-z0-9_:<>,&* ]*[ &*][a-z][A-Za-z0-9]*\\("
    FUNCTIONS "${TEXT}")
  macula_declared("${CONSTANTS};${TYPES};${FUNCTIONS}" NAMES)
  string(REGEX MATCHALL "\n +${CONSTANT}" CONSTANTS "${TEXT}")
  list(FILTER CONSTANTS INCLUDE REGEX " k[A-Z]")
  macula_declared("${CONSTANTS}" INNER)
  set(${OUT} "${NAMES}" PARENT_SCOPE)
  set(${LOCAL} "${INNER}" PARENT_SCOPE)
endfunction()

# Sets OUT to whether two lists have an element in common.
function(macula_meet FIRST SECOND OUT)
  set(${OUT} FALSE PARENT_SCOPE)
  foreach(NAME IN LISTS FIRST)
    if(NAME IN_LIST SECOND)
      set(${OUT} TRUE PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

# macula_unity(TARGET BATCH): compiles up to BATCH sources of the target as one.
function(macula_unity TARGET BATCH)
  if(NOT MACULA_UNITY)
    return()
  endif()
  get_target_property(SOURCES ${TARGET} SOURCES)
  set(GROUPS 0)
  foreach(SOURCE IN LISTS SOURCES)
    get_filename_component(FILE ${SOURCE} ABSOLUTE)
    macula_own_names(${FILE} NAMES LOCAL)
    set(GROUP 0)
    while(TRUE)
      math(EXPR GROUP "${GROUP} + 1")
      if(GROUP GREATER GROUPS)
        set(GROUPS ${GROUP})
        set(SIZE_${GROUP} 0)
        set(NAMES_${GROUP} "")
        set(LOCAL_${GROUP} "")
      endif()
      if(SIZE_${GROUP} LESS BATCH)
        macula_meet("${NAMES}" "${NAMES_${GROUP}}" CLASH)
        macula_meet("${LOCAL}" "${NAMES_${GROUP}}" HIDES)
        macula_meet("${NAMES}" "${LOCAL_${GROUP}}" HIDDEN)
        if(NOT CLASH AND NOT HIDES AND NOT HIDDEN)
          break()
        endif()
      endif()
    endwhile()
    list(APPEND NAMES_${GROUP} ${NAMES})
    list(APPEND LOCAL_${GROUP} ${LOCAL})
    math(EXPR SIZE_${GROUP} "${SIZE_${GROUP}} + 1")
    set_source_files_properties(${SOURCE} PROPERTIES UNITY_GROUP ${GROUP})
  endforeach()
  set_target_properties(${TARGET} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()
