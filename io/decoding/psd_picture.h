#pragma once
// The merged picture of a PSD or PSB file, which lies behind its layers (Adobe Photoshop File Formats
// Specification). OpenImageIO refuses a file for a layer packed in a way that it does not know, leaves out
// the transparency of grey pictures, and takes colours that are not mixed with white for such that are.

#include <cstdint>
#include <vector>

namespace dapple {

class PsdPicture {
 public:
    /// Of an open file, whose descriptor keeps its place and stays open. Throws DecodeError if it ends too
    /// early.
    explicit PsdPicture(int file);

    /// What the same picture without layers begins with; after it comes what the file has from rest() on.
    std::vector<unsigned char> beginning() const;
    std::uint64_t rest() const { return data_; }

    /// Whether it is a grey or an RGB picture with transparency, which read() reads.
    bool has_transparency() const { return transparent_; }
    /// Of these: the colours', and alpha.
    int channels() const { return colours_ + 1; }
    /// Rows [begin, end), values from 0 to 1 or of 32-bit pixels as they are, colours not multiplied by
    /// alpha. Throws DecodeError where a row is not there.
    void read(int begin, int end, float* pixels);

 private:
    bool says_transparent() const;
    void find_rows();
    void find_white();
    void read_values(int begin, int end, float* pixels);
    void read_row(int channel, int y);

    int file_, long_bytes_ = 4;
    std::uint64_t layers_ = 0, data_ = 0;  // places: of the layers' section, and behind it
    int channels_ = 0, colours_ = 0, bits_ = 0, width_ = 0, height_ = 0;
    bool transparent_ = false, packed_ = false, mixed_with_white_ = true;
    std::vector<std::uint64_t>
        rows_;  // where each of the colours and alpha begins, channel by channel; and the end
    std::vector<unsigned char> packed_row_, row_;
};

}  // namespace dapple
