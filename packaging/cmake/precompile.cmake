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
