#include "core/reports/html.h"

#include <fmt/format.h>

#include <cstdint>

namespace dapple {
namespace {

constexpr std::string_view kStyle = R"(
body { font: 16px/1.5 sans-serif; color: #222; background: #fff; max-width: 66rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.25rem; margin-top: 2.2rem; border-bottom: 1px solid #ccc; }
.side { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; }
.side figure { margin: 0; flex: 1 1 18rem; } .side svg { flex: 1 1 24rem; max-width: 48rem; height: auto; }
.one figure { max-width: 44rem; }
img { max-width: 100%; width: 100%; height: auto; border: 1px solid #ccc; } img.pixels { image-rendering: pixelated; }
figcaption { font-size: 0.85rem; } .say { color: #333; max-width: 48rem; }
table { border-collapse: collapse; margin: 0.6rem 0; } th, td { text-align: left; padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid #ddd; vertical-align: top; }
tr.good td:last-child { color: #0a6b2b; } tr.bad td { color: #a30000; font-weight: bold; }
)";

constexpr std::string_view kReplacement = "\xEF\xBF\xBD";

// The length of the UTF-8 character that text begins with, 0 if it begins with none.
std::size_t character_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = byte(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xF0 && first < 0xF5   ? 4
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xC2 && first < 0xE0 ? 2
                                                               : 0;
    if (length == 0 || length > text.size()) return 0;
    std::uint32_t code = first & (0x7Fu >> length);
    for (std::size_t i = 1; i < length; ++i) {
        if ((byte(i) & 0xC0) != 0x80) return 0;
        code = code << 6 | (byte(i) & 0x3Fu);
    }
    const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
    const bool no_character =
        (code >= 0xD800 && code < 0xE000) || code > 0x10FFFF || code == 0xFFFE || code == 0xFFFF;
    return overlong || no_character ? 0 : length;
}

}  // namespace

std::string xml_text(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t length = character_length(text);
        const char c = text.front();
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '>')
            result += "&gt;";
        else if (c == '"')
            result += "&quot;";
        else if (c == '\'')
            result += "&#39;";
        else if (length == 0)
            result += kReplacement;
        else if (length == 1 && static_cast<unsigned char>(c) < 0x20 && c != '\n' && c != '\t')
            result += kReplacement;
        else
            result += text.substr(0, length);
        text.remove_prefix(length == 0 ? 1 : length);
    }
    return result;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string result;
    result.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t three = 0;
        for (std::size_t k = 0; k < 3; ++k)
            three = three << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0u);
        for (std::size_t k = 0; k < 4; ++k)
            result += i + k <= bytes.size() ? letters[three >> (18 - 6 * k) & 63] : '=';
    }
    return result;
}

std::string data_address(std::string_view media_type, std::string_view bytes) {
    return fmt::format("data:{};base64,{}", media_type, base64(bytes));
}

HtmlPage::HtmlPage(std::string_view title) : title_(xml_text(title)) {
    body_ = fmt::format("<h1>{}</h1>\n", title_);
}

void HtmlPage::heading(std::string_view text) {
    body_ += fmt::format("<h2>{}</h2>\n", xml_text(text));
}

void HtmlPage::paragraph(std::string_view text) {
    body_ += fmt::format("<p class=\"say\">{}</p>\n", xml_text(text));
}

void HtmlPage::pictures(std::span<const Picture> pictures, std::string_view sentence) {
    body_ += fmt::format("<div class=\"side{}\">\n", pictures.size() == 1 ? " one" : "");
    for (const Picture& picture : pictures) {
        body_ += fmt::format("<figure><img{} src=\"{}\" alt=\"{}\"/>",
                             picture.pixelated ? " class=\"pixels\"" : "",
                             data_address(picture.media_type, picture.bytes), xml_text(picture.alt));
        if (!picture.caption.empty())
            body_ += fmt::format("<figcaption>{}</figcaption>", xml_text(picture.caption));
        body_ += "</figure>\n";
    }
    body_ += "</div>\n";
    paragraph(sentence);
}

void HtmlPage::drawings(std::span<const std::string> svg, std::string_view sentence) {
    body_ += "<div class=\"side\">\n";
    for (const std::string& drawing : svg) body_ += drawing + '\n';
    body_ += "</div>\n";
    paragraph(sentence);
}

void HtmlPage::table(const std::vector<std::string>& head, const std::vector<Row>& rows) {
    body_ += "<table><thead><tr>";
    for (const std::string& cell : head) body_ += fmt::format("<th>{}</th>", xml_text(cell));
    body_ += "</tr></thead><tbody>\n";
    for (const Row& row : rows) {
        body_ += row.kind == RowKind::good  ? "<tr class=\"good\">"
                 : row.kind == RowKind::bad ? "<tr class=\"bad\">"
                                            : "<tr>";
        for (const std::string& cell : row.cells) body_ += fmt::format("<td>{}</td>", xml_text(cell));
        body_ += "</tr>\n";
    }
    body_ += "</tbody></table>\n";
}

std::string HtmlPage::text() const {
    return fmt::format(
        "<!DOCTYPE html>\n<html xmlns=\"http://www.w3.org/1999/xhtml\" lang=\"en\">\n<head>\n"
        "<meta charset=\"utf-8\"/>\n<meta name=\"viewport\" content=\"width=device-width, "
        "initial-scale=1\"/>\n"
        "<title>{}</title>\n<style>{}</style>\n</head>\n<body>\n{}</body>\n</html>\n",
        title_, kStyle, body_);
}

}  // namespace dapple
