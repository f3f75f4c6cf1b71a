// `dapple-lab volume`: volumes and clouds read, points and films written, and what is refused.

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "lab/volume/resample_cloud.h"
#include "lab/volume/volume_file.h"
#include "tests/render_scene.h"

namespace dapple {
namespace {

template <class Number>
std::string bytes_of(std::vector<Number> numbers, bool swapped = false) {
    std::string bytes;
    for (const Number number : numbers) {
        std::string one(sizeof(Number), '\0');
        std::memcpy(one.data(), &number, sizeof(Number));
        if (swapped) std::ranges::reverse(one);
        bytes += one;
    }
    return bytes;
}

std::string nrrd(const std::string& type, const std::string& voxels, const std::string& more = "") {
    const bool needs_order = type.find("char") == type.npos && more.find("endian") == more.npos;
    return "NRRD0004\n# made by a test\ntype: " + type + "\ndimension: 3\nsizes: 2 1 3\n" + more +
           (needs_order ? "endian: little\n" : "") + "encoding: raw\n\n" + voxels;
}

}  // namespace

TEST_CASE("voxels of each type are read, in either order of their bytes") {
    const Scene scene;
    const std::vector<float> values{0, 1, 2, 3, 4, 5};
    const auto check = [&](const std::string& text) {
        put_text(scene("v.nrrd"), text);
        const Volume volume = read_nrrd(scene("v.nrrd"));
        CHECK(volume.size == glm::ivec3(2, 1, 3));
        CHECK(volume.density == values);
        return volume;
    };
    check(nrrd("uchar", bytes_of<std::uint8_t>({0, 1, 2, 3, 4, 5})));
    check(nrrd("unsigned short", bytes_of<std::uint16_t>({0, 1, 2, 3, 4, 5}), "endian: little\n"));
    check(nrrd("short", bytes_of<std::int16_t>({0, 1, 2, 3, 4, 5}, true), "endian: big\n"));
    check(nrrd("float", bytes_of<float>({0, 1, 2, 3, 4, 5}, true), "endian: big\n"));
    const Volume volume = check(nrrd("double", bytes_of<double>({0, 1, 2, 3, 4, 5}), "spacings: 1 2 0.5\n"));
    CHECK(volume.spacing == glm::dvec3(1, 2, 0.5));
    CHECK(volume.corner == glm::dvec3(0));
    // Each field of the format that says where voxels are, in the file and in space.
    const std::string six = bytes_of<std::uint8_t>({0, 1, 2, 3, 4, 5});
    check(nrrd("uchar", "four" + six, "byte skip: 4\n"));
    check(nrrd("uchar", "some lines\nof text\nxx" + six, "line skip: 2\nbyteskip: 2\n"));
    check(nrrd("uchar", "whatever it is" + six, "byte skip: -1\n"));
    const Volume placed =
        check(nrrd("uchar", six,
                   "space: left-posterior-superior\nspace directions: (2,0,0) (0,0.5,0) (0,0,4)\n"
                   "Space Origin: (431000,-5412000,7)\nkinds: domain domain domain\nof me:=9\n"));
    CHECK(placed.spacing == glm::dvec3(2, 0.5, 4));
    CHECK(placed.corner == glm::dvec3(430999, -5412000.25, 5));
}

TEST_CASE(
    "points are read from each kind of PLY, among other properties, and written so that they are read") {
    const Scene scene;
    const std::vector<glm::dvec3> points{{1, 2, 3}, {-0.5, 1e3, 0.25}};
    const std::string properties =
        "element vertex 2\nproperty uchar red\nproperty float x\nproperty float y\nproperty double z\n"
        "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const auto check = [&](const std::string& text) {
        put_text(scene("p.ply"), text);
        CHECK(read_ply(scene("p.ply")) == points);
    };
    check("ply\nformat ascii 1.0\ncomment hello\n" + properties + "255 1 2 3\n0 -0.5 1e3 .25\n3 0 1 1\n");
    for (const bool swapped : {false, true}) {
        std::string text =
            fmt::format("ply\nformat binary_{}_endian 1.0\n", swapped ? "big" : "little") + properties;
        for (const glm::dvec3& point : points)
            text += '\7' + bytes_of<float>({float(point.x), float(point.y)}, swapped) +
                    bytes_of<double>({point.z}, swapped);
        check(text + "more");
    }
    std::ofstream out(scene("o.ply"), std::ios::binary);
    write_ply(out, points);
    out.close();
    CHECK(read_ply(scene("o.ply")) == points);
}

