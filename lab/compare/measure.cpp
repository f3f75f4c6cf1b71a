#include "lab/compare/measure.h"

#include <tbb/global_control.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <ctime>
#include <limits>
#include <mutex>
#include <thread>

#include "core/analysis/periodogram.h"
#include "core/image/tone.h"
#include "lab/analysis/report_page.h"
#include "lab/analysis/seams.h"
#include "lab/related/covered.h"

namespace dapple {
namespace {

constexpr int kDotsPicture = 420, kSpectrumPicture = 512, kDrawingWidth = 480;  // px
constexpr double kDotsShown = 1500;
constexpr int kGreySide = 256;       // px, of a grey drawn as a picture is
constexpr int kMostTimes = 5;        // that one drawing is made
constexpr double kShortTime = 0.05;  // s, after which it is not made again

double seconds_since(std::clock_t start) {
    return double(std::clock() - start) / CLOCKS_PER_SEC;
}

// A stop after some processor time, or when another is requested.
class Deadline {
 public:
    Deadline(double seconds, const std::stop_token& other)
        : other_(other, [this] { source_.request_stop(); }),
          timer_([this, seconds, start = std::clock()](const std::stop_token& done) {
              std::unique_lock lock(mutex_);
              while (!done.stop_requested() && seconds_since(start) < seconds)
                  waiting_.wait_for(lock, done, std::chrono::milliseconds(20),
                                    [&] { return done.stop_requested(); });
              if (!done.stop_requested()) source_.request_stop();
          }) {}

    std::stop_token token() const { return source_.get_token(); }
    bool passed() const { return source_.stop_requested(); }

 private:
    std::stop_source source_;
    std::stop_callback<std::function<void()>> other_;
    std::mutex mutex_;
    std::condition_variable_any waiting_;
    std::jthread timer_;  // the last: it ends first
};

struct TimedDots {
    PlainDots dots;
    double seconds = 0;
};

class MethodMeasurer {
 public:
    MethodMeasurer(const Contender& method, const CompareRequest& request)
        : method_(method), request_(request) {}

    bool stopped() const { return request_.stop.stop_requested(); }

    // None where it takes longer than allowed.
    std::optional<TimedDots> dots(const Density* density, std::size_t count) {
        if (expected_seconds(count) > request_.seconds) return {};
        const Deadline deadline(request_.seconds, request_.stop);
        const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
        TimedDots timed;
        double all = 0;
        timed.seconds = std::numeric_limits<double>::infinity();
        // What is quick is measured several times: the first may have had to wait for memory and threads.
        for (int time = 0;
             time == 0 || (time < kMostTimes && all < std::min(kShortTime, request_.seconds / 8)); ++time) {
            const std::clock_t start = std::clock();
            timed.dots = method_.dots(
                {.density = density, .count = count, .seed = request_.seed, .stop = deadline.token()});
            const double took = seconds_since(start);
            timed.seconds = std::min(timed.seconds, took);
            all += took;
        }
        // What does not ask about stops came late all the same.
        if (deadline.passed() || timed.seconds > request_.seconds || timed.dots.empty()) {
            if (!density) too_many_ = std::min(too_many_, count);
            return {};
        }
        if (!density) known_.push_back({count, timed.seconds});
        return timed;
    }

    std::vector<Growth> growth() {
        std::vector<Growth> grown;
        for (const std::size_t count : request_.growth) {
            const std::optional<TimedDots> timed = dots(nullptr, count);
            grown.push_back({count, timed ? std::optional(timed->seconds) : std::nullopt});
        }
        return grown;
    }

    std::optional<GreyMarks> grey(std::size_t count) {
        const std::optional<TimedDots> timed = dots(nullptr, count);
        if (!timed) return {};
        const Domain torus{};
        const std::vector<glm::dvec2> points = points_inside(timed->dots, torus);
        const Periodogram spectrum = periodogram(points, torus);
        GreyMarks marks{.wanted = count, .count = points.size(), .seconds = timed->seconds};
        marks.nearest = nearest_summary(points, torus);
        marks.power_03 = low_frequency_power(spectrum, 0.3);
        marks.power_05 = low_frequency_power(spectrum, 0.5);
        marks.peaks = spectral_peaks(spectrum);
        marks.radial_power = radial_power(spectrum);
        marks.effective_nyquist = effective_nyquist(marks.radial_power);
        if (count <= kMostForStar) marks.star = star_discrepancy(points, torus, points.size()).upper;
        marks.l2_star = l2_star_discrepancy(points, torus);
        if (method_.has_tiles) marks.seam = seams(points, kSeamLoad).worst();
        if (request_.pngs) {
            const double part = std::min(1.0, std::sqrt(kDotsShown / double(points.size())));
            marks.dots_png = png_of_points(points, torus, kDotsPicture, part);
            marks.spectrum_png = png_of(spectrum_picture(spectrum, kSpectrumPicture));
        }
        return marks;
    }

