#include "app/viewer/background/worker.h"
#include "core/watch.h"

#include <utility>

namespace dapple {
namespace {

using Clock = std::chrono::steady_clock;

// A placing that has run for so long is stopped when another is requested.
constexpr std::chrono::milliseconds kLong(250);

}  // namespace

void Worker::open(std::string name, Open open, std::filesystem::path file) {
    this->open(std::move(name),
               Opening{.whole = [open = std::move(open)](const std::stop_token&) { return open(); }},
               std::move(file));
}

void Worker::open(std::string name, Opening opening, std::filesystem::path file) {
    tasks_.push_back(OpenTask{std::move(name), std::move(opening), std::move(file)});
    go_on();
}

void Worker::stop_opening() {
    if (!opening_) return;
    opening_stopped_ = true;
    reading_.stop();
}

std::optional<OpeningInfo> Worker::opening() const {
    const auto since = reading_.since();
    if (!opening_ || !since) return std::nullopt;
    return OpeningInfo{opening_->name, *since};
}

void Worker::place(DotsRequest request) {
    last_request_ = request;
    last_request_->close.reset();
    next_request_ = std::move(request);
    if (const auto since = placing_since(); since && Clock::now() - *since > kLong) placing_.stop();
    go_on();
}

void Worker::clear() {
    last_request_.reset();
    next_request_.reset();
    if (placing()) placing_.stop();
    // What has not begun would only be forgotten.
    std::erase_if(tasks_, [](const Task& task) {
        return std::holds_alternative<OpenTask>(task) || std::holds_alternative<ClearTask>(task);
    });
    tasks_.push_back(ClearTask{});
    go_on();
}

void Worker::save(std::filesystem::path path, PrepareFile prepare) {
    saves_.push_back({all_saves_++, std::move(path)});
    tasks_.push_back(SaveTask{saves_.back(), std::move(prepare)});
    go_on();
}

void Worker::cancel_saving() {
    if (saves_.empty()) return;
    cancelled_saves_ = all_saves_;
    if (under_way_ && std::holds_alternative<SaveTask>(*under_way_)) placing_.stop();
    writing_.stop();
}

std::optional<SavingInfo> Worker::saving() const {
    if (saves_.empty()) return std::nullopt;
    return SavingInfo{written_ ? written_->save.path : saves_.front().path, writing_.share().value_or(0)};
}

std::optional<Clock::time_point> Worker::placing_since() const {
    return placing() ? placing_.since() : std::nullopt;
}

std::optional<float> Worker::placed_share() const {
    return placing() ? placing_.share() : std::nullopt;
}

std::vector<WorkerEvent> Worker::events(std::chrono::milliseconds patience) {
    const Clock::time_point end = Clock::now() + patience;
    go_on();
    while (events_.empty() && (placing() || next_request_) && under_way_ && Clock::now() < end) {
        placing_.wait_until(end);
        go_on();
    }
    return std::exchange(events_, {});
}

void Worker::recycle(PlacedDrawing drawing) {
    given_back_.push_back(std::move(drawing));
    go_on();
}

// Takes what has come from the threads, and gives them what is next.
void Worker::go_on() {
    take_read();
    take_results();
    if (!under_way_) begin_next();
    take_written();
    write_next();
}

void Worker::take_read() {
    if (!opening_) return;
    const bool over = !reading_.busy();  // asked first, as below
    try {
        while (std::optional<ReadPicture> read = reading_.result()) {
            OpenedPicture about{};
            about.file = opening_->file;
            about.name = opening_->name;
            about.read = [whole = opening_->opening.whole] { return whole({}); };
            about.refines = looked_;
            if (read->whole) whole_missing_.clear();
            read_.push_back({std::move(*read), std::move(about)});
            looked_ = true;
        }
    } catch (...) {
        fail_opening();
    }
    if (over) opening_.reset();
}

void Worker::fail_opening() {
    const std::string message = words_of_exception();
    if (opening_stopped_)
        events_.push_back(OpeningStopped{opening_->name, opening_->file});
    else
        events_.push_back(TaskFailed{message, opening_->file});
    if (looked_)
        whole_missing_ =
            opening_->name + ": only a preview was read, which cannot be saved; open the picture again";
}

void Worker::begin_opening() {
    opening_ = std::get<OpenTask>(std::move(tasks_.front()));
    tasks_.pop_front();
    opening_stopped_ = looked_ = false;
    reading_.begin([opening = opening_->opening](const Background<ReadPicture>::Task& todo) {
        if (opening.first_look)
            if (std::optional<Picture> look = opening.first_look(todo.stop()))
                todo.publish({std::move(*look), false});
        return std::optional(ReadPicture{opening.whole(todo.stop()), true});
    });
}

void Worker::take_results() {
    if (!under_way_) return;
    const bool over = !placing_.busy();  // asked first: there may be a result between the two
    try {
        while (std::optional<DotsPlaced> placed = placing_.result()) events_.push_back(std::move(*placed));
    } catch (...) {
        const std::string message = words_of_exception();
        if (const auto* save = std::get_if<SaveTask>(&*under_way_))
            end_saving(save->save, TaskFailed{message});
        else
            events_.push_back(TaskFailed{message});
    }
    // What was shown has had its time if something newer waits.
    if ((next_request_ || !read_.empty()) && placing() && placing_.has_published()) placing_.stop();
    if (over) end_task();
}

void Worker::end_task() {
    if (std::holds_alternative<ShowTask>(*under_way_) && (!next_request_ || next_request_->close))
        next_request_ = last_request_;
    if (auto* save = std::get_if<SaveTask>(&*under_way_)) {
        if (save->write)
            writes_.push_back(std::move(*save));
        else
            end_saving(save->save, SavingCancelled{save->save.path});
    }
    under_way_.reset();
}

void Worker::begin_next() {
    while (!tasks_.empty() && std::holds_alternative<SaveTask>(tasks_.front())) {
        const Save& save = std::get<SaveTask>(tasks_.front()).save;
        if (!cancelled(save)) break;
        end_saving(save, SavingCancelled{save.path});
        tasks_.pop_front();
    }
    if (!whole_missing_.empty() && !opening_ && !tasks_.empty() &&
        std::holds_alternative<SaveTask>(tasks_.front())) {
        end_saving(std::get<SaveTask>(tasks_.front()).save, TaskFailed{whole_missing_});
        tasks_.pop_front();
    }
    // What is told of a picture comes before anything else is done; what was requested later waits for it.
    if (!read_.empty()) {
        begin(std::move(read_.front()));
        read_.pop_front();
    } else if (!opening_ && !tasks_.empty()) {
        if (std::holds_alternative<OpenTask>(tasks_.front())) return begin_opening();
        begin(std::move(tasks_.front()));
        tasks_.pop_front();
    } else if (next_request_ && bench_.has_picture() && (!opening_ || looked_)) {
        begin(*std::exchange(next_request_, std::nullopt));
    } else if (!given_back_.empty()) {
        begin(SortTask{});
    }
}

void Worker::begin(Task task) {
    for (PlacedDrawing& drawing : given_back_) bench_.give_back(std::move(drawing));
    given_back_.clear();
    under_way_ = std::move(task);
    placing_.begin([this](const Background<DotsPlaced>::Task& todo) -> std::optional<DotsPlaced> {
        bench_.sort_spare();
        if (const auto* request = std::get_if<DotsRequest>(&*under_way_))
            return bench_.place_for_screen(*request, todo);
        if (auto* save = std::get_if<SaveTask>(&*under_way_))
            save->write = save->prepare(bench_, todo.stop());
        if (auto* show = std::get_if<ShowTask>(&*under_way_))
            bench_.open(std::move(show->read.picture), std::move(show->about));
        if (std::holds_alternative<ClearTask>(*under_way_)) bench_.clear();
        return std::nullopt;
    });
}

void Worker::take_written() {
    if (!written_) return;
    const bool over = !writing_.busy();
    try {
        while (std::optional<WorkerEvent> outcome = writing_.result())
            end_saving(written_->save, std::move(*outcome));
    } catch (...) {
        end_saving(written_->save, TaskFailed{words_of_exception()});
    }
    if (over) written_.reset();
}

void Worker::write_next() {
    while (!written_ && !writes_.empty()) {
        SaveTask next = std::move(writes_.front());
        writes_.pop_front();
        if (cancelled(next.save)) {
            end_saving(next.save, SavingCancelled{next.save.path});
            continue;
        }
        written_ = std::move(next);
        writing_.begin([this](const Background<WorkerEvent>::Task& todo) -> std::optional<WorkerEvent> {
            const Watch watch{todo.stop(), [&todo](double share) { todo.report_share(share); }};
            if (written_->write(watch)) return DrawingSaved{written_->save.path};
            return SavingCancelled{written_->save.path};
        });
    }
}

void Worker::end_saving(const Save& save, WorkerEvent outcome) {
    if (std::erase_if(saves_, [number = save.number](const Save& each) { return each.number == number; }) > 0)
        events_.push_back(std::move(outcome));
}

}  // namespace dapple
