#include "io/decoding/changed_beginning.h"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace dapple {

ChangedBeginning::ChangedBeginning(std::vector<unsigned char> beginning, int file, std::uint64_t rest)
    : IOProxy("picture", Read), beginning_(std::move(beginning)), file_(file), rest_(rest) {}

std::size_t ChangedBeginning::read(void* to, std::size_t size) {
    const std::size_t got = pread(to, size, m_pos);
    m_pos += static_cast<std::int64_t>(got);
    return got;
}

std::size_t ChangedBeginning::pread(void* to, std::size_t size, std::int64_t at) {
    if (at < 0) return 0;
    auto place = static_cast<std::uint64_t>(at);
    auto* const bytes = static_cast<unsigned char*>(to);
    std::size_t got = 0;
    if (place < beginning_.size()) {
        got = std::min<std::size_t>(size, beginning_.size() - place);
        std::copy_n(beginning_.begin() + at, got, bytes);
        place += got;
    }
    while (got < size) {
        const std::uint64_t in_file = place - beginning_.size() + rest_;
        if (in_file > INT64_MAX) break;
        const ssize_t more = ::pread(file_, bytes + got, size - got, static_cast<off_t>(in_file));
        if (more <= 0) break;
        got += static_cast<std::size_t>(more);
        place += static_cast<std::uint64_t>(more);
    }
    return got;
}

std::size_t ChangedBeginning::size() const {
    struct stat status {};
    if (::fstat(file_, &status) != 0) return beginning_.size();
    const auto all = static_cast<std::uint64_t>(status.st_size);
    return beginning_.size() + (all > rest_ ? all - rest_ : 0);
}

}  // namespace dapple
