#include "app/viewer/model/worker.h"

#include <malloc.h>

#include <algorithm>
#include <exception>
#include <new>

#include "app/viewer/model/mipmaps.h"

namespace dapple {
namespace {

// A placing that has run for so long is stopped when another is ordered.
constexpr std::chrono::milliseconds kLong(250);
constexpr std::size_t kMostSpare = 2;
constexpr std::size_t kManyDots = 1'000'000;  // fewer are not worth giving their memory back
// A drawing that takes longer to settle is shown on its way.
constexpr std::chrono::milliseconds kFrame(16);
constexpr double kSecondsADotAndStep = 0.4e-6;  // about, on two processor cores

std::string words_of_exception() {
    try {
        throw;
    } catch (const std::bad_alloc&) {
        return "There is not enough memory for this.";
    } catch (const std::exception& error) {
        return error.what();
    }
}

std::size_t room_of(const PlacedDrawing& drawing) {
    std::size_t room = 0;
    for (const Dots& piece : drawing.stippling.dots.pieces) room += piece.x.capacity();
    return room;
}

bool far_too_large(std::size_t room, std::size_t dots) {
    return room > kManyDots && room > 4 * dots;
}

// What was freed in small pieces stays with the C library otherwise.
void give_memory_back() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

// What the window needs beyond the drawing, and nothing that it doesn't.
void make_ready_for_screen(PlacedDrawing& drawing) {
    drawing.blocks = dot_blocks(drawing.stippling.dots);
    // Large tiles first: see Renderer::set_tiles().
    std::ranges::stable_sort(drawing.outlines, {}, &PlacedTile::level);
    if (!far_too_large(room_of(drawing), drawing.stippling.dots.size())) return;
    for (Dots& piece : drawing.stippling.dots.pieces) {
        for (FloatBuffer* column : {&piece.x, &piece.y, &piece.threshold, &piece.critical, &piece.radius})
            column->shrink_to_fit();
    }
    drawing.colours.shrink_to_fit();
    give_memory_back();
}

bool looks_like_environment(const Grid<float>& light) {
    return light.width == 2 * light.height && std::ranges::max(light.values) > 1;
}

bool same_tile(const DotsRequest& a, const DotsRequest& b) {
    return a.tile == b.tile && a.ranking == b.ranking && a.drawing.placer == b.drawing.placer;
}

}  // namespace

Worker::Worker(std::function<void()> wake)
    : wake_(std::move(wake)),
      thread_([this](std::stop_token stop) { run(stop); }),
      writer_([this](std::stop_token stop) { run_writes(stop); }) {}

Worker::~Worker() {
    thread_.request_stop();
    writer_.request_stop();
    std::scoped_lock lock(mutex_);
    placing_stop_.request_stop();
    saving_stop_.request_stop();
}

void Worker::open(std::string name, Open open, std::filesystem::path file) {
    std::scoped_lock lock(mutex_);
    tasks_.push_back(OpenTask{std::move(name), std::move(open), std::move(file)});
    changed_.notify_all();
}

void Worker::place(DotsRequest request) {
    std::scoped_lock lock(mutex_);
    last_request_ = request;
    last_request_->close.reset();
    next_request_ = std::move(request);
    if (placing_since_ && (placing_shown_ || std::chrono::steady_clock::now() - *placing_since_ > kLong))
        placing_stop_.request_stop();
    changed_.notify_all();
}

void Worker::clear() {
    std::scoped_lock lock(mutex_);
    last_request_.reset();
    next_request_.reset();
    placing_stop_.request_stop();
    tasks_.push_back(ClearTask{});
    changed_.notify_all();
}

void Worker::save(std::filesystem::path path, Prepare prepare) {
    std::scoped_lock lock(mutex_);
    if (saves_++ == 0) {
        saving_stop_ = {};
        saving_ = {path, 0};
    }
    tasks_.push_back(SaveTask{std::move(path), std::move(prepare)});
    changed_.notify_all();
}

void Worker::cancel_saving() {
    std::scoped_lock lock(mutex_);
    saving_stop_.request_stop();
}

std::optional<SavingInfo> Worker::saving() const {
    std::scoped_lock lock(mutex_);
    if (saves_ == 0) return std::nullopt;
    return saving_;
}

std::optional<std::chrono::steady_clock::time_point> Worker::placing_since() const {
    std::scoped_lock lock(mutex_);
    return placing_since_;
}

std::optional<float> Worker::placed_share() const {
    const float share = placed_share_;
    return placing_since() && share >= 0 ? std::optional(share) : std::nullopt;
}

std::vector<WorkerEvent> Worker::events(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    if (patience.count() > 0)
        changed_.wait_for(lock, patience,
                          [&] { return !events_.empty() || (!next_request_ && !placing_since_); });
    return std::exchange(events_, {});
}

void Worker::recycle(PlacedDrawing drawing) {
    std::scoped_lock lock(mutex_);
    given_back_.push_back(std::move(drawing));
    changed_.notify_all();
}

void Worker::publish(WorkerEvent event) {
    {
        std::scoped_lock lock(mutex_);
        events_.push_back(std::move(event));
        changed_.notify_all();
    }
    wake_();
}

void Worker::publish_failure() noexcept {
    try {
        publish(TaskFailed{words_of_exception()});
    } catch (...) {  // there is no memory even for that, or nobody to be woken
    }
}

void Worker::sort_given_back() {
    std::vector<PlacedDrawing> given_back;
    {
        std::scoped_lock lock(mutex_);
        given_back.swap(given_back_);
    }
    std::size_t freed = 0;
    for (PlacedDrawing& drawing : given_back) {
        const std::size_t room = room_of(drawing);
        if (spare_.size() < kMostSpare && !far_too_large(room, last_size_))
            spare_.push_back(std::move(drawing));
        else
            freed += room;
    }
    std::erase_if(spare_, [&](const PlacedDrawing& drawing) {
        const bool too_large = far_too_large(room_of(drawing), last_size_);
        if (too_large) freed += room_of(drawing);
        return too_large;
    });
    given_back.clear();
    if (freed > kManyDots) give_memory_back();
}

void Worker::run(std::stop_token stop) {
    while (true) {
        std::optional<Task> task;
        std::optional<DotsRequest> request;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop,
                          [&] { return !tasks_.empty() || next_request_ || !given_back_.empty(); });
            if (stop.stop_requested()) return;
            if (!tasks_.empty()) {
                task = std::move(tasks_.front());
                tasks_.pop_front();
            } else if (next_request_) {
                request = *std::exchange(next_request_, std::nullopt);
                placing_stop_ = {};
                placing_since_ = std::chrono::steady_clock::now();
                placing_shown_ = false;
                placed_share_ = -1;
            }
        }
        // Whatever goes wrong, this thread goes on and someone is told.
        try {
            sort_given_back();
            if (task)
                std::visit([this](auto& t) { run_task(t); }, *task);
            else if (request && workbench_.has_picture())
                run_request(*request);
        } catch (...) {
            publish_failure();
        }
        std::scoped_lock lock(mutex_);
        placing_since_.reset();
        changed_.notify_all();
    }
}

