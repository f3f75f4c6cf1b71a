#pragma once
// What dapple-lab compare measured: as text, as JSON and as a page.

#include <span>
#include <string>

#include "lab/compare/measure.h"

namespace dapple {

/// Tables in Markdown: grey, each picture, growth; and where dapple is not first.
std::string compare_text(std::span<const MeasuredMethod> measured, const CompareRequest& request);

/// {"seconds_allowed", "seed", "methods": [{"name", "title", "source", "limits", "nested", "grey": [...],
/// "pictures": [...], "growth": [...]}]}. Keys of the marks are those of lab/compare/columns.h; null stands
/// for what took longer than allowed, or what a method does not have.
std::string compare_json(std::span<const MeasuredMethod> measured, const CompareRequest& request);

/// A page that needs nothing beside it: the tables, spectra and drawings side by side, plots. Needs
/// CompareRequest::pngs.
std::string compare_page(std::span<const MeasuredMethod> measured, const CompareRequest& request);

}  // namespace dapple
