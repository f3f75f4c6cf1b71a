#include "app/viewer/shell/shell.h"

#include <imgui.h>
#include <time.h>
#include <algorithm>
#include <chrono>
#include <cstddef>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "app/viewer/desktop/pasted_picture.h"
#include "app/viewer/model/session.h"
#include "app/viewer/model/tile_choices.h"
#include "app/viewer/panels/window_panels.h"
#include "io/files/tile_library.h"
#include "io/settings/xdg_folders.h"

namespace dapple {

std::string Leaving::question() const {
    if (waiting_ && !waiting_->saving) return "changes";
    return asks_about_saving_ ? "saving" : "";
}

std::optional<Successor> Leaving::draw(Document& document, Asking& asking) {
    if (question() == "saving") {
        const std::string file = document.saving();
        const auto answer = file.empty() ? ChangesAnswer::save : dapple::ask_about_saving(file);
        if (answer == ChangesAnswer::discard) document.stop_saving();
        closes_once_saved_ = answer == ChangesAnswer::save || answer == ChangesAnswer::discard;
        asks_about_saving_ = !answer;
    }
    if (!waiting_) return std::nullopt;
    const std::string name = document.unsaved();
    if (name.empty()) return std::exchange(waiting_, {})->next;
    if (waiting_->saving) {
        if (!asking.dialog().is_open()) waiting_.reset();  // it was not saved
        return std::nullopt;
    }
    const auto answer = ask_about_changes(name);
    if (answer == ChangesAnswer::discard) return std::exchange(waiting_, {})->next;
    if (answer == ChangesAnswer::cancel) waiting_.reset();
    if (answer != ChangesAnswer::save) return std::nullopt;
    waiting_->saving = true;
    Session& session = *document.session();
    if (const std::filesystem::path own = session.project_path(); !own.empty())
        session.save_project(own);
    else
        asking.ask_where_to_save(document.where_to_save_project(), Asked::project);
    return std::nullopt;
}

namespace {

// ImGui answers an event over a few frames.
constexpr int kFramesAfterEvent = 3;
constexpr int kUntilSeen = 2;  // frames until a dialog is seen, the first of which ImGui measures it in
constexpr double kCursorBlinks = 0.3;  // seconds
constexpr double kRepeats = 0.02;

bool input_arrived() {
    const ImGuiIO& io = ImGui::GetIO();
    bool arrived = io.MouseDelta.x != 0 || io.MouseDelta.y != 0 || io.MouseWheel != 0;
    for (int button = 0; button < ImGuiMouseButton_COUNT; ++button)
        arrived |= io.MouseClicked[button] || io.MouseReleased[button];
    return arrived;
}

// Processor time of this thread.
double work_ms() {
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) * 1e3 + static_cast<double>(time.tv_nsec) * 1e-6;
}

// Sections of rows that are in dialogs, where rows are listed.
constexpr const char *kPreferenceRows = "Preferences", *kExportRows = "Export";

// What it shows lengths in; null: it shows none.
LengthUnit* unit_of(Document& document) {
    Session* const session = document.session();
    return session ? &session->settings.unit : nullptr;
}

// A row that several formats have is listed once: for the format that the dialog begins with, if that has it.
void list_export_rows(const SaveQuestion& question, Document& document, std::vector<ListedRow>& rows) {
    const std::size_t before = rows.size(), first = format_of(question, question.start).value_or(0);
    const auto list = [&](std::size_t format) {
        section(kExportRows);
        subsection(question.formats[format].name);
        const auto known = static_cast<std::ptrdiff_t>(rows.size());
        document.draw_saving_rows(format);
        const auto is_known = [&](const ListedRow& row) {
            return std::any_of(rows.begin() + static_cast<std::ptrdiff_t>(before), rows.begin() + known,
                               [&](const ListedRow& other) { return other.label == row.label; });
        };
        rows.erase(std::remove_if(rows.begin() + known, rows.end(), is_known), rows.end());
    };
    list(first);
    for (std::size_t format = 0; format < question.formats.size(); ++format)
        if (format != first) list(format);
}

// The canvas's right edge, which a mouse drags; whether one does.
bool drag_edge(glm::vec2 canvas, float scale) {
    constexpr float kHalf = 3;
    ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, {0, 0});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowMinSize, {1, 1});
    ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
    begin_bare("##edge", {canvas.x - kHalf * scale, 0}, {2 * kHalf * scale, canvas.y},
               ImGuiWindowFlags_NoNavInputs | ImGuiWindowFlags_NoBackground);
    press_area("edge", {2 * kHalf * scale, canvas.y});
    note_place("Panels' edge");
    const bool held = ImGui::IsItemActive();
    if (held || ImGui::IsItemHovered()) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
    ImGui::End();
    ImGui::PopStyleVar(3);
    return held;
}

}  // namespace

