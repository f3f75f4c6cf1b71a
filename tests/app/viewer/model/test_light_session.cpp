// An environment map as the window has it, without the window.

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "app/viewer/model/light_session.h"
#include "io/files/save_lights.h"
#include "io/files/tile_library.h"
#include "tests/file_text.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

template <class Done>
bool brings(LightSession& session, Done done) {
    return wait_until([&] {
        session.take_events();
        return done();
    });
}

void write_even_map(const fs::path& file, int width) {
    std::ofstream out(file, std::ios::binary);
    out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y " << width / 2 << " +X " << width << "\n";
    for (int texel = 0; texel < width * width / 2; ++texel) out << "\x80\x80\x80\x81";
}

}  // namespace

TEST_CASE("of maps that are opened while another is read the last one is shown, with its own samples") {
    const TemporaryFolder folder;
    for (const int width : {64, 32, 16}) write_even_map(folder / (std::to_string(width) + ".hdr"), width);
    LightSession session(LightsSettings{}, [] {});
    for (const char* name : {"64.hdr", "32.hdr", "16.hdr"}) session.open(folder / name);
    REQUIRE(brings(session, [&] { return session.name() == "16.hdr" && session.samples().found; }));
    CHECK(session.lit()->map.width() == 16);
    CHECK(session.maps() <= 2);  // that of 32 was never read
    CHECK(session.banner.message.empty());
}

