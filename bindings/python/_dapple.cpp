// The module's part in C++: what bindings/include/dapple/ has, with numpy's arrays for its spans. Arrays come
// here contiguous and of the type that is named; dapple/__init__.py takes what people have, and is the
// manual.

#include <dapple/analysis.h>
#include <dapple/drawing.h>
#include <dapple/lights.h>
#include <dapple/tile.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace py = pybind11;
using namespace py::literals;
using namespace dapple;

namespace {

template <class Value>
using Array = py::array_t<Value, py::array::c_style>;

template <class Value>
std::span<const Value> span_of(const Array<Value>& array) {
    return {array.data(), static_cast<std::size_t>(array.size())};
}

template <class Value>
int side(const Array<Value>& array, int axis) {
    return static_cast<int>(array.shape(axis));
}

/// The same memory, which lives as long as the array.
template <class Value>
py::array_t<Value> array_of(std::vector<Value>&& values, std::vector<py::ssize_t> shape) {
    auto kept = std::make_unique<std::vector<Value>>(std::move(values));
    const py::capsule owner(kept.get(), [](void* all) { delete static_cast<std::vector<Value>*>(all); });
    return py::array_t<Value>(std::move(shape), kept.release()->data(), owner);
}

/// What `work` returns, done in another thread and without Python's lock; Ctrl+C asks it to stop, and is then
/// raised as ever.
template <class Work>
auto interruptibly(const Work& work) {
    std::stop_source stop;
    auto result = std::async(std::launch::async, [&] { return work(stop.get_token()); });
    const py::gil_scoped_release free;
    while (result.wait_for(std::chrono::milliseconds(20)) != std::future_status::ready) {
        const py::gil_scoped_acquire held;
        if (PyErr_CheckSignals() == 0) continue;
        stop.request_stop();
        {
            const py::gil_scoped_release free_again;
            result.wait();
        }
        throw py::error_already_set();
    }
    return result.get();
}

/// For any number of Python's threads, one after the other.
class SharedStippler {
 public:
    explicit SharedStippler(int threads) : stippler_(threads) {}

    /// Python's lock must not be held: who has the stippler may be waiting for it.
    template <class Use>
    auto use(const Use& use) {
        const std::lock_guard lock(mutex_);
        return use(stippler_);
    }

