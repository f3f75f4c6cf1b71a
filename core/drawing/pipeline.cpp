#include "core/drawing/pipeline.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/drawing/relaxed_stream.h"
#include "core/image/auto_tone.h"
#include "core/image/detail.h"
#include "core/lines/line_field.h"
#include "core/maths/portable_math.h"
#include "core/placing/page.h"
#include "core/relaxing/relax.h"
#include "core/relaxing/stir.h"

namespace dapple {

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds_since(Clock::time_point start) {
    return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

// Pictures up to this size are kept with their detail brought out, while the number of dots changes.
constexpr std::size_t kMostPixelsKept = 16'000'000;
// Scales whose ratio's logarithm to base 2 is less have the same ink curve, nearly.
constexpr double kSameLevel = 0.1;

// Cells have so many pixels across from dot to dot where they are darkest, as long as there are no more in
// all.
constexpr double kPixelsApart = 4, kMostFinePixels = 1e6;

// The side of the smallest solid black, in page units.
constexpr double kLeastSolid = 0.02;
// Nearer than that to one, a line would draw its outline once more.
constexpr double kAlongSolid = 0.004;

// Figure 8 emits every fourth dot once more, a little more or less.
constexpr double kWithDuplicates = 1.4;

// The scale at which the largest dots make black.
double scale_of_radius(double radius, double full_load) {
    return full_load / (std::numbers::pi * kDotsPerScale * radius * radius);
}

double smallest_area(const DotSize& size) {
    if (size.sizing != DotSizing::by_tone) return 1;
    const double ratio = size.smallest_mm / size.largest_mm;
    return ratio * ratio;
}

// Where the picture lies on its page, as far as that does not follow from the number of its dots.
void lay_out(DrawingPlan& plan, const PageSetup& setup, glm::ivec2 pixels) {
    plan.setup = setup;
    plan.pixels = pixels;
    const PageLayout layout = layout_of(setup, pixels, {.mm = plan.largest_share() * reach_mm(plan.size)});
    const glm::dvec2 picture = layout.picture.size();
    plan.page = {picture.x, picture.y, layout.page.mm_per_page_unit};
}

// Gives each dot the radius that tone and mask ask for at its place. None where all are alike.
std::function<void(Dots&)> sizes_by_place(const DrawingPlan& plan, double scale) {
    if (plan.size.sizing != DotSizing::by_tone && plan.finer.empty() && plan.largest_edit_mm == 0) return {};
    return [density = plan.density, finer = plan.finer, smallest = smallest_area(plan.size),
            largest = plan.radius(scale)](Dots& dots) {
        dots.radius.resize(dots.size());
        for (std::size_t i = 0; i < dots.size(); ++i) {
            const glm::dvec2 place(dots.x[i], dots.y[i]);
            const double times = finer.times_at(place), d = std::min(density->at(place) / times, 1.0);
            dots.radius[i] = static_cast<float>(largest * std::sqrt((smallest + (1 - smallest) * d) / times));
        }
    };
}

// Those of each pen's dots; none where all pens' are alike.
std::vector<double> areas_by_pen(const DrawingPlan& plan) {
    std::vector<double> areas = dot_areas(plan.pens);
    if (plan.size.sizing != DotSizing::fixed || std::ranges::all_of(areas, [](double a) { return a == 1; }))
        areas.clear();
    return areas;
}

void give_sizes(const DrawingPlan& plan, double scale, DotPieces& dots) {
    if (!areas_by_pen(plan).empty()) {
        for (Dots& piece : dots.pieces) {
            const Pen& pen = plan.pens[static_cast<std::size_t>(piece.pen)];
            const double radius = dot_radius_mm(pen, plan.size.radius_mm) / plan.page.mm_per_page_unit;
            piece.radius.assign(piece.size(), static_cast<float>(radius));
        }
        return;
    }
    if (const auto size = sizes_by_place(plan, scale))
        for (Dots& piece : dots.pieces) size(piece);
}

PageLayout edited_page(const DrawingPlan& plan, double scale) {
    return plan.layout(plan.edits_scale.value_or(scale));
}

void give_sizes_and_edit(const DrawingPlan& plan, double scale, DotPieces& dots) {
    const auto sizes = [&] { give_sizes(plan, scale, dots); };
    if (plan.edits.empty()) return sizes();
    apply(plan.edits, edited_page(plan, scale), scale, !plan.pens.empty(), plan.placing.thresholds, dots,
          sizes);
}

}  // namespace

double DrawingPlan::scale() const {
    return placing.cut ? placing.cut->last_scale() : placing.scale;
}

double DrawingPlan::dots() const {
    return placing.count ? static_cast<double>(*placing.count) : expected_dots(*density, scale());
}

double DrawingPlan::radius(double scale) const {
    if (size.sizing == DotSizing::automatic) return radius_for_tone(scale, full_load);
    return reach_mm(size) / page.mm_per_page_unit;
}

double DrawingPlan::radius_mm(double scale) const {
    const bool automatic = size.sizing == DotSizing::automatic;
    const double mm = automatic ? radius(scale) * layout(scale).page.mm_per_page_unit : reach_mm(size);
    return std::max(largest_share() * mm, largest_edit_mm);
}

PageLayout DrawingPlan::layout(double scale) const {
    const double half_line = stroke_width_mm / 2;
    if (joined && half_line > 0) return layout_of(setup, pixels, {.mm = half_line});
    const bool automatic = size.sizing == DotSizing::automatic;
    return layout_of(setup, pixels,
                     {.mm = std::max(largest_share() * reach_mm(size), half_line),
                      .picture_units = automatic ? largest_share() * radius(scale) : 0});
}

void Pipeline::set_light(Grid<float> light, float usual_exposure, int pixels_in_one) {
    light_ = std::move(light);
    framed_.reset();
    colours_ = {};
    framed_colours_.reset();
    pixels_in_one_ = pixels_in_one;
    framing_ = whole_picture(pixels());
    usual_exposure_ = usual_exposure;
    forget_light();
}

void Pipeline::set_colours(ColourGrid colours) {
    colours_ = std::move(colours);
    framed_colours_.reset();
    if (framing_ != whole_picture(pixels())) framed_colours_ = framed(colours_, framing_of_light());
    forget_densities();
}

void Pipeline::forget_light() {
    histogram_.forget();
    usual_.forget();
    forget_densities();
}

void Pipeline::forget_densities() {
    detailed_.forget();
    toned_.forget();
    masked_.forget();
    dots_by_scale_.forget();
    lines_.forget();
    blacks_.forget();
    room_.forget();
}

void Pipeline::set_plain(std::optional<Density> density) {
    plain_.reset();
    if (density) plain_ = std::make_shared<const Density>(std::move(*density));
    finer_cells_.forget();
}

void Pipeline::frame(const PageSetup& setup) {
    if (light_.empty()) return;
    const Framing framing = framing_of(setup, pixels());
    if (std::exchange(framing_, framing) == framing) return;
    framed_.reset();
    framed_colours_.reset();
    if (framing != whole_picture(pixels())) {
        framed_ = framed(light_, framing_of_light());
        if (!colours_.empty()) framed_colours_ = framed(colours_, framing_of_light());
    }
    forget_light();
}

Framing Pipeline::framing_of_light() const {
    Framing framing = framing_;
    framing.pixels.low /= pixels_in_one_;
    framing.pixels.high = (framing.pixels.high + pixels_in_one_ - 1) / pixels_in_one_;
    return framing;
}

std::shared_ptr<const Histogram> Pipeline::histogram(float exposure) {
    if (light_.empty()) return nullptr;
    return histogram_.of(
        exposure, [&] { return std::make_shared<const Histogram>(histogram_of(framed_light(), exposure)); });
}

Tone Pipeline::usual_tone(const Histogram& histogram, const Tone& own, double strength) {
    return usual_.of({own, strength, own.exposure}, [&] { return auto_tone(histogram, own, strength); });
}

Grid<float> Pipeline::detailed_light(const Detailed& detailed) {
    const auto make = [&] {
        Grid<float> light = exposed(framed_light(), detailed.exposure);
        return detailed.amount == 0 ? light : with_detail(std::move(light), detailed.amount, detailed.sigma);
    };
    if (detailed.amount != 0 && framed_light().values.size() <= kMostPixelsKept)
        return detailed_.of(detailed, make);
    detailed_.forget();
    return make();
}

const PenDensities& Pipeline::toned_densities(const Toned& toned) {
    return toned_.of(toned, [&]() -> PenDensities {
        const Clock::time_point start = Clock::now();
        Grid<float> light = detailed_light({toned.tone.exposure, toned.tone.detail, toned.detail_sigma});
        PenDensities densities;
        if (toned.pens.pens.empty())
            densities.all = std::make_shared<const Density>(
                page_density(density_of(std::move(light), toned.tone, InkCurve(toned.ink))));
        else
            densities = toned_by_pen(toned, std::move(light));
        tone_ms_ += milliseconds_since(start);
        return densities;
    });
}

// Steps of relaxation see a density blurred by its pixels: cells as wide as dots are apart, or wider, are
// taken apart, so that their edges are seen where they are.
std::shared_ptr<const Density> Pipeline::plain_for(double dots) {
    if (plain_->reading() != Reading::by_cell || !(plain_->mean() > 0)) return plain_;
    const double most = std::ranges::max(plain_->values().values);
    const double apart = plain_->longer_side() * std::sqrt(plain_->mean() / (std::max(dots, 1.0) * most));
    const double pixels = static_cast<double>(plain_->values().values.size());
    const int times =
        static_cast<int>(std::min(std::ceil(kPixelsApart / apart), std::sqrt(kMostFinePixels / pixels)));
    if (times <= 1) return plain_;
    return finer_cells_.of(times,
                           [&] { return std::make_shared<const Density>(in_finer_cells(*plain_, times)); });
}

std::shared_ptr<const Density> Pipeline::density_for(const Toned& toned, const Mask& mask) {
    if (plain_) return plain_;
    if (mask.empty() || !toned_.find(toned)) masked_.forget();  // its memory may be needed
    const std::shared_ptr<const Density> density = toned_densities(toned).all;
    if (mask.empty()) return density;
    return masked_.of({density, mask}, [&] {
        const Clock::time_point start = Clock::now();
        auto under = std::make_shared<const Density>(
            page_density(masked(density->values(), mask, framing_of_light(), {light_.width, light_.height})));
        tone_ms_ += milliseconds_since(start);
        return under;
    });
}

PenDensities Pipeline::by_pen_under(const Mask& mask) const {
    PenDensities result = toned_.value();
    if (mask.empty()) return result;
    result.all = masked_.value();
    for (std::shared_ptr<const Density>& each : result.each)
        each = std::make_shared<const Density>(
            masked(each->values(), mask, framing_of_light(), {light_.width, light_.height}));
    return result;
}

PenDensities Pipeline::toned_by_pen(const Toned& toned, Grid<float> light) {
    const std::shared_ptr<const Separation> separation = separation_.of(toned.pens, [&] {
        return std::make_shared<const Separation>(toned.pens.pens, toned.pens.paper, toned.pens.black);
    });
    const Grid<float> seen = toned_light(std::move(light), toned.tone);
    return separated({seen, framed_colours(), toned.tone.invert}, *separation, toned.pens.pens, toned.ink);
}

double DrawingPlan::dots_for_tone() const {
    return expected_dots(*density, scale_of_radius(radius(0), full_load));
}

// Density, count or scale, steps and black, each of which may follow from the others.
void Pipeline::tone_for(DrawingPlan& plan, const DrawingSettings& settings) {
    const bool by_tone = settings.dot_size.sizing == DotSizing::by_tone;
    const bool moves = plan.placer == PlacerKind::exact;
    const double width = plan.pixels.x, height = plan.pixels.y, longer = std::max(width, height);
    PlacingRequest& placing = plan.placing;
    if (by_tone) placing.count.reset();  // which follows from how large they are
    Toned toned{plan.tone,
                {.smallest_area = smallest_area(settings.dot_size), .joined = plan.joined},
                0,
                {plan.pens, plan.pens.empty() ? kWhite : settings.paper}};
    if (settings.pens.set == PenSet::cmyk) toned.pens.black = settings.pens.black;

    const auto choose_steps = [&](double dots) {
        plan.usual_steps = moves ? usual_steps(dots, plan.page.width_mm * plan.page.height_mm) : 0;
        plan.steps = moves ? std::clamp(settings.relax.value_or(plan.usual_steps), 0, kMostRelaxingSteps) : 0;
        toned.ink.relaxing_steps = plan.pens.empty() ? plan.steps : steps_among_pens(plan.steps);
    };
    const auto choose_black = [&](double dots) {
        const bool may_be_open = !plain_ && !plan.joined && !by_tone;
        plan.usual_tone.black = may_be_open ? std::lerp(1, usual_black(dots), settings.tone_strength) : 1;
        const double usual = settings.automatic_tone ? *plan.usual_tone.black : 1;
        plan.tone.black = may_be_open ? settings.tone.black.value_or(usual) : 1;
        toned.tone.black = toned.ink.black = *plan.tone.black;
    };
    const auto expect = [&](double dots) {
        choose_steps(dots);
        choose_black(dots);
        plan.full_load = InkCurve(toned.ink).full_load();
        if (by_tone) placing.scale = scale_of_radius(plan.radius(0), plan.full_load);
    };
    // As the histogram has it, nearly.
    const auto dots_at_scale_1 = [&] {
        const double mean =
            plain_ ? plain_->mean() : mean_density(*plan.histogram, toned.tone, InkCurve(toned.ink));
        return kDotsPerScale * (width * height) / (longer * longer) * mean;
    };
    const auto expected = [&] {
        return placing.count ? static_cast<double>(*placing.count) : placing.scale * dots_at_scale_1();
    };
    // Which density covers how much may depend on the scale.
    const auto depends_on_scale = [&] { return moves && depends_on_level(plan.steps); };
    const auto make_density = [&](double scale) {
        toned.ink.level.reset();
        if (depends_on_scale()) toned.ink.level = level_of(scale, tile_->tile().size());
        plan.ink = toned.ink;
        plan.density = density_for(toned, settings.mask);
    };

    expect(static_cast<double>(placing.count.value_or(1)));
    for (int round = 0; !placing.count && round < 3; ++round) expect(expected());
    if (plan.tone.detail > 0) toned.detail_sigma = detail_sigma(width * height, expected());
    if (placing.count) {
        // Its scale depends on the mean density: first on that which the histogram tells.
        double scale = expected() / std::max(dots_at_scale_1(), 1e-9);
        make_density(scale);
        for (int round = 0; depends_on_scale() && round < 2 && plan.density->mean() > 0; ++round) {
            const double as_told = std::exchange(scale, scale_for(*plan.density, expected()));
            if (std::abs(portable::log2(scale / as_told)) < kSameLevel) break;
            make_density(scale);
        }
        return;
    }
    // As many dots of a count have the same black and steps: known from when the same was planned last.
    const Scaled scaled{toned, settings.mask, placing.scale};
    if (const double* const dots = dots_by_scale_.find(scaled)) {
        expect(*dots);
        return make_density(placing.scale);
    }
    make_density(placing.scale);
    double dots = 0;
    for (int round = 0; round < 3; ++round) {
        const InkedDots before = toned.ink;
        dots = expected_dots(*plan.density, placing.scale);
        expect(dots);
        if (toned.ink == before) break;
        make_density(placing.scale);
    }
    dots_by_scale_.keep(scaled, dots);
}

// Lines and solid blacks, and the density with room for them. Lines are found on the picture as it is
// exposed, whatever its tone; black is what the tone makes black.
void Pipeline::add_inking(DrawingPlan& plan, const DrawingSettings& request) {
    // What is drawn must not depend on where the drawing is cut or shown, so the gap follows from the plan.
    const double dots = std::max(plan.dots(), 1.0);
    const double spacing = std::sqrt(plan.density->width() * double(plan.density->height()) / dots) /
                           plan.density->longer_side();
    const double radius =
        plan.largest_share() *
        plan.radius(plan.placing.count ? scale_for(*plan.density, dots) : plan.placing.scale);
    const Inked inked{plan.density, request.contours, request.solid, {radius, spacing}};
    const Room& room = room_.of(inked, [&] {
        const LitForLines lit{plan.tone.exposure, plan.tone.invert};
        const Grid<float> light = exposed(reduced(framed_light()), lit.exposure);
        const auto as_drawn = [&](Grid<float> seen) { return lit.invert ? negative(std::move(seen)) : seen; };
        Grid<float> seen = as_drawn(toned_light(light, plan.tone));
        // Where the mask takes most dots away there are neither lines nor blacks.
        Grid<float> kept(seen.width, seen.height, 1);
        if (!request.mask.empty())
            kept = reduced(masked(Grid<float>(plan.density->width(), plan.density->height(), 1),
                                  request.mask.without_finer(), framing_of_light(),
                                  {light_.width, light_.height}));
        for (std::size_t i = 0; i < seen.values.size(); ++i)
            if (kept.values[i] < 0.5f) seen.values[i] = 1;
        Inking inking;
        if (request.contours > 0)
            inking.lines =
                lines_shown(lines_.of(lit, [&] { return find_lines(as_drawn(light)); }), request.contours);
        if (request.solid < 1) {
            inking.areas = blacks_.of({plan.tone, request.solid, request.mask},
                                      [&] { return find_blacks(seen, request.solid, kLeastSolid); });
            inking.lines = outside(inking.lines, inking.areas, kAlongSolid);
        }
        if (!request.mask.empty())
            inking =
                within(std::move(inking), [&, longer = std::max(kept.width, kept.height)](glm::dvec2 at) {
                    return value_at(kept, glm::vec2(at * double(longer)) - 0.5f) >= 0.5f;
                });
        Room made;
        inking = fitted(std::move(inking), seen, inked.dots);
        made.times = room_for_dots(inking, *plan.density, seen, InkCurve(plan.ink), inked.dots);
        made.density = std::make_shared<const Density>(with_room(*plan.density, made.times));
        made.inking = std::make_shared<const Inking>(std::move(inking));
        return made;
    });
    plan.inking = room.inking;
    if (!plan.edits.empty()) {  // dots keep away even from what is not there any more
        const double scale = plan.placing.count ? scale_for(*plan.density, dots) : plan.placing.scale;
        plan.inking = std::make_shared<const Inking>(within(
            *room.inking, [is_bare = bare_places(plan.edits, edited_page(plan, scale))](glm::dvec2 at) {
                return !is_bare(at, 0);
            }));
    }
    plan.density = room.density;
    if (plan.pens.empty()) return;
    plan.by_pen.all = room.density;
    for (std::shared_ptr<const Density>& each : plan.by_pen.each)
        each = std::make_shared<const Density>(with_room(*each, room.times));
}

namespace {

// As large as pens draw them.
DrawingSettings with_pens_sizes(const DrawingSettings& asked) {
    DrawingSettings settings = asked;
    const bool touches = draws_touches(settings);
    if (touches && !have_widths(settings.pens) && settings.dot_size.sizing != DotSizing::by_tone) {
        settings.dot_size.sizing = DotSizing::fixed;
        settings.dot_size.radius_mm = settings.pen_width_mm / 2;
    }
    if ((draws_strokes(settings) && !touches) || settings.dot_size.sizing == DotSizing::by_tone) {
        settings.pens.width_mm = 0;
        for (Pen& pen : settings.pens.own) pen.width_mm = 0;
    }
    if (!can_be_finer(asked)) settings.mask = settings.mask.without_finer();
    return settings;
}

}  // namespace

DrawingPlan Pipeline::plan(const DrawingSettings& asked, std::uint64_t most_dots) {
    const DrawingSettings settings = with_pens_sizes(asked);
    tone_ms_ = 0;
    DrawingPlan plan;
    frame(settings.page);
    plan.framing = framing_;
    plan.opened = pixels();
    plan.tone = settings.tone;
    plan.size = settings.dot_size;
    if (!plain_) plan.finer = {settings.mask, framing_of_light(), {light_.width, light_.height}};
    plan.placer = settings.placer;
    plan.settle_for = settings.settle_for;
    plan.placing = settings.placing;
    plan.joined = settings.style != DrawingStyle::dots;
    plan.stroke_width_mm = keeps_dots_inside(settings.page) ? widest_stroke(asked) : 0;
    plan.edits = parse_edits(settings.edits);
    for (const Edit& edit : plan.edits)
        if (edit.kind == Edit::Kind::dot && !plan.joined && !draws_touches(asked))
            plan.largest_edit_mm = std::max(plan.largest_edit_mm, double{edit.radius_mm});
    if (settings.automatic_exposure) plan.tone.exposure = usual_exposure_;
    if (!plain_) plan.pens = pens_for(settings.pens, framed_colours(), plan.tone.exposure, settings.paper);
    const std::optional<double> pens_width = width_of_pens(plan.pens);
    if (pens_width && plan.size.sizing == DotSizing::automatic)
        plan.size = {.sizing = DotSizing::fixed, .radius_mm = *pens_width / 2};
    if (!plain_) plan.histogram = histogram(plan.tone.exposure);
    plan.usual_tone = plan.tone;
    if (!plain_) {
        plan.usual_tone = usual_tone(*plan.histogram, plan.tone, settings.tone_strength);
        // Colours that are made much lighter get pale, as few of them are both light and strong: half the
        // way.
        if (has_colour(plan.pens) && !framed_colours().empty())
            plan.usual_tone.gamma = std::sqrt(plan.usual_tone.gamma);
    }
    if (settings.automatic_tone) plan.tone = plan.usual_tone;

    lay_out(plan, settings.page,
            plain_ ? glm::ivec2(plain_->width(), plain_->height())
                   : glm::ivec2(framed_light().width, framed_light().height));
    tone_for(plan, settings);

    const double dots = plan.dots();
    const double most =
        static_cast<double>(most_dots) / (settings.placer == PlacerKind::exact ? 1 : kWithDuplicates);
    if (!plan.pens.empty()) plan.by_pen = by_pen_under(settings.mask);
    if (plain_ && plan.steps > 0) plan.density = plain_for(dots);
    if (!plain_ && has_inking(settings)) add_inking(plan, settings);
    plan.lowered = dots > most;
    if (plan.lowered && plan.placing.count) plan.placing.count = static_cast<std::uint64_t>(most);
    if (plan.lowered && !plan.placing.count) plan.placing.scale = scale_for(*plan.density, most);
    return plan;
}

namespace {

// Even where discs overlap to solid black, which lines and samples do not.
RelaxingRequest relaxing_of(const DrawingPlan& plan, const Placer& placer, double scale) {
    const bool pictures = plan.settle_for == SettleFor::pictures;
    RelaxingRequest relaxing{
        .scale = scale,
        .threads = plan.placing.threads,
        .keeps_density = !pictures,
        .ink = plan.placing.count && !pictures
                   ? ink_for(*plan.density, scale, kSampleKernel, static_cast<double>(*plan.placing.count))
                   : 1,
        .stirring = stirring_of(placer.table(), scale)};
    // What has a tone is seen, unless lines are.
    if (pictures && !plan.joined && plan.histogram && plan.pens.empty()) {
        relaxing.light = std::make_shared<const InkCurve>(plan.ink);
        relaxing.cut_off = !keeps_dots_inside(plan.setup);
    }
    if (pictures && !plan.joined) {
        relaxing.areas = {static_cast<float>(smallest_area(plan.size)), plan.finer};
        relaxing.even_from = relaxing.areas.tone_of(static_cast<float>(kSolidLoad / plan.full_load));
    }
    return relaxing;
}

// Whether its dots are more than are settled at once.
bool is_streamed(const DrawingPlan& plan) {
    return plan.dots() > static_cast<double>(kDotsAtOnce);
}

}  // namespace

bool Pipeline::draw(const DrawingPlan& plan, Stippling& drawn, const DrawingWatch& watch) {
    if (!settle(plan, drawn, watch)) return false;
    finish(plan, drawn);
    return true;
}

void Pipeline::finish(const DrawingPlan& plan, Stippling& drawn) {
    give_sizes_and_edit(plan, drawn.scale, drawn.dots);
    if (drawn.duplicates > 0 && !plan.edits.empty()) drawn.duplicates = duplicates_among(drawn.dots);
}

bool Pipeline::settle(const DrawingPlan& plan, Stippling& drawn, const DrawingWatch& watch) {
    const Density& density = *plan.density;
    if (!stipple(*tile_, density, plan.placer, plan.placing, drawn, watch.stop)) return false;
    if (plan.placing.thresholds) fill_critical_scales(drawn.dots, density);
    const auto on_the_way = [&](DotPieces dots) {
        if (!plan.pens.empty()) dots = pen_dots(dots, plan.by_pen, {.scale = drawn.scale, .rough = true});
        give_sizes_and_edit(plan, drawn.scale, dots);
        return dots;
    };
    const bool relaxes = plan.steps > 0 && drawn.dots.size() > 0;
    if (relaxes && (!watch.step || watch.step(drawn, [&] { return on_the_way(drawn.dots); }))) {
        auto start = Clock::now();
        RelaxingRequest relaxing = relaxing_of(plan, tile_->placer(), drawn.scale);
        if (is_streamed(plan) && !relaxing.keeps_density)
            relaxing.carried = carried(tile_->placer(), density, plan.placing, relaxing);
        // What is shown before the end is seen by one warp more, which takes about as long as a step.
        const bool warped = !relaxing.carried && !relaxing.keeps_density;
        stir(drawn.dots, density, relaxing);
        Relaxation relaxation(std::exchange(drawn.dots, {}), density, relaxing);
        for (const RelaxingStep& how : relaxing_steps(plan.steps, relaxing)) {
            if (!relaxation.step(how, watch.stop)) return false;
            drawn.relax_ms += milliseconds_since(std::exchange(start, Clock::now()));
            if (how.kind == RelaxingStep::Kind::warp) continue;
            ++drawn.steps;
            if (drawn.steps < plan.steps && watch.step && !watch.step(drawn, [&] {
                    return on_the_way(warped ? relaxation.dots_warped() : relaxation.dots());
                })) {
                if (warped) relaxation.step({RelaxingStep::Kind::warp});
                break;
            }
            start = Clock::now();
        }
        drawn.dots = relaxation.dots();
    }
    if (!plan.pens.empty() && drawn.dots.size() > 0) {
        DotPieces by_pen = pen_dots(drawn.dots, plan.by_pen,
                                    {.scale = drawn.scale,
                                     .move = drawn.steps > 0,
                                     .rough = relaxes && drawn.steps < plan.steps,
                                     .areas = areas_by_pen(plan),
                                     .threads = plan.placing.threads},
                                    watch.stop);
        if (by_pen.pieces.empty()) return false;
        drawn.dots = std::move(by_pen);
    }
    return true;
}

double Pipeline::find_scale(DrawingPlan& plan) {
    PlacingRequest& placing = plan.placing;
    if (plan.placer == PlacerKind::exact && placing.count && !placing.cut)
        placing.cut = placing_of(tile_->placer(), *plan.density, {.placing = placing}).cut;
    return plan.scale();
}

std::optional<PlannedDrawing> Pipeline::drawing(DrawingPlan plan, const std::stop_token& stop) {
    PlannedDrawing drawing;
    drawing.tile_size = tile_->tile().size();
    if (plan.placer == PlacerKind::figure8 || !plan.pens.empty() || !plan.edits.empty()) {
        // It needs all dots at once: it counts the duplicates among them. So do pens that share dots out.
        // Edits are of few enough to be seen.
        const auto drawn = std::make_shared<Stippling>();
        if (!draw(plan, *drawn, {.stop = stop, .step = {}})) return std::nullopt;
        drawing.scale = drawn->scale;
        drawing.dots = [drawn](const PagePart& part, const std::stop_token&) {
            DotPieces own = drawn->dots;
            for (Dots& piece : own.pieces) cut_to(part, piece);
            DotStream dots = stream_of(std::make_shared<const DotPieces>(std::move(own)), drawn->scale);
            dots.duplicates = drawn->duplicates;
            return dots;
        };
    } else {
        drawing.scale = find_scale(plan);
        const StreamRequest request{
            .placing = plan.placing, .part = {}, .finish = sizes_by_place(plan, drawing.scale)};
        RelaxingRequest relaxing = relaxing_of(plan, tile_->placer(), drawing.scale);
        const bool streamed = is_streamed(plan);
        if (plan.steps > 0 && streamed)  // once for all parts
            share_work(tile_->placer(), *plan.density, plan.placing, plan.steps, relaxing);
        const auto settled = plan.steps > 0 && !streamed ? std::make_shared<SettledDots>() : nullptr;
        drawing.dots = [table = tile_->placer().shared_table(), density = plan.density, request, settled,
                        steps = plan.steps, relaxing](const PagePart& part, const std::stop_token& stopped) {
            const auto placer = std::make_shared<Placer>(table);
            StreamRequest of_part = request;
            of_part.part = part;
            if (settled) return settled->on(*placer, *density, of_part, steps, relaxing, stopped);
            DotStream dots =
                steps > 0 ? relaxed_stream(*placer, *density, of_part, steps, kDotsAtOnce, stopped, relaxing)
                          : dapple::stream(*placer, *density, of_part);
            dots.for_each_piece = [placer, density, each = std::move(dots.for_each_piece)](
                                      const TakePiece& take) { each(take); };
            return dots;
        };
    }
    drawing.outlines = outlines_of(plan, drawing.scale);
    drawing.plan = std::move(plan);
    return drawing;
}

std::function<std::vector<PlacedTile>()> Pipeline::outlines_of(const DrawingPlan& plan, double scale) const {
    if (plan.placer == PlacerKind::figure8)
        return [tile = tile_->tile(), ranks = tile_->own_ranks(), density = plan.density, scale] {
            return place_figure8(*density, tile, ranks, scale).tiles;
        };
    return [table = tile_->placer().shared_table(), density = plan.density, scale] {
        return placed_tiles(*table, *density, {.scale = scale});
    };
}

}  // namespace dapple
