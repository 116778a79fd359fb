# The explorer's engine, compiled for browsers by Emscripten from the same rooms; tools/explorer calls it. Of libraries
# it takes the headers of this machine, without those of its C library, and utf8proc from its source (UTF8PROC_SOURCE).
set(MIXITY_UTF8PROC_SOURCE "" CACHE PATH "Folder that holds utf8proc.c")
set(headers ${PROJECT_BINARY_DIR}/include)
file(MAKE_DIRECTORY ${headers})
foreach(name boost eigen3 nlohmann toml++ utf8proc.h pugixml.hpp pugiconfig.hpp xxhash.h xxh3.h fast_float mrpt/expr/include/mrpt/3rdparty/exprtk.hpp)
  cmake_path(GET name FILENAME linked)
  file(CREATE_LINK /usr/include/${name} ${headers}/${linked} SYMBOLIC)
endforeach()
set(EXPRTK_INCLUDE_DIR ${headers})
add_library(browser_headers INTERFACE)
target_include_directories(browser_headers SYSTEM INTERFACE ${headers} ${headers}/eigen3)
target_compile_definitions(browser_headers INTERFACE TOML_HEADER_ONLY=1 UTF8PROC_STATIC)
foreach(name Boost::headers Eigen3::Eigen Ceres::ceres nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus
        PkgConfig::utf8proc PkgConfig::minizip pugixml::pugixml Threads::Threads)
  add_library(${name} INTERFACE IMPORTED)
  target_link_libraries(${name} INTERFACE browser_headers)
endforeach()
enable_language(C)
add_library(utf8proc STATIC ${MIXITY_UTF8PROC_SOURCE}/utf8proc.c)
target_compile_definitions(utf8proc PRIVATE UTF8PROC_STATIC)
target_link_libraries(browser_headers INTERFACE utf8proc)
add_library(mixity_warnings INTERFACE)

add_compile_options(-O2 -fwasm-exceptions -msimd128)
add_compile_definitions(BOOST_MATH_PROMOTE_DOUBLE_POLICY=false)  # long double has 128 bits there, all in software
add_compile_options($<$<COMPILE_LANGUAGE:CXX>:SHELL:-include\ ${PROJECT_SOURCE_DIR}/src/explorer/standard_library.h>)
# Most of the time goes into headers that several files share.
set(CMAKE_UNITY_BUILD ON)
set(CMAKE_UNITY_BUILD_BATCH_SIZE 25)
add_subdirectory(src)
# What reads files and writes texts is compiled for size: no fit waits for it.
foreach(room table dataset logs studies report)
  target_compile_options(mixity_${room} PRIVATE -Os)
endforeach()

file(GLOB engine CONFIGURE_DEPENDS src/explorer/*.cc)
add_executable(engine ${engine})
target_compile_options(engine PRIVATE -Os)
target_compile_definitions(engine PRIVATE MIXITY_VERSION="${PROJECT_VERSION}")
target_link_libraries(engine PRIVATE mixity_report nlohmann_json::nlohmann_json)
target_include_directories(engine PRIVATE src)
# -O2 would optimise each function again into which another is inlined, which takes four times as long and makes a fit no
# faster: here each is optimised once, after all inlining.
set(passes low-memory-unused zero-filled-memory strip-debug strip-producers duplicate-function-elimination
  remove-unused-module-elements inlining dce remove-unused-names remove-unused-brs optimize-instructions
  simplify-locals-nostructure vacuum coalesce-locals simplify-locals vacuum reorder-locals merge-blocks
  duplicate-function-elimination remove-unused-module-elements)
list(JOIN passes "," passes)
target_link_options(engine PRIVATE -O1 -sBINARYEN_EXTRA_PASSES=${passes} -fwasm-exceptions -msimd128 --bind -sSINGLE_FILE=1 -sMODULARIZE=1 -sEXPORT_NAME=mixity
  -sALLOW_MEMORY_GROWTH=1 -sDYNAMIC_EXECUTION=0 -sENVIRONMENT=web,worker,node -sEXPORTED_RUNTIME_METHODS=HEAPF64 -sEXPORTED_FUNCTIONS=_malloc,_free)