void Worker::run_task(OpenTask& task) {
    try {
        Picture picture = task.open();
        int longer = std::max(picture.light.width, picture.light.height);
        const bool environment = looks_like_environment(picture.light);
        workbench_.set_picture(std::move(picture.light), picture.exposure);
        arrived_ = OpenedPicture{
            .file = task.file,
            .name = task.name,
            .description = picture.description,
            .longer_side = longer,
            .preview = std::make_shared<const std::vector<Grid<glm::u8vec4>>>(
                mipmaps_of(std::move(picture.preview))),
            .exposure = picture.exposure,
            .read = task.open,
            .looks_like_environment = environment,
        };
        std::scoped_lock lock(mutex_);
        if (!next_request_ || next_request_->close) next_request_ = last_request_;
    } catch (...) {
        publish(TaskFailed{words_of_exception()});
    }
}

void Worker::run_task(SaveTask& task) {
    std::stop_token stop;
    {
        std::scoped_lock lock(mutex_);
        stop = saving_stop_.get_token();
    }
    try {
        Write write;
        if (!stop.stop_requested()) write = task.prepare(workbench_, stop);
        if (!write) return end_saving(SavingCancelled{task.path});
        std::scoped_lock lock(mutex_);
        writes_.push_back({task.path, std::move(write)});
        changed_.notify_all();
    } catch (...) {
        end_saving(TaskFailed{words_of_exception()});
    }
}

