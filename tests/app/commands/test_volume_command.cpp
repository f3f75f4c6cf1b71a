// `dapple volume`: volumes and clouds read, points and films written, and what is refused.

#include <doctest/doctest.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "app/files/volume_file.h"
#include "core/volume/resample_cloud.h"
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
    return "NRRD0004\n# made by a test\ntype: " + type + "\ndimension: 3\nsizes: 2 1 3\n" + more +
           "encoding: raw\n\n" + voxels;
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
    REQUIRE(
        run_dapple("volume ball -n 300 -o " + scene("ball.ply") + " --film " + scene("turn.webp")).status ==
        0);
    const auto points = read_ply(scene("ball.ply"));
    CHECK(points.size() == 300);
    const Volume ball = ball_volume();
    for (const glm::dvec3& point : points) CHECK(ball.at(point) > 0);
    CHECK(text_of(scene("turn.webp")).starts_with("RIFF"));
    REQUIRE(run_dapple("volume ball -n 300 -o " + scene("ball.csv")).status == 0);
    const std::string table = text_of(scene("ball.csv"));
    CHECK(table.starts_with("x,y,z\n"));
    CHECK(std::ranges::count(table, '\n') == 301);

    const std::string slices = scene("cat.png") + " " + scene("cat.png");
    REQUIRE(run_dapple("volume " + slices + " -n 1k -o " + scene("cat.ply")).status == 0);
    for (const glm::dvec3& point : read_ply(scene("cat.ply"))) CHECK(point.z < 2);
    REQUIRE(run_dapple("volume " + slices + " --invert -n 1k -o " + scene("dark.ply")).status == 0);
    CHECK(text_of(scene("dark.ply")) != text_of(scene("cat.ply")));
}

TEST_CASE("a cloud becomes as many of its own points") {
    const Scene scene;
    std::vector<glm::dvec3> cloud;
    for (int i = 0; i < 500; ++i) cloud.emplace_back(i % 25, i / 25 * 0.5, i * i % 7);
    std::ofstream out(scene("scan.ply"), std::ios::binary);
    write_ply(out, cloud);
    out.close();
    REQUIRE(run_dapple("volume " + scene("scan.ply") + " -n 40 -o " + scene("even.ply")).status == 0);
    std::vector<glm::dvec3> even;
    for (const std::size_t i : even_subset(cloud, 40)) even.push_back(cloud[i]);
    CHECK(read_ply(scene("even.ply")) == even);
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
    fails("l.nrrd", nrrd("short", bytes_of<std::int16_t>({0, 1, -4, 0, 0, 0})), "a density of -4");
    const std::string ascii = "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n";
    fails("a.ply", "plyx\n", "is no PLY file");
    fails("b.ply", ascii, "ends within its header");
    fails("c.ply", ascii + "end_header\n1 2\n", "has vertices without x, y and z");
    fails("d.ply", ascii + "property float z\nend_header\n1 2\n", "vertex 1 is not 3 numbers");
    fails("e.ply", ascii + "property float z\nend_header\n1 2 nan\n", "vertex 1 is nowhere");
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
    scene.must_fail("volume ball -n 0" + to, "-n: 0 is not possible");
    scene.must_fail("volume ball --relax 101" + to, "--relax");
    scene.must_fail("volume none.nrrd" + to, "none.nrrd: no such file");
    scene.must_fail("volume ball gyroid" + to, "density: several files are the slices of one volume");
    scene.must_fail("volume none.ply --relax 3" + to, "--relax: applies to a density");
    scene.must_fail("volume a.ply b.png" + to, "give pictures alone");
    scene.must_fail("volume ball --film " + scene("turn.gif") + to, "turn.gif");
    scene.must_fail("volume " + scene("old.svg") + to, "old.svg");
    put_text(scene("p.ply"), ascii + "property float z\nend_header\n1 2 3\n");
    scene.must_fail("volume " + scene("p.ply") + " -n 2" + to, "2 points of a cloud that has 1");
    scene.must_fail("volume " + scene("p.ply") + " -n 1 -o " + scene("p.ply"), "p.ply");
}

}  // namespace dapple
