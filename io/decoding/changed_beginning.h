#pragma once
// A file that begins otherwise: what OpenImageIO reads in place of one that it reads wrong.

#include <OpenImageIO/filesystem.h>

#include <cstdint>
#include <vector>

namespace dapple {

class ChangedBeginning : public OIIO::Filesystem::IOProxy {
 public:
    /// `beginning`, and after it what the open file has from `rest` on.
    ChangedBeginning(std::vector<unsigned char> beginning, int file, std::uint64_t rest);

    const char* proxytype() const override { return "changed beginning"; }
    std::size_t read(void* to, std::size_t size) override;
    std::size_t pread(void* to, std::size_t size, std::int64_t at) override;
    std::size_t size() const override;

 private:
    std::vector<unsigned char> beginning_;
    int file_;
    std::uint64_t rest_;
};

}  // namespace dapple
