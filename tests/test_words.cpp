// What people read says everything in the field's words: these, of the house's own, are not to come back.

#include <doctest/doctest.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "tests/file_text.h"
#include "tests/places.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

struct Word {
    const char *house, *field;
};
// In small letters, with what to write in its place.
constexpr Word kOfTheHouse[] = {
    {"settl", "relax"},
    {"pen's way", "pen travel"},
    {"short way", "short route"},
    {"before its way", "unoptimised"},
    {" goes ", "the verb meant"},
    {"bring it back", "restore"},
    {"brings it back", "restores"},
    {"bring the drawing back", "restore"},
    {"own pens", "custom pens"},
    {"own path", "custom path"},
    {"own dialog", "Dapple's dialog"},
    {"as set below", "Custom"},
    {"opened before", "recent"},
    {"let it rest", "pause"},
    {"the usual value", "default"},
    {"as usual", "by default"},
    {"usual settings", "default settings"},
    {"nearer to others", "closer"},
    {"are nearer", "are closer"},
    {"part them", "use ..."},
    {"dots per inch", "pixels per inch"},
    {"dots by", "dot count"},
    {"wallpaper", "repeats exactly"},
    {"mean distance of dots", "mean dot spacing"},
    {"so many", "N, this many"},
    {"no more than", "at most"},
    {"escape stops it", "Esc stops"},
    {"take its settings", "use its settings"},
    {" tells ", "reports"},
    {" told ", "reported"},
    {"is there any more", "exists"},
    {"taken as none", "set to 0"},
    {"says what cannot be", "sent something impossible"},
};
// Names in files and options, which stay for good, and the sentence that explains one.
const std::set<std::string> kNames{
    "settled", "settle_for", "--settle-for",
    "a sample's place in its region. settled: the least error; dot: as placed; "
    "random: no bias"};

/// A source's string literals in small letters, those that follow one another as one; not what it includes.
std::vector<std::string> literals_in(const std::string& source) {
    std::vector<std::string> found;
    bool goes_on = false;
    const auto skip_to = [&](std::size_t from, const char* end) {
        return std::min(source.find(end, from), source.size());
    };
    for (std::size_t i = 0; i < source.size(); ++i) {
        if (source[i] == '#' || source.compare(i, 2, "//") == 0) {
            i = skip_to(i, "\n");
        } else if (source[i] == '"' || source[i] == '\'') {
            const std::size_t begin = i + 1;
            const char quote = source[i];
            for (++i; i < source.size() && source[i] != quote; ++i) i += source[i] == '\\';
            // What separates a number's digits opens nothing.
            if (quote == '\'' && i > begin + 3) i = begin;
            if (quote == '"' && !goes_on) found.emplace_back();
            if (quote == '"')
                for (const char letter : source.substr(begin, i - begin))
                    found.back() += static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
            goes_on = quote == '"';
        } else if (!std::isspace(static_cast<unsigned char>(source[i]))) {
            goes_on = false;
        }
    }
    return found;
}

/// Which of the house's words a source's literals have, a line each.
std::string house_words_in(const std::string& source, const std::string& name) {
    std::string wrong;
    for (const std::string& literal : literals_in(source))
        for (const auto& [house, field] : kOfTheHouse)
            if (literal.find(house) != literal.npos && !kNames.contains(literal))
                wrong += name + ": \"" + house + "\", say \"" + field + "\", in \"" + literal + "\"\n";
    return wrong;
}

}  // namespace

TEST_CASE("no string of the program has the house's own words, but for names in files and options") {
    std::string wrong;
    std::size_t files = 0;
    for (const char* const folder : {"app", "core", "io"}) {
        for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source_folder() / folder)) {
            if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
            wrong +=
                house_words_in(text_of(entry.path()), fs::relative(entry.path(), source_folder()).string());
            ++files;
        }
    }
    INFO(wrong);
    CHECK(wrong.empty());
    CHECK(files > 300);
}

TEST_CASE("a house word is found across the lines of a sentence, and not in comments, includes or names") {
    CHECK(house_words_in("tip(\"The dots Set\"\n    \"tle.\");", "a.cpp") ==
          "a.cpp: \"settl\", say \"relax\", in \"the dots settle.\"\n");
    CHECK(house_words_in("f(1'000, '\"'); say(\"a \\\"b\\\" \" /**/ \"Bring it back\");", "b.cpp") != "");
    CHECK(house_words_in("// \"settled\"\nfield(\"settle_for\"); call(\"set\", \"tle\");", "c.cpp").empty());
    CHECK(house_words_in("#include \"settling.h\"\n", "d.cpp").empty());
}

}  // namespace dapple
