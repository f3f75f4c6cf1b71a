#include "app/viewer/model/worker.h"

#include <algorithm>
#include <utility>

namespace dapple {
namespace {

using Clock = std::chrono::steady_clock;

// A placing that has run for so long is stopped when another is requested.
constexpr std::chrono::milliseconds kLong(250);

}  // namespace

void Worker::open(std::string name, Open open, std::filesystem::path file) {
    tasks_.push_back(OpenTask{std::move(name), std::move(open), std::move(file)});
    go_on();
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
    tasks_.push_back(ClearTask{});
    go_on();
}

void Worker::save(std::filesystem::path path, PrepareFile prepare) {
    if (saves_.empty()) saving_cancelled_ = false;
    saves_.push_back(path);
    tasks_.push_back(SaveTask{std::move(path), std::move(prepare)});
    go_on();
}

void Worker::cancel_saving() {
    if (saves_.empty()) return;
    saving_cancelled_ = true;
    if (under_way_ && std::holds_alternative<SaveTask>(*under_way_)) placing_.stop();
    writing_.stop();
}

std::optional<SavingInfo> Worker::saving() const {
    if (saves_.empty()) return std::nullopt;
    return SavingInfo{written_ ? written_->path : saves_.front(), writing_.share().value_or(0)};
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
    take_results();
    if (!under_way_) begin_next();
    take_written();
    write_next();
}

void Worker::take_results() {
    if (!under_way_) return;
    const bool over = !placing_.busy();  // asked first: there may be a result between the two
    try {
        while (std::optional<PlacingBench::Result> result = placing_.result())
            std::visit([this](auto& r) { take(r); }, *result);
    } catch (...) {
        const std::string message = words_of_exception();
        if (const auto* save = std::get_if<SaveTask>(&*under_way_))
            end_saving(save->path, TaskFailed{message});
        else
            events_.push_back(TaskFailed{message});
        // A picture that cannot be read is not to be placed.
        if (std::holds_alternative<OpenTask>(*under_way_)) under_way_ = SortTask{};
    }
    // What was shown has had its time if something newer waits.
    if (next_request_ && placing() && placing_.has_published()) placing_.stop();
    if (over) end_task();
}

void Worker::end_task() {
    if (std::holds_alternative<OpenTask>(*under_way_) && (!next_request_ || next_request_->close))
        next_request_ = last_request_;
    under_way_.reset();
}

void Worker::take(DotsPlaced& placed) {
    events_.push_back(std::move(placed));
}

void Worker::take(FilePrepared& prepared) {
    const std::filesystem::path& path = std::get<SaveTask>(*under_way_).path;
    if (prepared.write)
        writes_.push_back({path, std::move(prepared.write)});
    else
        end_saving(path, SavingCancelled{path});
}

void Worker::begin_next() {
    while (saving_cancelled_ && !tasks_.empty() && std::holds_alternative<SaveTask>(tasks_.front())) {
        const std::filesystem::path path = std::get<SaveTask>(tasks_.front()).path;
        end_saving(path, SavingCancelled{path});
        tasks_.pop_front();
    }
    if (!tasks_.empty()) {
        begin(std::move(tasks_.front()));
        tasks_.pop_front();
    } else if (next_request_ && bench_.has_picture()) {
        begin(*std::exchange(next_request_, std::nullopt));
    } else if (!given_back_.empty()) {
        begin(SortTask{});
    }
}

void Worker::begin(Task task) {
    for (PlacedDrawing& drawing : given_back_) bench_.spare().give_back(std::move(drawing));
    given_back_.clear();
    under_way_ = std::move(task);
    placing_.begin([this](const PlacingBench::Task& todo) -> std::optional<PlacingBench::Result> {
        bench_.sort_spare();
        if (const auto* request = std::get_if<DotsRequest>(&*under_way_)) return bench_.place(*request, todo);
        if (const auto* save = std::get_if<SaveTask>(&*under_way_))
            return bench_.prepare(save->prepare, todo);
        if (const auto* open = std::get_if<OpenTask>(&*under_way_))
            bench_.open(open->name, open->open, open->file);
        if (std::holds_alternative<ClearTask>(*under_way_)) bench_.clear();
        return std::nullopt;
    });
}

void Worker::take_written() {
    if (!written_) return;
    const bool over = !writing_.busy();
    try {
        while (std::optional<WorkerEvent> outcome = writing_.result())
            end_saving(written_->path, std::move(*outcome));
    } catch (...) {
        end_saving(written_->path, TaskFailed{words_of_exception()});
    }
    if (over) written_.reset();
}

void Worker::write_next() {
    while (!written_ && !writes_.empty()) {
        WriteTask next = std::move(writes_.front());
        writes_.pop_front();
        if (saving_cancelled_) {
            end_saving(next.path, SavingCancelled{next.path});
            continue;
        }
        written_ = std::move(next);
        writing_.begin([this](const Background<WorkerEvent>::Task& todo) -> std::optional<WorkerEvent> {
            const SavingWatch watch{todo.stop(), [&todo](double share) { todo.report_share(share); }};
            if (written_->write(watch)) return DrawingSaved{written_->path};
            return SavingCancelled{written_->path};
        });
    }
}

void Worker::end_saving(const std::filesystem::path& path, WorkerEvent outcome) {
    const auto ended = std::ranges::find(saves_, path);
    if (ended != saves_.end()) saves_.erase(ended);
    events_.push_back(std::move(outcome));
}

}  // namespace dapple
