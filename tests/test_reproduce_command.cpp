#include <doctest/doctest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "app/commands/reproduce.h"
#include "tests/file_text.h"
#include "tests/shell.h"
#include "tests/temporary_folder.h"

using namespace dapple;

TEST_CASE("every number of the paper comes out, and every figure, on one well-formed page") {
    const TemporaryFolder folder;
    const Outcome outcome = run_dapple("reproduce -o " + (folder / "paper").string());
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    CHECK(outcome.out.find("numbers are equal") != std::string::npos);

    const auto numbers = nlohmann::json::parse(text_of(folder / "paper/numbers.json"));
    CHECK(numbers.size() == 21);
    for (const auto& row : numbers) {
        CAPTURE(row.dump());
        CHECK(row["equal"] == true);
        CHECK(row["expected"] == row["ours"]);
    }
    const auto has = [&](const std::string& value) {
        for (const auto& row : numbers)
            if (row["ours"] == value) return true;
        return false;
    };
    for (const char* value : {"19.6 %", "14.0 %", "0.696594", "0.652788", "0.832358", "0.649963", "54608",
                              "40960", "0.782220", "0.914419"}) {
        CAPTURE(value);
        CHECK(has(value));
    }

    pugi::xml_document page;
    REQUIRE(page.load_file((folder / "paper/index.html").c_str(), pugi::parse_full));
    CHECK(page.select_nodes("//tr[@class='good']").size() == 21);
    CHECK(page.select_nodes("//tr[@class='bad']").empty());
    CHECK(page.select_nodes("//img").size() == 12);
    for (const pugi::xpath_node& node : page.select_nodes("//@src"))
        CHECK(std::string(node.attribute().value()).starts_with("data:image/"));
    for (const char* figure :
         {"Table 1", "Figures 1 and 2", "Figure 3", "Figure 4", "Figures 5 and 6", "Figure 7"}) {
        CAPTURE(figure);
        bool found = false;
        for (const pugi::xpath_node& node : page.select_nodes("//h2"))
            found = found || std::string(node.node().text().get()).starts_with(figure);
        CHECK(found);
    }
}

TEST_CASE("a number that differs is an error that says where to look") {
    const std::vector<ComparedNumber> rows{{"a", "1.00", "1.00", "paper"}, {"b", "2.00", "2.01", "paper"}};
    CHECK_THROWS_WITH_AS(
        check_equal(rows, "paper/index.html"),
        "1 of 2 numbers differ from what should come out; they are marked in paper/index.html",
        std::runtime_error);
    CHECK_NOTHROW(check_equal(std::vector(rows.begin(), rows.begin() + 1), "paper/index.html"));
}

TEST_CASE("a folder that cannot be, and a map that is none, are refused in words") {
    const TemporaryFolder folder;
    put_text(folder / "file", "x");
    const auto refuses = [&](const std::string& arguments, const std::string& words) {
        const Outcome outcome = run_dapple("reproduce " + arguments);
        CAPTURE(outcome.err);
        CHECK(outcome.status != 0);
        CHECK(outcome.sentences() == 1);
        CHECK(outcome.err.find(words) != std::string::npos);
    };
    refuses("-o " + (folder / "file").string(), "is a file, not a folder");
    refuses("-o " + (folder / "a/b").string(), "cannot be made");
    refuses("", "--output");
    CHECK(text_of(folder / "file") == "x");
}
