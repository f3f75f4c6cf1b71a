#include "io/reports/html.h"

#include <fmt/format.h>

#include "core/text/text_lines.h"

namespace dapple {
namespace {

constexpr std::string_view kStyle = R"(
body { font: 16px/1.5 sans-serif; color: #222; background: #fff; max-width: 66rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.25rem; margin-top: 2.2rem; border-bottom: 1px solid #ccc; }
.side { display: flex; flex-wrap: wrap; gap: 1rem; align-items: flex-start; margin-top: 0.8rem; }
.side figure { margin: 0; flex: 1 1 18rem; } .side svg { flex: 1 1 24rem; max-width: 48rem; height: auto; }
.one figure { max-width: 44rem; } .four figure { flex: 1 1 26rem; } .many figure { flex: 0 1 20rem; }
img { max-width: 100%; width: 100%; height: auto; border: 1px solid #ccc; } img.pixels { image-rendering: pixelated; }
figcaption { font-size: 0.85rem; } .say { color: #333; max-width: 48rem; }
table { border-collapse: collapse; margin: 0.6rem 0; } th, td { text-align: left; padding: 0.2rem 0.8rem 0.2rem 0; border-bottom: 1px solid #ddd; vertical-align: top; }
td:not(:first-child):not(:last-child) { white-space: nowrap; }
tr.good td:last-child { color: #0a6b2b; } tr.bad td { color: #a30000; font-weight: bold; }
)";

}  // namespace

std::string data_address(std::string_view media_type, std::string_view bytes) {
    return fmt::format("data:{};base64,{}", media_type, base64_of(bytes));
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
    const char* const kind = pictures.size() == 1   ? " one"
                             : pictures.size() == 4 ? " four"
                             : pictures.size() > 4  ? " many"
                                                    : "";
    body_ += fmt::format("<div class=\"side{}\">\n", kind);
    for (const Picture& picture : pictures) {
        body_ += fmt::format("<figure><img{} src=\"{}\" alt=\"{}\"/>",
                             picture.pixelated ? " class=\"pixels\"" : "",
                             data_address(picture.media_type, picture.bytes), xml_text(picture.alt));
        if (!picture.caption.empty())
            body_ += fmt::format("<figcaption>{}</figcaption>", xml_text(picture.caption));
        body_ += "</figure>\n";
    }
    body_ += "</div>\n";
    if (!sentence.empty()) paragraph(sentence);
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