 private:
    std::mutex mutex_;
    Stippler stippler_;
};

template <class Value>
auto set_picture(LightPicture (*picture_of)(std::span<const Value>, int, int, int)) {
    return [picture_of](SharedStippler& shared, const Array<Value>& pixels) {
        const py::gil_scoped_release free;
        const LightPicture picture =
            picture_of(span_of(pixels), side(pixels, 1), side(pixels, 0), side(pixels, 2));
        shared.use([&](Stippler& stippler) { stippler.set_picture(picture); });
    };
}

void set_density(SharedStippler& shared, const Array<float>& values, bool linear) {
    const py::gil_scoped_release free;
    shared.use([&](Stippler& stippler) {
        stippler.set_density(span_of(values), side(values, 1), side(values, 0),
                             linear ? Interpolation::linear : Interpolation::nearest);
    });
}

void set_tile(SharedStippler& shared, const std::string& text) {
    const py::gil_scoped_release free;
    shared.use([&](Stippler& stippler) { stippler.set_tile(text); });
}

py::list list_of(const std::vector<DrawingPen>& pens) {
    py::list list;
    for (const DrawingPen& pen : pens)
        list.append(py::make_tuple(pen.name, py::make_tuple(pen.red, pen.green, pen.blue)));
    return list;
}

py::dict plan(SharedStippler& shared, const Settings& settings) {
    const Plan plan = interruptibly([&](const std::stop_token&) {
        return shared.use([&](Stippler& stippler) { return stippler.plan(settings); });
    });
    return py::dict("dots"_a = plan.dots, "lowered"_a = plan.lowered, "steps"_a = plan.steps,
                    "page_mm"_a = py::make_tuple(plan.page_width_mm, plan.page_height_mm),
                    "radius_mm"_a = plan.radius_mm, "pens"_a = list_of(plan.pens),
                    "exposure"_a = plan.exposure, "black_point"_a = plan.black_point,
                    "white_point"_a = plan.white_point, "contrast"_a = plan.contrast,
                    "brightness"_a = plan.brightness, "gamma"_a = plan.gamma, "black"_a = plan.black);
}

Drawing draw(SharedStippler& shared, const Settings& settings) {
    // Without a drawing it was stopped, and has not come here.
    return interruptibly([&](const std::stop_token& stop) {
               return shared.use([&](Stippler& stippler) { return stippler.draw(settings, {stop, {}}); });
           })
        .value();
}

py::tuple arrays(const Drawing& drawing) {
    const auto count = static_cast<py::ssize_t>(drawing.count());
    py::array_t<float> x(count), y(count), radius(count);
    py::array_t<int> pen(count);
    float *to_x = x.mutable_data(), *to_y = y.mutable_data(), *to_radius = radius.mutable_data();
    int* to_pen = pen.mutable_data();
    interruptibly([&](const std::stop_token& stop) {
        return drawing.for_each([&](const DotSpan& dots) {
            to_x = std::ranges::copy(dots.x, to_x).out;
            to_y = std::ranges::copy(dots.y, to_y).out;
            to_radius = std::ranges::copy(dots.radius, to_radius).out;
            to_pen = std::fill_n(to_pen, dots.x.size(), dots.pen);
            return !stop.stop_requested();
        });
    });
    return py::make_tuple(x, y, radius, pen);
}

void save(const Drawing& drawing, const std::filesystem::path& path, FileFormat format) {
    interruptibly([&](const std::stop_token& stop) {
        errno = 0;
        std::ofstream out(path, std::ios::binary);
        if (out) drawing.write(out, format, {stop, {}});
        out.close();
        if (!out)
            throw std::filesystem::filesystem_error("", path, {errno ? errno : EIO, std::generic_category()});
    });
}

py::list advice(const Drawing& drawing, const std::string& format) {
    const std::vector<Advice> found = interruptibly([&](const std::stop_token& stop) {
        return drawing.advice(file_format(format), {stop, {}});
    });
    py::list list;
    for (const Advice& each : found) list.append(py::make_tuple(each.kind, each.text, each.amount));
    return list;
}

py::array pixels(const Drawing& drawing, double dpi) {
    PagePixels page = interruptibly([&](const std::stop_token&) { return drawing.pixels(dpi); });
    return array_of(std::move(page.rgb), {page.height, page.width, 3});
}

py::array lights(const Array<float>& radiance, std::uint64_t count, std::uint64_t seed, int threads) {
    std::vector<SampledLight> all = interruptibly([&](const std::stop_token&) {
        return sample_lights(span_of(radiance), side(radiance, 1), side(radiance, 0),
                             {.count = count, .seed = seed, .threads = threads});
    });
    const auto size = static_cast<py::ssize_t>(all.size());
    return array_of(std::move(all), {size});
}

py::dict evenness(const Array<double>& x, const Array<double>& y, double width, double height,
                  bool periodic) {
    const PointEvenness found = interruptibly([&](const std::stop_token&) {
        return evenness_of(span_of(x), span_of(y), width, height,
                           periodic ? PointEdges::meet : PointEdges::unknown);
    });
    return py::dict("count"_a = found.count, "nearest_minimum"_a = found.nearest_minimum,
                    "nearest_first_percentile"_a = found.nearest_first_percentile,
                    "nearest_mean"_a = found.nearest_mean, "power_below_03"_a = found.power_below_03,
                    "power_below_05"_a = found.power_below_05, "highest_bin"_a = found.highest_bin,
                    "star_discrepancy"_a = found.star_discrepancy,
                    "l2_star_discrepancy"_a = found.l2_star_discrepancy);
}

py::array points_of_tile(const std::string& text) {
    const TilePoints points = tile_points(text);
    std::vector<double> xy;
    xy.reserve(2 * points.x.size());
    for (std::size_t i = 0; i < points.x.size(); ++i) xy.insert(xy.end(), {points.x[i], points.y[i]});
    const auto kinds = static_cast<py::ssize_t>(points.kinds);
    return array_of(std::move(xy), {kinds, static_cast<py::ssize_t>(points.x.size()) / kinds, 2});
}

/// What the library throws is about what it was given.
void translate(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(std::move(thrown));
    } catch (const py::builtin_exception&) {
        throw;
    } catch (const std::filesystem::filesystem_error& error) {
        errno = error.code().value();
        PyErr_SetFromErrnoWithFilename(PyExc_OSError, error.path1().c_str());
    } catch (const std::system_error&) {
        throw;
    } catch (const std::runtime_error& error) {
        PyErr_SetString(PyExc_ValueError, error.what());
    }
}

}  // namespace

PYBIND11_MODULE(_dapple, m) {
    m.attr("version") = DAPPLE_VERSION;
    py::register_local_exception_translator(translate);
    PYBIND11_NUMPY_DTYPE(SampledLight, direction, u, v, weight, pdf);

    py::class_<Settings>(m, "Settings")
        .def(py::init<>())
        .def("set", &Settings::set)
        .def("text", &Settings::text)
        .def("changed", &Settings::changed);

    py::class_<SharedStippler>(m, "Stippler")
        .def(py::init<int>())
        .def("set_srgb", set_picture<std::uint8_t>(picture_of_srgb), py::arg("pixels").noconvert())
        .def("set_srgb", set_picture<std::uint16_t>(picture_of_srgb), py::arg("pixels").noconvert())
        .def("set_srgb", set_picture<float>(picture_of_srgb), py::arg("pixels").noconvert())
        .def("set_light", set_picture<float>(picture_of_light), py::arg("pixels").noconvert())
        .def("set_density", set_density, py::arg("values").noconvert(), "linear"_a)
        .def("set_tile", set_tile)
        .def("plan", plan)
        .def("draw", draw);

    py::enum_<FileFormat>(m, "FileFormat");
    m.def("file_format", file_format);

    py::class_<Drawing>(m, "Drawing")
        .def("count", &Drawing::count)
        .def("page_mm",
             [](const Drawing& drawing) {
                 return py::make_tuple(drawing.page_width_mm(), drawing.page_height_mm());
             })
        .def("pens", [](const Drawing& drawing) { return list_of(drawing.pens()); })
        .def("arrays", arrays)
        .def("save", save)
        .def("advice", advice)
        .def("pixels", pixels);

    m.def("lights", lights, py::arg("radiance").noconvert(), "count"_a, "seed"_a, "threads"_a);
    m.def("evenness", evenness);
    m.def("tile_names", tile_names);
    m.def("tile_text", tile_text);
    m.def("tile_points", points_of_tile);
}