TEST_CASE("a volume becomes points to the number, as PLY, as CSV, with a film, from slices too") {
    const Scene scene;
    REQUIRE(run_lab("volume ball -n 300 -o " + scene("ball.ply") + " --film " + scene("turn.webp")).status ==
            0);
    const auto points = read_ply(scene("ball.ply"));
    CHECK(points.size() == 300);
    const Volume ball = ball_volume();
    for (const glm::dvec3& point : points) CHECK(ball.at(point) > 0);
    CHECK(text_of(scene("turn.webp")).starts_with("RIFF"));
    REQUIRE(run_lab("volume ball -n 300 -o " + scene("ball.csv")).status == 0);
    const std::string table = text_of(scene("ball.csv"));
    CHECK(table.starts_with("x,y,z\n"));
    CHECK(std::ranges::count(table, '\n') == 301);

    const std::string slices = scene("cat.png") + " " + scene("cat.png");
    REQUIRE(run_lab("volume " + slices + " -n 1k -o " + scene("cat.ply")).status == 0);
    for (const glm::dvec3& point : read_ply(scene("cat.ply"))) CHECK(point.z < 2);
    REQUIRE(run_lab("volume " + slices + " --invert -n 1k -o " + scene("dark.ply")).status == 0);
    CHECK(text_of(scene("dark.ply")) != text_of(scene("cat.ply")));
}

TEST_CASE("a cloud becomes as many of its own points") {
    const Scene scene;
    std::vector<glm::dvec3> cloud;
    for (int i = 0; i < 500; ++i) cloud.emplace_back(i % 25, i / 25 * 0.5, i * i % 7);
    std::ofstream out(scene("scan.ply"), std::ios::binary);
    write_ply(out, cloud);
    out.close();
    REQUIRE(run_lab("volume " + scene("scan.ply") + " -n 40 -o " + scene("even.ply")).status == 0);
    std::vector<glm::dvec3> even;
    for (const std::size_t i : even_subset(cloud, 40)) even.push_back(cloud[i]);
    CHECK(read_ply(scene("even.ply")) == even);
}

TEST_CASE(
    "the points of a cloud keep all their digits, wherever it lies, and dots lie where a file's origin is") {
    const Scene scene;
    // A steep front, measured to a tenth of a millimetre, in metres of UTM.
    std::vector<glm::dvec3> cloud;
    for (int i = 0; i < 4000; ++i) {
        const auto part = [i](int step, int of) { return static_cast<double>(i * step % of) / of; };
        cloud.emplace_back(431'000 + 20 * part(7919, 20'011), 5'412'000 + 10 * part(104'729, 19'997),
                           300 + 8 * part(1299, 9973));
    }
    std::string text = "ply\nformat ascii 1.0\nelement vertex 4000\n", binary = text;
    binary.replace(binary.find("ascii"), 5, "binary_big_endian");
    for (const char* const axis : {"x", "y", "z"}) {
        text += fmt::format("property float {}\n", axis);  // as some programs write, with more digits
        binary += fmt::format("property double {}\n", axis);
    }
    text += "end_header\n";
    binary += "end_header\n";
    for (const glm::dvec3& point : cloud) {
        text += fmt::format("{} {} {}\n", point.x, point.y, point.z);
        binary += bytes_of<double>({point.x, point.y, point.z}, true);
    }
    put_text(scene("text.ply"), text);
    put_text(scene("binary.ply"), binary);
    const auto earlier = [](const glm::dvec3& a, const glm::dvec3& b) {
        return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::ranges::sort(cloud, earlier);
    std::vector<glm::dvec3> first;
    for (const char* const name : {"text.ply", "binary.ply"}) {
        REQUIRE(run_lab("volume " + scene(name) + " -n 200 -o " + scene("o.ply")).status == 0);
        std::vector<glm::dvec3> points = read_ply(scene("o.ply"));
        CHECK(points.size() == 200);
        for (const glm::dvec3& point : points) CHECK(std::ranges::binary_search(cloud, point, earlier));
        if (first.empty()) first = points;
        CHECK(points == first);
        REQUIRE(run_lab("volume " + scene(name) + " -n 200 -o " + scene("o.csv")).status == 0);
        std::istringstream table(text_of(scene("o.csv")));
        std::string line;
        std::getline(table, line);
        for (const glm::dvec3& point : points) {
            std::getline(table, line);
            CHECK(line == fmt::format("{},{},{}", point.x, point.y, point.z));
        }
    }
    // So far off, floats are whole numbers.
    put_text(scene("v.nrrd"), nrrd("uchar", bytes_of<std::uint8_t>({1, 1, 1, 1, 1, 1}),
                                   "spacings: 1 1 1\nspace origin: (1e7,1e7,0.5)\n"));
    REQUIRE(run_lab("volume " + scene("v.nrrd") + " -n 300 -o " + scene("o.ply")).status == 0);
    std::vector<glm::dvec3> dots = read_ply(scene("o.ply"));
    for (const glm::dvec3& dot : dots) {
        CHECK(std::abs(dot.x - 1e7 - 0.5) <= 1);
        CHECK(std::abs(dot.y - 1e7) <= 0.5);
        CHECK(std::abs(dot.z - 1.5) <= 1.5);
    }
    std::ranges::sort(dots, earlier);
    CHECK(std::ranges::adjacent_find(dots) == dots.end());
}

