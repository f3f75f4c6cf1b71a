#pragma once
// A page for people: one file with everything in it, that any browser shows without a network. It is
// well-formed XML too, so that programs can read it.

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

/// Bytes as an address: "data:image/png;base64,...".
std::string data_address(std::string_view media_type, std::string_view bytes);

class HtmlPage {
 public:
    explicit HtmlPage(std::string_view title);

    void heading(std::string_view text);
    void paragraph(std::string_view text);

    /// A picture, or several side by side, under them a sentence, if any, that says what to see.
    struct Picture {
        std::string bytes{};  // of the file
        std::string media_type = "image/png";
        std::string alt{};       // what it shows, for those who cannot see it
        std::string caption{};   // under this one; none, none
        bool pixelated = false;  // enlarged without blur
    };
    void pictures(std::span<const Picture> pictures, std::string_view sentence = {});

    /// Well-formed <svg> elements, as svg_plot() writes them, side by side.
    void drawings(std::span<const std::string> svg, std::string_view sentence);

    enum class RowKind { plain, good, bad };
    struct Row {
        std::vector<std::string> cells;
        RowKind kind = RowKind::plain;
    };
    void table(const std::vector<std::string>& head, const std::vector<Row>& rows);

    /// The whole page.
    std::string text() const;

 private:
    std::string title_;
    std::string body_;
};

}  // namespace dapple
