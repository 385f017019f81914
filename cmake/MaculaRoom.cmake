# Warnings, sanitizers and the function that makes a library of one folder ("room").

add_library(macula_options INTERFACE)
target_include_directories(macula_options INTERFACE ${PROJECT_SOURCE_DIR}
  ${PROJECT_SOURCE_DIR}/shaders)  # headers that C++ shares with GLSL
target_compile_options(macula_options INTERFACE -Wall -Wextra -Wshadow -Wconversion
  # Contraction into FMA would make CPU mirrors and hashes depend on the machine.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL GNU AND CMAKE_CXX_COMPILER_VERSION VERSION_LESS 13)
  # GCC 12 takes "text" + string for a memcpy onto itself (GCC bug 105329).
  target_compile_options(macula_options INTERFACE -Wno-restrict)
endif()
if(MACULA_WERROR)
  target_compile_options(macula_options INTERFACE -Werror)
endif()
if(MACULA_FUZZ)
  # Coverage of the libraries guides the fuzzer; its main() is linked into the targets alone.
  target_compile_options(macula_options INTERFACE -fsanitize=fuzzer-no-link)
endif()
if(MACULA_UNITY AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
  # It warns of types in anonymous namespaces that a class of an included file uses; every source of
  # a unity build is an included file.
  target_compile_options(macula_options INTERFACE -Wno-subobject-linkage)
endif()
if(MACULA_SANITIZE)
  target_compile_options(macula_options INTERFACE -fsanitize=address,undefined
    -fno-sanitize-recover=undefined -fno-omit-frame-pointer)
  target_link_options(macula_options INTERFACE -fsanitize=address,undefined)
endif()

# Sources of a unity build that are compiled as one. More would leave processors without work and
# make the rebuild after a change long.
set(MACULA_BATCH 12)

# macula_room(NAME SOURCES a.cpp b.cpp DEPENDS room_or_library ...)
# Makes the static library macula_NAME. What is not listed in DEPENDS cannot be linked, so the
# lists of dependencies are the map of which room may use which.
function(macula_room NAME)
  cmake_parse_arguments(ROOM "" "" "SOURCES;DEPENDS" ${ARGN})
  add_library(macula_${NAME} STATIC ${ROOM_SOURCES})
  target_link_libraries(macula_${NAME} PUBLIC macula_options ${ROOM_DEPENDS})
  macula_unity(macula_${NAME} ${MACULA_BATCH})
endfunction()
