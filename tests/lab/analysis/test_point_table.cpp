#include <doctest/doctest.h>

#include <sstream>
#include <stdexcept>

#include "core/output/drawing_format.h"
#include "lab/analysis/point_table.h"
#include "tests/point_sets.h"

using namespace dapple;

using Points = std::vector<glm::dvec2>;

TEST_CASE("a table's fields may be apart by commas, semicolons, tabs or spaces") {
    const Points wanted{{1, 2.5}, {-3e-2, 4}};
    CHECK(parse_point_table("1,2.5\n-3e-2,4\n") == wanted);
    CHECK(parse_point_table("1;2.5\n-3e-2;4") == wanted);
    CHECK(parse_point_table("1\t2.5\r\n-3e-2\t4\r\n") == wanted);
    CHECK(parse_point_table("  1   2.5 \n\n# a comment\n-3e-2 +4\n") == wanted);
    CHECK(parse_point_table("\xEF\xBB\xBF"
                            "1, 2.5, 7\n-3e-2 , 4, 8") == wanted);
}

TEST_CASE("decimals may follow a comma where tabs, semicolons, blanks or quotes part the fields") {
    const Points wanted{{1.5, 2.5}, {-3, 0.25}};
    CHECK(parse_point_table("1,5;2,5\n-3;0,25\n") == wanted);
    CHECK(parse_point_table("1,5\t2,5\n-3\t2,5e-1\n") == wanted);
    CHECK(parse_point_table("1,5 2,5\n-3 0,25\n") == wanted);
    CHECK(parse_point_table("\"1,5\",\"2,5\"\n\"-3\",\"0,25\"\n") == wanted);
    CHECK(parse_point_table("x;y;page_width_mm;page_height_mm\n1,5;2,5;9,5;8\n-3;0,25;9,5;8\n") == wanted);
    CHECK(page_of_table("x;y;page_width_mm;page_height_mm\n1,5;2,5;9,5;8\n") == glm::dvec2(9.5, 8));
    CHECK(parse_point_table("x y\n1.5,2.5\n-3,0.25\n") == wanted);  // the header is parted otherwise
}

TEST_CASE("a table is read as R, a spreadsheet or pandas writes it, with quotes and names of rows") {
    const Points wanted{{0.5, 0.25}, {0.75, 1}};
    // write.csv(), write.table(), write.csv2() of a data frame, and with row.names = FALSE.
    CHECK(parse_point_table("\"\",\"x\",\"y\"\n\"1\",0.5,0.25\n\"2\",0.75,1\n") == wanted);
    CHECK(parse_point_table("\"x\" \"y\"\n\"1\" 0.5 0.25\n\"2\" 0.75 1\n") == wanted);
    CHECK(parse_point_table("\"\";\"x\";\"y\"\n\"1\";0,5;0,25\n\"2\";0,75;1\n") == wanted);
    CHECK(parse_point_table("\"x\",\"y\"\n0.5,0.25\n0.75,1\n") == wanted);
    CHECK(parse_point_table("x,y\nmy first,0.5,0.25\n\"a, b\",0.75,1\n") == wanted);
    // pandas' to_csv(), and a spreadsheet's with all fields in quotes, or a separator behind the last.
    CHECK(parse_point_table(",X,Y,Note\n0,0.5,0.25,\"a \"\"b\"\", c\"\n1,0.75,1,\n") == wanted);
    CHECK(parse_point_table("\"Y\",\"X\"\r\n\"0.25\",\"0.5\"\r\n\"1\",\"0.75\"\r\n") == wanted);
    CHECK(parse_point_table("X,Y\n0.5,0.25,\n0.75,1,\n") == wanted);
    CHECK(page_of_table("\"page_width_mm\" \"PAGE_HEIGHT_MM\" \"x\" \"y\"\n\"1\" 20 10 1 2\n") ==
          glm::dvec2(20, 10));
}

TEST_CASE("a header says which columns the places are in") {
    const Points wanted{{1, 2}};
    CHECK(parse_point_table("x,y\n1,2\n") == wanted);
    CHECK(parse_point_table("radius,y,x\n9,2,1\n") == wanted);
    CHECK(parse_point_table("x,y,x_mm,y_mm\n8,9,1,2\n") == wanted);
}

TEST_CASE("a drawing's own table reads back") {
    Dots dots;
    dots.x = {0.25f, 0.75f};
    dots.y = {0.5f, 0.125f};
    dots.threshold = {0.03125f, 0.09375f};
    dots.critical = {1, 2};
    std::ostringstream out;
    write_csv(out, {.size = {200, 100, 200}, .dots = stream_of(dots), .dot_radius_mm = 0.5, .tile_size = 16});
    CHECK(parse_point_table(out.str()) == Points{{50, 100}, {150, 25}});
    CHECK(page_of_table(out.str()) == glm::dvec2(200, 100));
}

