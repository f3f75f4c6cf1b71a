#pragma once
// What a file would come to, told before it is written: how large it is, how long it takes to plot, and what
// someone should know of it.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/viewer/model/pane.h"
#include "core/output/findings.h"
#include "core/output/plotting_time.h"
#include "io/files/save_drawing.h"

namespace dapple {

struct PlottingEstimate {
    PlottingTime time;
    double segments = 0;      // straight pieces of lines
    double way_m = 0;         // from dot to dot, in metres,
    double way_before_m = 0;  // and along the Hilbert curve, before it is shortened
};

/// About how long a machine would plot such a file in that order. Some of the dots are put in order, and the
/// rest is taken to be like them: dots that are near each other, as they follow in the stream; by priority,
/// dots that lie anywhere.
PlottingEstimate estimated_plotting(const DrawingToSave& drawing, DotOrder order,
                                    const MachineProgram& program);

/// What saving would write.
struct ExportInfo {
    std::uint64_t dots = 0;
    std::optional<double> bytes = {};           // about; none if it is not known
    std::string trouble = {};                   // why it cannot be written; empty: it can
    PageSize page = {};                         // that is written; 0: not known
    std::optional<PlottingTime> plotting = {};  // about, once all is relaxed, of the machine chosen
    double way_m = 0;                           // of the pen, about
    std::vector<Finding> findings = {};
};

/// What an estimate depends on.
struct EstimateKey {
    std::uint64_t placings = 0;
    DrawingFormat format = DrawingFormat::svg;
    DrawingSettings drawing;
    SavingChoice saving;
    bool operator==(const EstimateKey&) const = default;
};

/// Estimates anew only when something changed.
class ExportEstimate {
 public:
    ExportInfo info(const Pane& pane, const ViewerSettings& settings, DrawingFormat format);

 private:
    /// What becomes of the dots on the page, measured anew only when they or the pen changed.
    Preflight measured(const Pane& pane, const InkedDot& ink);

    std::optional<EstimateKey> key_;
    ExportInfo info_;
    std::optional<std::pair<std::uint64_t, InkedDot>> measured_key_;
    Preflight measured_;
};

/// How long the drawing on the page takes to plot, for the line below the canvas; none until it is relaxed.
class PlottingClock {
 public:
    std::optional<PlottingTime> time(const Pane& pane, const ViewerSettings& settings);

 private:
    std::optional<EstimateKey> key_;
    std::optional<PlottingTime> time_;
};

}  // namespace dapple
