#pragma once
// The section "Page": the paper, its margins, and how the picture lies on it.

#include "core/drawing/page_setup.h"

namespace dapple {

/// `drawn` is the page on screen: where a page of a size of one's own starts from. Returns true if it changed
/// the settings.
bool draw_page_panel(PageSetup& setup, const PageSize& drawn);

}  // namespace dapple
