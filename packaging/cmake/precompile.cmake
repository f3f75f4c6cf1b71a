# precompile(TARGET HEADER...): the compiler reads these headers, and those of other libraries that nearly every file of ours
# includes, once for all files of the target. Each file includes what it needs all the same: the presets tsan and clang do without.
function(precompile target)
    target_precompile_headers(${target} PRIVATE ${ARGN}
        <algorithm> <array> <atomic> <cassert> <chrono> <cmath> <compare> <cstddef> <cstdint> <cstdlib> <deque>
        <exception> <filesystem> <functional> <limits> <map> <memory> <mutex> <new> <numeric> <optional> <ostream>
        <random> <ranges> <set> <span> <stdexcept> <stop_token> <string> <string_view> <system_error> <thread> <utility>
        <variant> <vector>
        <fmt/format.h>
        <glm/common.hpp> <glm/geometric.hpp> <glm/gtc/packing.hpp> <glm/gtc/type_precision.hpp> <glm/vec2.hpp>
        <glm/vec3.hpp> <glm/vec4.hpp>)
endfunction()

# compile_together(TARGET...): where CMAKE_UNITY_BUILD is on, the compiler reads the files of a folder as one: half the work.
# So no two files of a folder may have names of their own alike.
function(compile_together)
    foreach(target ${ARGN})
        set_target_properties(${target} PROPERTIES UNITY_BUILD_MODE GROUP)
        get_target_property(files ${target} SOURCES)
        foreach(file ${files})
            cmake_path(GET file PARENT_PATH folder)
            string(MAKE_C_IDENTIFIER "${folder}" group)
            set_source_files_properties(${file} PROPERTIES UNITY_GROUP "${group}")
        endforeach()
    endforeach()
endfunction()
