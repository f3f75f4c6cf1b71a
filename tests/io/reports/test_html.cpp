#include <doctest/doctest.h>

#include <array>
#include <pugixml.hpp>
#include <string>

#include "core/text/text_lines.h"
#include "io/reports/html.h"
#include "io/reports/plot.h"

using namespace dapple;

TEST_CASE("base64 is RFC 4648's") {
    // The RFC's own examples, section 10.
    CHECK(base64_of("") == "");
    CHECK(base64_of("f") == "Zg==");
    CHECK(base64_of("fo") == "Zm8=");
    CHECK(base64_of("foo") == "Zm9v");
    CHECK(base64_of("foob") == "Zm9vYg==");
    CHECK(base64_of("fooba") == "Zm9vYmE=");
    CHECK(base64_of("foobar") == "Zm9vYmFy");
    CHECK(base64_of(std::string("\xFF\xEF\xBE\x00", 4)) == "/+++AA==");
    CHECK(bytes_of_base64("Zm9vYg==") == "foob");
    CHECK(bytes_of_base64("/+++AA==") == std::string("\xFF\xEF\xBE\x00", 4));
    CHECK_THROWS_WITH(bytes_of_base64("Zm9v!A=="), "are not in base64");
    CHECK_THROWS_WITH(bytes_of_base64("Zm9vY"), "are not in base64");
    CHECK(data_address("image/png", "foo") == "data:image/png;base64,Zm9v");
}

TEST_CASE("any bytes become text that XML can hold") {
    CHECK(xml_text("a<b> & \"c\" 'd'") == "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;");
    CHECK(xml_text("Dutré, π, 𝄞") == "Dutré, π, 𝄞");
    const std::string mark = "\xEF\xBF\xBD";
    CHECK(xml_text("a\x01"
                   "b\x1F") == "a" + mark + "b" + mark);
    CHECK(xml_text("\xE9t\xE9") == mark + "t" + mark);      // Latin-1
    CHECK(xml_text("\xC0\xAF") == mark + mark);             // overlong
    CHECK(xml_text("\xED\xA0\x80") == mark + mark + mark);  // a surrogate
    CHECK(xml_text("\xE2\x82") == mark + mark);             // cut off
}

TEST_CASE("a page is well-formed, complete, and asks for nothing from outside") {
    HtmlPage page("Dots & <more>");
    page.heading("First");
    page.paragraph("It's 5 > 3.");
    page.pictures(std::array{HtmlPage::Picture{.bytes = "foo", .alt = "a \"cat\"", .caption = "Cat"},
                             HtmlPage::Picture{.bytes = "bar", .alt = "a dog", .pixelated = true}},
                  "Look.");
    page.drawings(std::array{svg_plot({.title = "plot"})}, "See.");
    page.table({"what", "value"},
               {{.cells = {"a", "1"}}, {.cells = {"b", "2"}, .kind = HtmlPage::RowKind::bad}});
    const std::string text = page.text();

    pugi::xml_document document;
    REQUIRE(document.load_string(text.c_str(), pugi::parse_full));
    const pugi::xml_node html = document.child("html");
    CHECK(std::string(html.attribute("xmlns").value()) == "http://www.w3.org/1999/xhtml");
    CHECK(std::string(html.child("head").child("title").text().get()) == "Dots & <more>");
    CHECK(std::string(html.child("body").child("h1").text().get()) == "Dots & <more>");
    CHECK(document.select_nodes("//figure/img").size() == 2);
    CHECK(std::string(document.select_node("//img").node().attribute("alt").value()) == "a \"cat\"");
    CHECK(document.select_nodes("//figcaption").size() == 1);
    CHECK(document.select_nodes("//tbody/tr").size() == 2);
    CHECK(std::string(document.select_node("//tr[@class='bad']/td").node().text().get()) == "b");
    for (const pugi::xpath_node& node : document.select_nodes("//@src"))
        CHECK(std::string(node.attribute().value()).starts_with("data:"));
    CHECK(document.select_nodes("//@href | //script | //link").empty());
}