Shell::Shell(bool log_status, Memory memory, std::filesystem::path unsaved)
    : log_(log_status),
      memory_(std::move(memory)),
      window_("Dapple", memory_.state.window),
      kept_(std::move(unsaved)),
      pasting_(&Window::wake) {
    ImGui::GetIO().UserData = &widgets_;
    panels_shown_ = memory_.state.panels_shown;
    window_.set_appearance(memory_.preferences.appearance);
}

int Shell::run(std::unique_ptr<Document> document) {
    int frames_left = kFramesAfterEvent;
    while (!may_close(document)) {
        double wait_at_most = frames_left > 0 ? 0 : document->seconds_to_next_frame();
        wait_at_most = std::min(wait_at_most, kept_.seconds_until_kept(*document));
        if (ImGui::GetIO().WantTextInput) wait_at_most = std::min(wait_at_most, kCursorBlinks);
        if (repeating_key_down()) wait_at_most = std::min(wait_at_most, kRepeats);
        if (window_.wait_for_events(wait_at_most)) frames_left = kFramesAfterEvent;
        const auto begin = std::chrono::steady_clock::now();
        const double work_before = work_ms();
        frame(*document);
        if (std::exchange(goes_back_, false)) go_back(document);
        if (auto successor = document->take_successor())
            before_ = std::exchange(document, std::move(successor));
        const std::chrono::duration<double, std::milli> passed = std::chrono::steady_clock::now() - begin;
        last_seconds_ = passed.count() / 1e3;
        log_.took(passed.count(), work_ms() - work_before);
        frames_left = input_arrived() || window_.input_waits() ? kFramesAfterEvent : frames_left - 1;
    }
    memory_.state.window = window_.place();
    memory_.state.panels_shown = panels_shown_;
    if (const auto view = document->kept_view()) memory_.state.view = *view;
    save_memory();
    kept_.forget();
    return 0;
}

void Shell::go_back(std::unique_ptr<Document>& document) {
    if (before_)
        document = std::move(before_);
    else
        document->say("No drawing to go back to: the map was opened by itself");
}

bool Shell::may_close(std::unique_ptr<Document>& document) {
    const bool before_saves = before_ && !before_->saving().empty();
    const bool saves = before_saves || !document->saving().empty();
    if (!saves && leaving_.closes_once_saved() && !document->tells_of_trouble()) window_.close();
    if (!window_.should_close()) return false;
    if (before_saves) go_back(document);
    if (saves) {
        window_.stay_open();
        leaving_.ask_about_saving();
        return false;
    }
    if (before_ && !before_->unsaved().empty()) go_back(document);
    if (closing_ || document->unsaved().empty()) return true;
    window_.stay_open();
    leaving_.begin({});
    return false;
}

void Shell::go_on(const Successor& next, Document& document) {
    if (!next.file) {
        closing_ = true;
        window_.close();
    } else if (next.file->as_picture) {
        document.open_as_picture(next.file->file);
    } else {
        document.take_dropped(next.file->file);
    }
}

bool Shell::draw_questions(Document& document) {
    const bool leaves = !leaving_.question().empty();
    const bool about_kept = log_.ready() && kept_.asks();
    if (const auto next = leaving_.draw(document, asking_)) go_on(*next, document);
    if (!leaves && about_kept) kept_.draw_question(document);
    return leaves || about_kept;
}

Shell::Question Shell::question() const {
    if (std::string leaves = leaving_.question(); !leaves.empty()) return {std::move(leaves), kUntilSeen};
    if (log_.ready() && kept_.asks()) return {"kept " + kept_.asked().string(), kUntilSeen};
    if (const std::size_t files = file_question_.files())
        return {"open " + std::to_string(files), kUntilSeen};
    const std::filesystem::path& replaces = asking_.dialog().replaces();
    if (replaces.empty()) return {};
    return {"replace " + replaces.string(), 1};  // in a dialog that is there already
}

void Shell::remember(Document& document) {
    if (!log_.ready()) return;
    memory_.begun();
    if (const auto trouble = memory_.take_trouble()) document.say(*trouble);
    const std::filesystem::path file = document.file();
    if (file.empty() || file == file_seen_) return;
    file_seen_ = file;
    const auto folder = memory_.state.folder;
    memory_.opened(file);
    if (file.parent_path() == pasted_folder()) memory_.state.folder = folder;  // nobody keeps pictures there
    save_memory();
}

// That nothing is remembered is no reason to stop anybody's work.
void Shell::save_memory() {
    try {
        memory_.save();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "dapple: %s; nothing is remembered\n", error.what());
    }
}

