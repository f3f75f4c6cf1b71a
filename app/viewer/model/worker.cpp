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

bool same_tile(const PlaceOrder& a, const PlaceOrder& b) {
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

void Worker::open(std::string name, Open open) {
    std::scoped_lock lock(mutex_);
    tasks_.push_back(OpenTask{std::move(name), std::move(open)});
    changed_.notify_all();
}

void Worker::place(PlaceOrder order) {
    std::scoped_lock lock(mutex_);
    last_order_ = order;
    last_order_->close.reset();
    next_order_ = std::move(order);
    if (placing_since_ && (placing_shown_ || std::chrono::steady_clock::now() - *placing_since_ > kLong))
        placing_stop_.request_stop();
    changed_.notify_all();
}

void Worker::clear() {
    std::scoped_lock lock(mutex_);
    last_order_.reset();
    next_order_.reset();
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

std::optional<SavingFacts> Worker::saving() const {
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

std::vector<WorkerNews> Worker::news(std::chrono::milliseconds patience) {
    std::unique_lock lock(mutex_);
    if (patience.count() > 0)
        changed_.wait_for(lock, patience,
                          [&] { return !news_.empty() || (!next_order_ && !placing_since_); });
    return std::exchange(news_, {});
}

void Worker::recycle(PlacedDrawing drawing) {
    std::scoped_lock lock(mutex_);
    given_back_.push_back(std::move(drawing));
    changed_.notify_all();
}

void Worker::publish(WorkerNews news) {
    {
        std::scoped_lock lock(mutex_);
        news_.push_back(std::move(news));
        changed_.notify_all();
    }
    wake_();
}

void Worker::tell_failure() noexcept {
    try {
        publish(FailedNews{words_of_exception()});
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
        std::optional<PlaceOrder> order;
        {
            std::unique_lock lock(mutex_);
            changed_.wait(lock, stop, [&] { return !tasks_.empty() || next_order_ || !given_back_.empty(); });
            if (stop.stop_requested()) return;
            if (!tasks_.empty()) {
                task = std::move(tasks_.front());
                tasks_.pop_front();
            } else if (next_order_) {
                order = *std::exchange(next_order_, std::nullopt);
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
            else if (order && workbench_.has_picture())
                run_order(*order);
        } catch (...) {
            tell_failure();
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
        if (!next_order_ || next_order_->close) next_order_ = last_order_;
    } catch (...) {
        publish(FailedNews{words_of_exception()});
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
        if (!write) return end_saving(CancelledNews{task.path});
        std::scoped_lock lock(mutex_);
        writes_.push_back({task.path, std::move(write)});
        changed_.notify_all();
    } catch (...) {
        end_saving(FailedNews{words_of_exception()});
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
            tell_failure();
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
        end_saving(written ? WorkerNews(SavedNews{task.path}) : WorkerNews(CancelledNews{task.path}));
    } catch (...) {
        end_saving(FailedNews{words_of_exception()});
    }
}

void Worker::end_saving(WorkerNews outcome) {
    {
        std::scoped_lock lock(mutex_);
        --saves_;
    }
    publish(std::move(outcome));
}

void Worker::run_order(const PlaceOrder& order) {
    PlacedNews placed;
    placed.order = order;
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
    const std::chrono::duration<double> step(static_cast<double>(order.drawing.placing.count.value_or(0)) *
                                             kSecondsADotAndStep);
    const Unsettled unsettled = [&](const std::function<PlacedDrawing()>& drawing) {
        if (stop.stop_requested()) return false;
        if (order.settled_only) return true;
        if (std::chrono::steady_clock::now() + step - shown < kFrame) return true;
        const bool goes_on = publish_unsettled(order, drawing());
        shown = std::chrono::steady_clock::now();
        return goes_on;
    };
    try {
        if (!workbench_.place(order, placed.drawing, stop, unsettled) || stop.stop_requested())
            return recycle(std::move(placed.drawing));
        last_size_ = placed.drawing.stippling.dots.size();
        make_ready_for_screen(placed.drawing);
        sort_given_back();
    } catch (...) {
        placed.error = words_of_exception();
        placed.drawing = {};
    }
    if (placed.error.empty()) tell_tile(placed);
    placed.picture = std::exchange(arrived_, std::nullopt);
    publish(std::move(placed));
}

bool Worker::publish_unsettled(const PlaceOrder& order, PlacedDrawing drawing) {
    PlacedNews placed;
    placed.order = order;
    placed.drawing = std::move(drawing);
    make_ready_for_screen(placed.drawing);
    tell_tile(placed);
    placed.picture = std::exchange(arrived_, std::nullopt);
    {
        std::scoped_lock lock(mutex_);
        placing_shown_ = true;
    }
    publish(std::move(placed));
    std::scoped_lock lock(mutex_);
    return !next_order_;
}

void Worker::tell_tile(PlacedNews& news) {
    const PlaceOrder& order = news.order;
    if (tile_told_ && same_tile(*tile_told_, order)) return;
    news.tile = view_of(order.tile, workbench_.pipeline().tile(), order.drawing.placer);
    tile_told_ = order;
}

}  // namespace dapple
