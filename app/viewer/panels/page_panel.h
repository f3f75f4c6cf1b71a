#pragma once
// The section "Page": the paper, its margins, how the picture lies on it, and the sheets of a mural.

#include "core/drawing/page_setup.h"
#include "core/output/sheet.h"
#include "core/text/length.h"

namespace dapple {

/// `drawn` is the page on screen: where a page of a size of one's own starts from. `unit` is what lengths are
/// shown and typed in; settings keep millimetres. Returns true if it changed anything.
bool draw_page_panel(PageSetup& setup, Sheet& sheets, const PageLayout& drawn, LengthUnit unit);

}  // namespace dapple