TEST_CASE("volumes and clouds that are broken are refused in a sentence, and nothing is written") {
    const Scene scene;
    const auto fails = [&](const std::string& name, const std::string& text, const std::string& words) {
        put_text(scene(name), text);
        scene.must_fail("volume " + scene(name) + " -o " + scene("out.ply"), name + ": " + words);
    };
    const std::string six = bytes_of<std::uint8_t>({0, 1, 2, 3, 4, 5});
    fails("a.nrrd", "hello\n", "is no NRRD file");
    fails("b.nrrd", "NRRD0004\ntype: uchar\n", "ends before its voxels begin");
    fails("c.nrrd", nrrd("uchar", six.substr(1)),
          "ends too early: 2 x 1 x 3 voxels need 6 bytes, and there are 5");
    fails("d.nrrd", nrrd("block", six), "has voxels of type block");
    fails("e.nrrd", nrrd("uchar", six, "data file: x.raw\n"), "has its voxels in another file");
    fails("f.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 3\nencoding: raw\n\n",
          "has not 3 dimensions");
    fails("g.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 99999 99999 99999\nencoding: raw\n\n",
          "ends too early");
    fails("h.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 2 -1 3\nencoding: raw\n\n",
          "has a side of -1 voxels");
    fails("i.nrrd", "NRRD0004\ntype: uchar\ndimension: 3\nsizes: 1 1 1\nencoding: gzip\n\n",
          "has encoding gzip");
    fails("j.nrrd", nrrd("uchar", std::string(6, '\0')), "all voxels are 0");
    fails("k.nrrd", nrrd("float", bytes_of<float>({0, 1, NAN, 0, 0, 0})), "a density of nan");
    // What the format has is followed or refused by its name.
    for (const auto& [field, words] :
         {std::pair<std::string, std::string>{"spacings: 1 0 1", "has voxels that are 0 wide"},
          {"spacings: 1 -2 1", "has voxels that are -2 wide"},
          {"spacings: 1 nan 1", "has voxels that are nan wide"},
          {"spacings: inf 1 1", "has voxels that are inf wide"},
          {"spacings: 1e39 1 1", "has voxels that are 1e39 wide"},
          {"spacings: 1 x 1", "has voxels that are x wide"},
          {"spacings: 1 2", "has 2 spacings; give 3"},
          {"spacings: 1 1 1\nspacings: 2 2 2", "has the field spacings twice"},
          {"byte skip: 1\nbyteskip: 1", "has the field byteskip twice"},
          {"byte skip: 9", "ends too early"},
          {"byte skip: -2", "has a byte skip of -2"},
          {"line skip: 5", "ends within the lines"},
          {"line skip: -1", "has a line skip of -1"},
          {"axis mins: 0 0 0", "has axis mins, which cannot be read"},
          {"space directions: (1,0,0) (0,0,1) (0,1,0)",
           "has voxels that are turned or mirrored by the space direction (0,0,1)"},
          {"space directions: (-1,0,0) (0,1,0) (0,0,1)", "has voxels that are turned"},
          {"space directions: none (0,1,0) (0,0,1)", "has a space direction none"},
          {"space directions: (1,0,0) (0,1,0)", "has 2 space directions"},
          {"space directions: (1,0,0) (0,1,0) (0,0,1)\nspacings: 1 1 1", "has both"},
          {"space origin: 1 2 3", "has a space origin 1 2 3"},
          {"space origin: (1,2,1e99)", "has a space origin (1,2,1e99), which is further"},
          {"spacing: 1 1 1", "has a field spacing, which is none of NRRD's"},
          {"spacings 1 1 1", "has a line that is no field"}})
        fails("m.nrrd", nrrd("uchar", six, field + "\n"), words);
    fails("n.nrrd", nrrd("short", six + six, "endian: middle\n"), "has middle for endian");
    fails("o.nrrd", "NRRD0004\ntype: short\ndimension: 3\nsizes: 2 1 3\nencoding: raw\n\n" + six + six,
          "has nothing for endian");
    fails("l.nrrd", nrrd("short", bytes_of<std::int16_t>({0, 1, -4, 0, 0, 0})), "a density of -4");
    const std::string ascii = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n";
    fails("a.ply", "plyx\n", "is no PLY file");
    fails("b.ply", ascii, "ends within its header");
    fails("c.ply", ascii + "end_header\n1 2\n", "has vertices without x, y and z");
    fails("d.ply", ascii + "property float z\nend_header\n1 2\n", "vertex 1 is not 3 numbers");
    fails("e.ply", ascii + "property float z\nend_header\n1 2 nan\n", "vertex 1 is nowhere");
    fails("j.ply", ascii + "property float z\nend_header\n1 2 1e101\n",
          "vertex 1 is further off than 1e+100");
    fails("k.ply", ascii + "property float z\nproperty double x\nend_header\n1 2 3 4\n",
          "has vertices with x twice");
    fails("l.ply", ascii + "properties float z\nend_header\n1 2 3\n", "has a line in its header");
    fails("f.ply",
          "ply\nformat binary_little_endian 1.0\nelement vertex 9999999999\nproperty float x\nproperty float "
          "y\nproperty float z\nend_header\n1234",
          "ends too early");
    fails("g.ply",
          "ply\nformat zip 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
          "end_header\n",
          "has format zip");
    fails("h.ply", "ply\nformat ascii 1.0\nelement vertex 1\nproperty list uchar int x\nend_header\n",
          "has vertices with lists");
    fails("i.ply", "ply\nformat ascii 1.0\nelement face 1\nelement vertex 1\nend_header\n",
          "has other elements before");

    const std::string to = " -o " + scene("out.ply");
    scene.must_fail("volume" + to, "density is required");
    scene.must_fail("volume ball", "--output is required");
    scene.must_fail("volume ball -o " + scene("out.obj"), "let the name end in .ply or .csv");
    scene.must_fail("volume ball -n 0" + to, "--dots: 0 is not possible");
    scene.must_fail("volume ball --relax 101" + to, "--relax");
    scene.must_fail("volume none.nrrd" + to, "none.nrrd: no such file");
    scene.must_fail("volume ball gyroid" + to, "density: several files are the slices of one volume");
    scene.must_fail("volume cube cat.png" + to, "density: several files are the slices of one volume");
    scene.must_fail("volume none.ply --relax 3" + to, "--relax: applies to a density");
    scene.must_fail("volume a.ply b.png" + to, "give pictures alone");
    scene.must_fail("volume ball --film " + scene("turn.gif") + to, "turn.gif");
    scene.must_fail("volume " + scene("old.svg") + to, "old.svg");
    put_text(scene("p.ply"), ascii + "property float z\nend_header\n1 2 3\n");
    scene.must_fail("volume " + scene("p.ply") + " -n 2" + to, "--dots: 2 points of a cloud that has 1");
    scene.must_fail("volume " + scene("p.ply") + " -n 1 -o " + scene("p.ply"), "p.ply");
}

}  // namespace dapple
