#pragma once
// The column of panels beside the canvas.

#include <functional>
#include <glm/vec2.hpp>
#include <string>

#include "app/viewer/model/session.h"
#include "app/viewer/panels/method_panels.h"
#include "app/viewer/panels/settings_panels.h"
#include "app/viewer/panels/shortcuts.h"
#include "app/viewer/panels/window_panels.h"

namespace dapple {

/// What the column begins with.
struct SidePanelTitle {
    std::string name, description;
    UndoInfo undo;
    bool has_project = false;
};

/// Begins the column in a rectangle: title, menu and buttons, which call `act`. What follows is drawn below.
void begin_side_panel(glm::vec2 corner, glm::vec2 size, const SidePanelTitle& title,
                      const std::function<void(Action)>& act);
void end_side_panel();

/// Which of its sections are open that others draw or measure for.
struct OpenSections {
    bool method = false, spectrum = false;  // see draw_spectrum_panel()
};

/// That of a drawing, in the order in which an artist decides.
class SidePanel {
 public:
    /// The folders of the person's own: see PresetRow and PaletteRow.
    explicit SidePanel(std::filesystem::path presets = {}, std::filesystem::path palettes = {})
        : presets_(std::move(presets)), palettes_(std::move(palettes)) {}

    /// Its rows alone, to be listed: see RowListing.
    static void draw_rows(Session& session);

    Column column() const { return column_; }
    /// From the one that there is, back to the drawing.
    void turn_to(Column column, Session& session);

    /// Draws it into a rectangle. The panels edit the session's settings; the buttons call `act`.
    OpenSections draw(Session& session, const SpectrumInfo& spectrum, const PresetRow::Preview& preview,
                      const std::function<void(Action)>& act, glm::vec2 corner, glm::vec2 size);

 private:
    void turn_to_revealed(Session& session);

    Column column_ = Column::drawing;
    std::string revealed_;  // the row that was turned to last
    PresetRow presets_;
    PaletteRow palettes_;
    std::size_t points_shown_ = SIZE_MAX;  // of the tile, at most
    int tiles_seen_ = 0;
};

}  // namespace dapple
