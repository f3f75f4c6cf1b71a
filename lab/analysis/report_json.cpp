#include "lab/analysis/report_json.h"
#include "core/tile/tile_file.h"

#include <nlohmann/json.hpp>

namespace dapple {
namespace {

using Json = nlohmann::ordered_json;

void add_placing(Json& json, const PlacedBy& placed) {
    json["tile"] = placed.tile;
    json["ranking"] = name_of(placed.ranking);
    json["placer"] = name_of(placed.placer);
    json["scale"] = placed.scale;
    json["emitted"] = placed.emitted;
    json["duplicates"] = placed.duplicates;
    json["mean_density"] = placed.mean_density;
}

void add_spectrum(Json& json, const PointReport& report) {
    json["highest_bin"] = report.peaks.highest_bin;
    json["highest_bin_frequency"] = {report.peaks.highest_x, report.peaks.highest_y};
    json["top_share"] = report.peaks.top_share;
    json["low_frequency_power"] = report.power_below_05;
    json["power_below_03"] = report.power_below_03;
    json["power_below_05"] = report.power_below_05;
    Json frequency = Json::array(), power = Json::array(), anisotropy = Json::array();
    for (const Ring& ring : report.radial_power) {
        frequency.push_back(ring.frequency);
        power.push_back(ring.power);
        anisotropy.push_back(ring.anisotropy_db);
    }
    json["radial_frequency"] = std::move(frequency);
    json["radial_power"] = std::move(power);
    json["anisotropy"] = std::move(anisotropy);
    json["effective_nyquist"] = report.effective_nyquist;
}

void add_correlations(Json& json, const Subject& subject, const PointReport& report) {
    Json distance = Json::array();
    for (std::size_t b = 0; b < report.pair_correlation.g.size(); ++b)
        distance.push_back((double(b) + 0.5) * report.pair_correlation.bin_width);
    json["pair_correlation"] = {{"distance", std::move(distance)}, {"g", report.pair_correlation.g}};
    if (report.periodicity && subject.period) {
        json["periodicity"] = report.periodicity->value;
        json["periodicity_lag"] = {report.periodicity->lag_x, report.periodicity->lag_y};
        json["period"] = {subject.period->x, subject.period->y};
    } else {
        for (const char* key : {"periodicity", "periodicity_lag", "period"}) json[key] = nullptr;
    }
}

}  // namespace

std::string report_json(const Subject& subject, const PointReport& report) {
    Json json;
    json["subject"] = subject.name;
    if (subject.placed) add_placing(json, *subject.placed);
    json["dots"] = report.count;
    json["domain"] = {{"width", report.domain.width},
                      {"height", report.domain.height},
                      {"topology", name_of(report.domain.topology)}};
    json["density"] = report.density;
    json["largest_radius"] = report.largest_radius;
    json["relative_radius"] = report.relative_radius;
    json["nearest"] = {
        {"min", report.nearest.minimum}, {"p1", report.nearest.p1}, {"mean", report.nearest.mean}};
    const LocalDensity& local = report.local_density;
    json["local_density"] = {{"columns", local.columns},
                             {"rows", local.rows},
                             {"lowest", local.lowest},
                             {"highest", local.highest},
                             {"deviation", local.deviation}};
    add_spectrum(json, report);
    add_correlations(json, subject, report);
    json["discrepancy"] = {{"star_lower", report.star_discrepancy.lower},
                           {"star_upper", report.star_discrepancy.upper},
                           {"l2_star", report.l2_star_discrepancy}};
    if (!subject.tone.empty()) {
        Json tone = Json::array();
        for (const ToneFromAfar& seen : subject.tone)
            tone.push_back({{"blur_spacings", seen.sigma_spacings},
                            {"blur_px", seen.fidelity.sigma_px},
                            {"viewing_distance_mm", seen.distance_mm},
                            {"mean_error", seen.fidelity.mean_error},
                            {"rms_error", seen.fidelity.rms_error},
                            {"psnr_db", seen.fidelity.psnr_db},
                            {"ssim", seen.fidelity.ssim}});
        json["tone_fidelity"] = std::move(tone);
    }
    // File names need not be UTF-8, JSON has to be.
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n';
}

}  // namespace dapple
