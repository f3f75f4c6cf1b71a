#pragma once
// Layers in a PDF, which its readers show and hide one by one.

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace dapple {

struct PdfLayer {
    std::string name;  // UTF-8
    bool multiplies;   // the colours of what lies below it; else it hides them
};

/// Writes the pages of a PDF (each with its content in one stream, as cairo writes them) as one page, the
/// first of them at the bottom, each as a layer: a form with an optional content group, and a transparency
/// group where it multiplies (PDF 32000-1, 8.10, 8.11 and 11.6.6). What is compressed stays so. There are as
/// many layers as pages. What the stream throws passes through.
void write_as_layers(std::ostream& out, std::string_view pages, const std::vector<PdfLayer>& layers);

}  // namespace dapple
