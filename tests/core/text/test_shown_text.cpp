#include <doctest/doctest.h>

#include <string>

#include "core/text/shown_text.h"

using namespace dapple;

TEST_CASE("names in any language are shown as they are") {
    for (const std::string text : {"", "cat.png", "with space & \"quotes\" \\ %s {}", "Kätzchen.jpg",
                                   "\xe7\x8c\xab.png", "\xf0\x9f\x90\x88.png", "\xd0\xba\xd0\xbe\xd1\x82"})
        CHECK(printable(text) == text);
}

TEST_CASE("what would command a terminal, end the line or turn the writing round is written out") {
    CHECK(printable("a\x1b[2Jb") == "a\\x1b[2Jb");
    CHECK(printable("a\nb\rc\td") == "a\\nb\\rc\\td");
    CHECK(printable(std::string("a\0b\x7f", 4)) == "a\\x00b\\x7f");
    CHECK(printable("a\xc2\x9b"
                    "2J") == "a\\x9b2J");                               // an escape sequence in one character
    CHECK(printable("cat\xe2\x80\xaegnp.exe") == "cat\\u202egnp.exe");  // shown as catexe.png
    CHECK(printable("a\xe2\x80\xa8z") == "a\\u2028z");
}

TEST_CASE("bytes that are no UTF-8 are written out, and what follows them is not lost") {
    CHECK(printable("a\xff"
                    "b") == "a\\xffb");
    CHECK(printable("\xe7\x8c") == "\\xe7\\x8c");  // cut off
    CHECK(printable("\xc3(") == "\\xc3(");
    CHECK(printable("\xc0\xaf") == "\\xc0\\xaf");                    // a longer form of /
    CHECK(printable("\xed\xa0\x80") == "\\xed\\xa0\\x80");           // half of a pair
    CHECK(printable("\xf4\x90\x80\x80") == "\\xf4\\x90\\x80\\x80");  // beyond Unicode
}

TEST_CASE("any bytes can be edited as text and come back as they were") {
    CHECK(editable("K\xc3\xa4tzchen \\ 1.jpg") == "K\xc3\xa4tzchen \\ 1.jpg");
    CHECK(editable("lat\xfc/\xf0\x9f\x93\xb7\n") == "lat\\xfc/\\xf0\\x9f\\x93\\xb7\\x0a");
    CHECK(editable("\\xfc") == "\\x5cxfc");  // a name with a backslash in it
    std::string all;
    for (int first = 0; first < 256; ++first)
        for (const int second : {0, 0x41, 0x5c, 0x80, 0xbf, 0xff})
            all += {static_cast<char>(first), static_cast<char>(second), '\\', 'x', '5', 'c'};
    CHECK(bytes_of(editable(all)) == all);
    CHECK(is_utf8(editable(all)));
}

TEST_CASE("what is printable stays so") {
    const std::string once = printable("\x1b[31m\n\xff\xe2\x80\xae");
    CHECK(printable(once) == once);
}

TEST_CASE("of a word that is far too long beginning and end are shown, and of letters no halves") {
    for (const std::string text : {"", " ", "a  b ", "no such file"}) CHECK(shortened(text) == text);
    const std::string path(499, 'x'), name = std::string(5000, 'a') + "z";
    CHECK(shortened("dapple: " + path + ": gone") == "dapple: " + path + ": gone");
    CHECK(shortened("dapple: " + name + " is gone") ==
          "dapple: " + std::string(200, 'a') + "..." + std::string(199, 'a') + "z is gone");
    std::string letters = "i";
    for (int i = 0; i < 400; ++i) letters += "\xc3\xa4";
    CHECK(is_utf8(shortened(letters)));
    CHECK(shortened(letters).size() < 410);
}

TEST_CASE("numbers of any size are told in words that can be read") {
    CHECK(grouped(0) == "0");
    CHECK(grouped(999) == "999");
    CHECK(grouped(1000) == "1,000");
    CHECK(grouped(1'234'567) == "1,234,567");
    CHECK(in_round_words(309.2) == "309");
    CHECK(in_round_words(54'321) == "54,321");
    CHECK(in_round_words(999'999.4) == "999,999");
    CHECK(in_round_words(999'999.6) == "1.00 million");
    CHECK(in_round_words(1.74e7) == "17.4 million");
    CHECK(in_round_words(9.996e8) == "1.00 billion");
    CHECK(in_round_words(2.2e12) == "2.20 trillion");
    CHECK(in_round_words(1.5e16) == "1.5 x 10^16");
}

TEST_CASE("lengths are told without powers of ten, and one dot is not many") {
    CHECK(millimetres_in_words(263.1) == "263 mm");
    CHECK(millimetres_in_words(0.3142) == "0.31 mm");
    CHECK(millimetres_in_words(9.96) == "10 mm");
    CHECK(millimetres_in_words(2e-7) == "0 mm");
    CHECK(way_in_words(12.34) == "12.3 m");
    CHECK(way_in_words(0.421) == "42 cm");
    CHECK(way_in_words(0.0031) == "3.1 mm");
    CHECK(way_in_words(0) == "0 mm");
    CHECK(dots_in_words(1) == "1 dot");
    CHECK(dots_in_words(0) == "0 dots");
    CHECK(dots_in_words(12'345) == "12,345 dots");
}

TEST_CASE("what is UTF-8 is told from what is not") {
    CHECK(is_utf8(""));
    CHECK(is_utf8("abc\n \u00e4 \u20ac \U0001f600"));
    CHECK_FALSE(is_utf8("a\xff"));
    CHECK_FALSE(is_utf8("\xc0\xaf"));      // longer than needed
    CHECK_FALSE(is_utf8("\xe2\x82"));      // cut off
    CHECK_FALSE(is_utf8("\xed\xa0\x80"));  // half of a pair
}
