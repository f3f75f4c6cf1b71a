#pragma once
// What the program uses of oneTBB, on plain threads: for ThreadSanitizer, which cannot see into Debian's
// library and so can't tell what happens before what there. With this, whatever it reports is ours; and for
// browsers, where there is one thread. Only the build with DAPPLE_TSAN and that of web find this folder.
// Inner loops of an outer one run on the thread that they are on.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace tbb {

namespace stand_in {

#ifdef __EMSCRIPTEN__
inline constexpr int kCores = 1;
/// Works at once.
struct Thread {
    explicit Thread(const auto& work) { work(); }
};
#else
/// As on a machine of three cores, whatever this one has: races need threads.
inline constexpr int kCores = 3;
using Thread = std::jthread;
#endif
}  // namespace stand_in

namespace info {
inline int default_concurrency() {
    return stand_in::kCores;
}
}  // namespace info

namespace stand_in {

inline thread_local int concurrency = info::default_concurrency();

/// While it lives, the thread may use so many.
class Concurrency {
 public:
    explicit Concurrency(int threads) : before_(std::exchange(concurrency, threads)) {}
    Concurrency(const Concurrency&) = delete;
    Concurrency& operator=(const Concurrency&) = delete;
    ~Concurrency() { concurrency = before_; }

 private:
    int before_;
};

/// Calls work(i) for each i below `count`. What one of them throws comes out.
template <class Work>
void for_each(std::size_t count, const Work& work) {
    const std::size_t threads = std::min(count, static_cast<std::size_t>(concurrency));
    std::atomic<std::size_t> next = 0;
    std::mutex mutex;
    std::exception_ptr error;
    const auto run = [&] {
        const Concurrency inner(threads > 1 ? 1 : concurrency);
        try {
            for (std::size_t i; (i = next++) < count;) work(i);
        } catch (...) {
            next = count;
            const std::lock_guard lock(mutex);
            if (!error) error = std::current_exception();
        }
    };
    {
        std::vector<Thread> others;
        for (std::size_t t = 1; t < threads; ++t) others.emplace_back(run);
        run();
    }
    if (error) std::rethrow_exception(error);
}

}  // namespace stand_in

struct simple_partitioner {};

template <class Value>
class blocked_range {
 public:
    blocked_range(Value begin, Value end, std::size_t grain = 1) : begin_(begin), end_(end), grain_(grain) {}
    Value begin() const { return begin_; }
    Value end() const { return end_; }
    std::size_t size() const { return static_cast<std::size_t>(end_ - begin_); }

    /// As many parts as threads might share, none smaller than the grain.
    std::vector<blocked_range> parts() const {
        if (!(begin_ < end_)) return {};
        const std::size_t part = std::max(grain_, (size() + 11) / 12);
        std::vector<blocked_range> result;
        for (std::size_t at = 0; at < size(); at += part)
            result.emplace_back(begin_ + static_cast<Value>(at),
                                begin_ + static_cast<Value>(std::min(at + part, size())), grain_);
        return result;
    }

 private:
    Value begin_, end_;
    std::size_t grain_;
};

template <class Index, class Body>
requires std::is_integral_v<Index>
void parallel_for(Index first, Index end, const Body& body, simple_partitioner = {}) {
    if (!(first < end)) return;
    stand_in::for_each(static_cast<std::size_t>(end - first),
                       [&](std::size_t i) { body(first + static_cast<Index>(i)); });
}

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body, simple_partitioner = {}) {
    const auto parts = range.parts();
    stand_in::for_each(parts.size(), [&](std::size_t i) { body(parts[i]); });
}

template <class Value, class Result, class Body, class Join>
Result parallel_reduce(const blocked_range<Value>& range, const Result& identity, const Body& body,
                       const Join& join) {
    const auto parts = range.parts();
    std::vector<Result> results(parts.size(), identity);
    stand_in::for_each(parts.size(), [&](std::size_t i) { results[i] = body(parts[i], identity); });
    Result all = identity;
    for (const Result& result : results) all = join(all, result);
    return all;
}

template <class First, class Second>
void parallel_invoke(const First& first, const Second& second) {
    stand_in::for_each(2, [&](std::size_t i) { i == 0 ? first() : second(); });
}

template <class Iterator, class Less = std::less<>>
void parallel_sort(Iterator first, Iterator last, const Less& less = {}) {
    std::sort(first, last, less);
}

class task_group {
 public:
    task_group() = default;
    task_group(const task_group&) = delete;
    task_group& operator=(const task_group&) = delete;

    template <class Work>
    void run(const Work& work) {
        others_.emplace_back([this, work, threads = stand_in::concurrency] {
            const stand_in::Concurrency own(threads);
            try {
                work();
            } catch (...) {
                const std::lock_guard lock(mutex_);
                if (!error_) error_ = std::current_exception();
            }
        });
    }
    /// What one of them throws comes out.
    void wait() {
        others_.clear();
        if (error_) std::rethrow_exception(std::exchange(error_, nullptr));
    }

 private:
    std::mutex mutex_;
    std::exception_ptr error_;
    std::vector<stand_in::Thread> others_;
};

class task_arena {
 public:
    explicit task_arena(int threads) : threads_(threads) {}
    template <class Work>
    auto execute(const Work& work) {
        const stand_in::Concurrency own(threads_);
        return work();
    }

 private:
    int threads_;
};

namespace this_task_arena {
inline int max_concurrency() {
    return stand_in::concurrency;
}
}  // namespace this_task_arena

template <class Value>
class enumerable_thread_specific {
 public:
    enumerable_thread_specific() : make_(std::make_unique<Value>) {}
    /// From a function that makes one, or from what each is made of.
    template <class Maker>
    explicit enumerable_thread_specific(const Maker& maker) {
        if constexpr (std::is_invocable_r_v<Value, Maker>) {
            make_ = [maker] { return std::make_unique<Value>(maker()); };
        } else {
            make_ = [maker] { return std::make_unique<Value>(maker); };
        }
    }
    Value& local() {
        const std::lock_guard lock(mutex_);
        std::unique_ptr<Value>& own = values_[std::this_thread::get_id()];
        if (!own) own = make_();
        return *own;
    }
    void combine_each(const auto& take) {
        for (const auto& [thread, own] : values_) take(*own);
    }

 private:
    std::function<std::unique_ptr<Value>()> make_;
    std::mutex mutex_;
    std::map<std::thread::id, std::unique_ptr<Value>> values_;
};

// Its threads here are made anew for each loop, by the thread whose priority they then have.
class task_scheduler_observer {
 public:
    virtual ~task_scheduler_observer() = default;
    virtual void on_scheduler_entry(bool) {}
    void observe(bool) {}
};

}  // namespace tbb
