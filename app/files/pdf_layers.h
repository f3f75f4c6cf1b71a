#pragma once
// Layers in a PDF, which its readers show and hide one by one.

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

/// Writes the pages of a PDF (each with its content in one stream, as cairo writes them) as one page, the
/// first of them at the bottom, each as a layer with its name (UTF-8): a form with an optional content group
/// (PDF 32000-1, 8.10 and 8.11). What is compressed stays so. There are as many names as pages. What the
/// stream throws passes through.
void write_as_layers(std::ostream& out, std::string_view pages, const std::vector<std::string>& names);

}  // namespace dapple
