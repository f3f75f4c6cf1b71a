// The module's part in C++: core's public headers, with numpy's arrays for grids and columns, and settings
// and reports as JSON. Arrays come here contiguous and of the type that is named; dapple/__init__.py takes
// what people have, and is the manual.

#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <future>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "core/analysis/report.h"
#include "core/drawing/stippler.h"
#include "core/lights/direction.h"
#include "core/lights/light_samples.h"
#include "core/settings/settings_json.h"
#include "core/tile/tile_file.h"

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

/// Of a two-dimensional array, or of one whose third axis is a texel.
template <class Element, class Value>
Grid<Element> grid_of(const Array<Value>& array) {
    Grid<Element> grid(static_cast<int>(array.shape(1)), static_cast<int>(array.shape(0)));
    std::memcpy(grid.values.data(), array.data(), static_cast<std::size_t>(array.nbytes()));
    return grid;
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
        LightPicture picture = picture_of(span_of(pixels), side(pixels, 1), side(pixels, 0), side(pixels, 2));
        shared.use([&](Stippler& stippler) { stippler.set_picture(std::move(picture)); });
    };
}

void set_density(SharedStippler& shared, const Array<float>& values, bool linear) {
    const py::gil_scoped_release free;
    shared.use([&](Stippler& stippler) {
        stippler.set_density(grid_of<float>(values), linear ? Reading::bilinear : Reading::by_cell);
    });
}

void set_tile(SharedStippler& shared, const std::string& text) {
    const py::gil_scoped_release free;
    shared.use([&](Stippler& stippler) { stippler.set_tile(text); });
}

std::string plan(SharedStippler& shared, const std::string& json) {
    return interruptibly([&](const std::stop_token&) {
        const DrawingSettings settings = settings_of(json).drawing;
        const DrawingPlan plan = shared.use([&](Stippler& stippler) { return stippler.plan(settings); });
        return report_json(plan, settings);
    });
}

Drawing draw(SharedStippler& shared, const std::string& json) {
    // Without a drawing it was stopped, and has not come here.
    return interruptibly([&](const std::stop_token& stop) {
               const Settings settings = settings_of(json);
               return shared.use([&](Stippler& stippler) { return stippler.draw(settings, {stop, {}}); });
           })
        .value();
}

py::tuple arrays(const Drawing& drawing) {
    const auto count = static_cast<py::ssize_t>(drawing.count);
    py::array_t<float> x(count), y(count), radius(count);
    py::array_t<int> pen(count);
    float *to_x = x.mutable_data(), *to_y = y.mutable_data(), *to_radius = radius.mutable_data();
    int* to_pen = pen.mutable_data();
    interruptibly([&](const std::stop_token& stop) {
        return drawing.for_each_piece([&](const Dots& dots) {
            to_x = std::ranges::copy(dots.x, to_x).out;
            to_y = std::ranges::copy(dots.y, to_y).out;
            to_radius = std::ranges::copy(dots.radius, to_radius).out;
            to_pen = std::fill_n(to_pen, dots.size(), dots.pen);
            return !stop.stop_requested();
        });
    });
    return py::make_tuple(x, y, radius, pen);
}

void save(const Drawing& drawing, const std::filesystem::path& path, const std::string& name) {
    const DrawingFormat format = text_format(name);
    interruptibly([&](const std::stop_token& stop) {
        errno = 0;
        std::ofstream out(path, std::ios::binary);
        if (out) drawing.write(out, format, {stop, {}});
        out.close();
        if (!out)
            throw std::filesystem::filesystem_error("", path, {errno ? errno : EIO, std::generic_category()});
    });
}

std::string findings(const Drawing& drawing, const std::string& format) {
    return interruptibly([&](const std::stop_token& stop) {
        return report_json(drawing.findings(text_format(format), {stop, {}}));
    });
}

py::array pixels(const Drawing& drawing, double dpi) {
    const Grid<glm::u8vec3> page = interruptibly([&](const std::stop_token&) { return drawing.pixels(dpi); });
    py::array_t<std::uint8_t> pixels({page.height, page.width, 3});
    std::memcpy(pixels.mutable_data(), page.values.data(), static_cast<std::size_t>(pixels.nbytes()));
    return pixels;
}

/// As numpy has its fields.
struct LightField {
    double direction[3], u, v, weight[3], pdf;
};

py::array lights(const Array<float>& radiance, std::uint64_t count, std::uint64_t seed, int threads) {
    std::vector<LightField> all = interruptibly([&](const std::stop_token&) {
        RankedTile tile = ranked_tile(tile_by_name(kDefaultTile));
        const LightSamples found = light_samples(EnvironmentMap(grid_of<glm::vec3>(radiance)), tile,
                                                 {.count = count, .seed = seed, .threads = threads});
        std::vector<LightField> fields;
        for (const auto& [uv, weight, ignored, pdf] : found.samples) {
            const glm::dvec3 to = direction_of(uv, SphereConvention::openexr);
            fields.push_back({{to.x, to.y, to.z}, uv.x, uv.y, {weight.r, weight.g, weight.b}, pdf});
        }
        return fields;
    });
    const auto size = static_cast<py::ssize_t>(all.size());
    return array_of(std::move(all), {size});
}

py::dict evenness(const Array<double>& points, double width, double height, bool periodic) {
    const PointReport found = interruptibly([&](const std::stop_token&) {
        const auto* const first = reinterpret_cast<const glm::dvec2*>(points.data());
        const Domain domain{width, height, periodic ? Topology::torus : Topology::window};
        return *analyse({first, static_cast<std::size_t>(points.shape(0))}, domain);
    });
    return py::dict("count"_a = found.count, "nearest_minimum"_a = found.nearest.minimum,
                    "nearest_first_percentile"_a = found.nearest.p1, "nearest_mean"_a = found.nearest.mean,
                    "power_below_03"_a = found.power_below_03, "power_below_05"_a = found.power_below_05,
                    "highest_bin"_a = found.peaks.highest_bin,
                    "star_discrepancy"_a = found.star_discrepancy.upper,
                    "l2_star_discrepancy"_a = found.l2_star_discrepancy);
}

py::array points_of_tile(const std::string& text) {
    const Tile tile = read_tile(text).tile;
    std::vector<double> xy;
    for (const BinaryPoint& point : tile.points) {
        const glm::dvec2 place = to_unit_square(point);
        xy.insert(xy.end(), {place.x, place.y});
    }
    return array_of(std::move(xy),
                    {static_cast<py::ssize_t>(tile.kinds()), static_cast<py::ssize_t>(tile.size()), 2});
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
    PYBIND11_NUMPY_DTYPE(LightField, direction, u, v, weight, pdf);

    m.def("settings", [](const std::string& json, const std::string& changes) {
        Settings settings = settings_of(json);
        read_json(changes, settings);
        return py::make_tuple(json_of(settings), settings.embedded);
    });

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

    py::class_<Drawing>(m, "Drawing")
        .def("report", [](const Drawing& drawing) { return report_json(drawing); })
        .def("arrays", arrays)
        .def("save", save)
        .def("findings", findings)
        .def("pixels", pixels);

    m.def("lights", lights, py::arg("radiance").noconvert(), "count"_a, "seed"_a, "threads"_a);
    m.def("evenness", evenness);
    m.def("tile_names", [] {
        const auto names = built_in_tile_names();
        return std::vector<std::string>(names.begin(), names.end());
    });
    m.def("tile_text", [](const std::string& name) { return write_tile(tile_by_name(name)); });
    m.def("tile_points", points_of_tile);
}
