#include "app/viewer/actions.h"

#include "app/files/tile_library.h"
#include "app/viewer/panels/export_panel.h"
#include "app/viewer/tile_choices.h"

namespace dapple {
namespace {

namespace fs = std::filesystem;

const std::vector<std::string> kPictures{".png",  ".jpg", ".jpeg", ".tif", ".tiff", ".exr", ".hdr",
                                         ".webp", ".gif", ".bmp",  ".tga", ".psd",  ".ppm", ".pgm",
                                         ".pnm",  ".jp2", ".heic", ".dpx", ".fits", ".ico", ".pic"};

fs::path where_to_save(const Session& session) {
    if (!session.saved_path().empty()) return session.saved_path();
    return fs::current_path() / fs::path(session.picture().name).stem().concat(".svg");
}

void ask_what_to_open(const Stage& stage) {
    stage.shown.asks_for_tile = false;
    const fs::path& path = stage.session.picture_path();
    stage.shown.dialog.ask_what_to_open(
        {"Open a picture", kPictures, path.empty() ? fs::current_path() : path});
}

void ask_for_tile(const Stage& stage) {
    stage.shown.asks_for_tile = true;
    stage.shown.dialog.ask_what_to_open(
        {"Open a tile", {kTileEnding}, folder_of_tiles(stage.session.settings.drawing.tile)});
}

void ask_where_to_save(const Stage& stage) {
    stage.shown.dialog.ask_where_to_save({.title = "Export the drawing",
                                          .formats = {{"SVG", ".svg"}, {"PNG", ".png"}, {"CSV", ".csv"}},
                                          .start = where_to_save(stage.session),
                                          .own_file = stage.session.saved_path(),
                                          .option_rows = kExportRows});
}

void toggle(bool& value) {
    value = !value;
}

}  // namespace

void act(Action action, const Stage& stage) {
    Session& session = stage.session;
    switch (action) {
        case Action::open:
            return ask_what_to_open(stage);
        case Action::open_tile:
            return ask_for_tile(stage);
        case Action::save:
            if (session.saved_path().empty()) return ask_where_to_save(stage);
            return session.save(session.saved_path());
        case Action::save_as:
            return ask_where_to_save(stage);
        case Action::undo:
            return session.undo();
        case Action::redo:
            return session.redo();
        case Action::fit:
            return stage.canvas.fit();
        case Action::one_to_one:
            return stage.canvas.zoom_to(session.picture().longer_side);
        case Action::zoom_in:
            return stage.canvas.zoom(1.25);
        case Action::zoom_out:
            return stage.canvas.zoom(0.8);
        case Action::toggle_tiles:
            return toggle(session.settings.drawing.show_tiles);
        case Action::compare: {
            ViewerSettings& settings = session.settings;
            settings.comparison = toggled(settings.comparison, settings.drawing);
            return;
        }
        case Action::loupe:
            return toggle(session.settings.loupe.on);
        case Action::photograph:  // while the key is held
        case Action::lighter:
        case Action::darker:
            return;  // of environment maps
        case Action::toggle_panels:
            return toggle(stage.shown.panels);
        case Action::full_screen:
            return stage.window.toggle_full_screen();
        case Action::help:
            return toggle(stage.shown.help);
        case Action::quit:
            return stage.window.close();
    }
}

}  // namespace dapple
