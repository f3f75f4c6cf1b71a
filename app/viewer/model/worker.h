#pragma once
// A thread that reads pictures and places dots, and one that writes files, so that the window never waits and
// sliders go on while a large drawing is saved.

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <stop_token>
#include <string>
#include <thread>
#include <variant>
#include <vector>

#include "app/files/picture.h"
#include "app/files/save_drawing.h"
#include "app/viewer/model/tile_view.h"
#include "app/viewer/model/workbench.h"

namespace dapple {

/// A picture that was opened; its light stays with the worker.
struct OpenedPicture {
    std::filesystem::path file = {};                                // none: not from one
    std::string name;                                               // for the title: "cat.png"
    std::string description;                                        // "512 x 512 pixels, ..."
    int longer_side = 1;                                            // pixels
    std::shared_ptr<const std::vector<Grid<glm::u8vec4>>> preview;  // mipmaps_of() it
    float exposure = 0;                                             // see Picture
    std::function<Picture()> read;                                  // reads it again
    /// Twice as wide as high and in parts brighter than paper, as environment maps are.
    bool looks_like_environment = false;
};

/// What the worker has to tell. A new picture comes together with its first dots. A drawing whose dots are
/// still to be relaxed comes as it lies, and again when it has settled further.
struct DotsPlaced {
    DotsRequest request;
    PlacedDrawing drawing;
    std::optional<OpenedPicture> picture;
    std::optional<TileView> tile;  // if it is another than the one told before
    std::string error;             // why there are no dots
};
struct TaskFailed {
    std::string message;
};
struct DrawingSaved {
    std::filesystem::path path;
};
struct SavingCancelled {
    std::filesystem::path path;
};
using WorkerEvent = std::variant<DotsPlaced, TaskFailed, DrawingSaved, SavingCancelled>;

/// What is being saved.
struct SavingInfo {
    std::filesystem::path path;
    double share = 0;  // written, 0..1
};

class Worker {
 public:
    /// `wake` is called from the worker's thread whenever there is an event.
    explicit Worker(std::function<void()> wake);
    ~Worker();

    using Open = std::function<Picture()>;
    /// Writes a file; false if stopped.
    using Write = std::function<bool(const SavingWatch&)>;
    /// Places what is to be written. Empty if stopped.
    using Prepare = std::function<Write(Workbench&, std::stop_token)>;

    /// Runs `open`, then shows what it returns under `name`. If it throws, the old picture stays.
    void open(std::string name, Open open, std::filesystem::path file = {});

    /// Places as ordered. An order that has not begun is replaced; one that has run for long, or that was
    /// shown already, is stopped; a short one may finish so that something moves under a slider that never
    /// rests.
    void place(DotsRequest request);

    /// Forgets picture, dots and orders and gives their memory back, after what is under way. Only events
    /// that was there already may still come.
    void clear();

    /// Runs `prepare` after what is under way, then what it returns beside further placing.
    void save(std::filesystem::path path, Prepare prepare);
    void cancel_saving();
    std::optional<SavingInfo> saving() const;

    /// When the placing that is under way began; none if none is.
    std::optional<std::chrono::steady_clock::time_point> placing_since() const;
    /// Which share of its dots is placed, 0..1; none before the first, and of Figure 8's, which come at once.
    std::optional<float> placed_share() const;

    /// Everything since the last call. Waits up to `patience` for a placing that is under way.
    std::vector<WorkerEvent> events(std::chrono::milliseconds patience = std::chrono::milliseconds(0));

    /// Gives back a drawing that is no longer needed: its memory is used again, or freed if that is far more
    /// than drawings need now. Takes no time, however large it is.
    void recycle(PlacedDrawing drawing);

 private:
    struct OpenTask {
        std::string name;
        Open open;
        std::filesystem::path file;
    };
    struct SaveTask {
        std::filesystem::path path;
        Prepare prepare;
    };
    struct WriteTask {
        std::filesystem::path path;
        Write write;
    };
    struct ClearTask {};
    using Task = std::variant<OpenTask, SaveTask, ClearTask>;

    void run(std::stop_token stop);
    void run_writes(std::stop_token stop);
    void publish_failure() noexcept;
    void end_saving(WorkerEvent outcome);
    void run_task(OpenTask& task);
    void run_task(SaveTask& task);
    void run_task(ClearTask& task);
    void run_write(const WriteTask& task);
    void run_request(const DotsRequest& request);
    void sort_given_back();
    bool publish_unsettled(const DotsRequest& request, PlacedDrawing drawing);
    void add_tile(DotsPlaced& event);
    void publish(WorkerEvent event);

    std::function<void()> wake_;
    Workbench workbench_;                        // the thread's own
    std::optional<OpenedPicture> arrived_;       // the thread's own: waits for its dots
    std::vector<PlacedDrawing> spare_;           // the thread's own
    std::size_t last_size_ = 0;                  // the thread's own: dots of the last drawing
    std::optional<DotsRequest> tile_published_;  // the thread's own: the order whose tile was told last

    mutable std::mutex mutex_;
    std::condition_variable_any changed_;
    std::deque<Task> tasks_;
    std::deque<WriteTask> writes_;
    std::optional<DotsRequest> next_request_, last_request_;
    std::vector<WorkerEvent> events_;
    std::vector<PlacedDrawing> given_back_;
    std::stop_source placing_stop_, saving_stop_;
    std::optional<std::chrono::steady_clock::time_point> placing_since_;
    bool placing_shown_ = false;            // of what is under way something was told
    std::atomic<float> placed_share_ = -1;  // of what is under way; below 0: not known
    int saves_ = 0;
    SavingInfo saving_;  // of use while saves_ > 0

    std::jthread thread_, writer_;  // last: they use all of the above
};

}  // namespace dapple