TEST_CASE("a table says its page in columns of these names, or not at all") {
    CHECK(page_of_table("# mine\nx,page_height_mm,y,page_width_mm\n1,30,2,40\n5,6,7,8\n") ==
          glm::dvec2(40, 30));
    for (const char* text :
         {"", "x,y\n1,2\n", "1,2\n3,4\n", "x,y,page_width_mm\n1,2,3\n", "x,y,page_width_mm,page_height_mm\n",
          "x,y,page_width_mm,page_height_mm\n1,2,3\n", "x,y,page_width_mm,page_height_mm\n1,2,3,0\n",
          "x,y,page_width_mm,page_height_mm\n1,2,inf,4\n"}) {
        CAPTURE(text);
        CHECK_FALSE(page_of_table(text).has_value());
    }
}

TEST_CASE("a malformed table is refused with its name, its line and what is wrong") {
    const auto message = [](std::string_view text) -> std::string {
        try {
            parse_point_table(text, "dots.csv");
        } catch (const std::runtime_error& error) {
            return error.what();
        }
        return "";
    };
    CHECK(message("") == "dots.csv: there are no points in it");
    CHECK(message("x_mm,y_mm\n") == "dots.csv: there are no points in it");
    CHECK(message("1,2\n3\n") == "dots.csv, line 2: there is no y; a point needs two numbers");
    CHECK(message("x,y\n1,2\n\n3,four\n") == "dots.csv, line 4: \"four\" is not a number");
    CHECK(message("1,2\n3,\n") == "dots.csv, line 2: \"\" is not a number");
    CHECK(message("1,2\n3,4px\n") == "dots.csv, line 2: \"4px\" is not a number");
    CHECK(message("1,2\nnan,3\n") == "dots.csv, line 2: x is nan, not a place");
    CHECK(message("1,-inf\n") == "dots.csv, line 1: y is -inf, not a place");
    CHECK(message("1,1e999\n") == "dots.csv, line 1: \"1e999\" is not a number");
    CHECK(message("place,size\n1,2\n") ==
          "dots.csv, line 1: \"place\" is neither a number nor a header with x_mm and y_mm, or x and y");
    CHECK(message("1,5;2,5\n1.5;2\n") ==
          "dots.csv, line 2: \"1.5\" has a decimal point, while numbers before it have a decimal comma; "
          "write all with the same");
    CHECK(message("x,y\n1,5,2,5\n") ==
          "dots.csv, line 2: there are 4 fields, and the header names 2; if decimals have commas, part the "
          "fields with semicolons");
    CHECK(message("1,500,000;2\n") ==
          "dots.csv, line 1: \"1,500,000\" is neither a number nor a header with "
          "x_mm and y_mm, or x and y");
    CHECK(message("1;2\n1,234.5;2\n") == "dots.csv, line 2: \"1,234.5\" is not a number");
    CHECK(message("1;2\n3;,5\n") == "dots.csv, line 2: \",5\" is not a number");
    CHECK(message("1 2\n3, 4\n") == "dots.csv, line 2: \"3,\" is not a number");
    CHECK(message("\"1,2\n") ==
          "dots.csv, line 1: \"\"1,2\" is neither a number nor a header with x_mm and y_mm, "
          "or x and y");
    CHECK(message("1,2\n\"3\"4,5\n") == "dots.csv, line 2: \"\"3\"4\" is not a number");
    CHECK(message("1,2\nx,y\n3,4\n") == "dots.csv, line 2: \"x\" is not a number");
}

TEST_CASE("the own box of a square lattice is the torus on which it closes") {
    Points points;
    for (int y = 0; y < 7; ++y)
        for (int x = 0; x < 5; ++x) points.push_back({10 + 2.0 * x, -3 + 2.0 * y});
    const PlacedPoints placed = in_their_own_box(points, Topology::torus);
    CHECK(placed.domain.width == doctest::Approx(10));
    CHECK(placed.domain.height == doctest::Approx(14));
    CHECK(placed.domain.topology == Topology::torus);
    CHECK(placed.points.front().x == doctest::Approx(1));
    CHECK(placed.points.front().y == doctest::Approx(1));
}

TEST_CASE("the own box of white noise is nearly what the noise fills") {
    const PlacedPoints placed = in_their_own_box(white_noise(10000, 5), Topology::window);
    CHECK(placed.domain.width == doctest::Approx(1).epsilon(0.02));
    CHECK(placed.domain.height == doctest::Approx(1).epsilon(0.02));
    for (const glm::dvec2 p : placed.points) {
        CHECK(p.x > 0);
        CHECK(p.x < placed.domain.width);
    }
}

TEST_CASE("points in a row have a box, points at one place have none") {
    const PlacedPoints row = in_their_own_box({{0, 5}, {1, 5}, {2, 5}}, Topology::window);
    CHECK(row.domain.height == doctest::Approx(1));
    CHECK(row.domain.width == doctest::Approx(3));
    for (const Points& points : {Points{{1, 2}}, Points{{1, 2}, {1, 2}}})
        CHECK_THROWS_WITH_AS(
            in_their_own_box(points, Topology::window, "dots.csv"),
            "dots.csv: all points are at one place; give the width and height of the area that they fill",
            std::runtime_error);
}
