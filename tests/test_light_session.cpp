// The environment map's window without the window: what is saved of it. Its textures need OpenGL.

#include "app/viewer/light_session.h"

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include "app/files/save_lights.h"
#include "app/files/tile_library.h"
#include "tests/file_text.h"
#include "tests/offscreen_gl.h"
#include "tests/temporary_folder.h"
#include "tests/wait_until.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

template <class Done>
bool brings(LightSession& session, Done done) {
    return wait_until([&] {
        session.take_news();
        return done();
    });
}

}  // namespace

TEST_CASE("samples are exported with the axes chosen and the map turned, as one asks for by hand") {
    const OffscreenContext context;
    const TemporaryFolder folder;
    LightsSettings settings;
    settings.request.count = 50;
    LightSession session(settings);
    {
        // Of 16 x 8 texels, all alike, in Radiance's format.
        std::ofstream out(folder / "even.hdr", std::ios::binary);
        out << "#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 8 +X 16\n";
        for (int texel = 0; texel < 8 * 16; ++texel) out << "\x80\x80\x80\x81";
    }
    session.open(folder / "even.hdr");
    REQUIRE(brings(session, [&] { return session.scene() != nullptr; }));
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

            RankedTile tile = tile_named(settings.tile, RankingOrder::energy);
            const EnvironmentMap& map = session.scene()->map();
            save_lights(folder / "by_hand.json", map, light_samples(map, tile, settings.request),
                        {.convention = convention, .rotation_degrees = turn, .source = "even.hdr"});
            CHECK(text_of(file) == text_of(folder / "by_hand.json"));
            files.insert(text_of(file));
        }
    }
    CHECK(files.size() == 8);
}

}  // namespace dapple
