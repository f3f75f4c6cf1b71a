#pragma once
// What one side of the canvas has done in the background, in order: pictures opened, dots placed for the
// newest of the requests, files written beside further placing, so that the window never waits and sliders go
// on while a large drawing is saved. Used by the window's thread alone.

#include <chrono>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "app/viewer/background/background.h"
#include "app/viewer/background/workbench.h"

namespace dapple {

/// What has happened since the window asked last.
struct TaskFailed {
    std::string message;
    std::optional<std::filesystem::path> picture = {};  // that could not be read; none: it was other work
};
struct DrawingSaved {
    std::filesystem::path path;
};
struct SavingCancelled {
    std::filesystem::path path;
};
/// A picture was not opened, or no more than a first look at it, as nobody wanted to wait.
struct OpeningStopped {
    std::string name;
    std::filesystem::path picture;
};
using WorkerEvent = std::variant<DotsPlaced, TaskFailed, DrawingSaved, SavingCancelled, OpeningStopped>;

/// What is being saved.
struct SavingInfo {
    std::filesystem::path path;
    double share = 0;  // written, 0..1
};

/// What is being opened.
struct OpeningInfo {
    std::string name;
    std::chrono::steady_clock::time_point since;
};

/// How a picture is read, beside further placing.
struct Opening {
    std::function<Picture(const std::stop_token&)> whole;
    /// A smaller one of the same, soon; nothing where there is none. It is drawn until the whole one is
    /// there.
    std::function<std::optional<Picture>(const std::stop_token&)> first_look = {};
};

class Worker {
 public:
    /// `wake` is called from other threads whenever events() has something to do.
    explicit Worker(std::function<void()> wake) : reading_(wake), placing_(wake), writing_(std::move(wake)) {}

    using Open = std::function<Picture()>;

    /// Runs `open`, then shows what it returns under `name`. If it throws, the old picture stays.
    void open(std::string name, Open open, std::filesystem::path file = {});
    /// The same for what can be stopped, and may have a first look. What is requested later than this waits
    /// for the whole picture, but for dots. If only a first look came, nothing is saved.
    void open(std::string name, Opening opening, std::filesystem::path file = {});
    /// Gives up what is being read.
    void stop_opening();
    /// The picture that is being read; none if none is.
    std::optional<OpeningInfo> opening() const;

    /// Places as requested. A request that has not begun is replaced; one that has run for long, or that was
    /// shown already, is stopped; a short one may finish so that something moves under a slider that never
    /// rests.
    void place(DotsRequest request);

    /// Forgets picture, dots and requests, with pictures that are not being read yet, and gives their memory
    /// back, after what is under way. Only events that were there already may still come.
    void clear();

    /// Runs `prepare` after what is under way, then what it returns beside further placing.
    void save(std::filesystem::path path, PrepareFile prepare);
    void cancel_saving();
    std::optional<SavingInfo> saving() const;

    /// When the placing that is under way began; none if none is.
    std::optional<std::chrono::steady_clock::time_point> placing_since() const;
    /// Which share of its dots is placed, 0..1; none before the first, and of Figure 8's, which come at once.
    std::optional<float> placed_share() const;

    /// Everything since the last call; begins what is next. Waits up to `patience` for a placing that is
    /// under way.
    std::vector<WorkerEvent> events(std::chrono::milliseconds patience = std::chrono::milliseconds(0));

    /// Gives back a drawing that is no longer needed: its memory is used again, or freed if that is far more
    /// than drawings need now. Takes no time, however large it is.
    void recycle(PlacedDrawing drawing);

 private:
    struct OpenTask {
        std::string name;
        Opening opening;
        std::filesystem::path file;
    };
    struct ReadPicture {
        Picture picture;
        bool whole = true;
    };
    struct ShowTask {
        ReadPicture read;
        OpenedPicture about;
    };
    /// A file that was asked for; the same one may be asked for again.
    struct Save {
        std::uint64_t number = 0;  // they are counted
        std::filesystem::path path;
    };
    struct SaveTask {
        Save save;
        PrepareFile prepare;
        WriteFile write = {};  // once that is done
    };
    struct ClearTask {};
    struct SortTask {};  // of drawings given back
    using Task = std::variant<OpenTask, ShowTask, SaveTask, ClearTask, SortTask, DotsRequest>;

    void go_on();
    void take_read();
    void fail_opening();
    void begin_opening();
    void take_results();
    void end_task();
    void begin_next();
    void begin(Task task);
    void take_written();
    void write_next();
    bool cancelled(const Save& save) const { return save.number < cancelled_saves_; }
    /// Once: what comes after its first outcome is none.
    void end_saving(const Save& save, WorkerEvent outcome);
    bool placing() const { return under_way_ && std::holds_alternative<DotsRequest>(*under_way_); }

    std::deque<Task> tasks_;
    std::optional<DotsRequest> next_request_, last_request_;
    std::optional<Task> under_way_;
    std::optional<OpenTask> opening_;                // the one being read
    bool opening_stopped_ = false, looked_ = false;  // its first look was shown
    std::deque<ShowTask> read_;
    std::string whole_missing_;  // why only a first look is shown; empty: it is not so
    std::deque<SaveTask> writes_;
    std::optional<SaveTask> written_;    // the one under way
    std::deque<Save> saves_;             // all that were not ended
    std::uint64_t all_saves_ = 0;        // so many were asked for,
    std::uint64_t cancelled_saves_ = 0;  // and the first so many of them have ended or are cancelled
    std::vector<PlacedDrawing> given_back_;
    std::vector<WorkerEvent> events_;

    Workbench bench_;  // of the task under way; the window's while there is none
    Background<ReadPicture> reading_;
    Background<DotsPlaced> placing_;
    Background<WorkerEvent> writing_;  // last: these use all of the above
};

}  // namespace dapple