TEST_CASE("a file that is asked for while another is written is written after it, as it was asked for") {
    const TemporaryFolder folder;
    LightsSettings settings;
    settings.request.count = 30'000;
    LightSession session(settings, [] {});
    write_even_map(folder / "even.hdr", 64);
    session.open(folder / "even.hdr");
    REQUIRE(brings(session, [&] { return session.lit() != nullptr; }));
    session.save(folder / "first.json");
    session.settings.request.count = 10;
    session.save(folder / "second.json");
    session.settings.request.count = 20;
    REQUIRE(brings(session, [&] { return session.saved_path() == folder / "second.json"; }));
    CHECK_FALSE(session.saving());
    const auto lines = [&](const char* name) { return std::ranges::count(text_of(folder / name), '\n'); };
    CHECK(lines("first.json") > 30'000);
    CHECK(lines("second.json") >= 10);
    CHECK(lines("second.json") < 30);
}

TEST_CASE("a map that does not come is given up for the next one, and when the window closes") {
    const TemporaryFolder folder;
    write_even_map(folder / "16.hdr", 16);
    REQUIRE(::mkfifo((folder / "pipe.hdr").c_str(), 0600) == 0);
    LightSession session(LightsSettings{}, [] {});
    session.open(folder / "pipe.hdr");
    session.open(folder / "16.hdr");
    CHECK(brings(session, [&] { return session.name() == "16.hdr" && session.samples().found; }));
    session.open(folder / "pipe.hdr");
    session.take_events();
}

TEST_CASE("a map that cannot be read leaves the one that is shown, and says why") {
    const TemporaryFolder folder;
    LightSession session(LightsSettings{}, [] {});
    session.open({});
    REQUIRE(brings(session, [&] { return session.samples().found.has_value(); }));
    session.open(folder / "none.hdr");
    REQUIRE(brings(session, [&] { return !session.banner.message.empty(); }));
    CHECK(session.banner.kind == BannerKind::error);
    CHECK(session.banner.message.find("none.hdr") != std::string::npos);
    CHECK(session.name() == "Sky");
    CHECK(session.samples().found);
}

TEST_CASE("the first map throws why it cannot be read, as there is nothing to go on showing") {
    LightSession session(LightsSettings{}, [] {});
    session.open("/nowhere/none.hdr");
    CHECK_THROWS_WITH(brings(session, [] { return false; }), doctest::Contains("none.hdr"));
}

TEST_CASE("a tile that is not there is told once, and the samples stay") {
    LightSession session(LightsSettings{}, [] {});
    session.open({});
    REQUIRE(brings(session, [&] { return session.samples().found.has_value(); }));
    const std::uint64_t samplings = session.samplings();
    session.settings.tile = "no such tile";
    REQUIRE(brings(session, [&] { return !session.banner.message.empty(); }));
    CHECK(session.samplings() == samplings);
    CHECK(session.samples().found);
}

TEST_CASE("samples that are given up leave those that are shown, with their settings") {
    const TemporaryFolder folder;
    write_even_map(folder / "large.hdr", 512);
    LightSession session(LightsSettings{}, [] {});
    session.open(folder / "large.hdr");
    REQUIRE(brings(session, [&] { return session.samples().found.has_value(); }));
    const LightsSettings before = session.settings;
    const std::uint64_t samplings = session.samplings();
    session.settings.request.count = 100'000;
    session.settings.stops = 2;  // not of the samples
    session.take_events();
    REQUIRE(session.sampling());
    session.stop(LightWork::sampling);
    CHECK(session.settings.request == before.request);
    CHECK(session.settings.stops == 2);
    CHECK(session.banner.kind == BannerKind::notice);
    CHECK(session.banner.message.find("Cancelled") == 0);
    REQUIRE(brings(session, [&] { return !session.sampling(); }));
    session.take_events();
    CHECK_FALSE(session.sampling());
    CHECK(session.samplings() == samplings);
    CHECK(session.samples().places.size() == before.request.count);

    session.settings.request.count = 500;  // and others come as ever
    CHECK(brings(session, [&] { return session.samples().places.size() == 500; }));
}

TEST_CASE("what takes long is told with how far it is, and a file that is given up is not written") {
    const TemporaryFolder folder;
    write_even_map(folder / "large.hdr", 512);
    LightSession session(LightsSettings{}, [] {});
    session.open({});
    REQUIRE(brings(session, [&] { return session.samples().found.has_value(); }));
    CHECK_FALSE(session.long_work());
    REQUIRE(::mkfifo((folder / "pipe.hdr").c_str(), 0600) == 0);
    session.open(folder / "pipe.hdr");
    REQUIRE(brings(session, [&] { return session.long_work().has_value(); }));
    CHECK(session.long_work()->work == LightWork::reading);
    CHECK(session.long_work()->file == folder / "pipe.hdr");
    session.stop(LightWork::reading);
    REQUIRE(brings(session, [&] { return !session.at_work(); }));
    CHECK(session.name() == "Sky");
    CHECK(session.banner.message.find("pipe.hdr") != std::string::npos);

    session.open(folder / "large.hdr");
    REQUIRE(brings(session, [&] { return session.name() == "large.hdr" && !session.at_work(); }));
    session.save(folder / "large.json");
    session.stop(LightWork::saving);
    REQUIRE(brings(session, [&] { return !session.saving(); }));
    CHECK_FALSE(fs::exists(folder / "large.json"));
    CHECK(session.saved_path().empty());
    CHECK(session.banner.message.find("was not written") != std::string::npos);
}

TEST_CASE("samples are exported with the axes chosen and the map turned, as one asks for by hand") {
    const TemporaryFolder folder;
    LightsSettings settings;
    settings.request.count = 50;
    LightSession session(settings, [] {});
    write_even_map(folder / "even.hdr", 16);
    session.open(folder / "even.hdr");
    REQUIRE(brings(session, [&] { return session.lit() != nullptr; }));
    std::set<std::string> files;
    for (const auto convention : {SphereConvention::openexr, SphereConvention::blender, SphereConvention::usd,
                                  SphereConvention::pbrt}) {
        for (const double turn : {0.0, 30.0}) {
            CAPTURE(static_cast<int>(convention));
            CAPTURE(turn);
            session.settings.convention = convention;
            session.settings.turn_degrees = turn;
            const fs::path file = folder / (std::to_string(files.size()) + ".json");
            session.save(file);
            REQUIRE(brings(session, [&] { return session.saved_path() == file; }));

            RankedTile tile = tile_named(settings.tile, RankingMethod::energy);
            const EnvironmentMap& map = session.lit()->map;
            save_lights(folder / "by_hand.json", map, light_samples(map, tile, settings.request),
                        {.convention = convention, .rotation_degrees = turn, .source = "even.hdr"});
            CHECK(text_of(file) == text_of(folder / "by_hand.json"));
            files.insert(text_of(file));
        }
    }
    CHECK(files.size() == 8);
}

}  // namespace dapple