    std::optional<DrawingMarks> drawing(const ComparedPicture& picture) {
        if (!ink_) ink_ = own_ink(method_, request_.stop);
        if (!ink_) return {};
        const Density density(density_of(picture.light, Tone{}, *ink_));
        const std::optional<TimedDots> timed = dots(&density, request_.picture_dots);
        if (!timed) return {};
        const Target target = target_for(picture.light, timed->dots.size());
        const double radius = fitted_radius(timed->dots, target);
        DrawingMarks marks{.count = timed->dots.size(), .seconds = timed->seconds};
        marks.marks = picture_marks(timed->dots, radius, target);
        marks.distances =
            local_distances(timed->dots, density, dots_at_full_density(density, timed->dots.size()));
        marks.cells = cell_marks(timed->dots, density);
        if (request_.pngs) marks.png = png_of_drawing(timed->dots, radius, picture.light);
        return marks;
    }

 private:
    struct Known {
        std::size_t count;
        double seconds;
    };

    // At least, from counts that were measured: time grows as the count does, or as it did from the last to
    // this. 0 where nothing is known, or what is known is too short to say.
    double expected_seconds(std::size_t count) const {
        if (count >= too_many_) return 2 * request_.seconds;
        if (known_.empty() || known_.back().count >= count || known_.back().seconds < 0.05) return 0;
        const Known& last = known_.back();
        double power = 1;
        if (known_.size() > 1) {
            const Known& before = known_[known_.size() - 2];
            if (before.count < last.count && before.seconds > 0)
                power = std::clamp(std::log(last.seconds / before.seconds) /
                                       std::log(double(last.count) / double(before.count)),
                                   1.0, 2.0);
        }
        return last.seconds * std::pow(double(count) / double(last.count), power) / 2;
    }

    static std::string png_of_drawing(const PlainDots& dots, double radius, const Grid<float>& light) {
        const Grid<float> ink = raster_of_dots(dots, radius, page_of_width(light, kDrawingWidth));
        Grid<glm::u8vec3> pixels(ink.width, ink.height);
        for (std::size_t i = 0; i < ink.values.size(); ++i)
            pixels.values[i] = glm::u8vec3(srgb_byte(1 - ink.values[i]));
        return png_of(pixels);
    }

    const Contender& method_;
    const CompareRequest& request_;
    std::vector<Known> known_;
    std::size_t too_many_ = ~std::size_t{0};
    std::optional<InkCurve> ink_;
};

}  // namespace

std::optional<InkCurve> own_ink(const Contender& method, const std::stop_token& stop) {
    // Tiles are made for many dots, and quickly; of the others a thousand dots lie as a million do.
    const std::size_t fewest = method.has_tiles ? 16'384 : 512;
    const Density grey(Grid<float>(kGreySide, kGreySide, 1.0f));
    const auto drawn = [&](DotsWanted wanted) {
        wanted.density = &grey;
        return method.dots(wanted);
    };
    const std::vector<float> coverage = mean_coverage_by_load(drawn, fewest, method.level_factor, stop);
    if (coverage.empty()) return {};
    return InkCurve(MeasuredCoverage{.load_step = kCoveredLoadStep, .coverage = coverage});
}

std::vector<MeasuredMethod> compare_methods(const std::vector<Contender>& methods,
                                            const CompareRequest& request) {
    std::vector<MeasuredMethod> measured;
    const double pieces = double(methods.size()) * double(2 + request.pictures.size());
    double done = 0;
    const auto report = [&](const Contender& method, const std::string& what) {
        if (request.progress) request.progress(done++ / pieces, method.title + what);
    };
    for (const Contender& method : methods) {
        // What is made once, as tables are, is made before the clock starts.
        method.dots({.count = 1});
        MethodMeasurer measurer(method, request);
        MeasuredMethod result{.method = method};
        report(method, ": how its time grows");
        if (!method.pictures_only) result.growth = measurer.growth();
        report(method, " on grey");
        for (const std::size_t count : request.dots)
            result.grey.push_back(method.pictures_only ? std::nullopt : measurer.grey(count));
        for (const ComparedPicture& picture : request.pictures) {
            report(method, " on " + picture.name);
            result.drawings.push_back(measurer.drawing(picture));
        }
        if (measurer.stopped()) return measured;
        measured.push_back(std::move(result));
    }
    return measured;
}

}  // namespace dapple