void Shell::frame(Document& document) {
    // What was typed before a question could be seen does not answer it.
    const Question asked = question();
    if (std::exchange(question_, asked.what) != asked.what) question_frames_ = 0;
    const bool is_seen = question_frames_ >= asked.frames_until_seen;
    if (!is_seen) window_.forget_typed();
    window_.begin_frame();
    const bool row_has_keys = std::exchange(widgets_.row_with_keys, 0) != 0;  // in the last frame
    widgets_.places.clear();
    widgets_.tips_end.reset();
    const float scale = ImGui::GetFontSize() / 15;
    const glm::vec2 screen{ImGui::GetIO().DisplaySize.x, ImGui::GetIO().DisplaySize.y};
    const float panels = panels_shown_ ? std::min(memory_.state.panel_width * scale, screen.x / 2) : 0;
    std::function<void(Action)> do_this;
    const Frame frame{.window = window_,
                      .canvas = {std::max(screen.x - panels, 1.0f), std::max(screen.y, 1.0f)},
                      .panels = {panels, screen.y},
                      .pixels_per_point = window_.pixels_per_point(),
                      .act = do_this,
                      .last_seconds = last_seconds_,
                      .can_go_back = before_ != nullptr};
    do_this = [&](Action action) { act(action, document, frame); };
    take_files(window_.take_dropped(), document);
    take_answers(document);
    for (Action action : pressed_actions(document.shortcuts(), row_has_keys)) do_this(action);
    draw_dialogs(document, do_this);
    document.draw(frame);
    if (panels_shown_ && drag_edge({frame.canvas.x, screen.y}, scale)) {
        const float width = std::min((screen.x - ImGui::GetIO().MousePos.x) / scale, screen.x / scale / 2);
        memory_.state.panel_width = std::clamp(width, kLeastPanelWidth, kMostPanelWidth);
    }
    window_.end_frame();
    if (!is_seen) window_.forget_typed();
    if (!is_seen && !window_.frame_is_unseen()) ++question_frames_;
    log_.write(document.status(), widgets_);
    remember(document);
    kept_.keep(before_ ? *before_ : document);
}

void Shell::act(Action action, Document& document, const Frame& frame) {
    switch (action) {
        case Action::open:
        case Action::find_picture:
        case Action::open_mask: {
            OpenQuestion question = document.what_to_open();
            if (question.start.empty()) question.start = folder_to_open();
            const DialogChoice choice = memory_.preferences.dialog;
            if (action == Action::open) return asking_.ask_what_to_open(question, Asked::picture, choice);
            const bool mask = action == Action::open_mask;
            question.title = mask ? "Open a mask" : "Find the project's picture";
            return asking_.ask_what_to_open(question, mask ? Asked::mask : Asked::found_picture, choice);
        }
        case Action::open_tile:
            return asking_.ask_what_to_open({"Open a tile", {kTileEnding}, folder_of_tiles(document.tile())},
                                            Asked::tile, memory_.preferences.dialog);
        case Action::paste:
            return paste(document);
        case Action::save:
            if (const auto question = document.where_to_save(); question && !question->own_file.empty())
                return document.save(question->own_file);
            return asking_.ask_where_to_save(document.where_to_save(), Asked::drawing);
        case Action::save_as:
            return asking_.ask_where_to_save(document.where_to_save(), Asked::drawing);
        case Action::save_project:
            return asking_.ask_where_to_save(document.where_to_save_project(), Asked::project);
        case Action::save_film:
            return asking_.ask_where_to_save(document.where_to_save_film(), Asked::film);
        case Action::toggle_panels:
            return toggle(panels_shown_);
        case Action::full_screen:
            return window_.toggle_full_screen();
        case Action::help:
            return toggle(help_shown_);
        case Action::palette:
            return palette_.toggle();
        case Action::preferences:
            return toggle(preferences_shown_);
        case Action::about:
            return toggle(about_shown_);
        case Action::back:
            goes_back_ = true;
            return;
        case Action::quit:
            return window_.close();
        default:
            return document.act(action, frame);
    }
}

void Shell::paste(Document& document) {
    std::vector<std::filesystem::path> files = pasted_files(window_.clipboard_text(), home_folder());
    if (!files.empty()) return take_files(std::move(files), document);
    if (pasting_.busy()) return;
    const std::filesystem::path folder = pasted_folder();
    if (folder.empty()) return document.say("A pasted picture cannot be kept: there is no home folder");
    pasting_.begin([folder](const auto& todo) { return save_pasted_picture(folder, todo.stop()); });
}

void Shell::take_answers(Document& document) {
    try {
        if (const auto chosen = asking_.answer()) take_chosen(*chosen, document);
        if (const auto pasted = pasting_.result()) document.open_as_picture(*pasted);
    } catch (const std::exception& error) {
        document.say(error.what());
    }
}

