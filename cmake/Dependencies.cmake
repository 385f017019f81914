# Every outside library, named once. All are packages of Debian bookworm (see tools/packages.txt).

find_package(PkgConfig REQUIRED)
find_package(fmt REQUIRED)
find_package(glm REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
find_package(CLI11 REQUIRED)
set(OPENSSL_USE_STATIC_LIBS ON)  # libcrypto, for SHA-256 and base64; static keeps the program portable
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
pkg_check_modules(EPOXY REQUIRED IMPORTED_TARGET epoxy)
pkg_check_modules(EGL REQUIRED IMPORTED_TARGET egl)
find_package(ZLIB REQUIRED)  # gzipped gaze logs, CRC of PNG
find_package(meshoptimizer REQUIRED)
find_package(TinyGLTF REQUIRED)  # its header; engine/scene compiles it
if(MACULA_WINDOW)
  find_package(glfw3 3.3 REQUIRED)
  pkg_check_modules(IMGUI REQUIRED IMPORTED_TARGET imgui)
endif()
if(MACULA_HID)
  pkg_check_modules(HIDAPI REQUIRED IMPORTED_TARGET hidapi-hidraw)
endif()
if(MACULA_IMAGE_IO)
  find_package(OpenImageIO 2.4 REQUIRED)
endif()
if(MACULA_DATASET)
  # Not its CMake package: Debian's names programs of other packages and fails without them.
  pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
endif()
if(MACULA_TESTS)
  find_package(GTest REQUIRED)
endif()
