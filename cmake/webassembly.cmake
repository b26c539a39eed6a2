# The engine for WebAssembly by emscripten, without what computes in other programs: no modules, no
# studies side by side, no files. Libraries of headers are those of the system; what has to be
# compiled is fetched as Debian has it.
include(FetchContent)

set(headers ${PROJECT_BINARY_DIR}/system)  # Apart from the headers of the system's C library.
file(MAKE_DIRECTORY ${headers})
foreach(library eigen3/Eigen eigen3/unsupported boost fast_float fmt nlohmann xsimd Spectra)
  find_path(found_${library} ${library} PATHS /usr/include /usr/local/include
    NO_DEFAULT_PATH NO_CMAKE_FIND_ROOT_PATH REQUIRED)
  cmake_path(GET library FILENAME name)
  file(CREATE_LINK ${found_${library}}/${library} ${headers}/${name} SYMBOLIC)
endforeach()
include_directories(SYSTEM ${headers})
foreach(target Eigen3::Eigen Boost::headers fmt::fmt nlohmann_json::nlohmann_json PkgConfig::NETTLE CLI11::CLI11 ZLIB::ZLIB)
  add_library(${target} INTERFACE IMPORTED GLOBAL)
endforeach()
target_include_directories(PkgConfig::NETTLE INTERFACE ${PROJECT_SOURCE_DIR}/wasm/include)

# Names of files in the module do not say where this folder lies.
add_compile_options(-fwasm-exceptions -msimd128 -msse2 -ffile-prefix-map=${PROJECT_SOURCE_DIR}=.
  -ffile-prefix-map=${PROJECT_BINARY_DIR}=.)
add_link_options(-fwasm-exceptions)

set(debian deb.debian.org/debian/pool/main archive.debian.org/debian/pool/main)
list(TRANSFORM debian PREPEND http:// )
set(CMAKE_POLICY_DEFAULT_CMP0077 NEW)
foreach(part IN ITEMS BUILD_CONTRIB BUILD_TOOLS BUILD_TESTS INSTALL)
  set(YAML_CPP_${part} OFF)
endforeach()
list(TRANSFORM debian APPEND /y/yaml-cpp/yaml-cpp_0.7.0+dfsg.orig.tar.xz OUTPUT_VARIABLE urls)
FetchContent_Declare(yaml-cpp URL ${urls}
  URL_HASH SHA256=dc63708605404e0b963e0ca3a9619d1c8270eda2839603e6fa0384e5e51e5312)
list(TRANSFORM debian APPEND /libc/libcsv/libcsv_3.0.3+dfsg.orig.tar.gz OUTPUT_VARIABLE urls)
FetchContent_Declare(libcsv URL ${urls}
  URL_HASH SHA256=06fddfaca720a4be7603bad63eb1833bca5b6c5a69b42b1c518a02cda2a73aef)
FetchContent_MakeAvailable(yaml-cpp libcsv)
set(YAML_CPP_LIBRARIES yaml-cpp)
add_library(csv STATIC ${libcsv_SOURCE_DIR}/libcsv.c)
target_include_directories(csv PUBLIC ${libcsv_SOURCE_DIR})
set(CSV_LIBRARY csv)

# Kernels of contacts and chains are vectorized; a long double is emulated.
add_compile_definitions(EIGEN_DONT_VECTORIZE BOOST_MATH_PROMOTE_DOUBLE_POLICY=false FMT_HEADER_ONLY)
add_compile_options(
  $<$<COMPILE_LANGUAGE:CXX>:-include> $<$<COMPILE_LANGUAGE:CXX>:${PROJECT_SOURCE_DIR}/wasm/include/missing.h>)
