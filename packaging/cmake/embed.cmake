# embed_files(TARGET NAMESPACE FILE...): compiles files into TARGET as
#   namespace NAMESPACE { std::string_view <file name with . and - as _>(); }
# declared in <TARGET>_embedded/NAMESPACE.h. A changed file is compiled in again. A namespace is embedded once a
# program. Where the assembler writes ELF, it brings the bytes in, so that large files cost nothing; the symbols are
# hidden: only the functions are for others. Elsewhere the bytes are numbers for the compiler.
function(embed_files target namespace)
    set(paths)
    set(folder ${CMAKE_CURRENT_BINARY_DIR}/embedded/${target}_embedded)
    set(header "#pragma once\n#include <string_view>\nnamespace ${namespace} {\n")
    set(source "#include \"${target}_embedded/${namespace}.h\"\n")
    foreach(file IN LISTS ARGN)
        cmake_path(ABSOLUTE_PATH file BASE_DIRECTORY ${CMAKE_CURRENT_SOURCE_DIR} OUTPUT_VARIABLE path)
        cmake_path(GET path FILENAME name)
        string(MAKE_C_IDENTIFIER ${name} symbol)
        string(APPEND header "std::string_view ${symbol}();\n")
        list(APPEND paths ${path})
        if(NOT CMAKE_EXECUTABLE_FORMAT STREQUAL "ELF" OR DAPPLE_PLAIN)
            set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${path})
            file(READ ${path} bytes HEX)
            string(REGEX REPLACE "(..)" "0x\\1," bytes "${bytes}")
            string(APPEND source "static const unsigned char ${symbol}_bytes[] = {${bytes}};\n"
                "std::string_view ${namespace}::${symbol}() {\n"
                "    return {reinterpret_cast<const char*>(${symbol}_bytes), sizeof ${symbol}_bytes};\n}\n")
            continue()
        endif()
        string(APPEND source "asm(\".section .rodata\\n.global ${namespace}_${symbol}_begin\\n.hidden ${namespace}_${symbol}_begin\\n${namespace}_${symbol}_begin:\\n\"\n"
            "    \".incbin \\\"${path}\\\"\\n.global ${namespace}_${symbol}_end\\n.hidden ${namespace}_${symbol}_end\\n${namespace}_${symbol}_end:\\n.byte 0\\n.previous\\n\");\n"
            "extern \"C\" const char ${namespace}_${symbol}_begin[], ${namespace}_${symbol}_end[];\n"
            "std::string_view ${namespace}::${symbol}() {\n"
            "    return {${namespace}_${symbol}_begin, static_cast<std::size_t>(${namespace}_${symbol}_end - ${namespace}_${symbol}_begin)};\n}\n")
    endforeach()
    string(APPEND header "}\n")
    file(CONFIGURE OUTPUT ${folder}/${namespace}.h CONTENT "${header}" @ONLY)
    file(CONFIGURE OUTPUT ${folder}/${namespace}.cpp CONTENT "${source}" @ONLY)
    set_source_files_properties(${folder}/${namespace}.cpp PROPERTIES OBJECT_DEPENDS "${paths}" SKIP_PRECOMPILE_HEADERS ON)
    target_sources(${target} PRIVATE ${folder}/${namespace}.cpp)
    target_include_directories(${target} PUBLIC ${CMAKE_CURRENT_BINARY_DIR}/embedded)
endfunction()
