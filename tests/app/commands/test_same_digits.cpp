// Files are the same to the byte whatever the processor: the standard library, which has other code for each,
// is told to think that this one cannot do much.

#include <doctest/doctest.h>

#include <cstdlib>
#include <map>
#include <string>
#include <vector>

#include "tests/render_scene.h"

namespace dapple {

TEST_CASE("lights and drawings have the same digits on every processor and with any number of threads") {
    const Scene scene;
    PictureFile map{.width = 64, .height = 32, .channels = 3};
    for (int i = 0; i < 64 * 32 * 3; ++i)
        map.values.push_back(static_cast<float>(i * 7919 % 1009) / (i % 97 == 0 ? 1009 : 4036));
    write_picture(scene("map.png"), map);
    write_picture(scene("cat.png"), coloured_picture());
    const std::string lights = "lights " + scene("map.png") + " -n 100", cat = "render " + scene("cat.png");
    const std::map<std::string, std::string> drawn{
        {"settled.json", lights},
        {"random.csv", lights + " --rotate 33.3 --position random --order placed --mis-compensation"},
        {"dot.usda", lights + " --position dot --convention blender"},
        {"dots.csv", cat + " --dots 2000"},
        {"tone.csv", cat + " --dot-radius 0.8..1.6 --gamma 1.7 --contrast 0.3 --exposure 0.7"},
        {"samples.csv", cat + " --dots 500 --settle-for samples"},
        {"pens.svg", cat + " --dots 800 --pens cmyk:0.5 --dot-shape spiral --dot-radius 0.8"},
        {"ranked.csv", cat + " --dots 800 --tile 14217,2895/16 --ranking energy --relax 0"},
        {"line.gcode", cat + " --dots 300 --style line"},
        {"page.png", cat + " --dots 300 --dpi 40 --finer " + scene("cat.png")}};
    std::map<std::string, std::string> first;
    const std::vector<std::string> lackings{"", "-FMA,-FMA4", "-AVX2,-AVX2_Usable,-FMA_Usable,-AVX512F",
                                            "-AVX,-SSE4_1"};
    for (const std::string& lacking : lackings) {
        CAPTURE(lacking);
        ::setenv("GLIBC_TUNABLES", ("glibc.cpu.hwcaps=" + lacking).c_str(), 1);
        const std::string threads = lacking.empty() ? " --threads 1" : " --threads 3";
        for (const auto& [name, command] : drawn) {
            CAPTURE(name);
            const Outcome outcome = run_dapple(command + threads + " -o " + scene(name));
            CAPTURE(outcome.err);
            CHECK(outcome.status == 0);
            const std::string text = text_of(scene(name));
            CHECK(first.try_emplace(name, text).first->second == text);
        }
    }
    ::unsetenv("GLIBC_TUNABLES");
}

}  // namespace dapple