void Worker::run_task(ClearTask&) {
    workbench_ = {};
    arrived_.reset();
    spare_.clear();
    last_size_ = 0;
    sort_given_back();
    give_memory_back();
}

void Worker::run_writes(std::stop_token stop) {
    while (true) {
        WriteTask task;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [&] { return !writes_.empty(); });
            if (stop.stop_requested()) return;
            task = std::move(writes_.front());
            writes_.pop_front();
            saving_ = {task.path, 0};
        }
        try {
            run_write(task);
        } catch (...) {
            publish_failure();
        }
    }
}

void Worker::run_write(const WriteTask& task) {
    SavingWatch watch;
    {
        std::scoped_lock lock(mutex_);
        watch.stop = saving_stop_.get_token();
    }
    watch.progress = [this](double share) {
        {
            std::scoped_lock lock(mutex_);
            // The window draws a frame for each step.
            if (share < 1 && share < saving_.share + 0.01) return;
            saving_.share = share;
        }
        wake_();
    };
    try {
        bool written = !watch.stop.stop_requested() && task.write(watch);
        end_saving(written ? WorkerEvent(DrawingSaved{task.path}) : WorkerEvent(SavingCancelled{task.path}));
    } catch (...) {
        end_saving(TaskFailed{words_of_exception()});
    }
}

void Worker::end_saving(WorkerEvent outcome) {
    {
        std::scoped_lock lock(mutex_);
        --saves_;
    }
    publish(std::move(outcome));
}

void Worker::run_request(const DotsRequest& request) {
    DotsPlaced placed;
    placed.request = request;
    std::stop_token stop;
    {
        std::scoped_lock lock(mutex_);
        stop = placing_stop_.get_token();
    }
    if (!spare_.empty()) {
        placed.drawing = std::move(spare_.back());
        spare_.pop_back();
    }
    workbench_.report_share(&placed_share_);
    // Steps that fit into a frame are not shown one by one.
    auto shown = std::chrono::steady_clock::now();
    const std::chrono::duration<double> step(static_cast<double>(request.drawing.placing.count.value_or(0)) *
                                             kSecondsADotAndStep);
    const Unsettled unsettled = [&](const std::function<PlacedDrawing()>& drawing) {
        if (stop.stop_requested()) return false;
        if (request.settled_only) return true;
        if (std::chrono::steady_clock::now() + step - shown < kFrame) return true;
        const bool goes_on = publish_unsettled(request, drawing());
        shown = std::chrono::steady_clock::now();
        return goes_on;
    };
    try {
        if (!workbench_.place(request, placed.drawing, stop, unsettled) || stop.stop_requested())
            return recycle(std::move(placed.drawing));
        last_size_ = placed.drawing.stippling.dots.size();
        make_ready_for_screen(placed.drawing);
        sort_given_back();
    } catch (...) {
        placed.error = words_of_exception();
        placed.drawing = {};
    }
    if (placed.error.empty()) add_tile(placed);
    placed.picture = std::exchange(arrived_, std::nullopt);
    publish(std::move(placed));
}

bool Worker::publish_unsettled(const DotsRequest& request, PlacedDrawing drawing) {
    DotsPlaced placed;
    placed.request = request;
    placed.drawing = std::move(drawing);
    make_ready_for_screen(placed.drawing);
    add_tile(placed);
    placed.picture = std::exchange(arrived_, std::nullopt);
    {
        std::scoped_lock lock(mutex_);
        placing_shown_ = true;
    }
    publish(std::move(placed));
    std::scoped_lock lock(mutex_);
    return !next_request_;
}

void Worker::add_tile(DotsPlaced& event) {
    const DotsRequest& request = event.request;
    if (tile_published_ && same_tile(*tile_published_, request)) return;
    event.tile = view_of(request.tile, workbench_.pipeline().tile(), request.drawing.placer);
    tile_published_ = request;
}

}  // namespace dapple