void Shell::take_files(std::vector<std::filesystem::path> files, Document& document) {
    file_question_.ask(std::move(files),
                       [&](const auto& file) { return document.is_picture_with_settings(file); });
}

void Shell::open_again(const std::filesystem::path& file, Document& document) {
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) return take_files({file}, document);
    memory_.forget(file);
    save_memory();
    document.say(file.string() + ": no longer exists");
}

void Shell::draw_file_question(Document& document) {
    const auto answer =
        file_question_.draw([&](const auto& file) { return document.is_picture_with_settings(file); });
    if (!answer) return;
    const Session* const session = document.session();
    if (session && session->would_lose_changes(answer->file))
        leaving_.begin({*answer});
    else
        go_on({*answer}, document);
}

std::filesystem::path Shell::folder_to_open() const {
    std::error_code ignored;
    for (const std::filesystem::path& folder : memory_.state.folder)
        if (std::filesystem::is_directory(folder, ignored)) return folder;
    return working_folder();
}

// In a window beyond the screen: what panels draw beside rows has to be in one.
void Shell::list_rows(Document& document, std::vector<ListedRow>& rows, const ListedRow* taken, int value) {
    begin_bare("##listed", {-9999, -9999}, {300, 300},
               ImGuiWindowFlags_NoInputs | ImGuiWindowFlags_NoNav | ImGuiWindowFlags_NoBringToFrontOnFocus);
    {
        const RowListing listing(rows, taken, value);
        document.draw_rows();
        section(kPreferenceRows);
        auto& [appearance, dialog] = memory_.preferences;
        if (draw_preferences(appearance, dialog, unit_of(document))) take_preferences();
        if (const auto question = document.where_to_save(); question && question->has_options)
            list_export_rows(*question, document, rows);
    }
    ImGui::End();
}

void Shell::take_row(const ListedRow& row, int value, Document& document) {
    if (!row.why_not.empty()) return document.say(row.label + ": " + row.why_not);
    std::vector<std::string> sections = row.sections;
    if (row.is_section) sections.push_back(row.label);
    const std::string outer = sections.empty() ? "" : sections.front();
    if (value >= 0) {
        std::vector<ListedRow> rows;
        list_rows(document, rows, &row, value);
    }
    if (outer == kPreferenceRows) {
        preferences_shown_ |= value < 0;
        return;
    }
    widgets_.reveal = row;
    if (outer != kExportRows) {
        panels_shown_ = true;
    } else if (auto question = document.where_to_save()) {
        const auto format = std::ranges::find_if(
            question->formats, [&](const FileFormat& each) { return each.name == sections.back(); });
        const auto begun = format_of(*question, question->start);
        if (format != question->formats.end() &&
            (!begun || question->formats[*begun].name != sections.back()))
            question->start.replace_extension(format->ending);
        question->begins_below = true;
        asking_.ask_where_to_save(std::move(question), Asked::drawing);
    }
}

void Shell::take_preferences() {
    window_.set_appearance(memory_.preferences.appearance);
    save_memory();
}

void Shell::draw_dialogs(Document& document, const std::function<void(Action)>& act) {
    // Alone: two dialogs would take turns in each other's place.
    if (draw_questions(document)) return;
    std::vector<ListedRow> rows;
    if (palette_.is_open()) list_rows(document, rows);
    palette_.draw(
        document.shortcuts(), act,
        {memory_.state.recent, [&](const std::filesystem::path& file) { open_again(file, document); }},
        {rows, [&](const ListedRow& row, int value) { take_row(row, value, document); }});
    draw_help_panel(help_shown_, document.shortcuts());
    draw_about_panel(about_shown_);
    auto& [appearance, dialog] = memory_.preferences;
    if (draw_preferences_panel(preferences_shown_, appearance, dialog, unit_of(document))) take_preferences();
    draw_file_question(document);
    const auto chosen =
        asking_.draw([&](std::size_t format) { return document.draw_saving_options(format); });
    if (chosen) take_chosen(*chosen, document);
}

void Shell::take_chosen(const Asking::Chosen& chosen, Document& document) {
    const auto& [path, asked] = chosen;
    Session* const session = document.session();
    if (asked == Asked::picture) return take_files({path}, document);
    if (asked == Asked::tile) return document.open_tile(path);
    if (asked == Asked::mask) return document.open_mask(path);
    if (asked == Asked::drawing) return document.save(path);
    if (!session) return;  // the question was another document's
    if (asked == Asked::found_picture) session->find_picture(path);
    if (asked == Asked::project) session->save_project(path);
    if (asked == Asked::film) session->save_film(path);
}

}  // namespace dapple
